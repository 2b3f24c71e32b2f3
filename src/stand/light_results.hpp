// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

//! The kind of light: a day in J m-2 with its hours, or a single light, of
//! which level ground receives 1.
enum class Span { day, single };

//! An axis of results; layers and faces have numbers in place of labels.
struct ResultAxis {
    const char* name;
    std::vector<std::string> labels{};
};

//! A result of the light on a canopy, from which both JSON and the datasets of
//! Python follow.
struct LightResult {
    const char* key;    //!< name in JSON
    const char* array;  //!< name of an array in Python; null: it has none
    //! Axes, of which the last one is the fastest; none: there is one value.
    std::vector<ResultAxis> along;
    std::vector<Estimate> values;
    bool has_surfaces = true;  //!< whether there are surfaces of its kind
};

//! Returns what a budget says of the light per area of ground, in its unit.
std::vector<LightResult> budget_results(const BudgetEstimate& budget,
                                        const CanopyReport& report);

//! Returns the PAR that parts of leaves, and each group, absorb.
std::vector<LightResult> part_results(const CanopyReport& report);

//! Returns the parts of the light of each waveband.
std::vector<LightResult> band_results(const CanopyReport& report);

//! The parts of a canopy, each of which has an assimilation.
enum class CarbonOf { all, components, groups };

//! Returns gross and net assimilation, and of all leaves in a day the carbon
//! balance, in carbon_unit(); net numbers have the error of gross ones.
std::vector<LightResult> carbon_results(const CanopyReport& report,
                                        CarbonOf parts, Span span);

//! The unit of assimilation, which is that of a second for a single light.
inline const char* carbon_unit(Span span) {
    return span == Span::single ? "umol m-2 s-1" : "mol m-2 day-1";
}

//! Returns the quantities that are single numbers. For a single light they are
//! fractions and areas only, because it has no rates of a day.
std::vector<Measured> numbers_of(const CanopyReport& report, Span span);

}  // namespace ideotype
