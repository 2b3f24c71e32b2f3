// SPDX-License-Identifier: Apache-2.0
// Tests soybean in rows with a closed canopy.
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/canopy/quantities.hpp"
#include "stand/stand.hpp"

namespace ideotype {
namespace {

class Soybean : public ::testing::Test {
  protected:
    Soybean()
        : campaign(read_campaign(IDEOTYPE_CAMPAIGNS "/soybean.toml",
                                 {"light.tolerance=0.001",
                                  "light.paths=1048576", "light.fields=1"})) {
        const Case chosen = cases(campaign).back();
        request =
            request_of(sampling_of(Task{}, campaign, chosen), campaign, chosen,
                       scene_of(campaign, chosen), {campaign.crop.baseline});
    }

    Campaign campaign;
    CanopyRequest request;
    const Device device{Device::supported_isas().back()};
};

TEST_F(Soybean, AbsorbsAsMuchAsClosedCanopies) {
    const CanopyReport report = evaluate(request, device);
    EXPECT_NEAR(report.lai, 5.06, 0.05);
    const Estimate fapar = measure_objective("fapar", report).estimate;
    EXPECT_GT(fapar.mean, 0.9);
    EXPECT_LT(fapar.mean, 0.98);
    EXPECT_LT(fapar.standard_error, 0.005);
}

TEST_F(Soybean, AssimilationByPiecesIsNearlyExact) {
    const auto gross = [&] {
        return measure_objective("gross_assimilation",
                                 evaluate(request, device))
            .estimate;
    };
    const Estimate usual = gross();
    request.details.exact = true;
    request.accuracy.tolerance = 0.006;
    const Estimate exact = gross();
    EXPECT_LT(usual.standard_error / usual.mean, 0.004);
    EXPECT_LT(exact.standard_error / exact.mean, 0.006);
    EXPECT_NEAR(
        usual.mean / exact.mean, 1,
        0.003 + 3 * std::hypot(usual.standard_error, exact.standard_error) /
                    exact.mean);
}

}  // namespace
}  // namespace ideotype
