// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/canopy/quantities.hpp"
#include "stand/stand.hpp"

namespace ideotype {

inline const std::string weed =
    "component=[{name=\"weed\", crop=\"crops/maize.toml\", rows=[2, 4]}]";
inline const std::string nir = "band=[{name=\"nir\"}]";

//! Evaluates campaigns of several components.
class Mixtures : public ::testing::Test {
  protected:
    CanopyReport evaluated(std::vector<std::string> settings) const {
        return evaluate(requested(std::move(settings)), device);
    }

    static CanopyRequest requested(std::vector<std::string> settings) {
        settings.push_back("objective.maximise=net_assimilation");
        for (const char* more : {"light.tolerance=0.004", "light.paths=65536",
                                 "light.randomisations=32"})
            settings.push_back(more);
        const Campaign campaign =
            read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml", settings);
        const Case chosen = cases(campaign).front();
        return request_of(sampling_of(Task{}, campaign, chosen), campaign,
                          chosen, scene_of(campaign, chosen),
                          {campaign.crop.baseline});
    }

    static Estimate number(const std::string& name,
                           const CanopyReport& report) {
        return measure_objective(name, report).estimate;
    }

    const Device device{Device::supported_isas().back()};
    //! Settings that give the campaign the same optics as the crop file of a
    //! component.
    const std::vector<std::string> alike{"optics.leaf_reflectance=0.06",
                                         "optics.leaf_transmittance=0.03"};
};

inline void expect_equal(Estimate a, Estimate b, const std::string& subject) {
    EXPECT_NEAR(a.mean, b.mean,
                4 * std::hypot(a.standard_error, b.standard_error))
        << subject;
}

}  // namespace ideotype
