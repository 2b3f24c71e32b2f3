// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "field_of_two_leaves.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {
namespace {

//! Plants of two leaves with sheaths; below one sheath a part of the stalk is
//! visible.
class Organs : public TwoLeaves {
  protected:
    Organs() {
        Component& component = request.scene.components[0];
        component.photosynthesis.emplace();
        plant = *component.plant;
        plant.sheath = {{}, true, .25, .001};
        set(plant);
    }

    void set(const Plant& other) {
        set_plant(request.scene.components[0], other);
    }

    static Estimate gross_of(const CanopyReport& report, std::size_t group) {
        return report.assimilation->gross.groups[group];
    }

    static constexpr std::size_t stalk = 2, sheath = 3;
    Plant plant;
};

TEST_F(Organs, WithoutACapacityAssimilateNothingAndCostNothing) {
    const CanopyReport report = evaluated();
    ASSERT_EQ(report.groups.size(), 4u);
    EXPECT_FALSE(report.has_living_organs);
    for (const std::size_t g : {stalk, sheath}) {
        EXPECT_EQ(gross_of(report, g).mean, 0);
        EXPECT_EQ(report.assimilation->losses[g].all(), 0);
    }
}

TEST_F(Organs, AssimilateTheirLightAsAtEachPoint) {
    plant.sheath.capacity = .3;
    plant.stalk.capacity = .1;
    set(plant);
    request.accuracy = {4096, 8};
    const CanopyReport pieces = evaluated();
    request.details.exact = true;
    request.accuracy = {4096, 16};
    const CanopyReport exact = evaluated();
    for (const std::size_t g : {stalk, sheath}) {
        const Estimate own = gross_of(pieces, g), other = gross_of(exact, g);
        EXPECT_GT(own.mean, 0);
        // Pieces of few faces overestimate assimilation by a few per cent.
        EXPECT_NEAR(own.mean, other.mean,
                    4 * std::hypot(own.standard_error, other.standard_error) +
                        .03 * other.mean)
            << g;
    }
    EXPECT_TRUE(pieces.has_living_organs);
}

TEST_F(Organs, LeaveTheLightOfLeavesAsItIs) {
    const CanopyReport dead = evaluated();
    plant.sheath.capacity = plant.stalk.capacity = .1;
    set(plant);
    const CanopyReport living = evaluated();
    EXPECT_EQ(living.par().budget_by_randomisation,
              dead.par().budget_by_randomisation);
    // The expected light is a mean over random neighbours, so that their number
    // may differ.
    EXPECT_NEAR(gross_of(living, 0).mean, gross_of(dead, 0).mean,
                3 * gross_of(dead, 0).standard_error);
    EXPECT_EQ(living.hit_by_sun->mean.mean, dead.hit_by_sun->mean.mean);
    EXPECT_EQ(living.lai, dead.lai);
}

TEST_F(Organs, RespireAndAreBuiltByTheirMass) {
    plant.stalk.density = 100;
    plant.stalk.maintenance = .015;
    set(plant);
    const CanopyReport report = evaluated();
    const Component& component = request.scene.components[0];
    const double mass = 100 * std::numbers::pi / 4 * .027 * .027 * 2 /
                        component.ground_per_plant;
    const CarbonLoss& loss = report.assimilation->losses[stalk];
    // On a clear day the air temperature is constant at 30 deg C.
    EXPECT_NEAR(loss.in_light + loss.at_night,
                mass * .015 / .030 * std::exp2(.5), 1e-9);
    EXPECT_NEAR(loss.building,
                mass * 1.52 / .030 / component.photosynthesis->building_days,
                1e-9);
    const double balance =
        measure_objective("carbon_balance", report).estimate.mean;
    request.scene.components[0].photosynthesis->building_days = 1e9;
    const CanopyReport unpaid = evaluated();
    EXPECT_GT(measure_objective("carbon_balance", unpaid).estimate.mean,
              balance);
}

TEST_F(Organs, CostAsMuchWhereTheyDoNotShow) {
    plant.stalk.density = 100;
    set(plant);
    const double shown = evaluated().assimilation->losses[stalk].building;
    plant.sheath.length = 3;
    plant.leaves[1].insertion_height = 2;
    set(plant);
    const CanopyReport report = evaluated(Fields::each);
    EXPECT_EQ(report.par().light.groups[stalk].mean, 0);
    EXPECT_NEAR(report.assimilation->losses[stalk].building, shown, 1e-12);
    for (std::size_t r = 0; r < 8; ++r)
        EXPECT_GT(report.assimilation->losses_in(r)[stalk].building, 0);
}

TEST_F(Organs, HaveRootsThatRespireAndAreBuiltWithThem) {
    plant.stalk.density = 100;
    set(plant);
    Component& component = request.scene.components[0];
    const CanopyReport bare = evaluated();
    component.roots = {.2, .015};
    const CanopyReport rooted = evaluated();
    const double stalk_mass = 100 * std::numbers::pi / 4 * .027 * .027 * 2 /
                              component.ground_per_plant;
    const auto more = [&](std::size_t group, double CarbonLoss::*part) {
        return rooted.assimilation->losses[group].*part -
               bare.assimilation->losses[group].*part;
    };
    const auto respired = [&](std::size_t group) {
        return more(group, &CarbonLoss::in_light) +
               more(group, &CarbonLoss::at_night);
    };
    // One mol of CH2O is 0.030 kg; the dry mass of leaves is 45 g m-2.
    const double per_mass = .2 * .015 / .030 * std::exp2(.5);
    EXPECT_NEAR(respired(stalk), stalk_mass * per_mass, 1e-9);
    EXPECT_NEAR(respired(0) + respired(1), .045 * bare.lai * per_mass, 1e-9);
    EXPECT_NEAR(
        more(stalk, &CarbonLoss::building),
        .2 * stalk_mass / .69 / .030 / component.photosynthesis->building_days,
        1e-9);
    EXPECT_EQ(respired(sheath), 0);
    EXPECT_EQ(rooted.assimilation->dry_mass[stalk],
              bare.assimilation->dry_mass[stalk]);
    EXPECT_NEAR(bare.assimilation->dry_mass[stalk], stalk_mass, 1e-9);
    EXPECT_NEAR(bare.assimilation->dry_mass[0] + bare.assimilation->dry_mass[1],
                .045 * bare.lai, 1e-9);
}

TEST_F(Organs, FillEarsThatRespireAPartOfTheirCarbon) {
    plant.stalk.density = 100;
    plant.stalk.maintenance = .015;
    set(plant);
    const auto number = [](const char* name, const CanopyReport& report) {
        return measure_objective(name, report).estimate.mean;
    };
    for (const Fields fields : {Fields::one, Fields::each}) {
        request.scene.components[0].ear_share = 0;
        const CanopyReport bare = evaluated(fields);
        request.scene.components[0].ear_share = .1;
        const CanopyReport full = evaluated(fields);
        const double growth =
            number("gross_assimilation", bare) - number("respiration", bare);
        EXPECT_NEAR(number("respiration", full),
                    number("respiration", bare) + .1 * growth, 1e-9);
        EXPECT_NEAR(number("carbon_balance", full),
                    number("carbon_balance", bare) - .1 * growth, 1e-9);
        EXPECT_EQ(number("net_assimilation", full),
                  number("net_assimilation", bare));
        // 30 g of CH2O yield 20.1 g of dry matter; 1 g m-2 is 0.01 t ha-1.
        EXPECT_NEAR(number("dry_matter", bare), .201 * growth, 1e-9);
        EXPECT_NEAR(number("dry_matter", full), .9 * .201 * growth, 1e-9);
    }
}

TEST_F(Organs, LoseByTheFieldInWhichPlantsAreMissing) {
    plant.stalk.density = 100;
    plant.stalk.maintenance = .015;
    set(plant);
    request.scene.components[0].variation.missing = .5;
    const CanopyReport report = evaluated(Fields::each);
    const auto& all = report.assimilation->losses_by_randomisation;
    ASSERT_EQ(all.size(), 8u);
    double mean = 0;
    bool differs = false;
    for (const std::vector<CarbonLoss>& losses : all) {
        mean += losses[stalk].all() / 8;
        differs |= losses[stalk].all() != all[0][stalk].all();
    }
    EXPECT_TRUE(differs);
    EXPECT_NEAR(mean, report.assimilation->losses[stalk].all(), 1e-12);
}

TEST_F(Organs, OfMissingPlantsCostNothing) {
    plant.stalk.density = 100;
    plant.stalk.maintenance = .015;
    set(plant);
    const CanopyReport alike = evaluated(Fields::each);
    request.scene.components[0].variation.missing = .5;
    const CanopyReport report = evaluated(Fields::each);
    const double share = report.lai / alike.lai;
    EXPECT_LT(share, .6);
    for (const auto part : {&CarbonLoss::at_night, &CarbonLoss::building})
        EXPECT_NEAR(report.assimilation->losses[stalk].*part,
                    share * alike.assimilation->losses[stalk].*part, 1e-12);
    // Losses are equal to those of each field evaluated alone.
    request.accuracy = {512, 4};
    for (std::uint32_t r = 0; r < 8; ++r) {
        request.randomness.first_randomisation = r;
        const CanopyReport alone = evaluated();
        EXPECT_NEAR(
            alone.assimilation->losses[stalk].all(),
            report.assimilation->losses_by_randomisation[r][stalk].all(),
            1e-12);
    }
}

TEST_F(Organs, CountByOrganAsTheyDoInAllOfTheCanopy) {
    plant.sheath.capacity = .3;
    plant.sheath.density = 90;
    set(plant);
    const CanopyReport report = evaluated();
    const QuantitySet set =
        canopy_quantities(request.scene, request.layers, request.details);
    const std::vector<Estimate> values = measure(report);
    const auto sum_of = [&](const std::string& name) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += values[set.offset(name) + i].mean;
        return sum;
    };
    EXPECT_NEAR(sum_of("assimilation_by_organ"),
                report.assimilation->gross.sum.mean, 1e-12);
    EXPECT_NEAR(sum_of("carbon_loss_by_organ"),
                ideotype::sum_of(report.assimilation->losses).all(), 1e-12);
}

}  // namespace
}  // namespace ideotype
