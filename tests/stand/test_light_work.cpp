// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/light/device.hpp"
#include "stand/stand.hpp"

namespace ideotype {
namespace {

class LightWorkOfStand : public testing::Test {
  protected:
    //! Returns the number of paths with which a plant is evaluated, in a new
    //! stand: no evaluation depends on others.
    std::uint64_t paths(const Plant& plant, const Task& task) const {
        Stand stand(campaign_, chosen_);
        std::uint64_t paths = 0;
        stand.report_each(
            {plant}, sampling_of(task, campaign_, chosen_),
            Device(Device::supported_isas().back()),
            [&](const Case&, const CanopyReport& of) { paths = of.paths; });
        return paths;
    }

    //! Returns the baseline with narrow leaves.
    Plant narrow() const {
        Plant plant = campaign_.crop.baseline;
        for (Leaf& leaf : plant.leaves) leaf.width *= 0.5;
        return plant;
    }

    const Campaign campaign_ =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml");
    const Case chosen_ = cases(campaign_).front();
};

TEST_F(LightWorkOfStand, IsThatOfTheBaselineForAllPlantsOfASearch) {
    const std::uint64_t all = paths(campaign_.crop.baseline, {});
    EXPECT_GT(all, 0u);
    EXPECT_EQ(paths(narrow(), {}), all);
    Task later;
    later.generation = 7;
    later.seed = 3;
    EXPECT_EQ(paths(narrow(), later), all);
}

TEST_F(LightWorkOfStand, IsThatOfThePlantForAToleranceOfTheTask) {
    Task task;
    task.tolerance = 0.005;
    EXPECT_NE(paths(narrow(), task), paths(campaign_.crop.baseline, task));
}

TEST_F(LightWorkOfStand, LetsMoreNoiseCancelBetweenPlants) {
    // Two plants of equal shape and nearly equal size have the same paths.
    Plant similar = campaign_.crop.baseline;
    for (Leaf& leaf : similar.leaves) leaf.width *= 1.001;
    Stand stand(campaign_, chosen_);
    const Device device(Device::supported_isas().back());
    const Sampling sampling = sampling_of({}, campaign_, chosen_);
    const auto values = [&](const Plant& plant) {
        return stand.evaluate({plant}, sampling, device).randomisations;
    };
    const std::vector<double> a = values(campaign_.crop.baseline),
                              b = values(similar);
    std::vector<double> more(a.size());
    for (std::size_t r = 0; r < a.size(); ++r) more[r] = b[r] - a[r];
    EXPECT_LT(estimate(more).standard_error, 0.7 * estimate(a).standard_error);
}

}  // namespace
}  // namespace ideotype
