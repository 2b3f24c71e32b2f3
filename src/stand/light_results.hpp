// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

//! Whether a report covers a day [J m-2, with hourly values] or one source
//! normalised to unit irradiance on level ground.
enum class Span { day, single };

//! An axis of results; layers and faces are numbered and have no labels.
struct ResultAxis {
    const char* name;
    std::vector<std::string> labels{};
};

//! One result of an evaluation of light, for JSON output and Python datasets.
struct LightResult {
    const char* key;    //!< name in JSON output
    const char* array;  //!< name of the array in Python; null: not in Python
    //! Axes, the last one varying fastest; empty for a single value.
    std::vector<ResultAxis> along;
    std::vector<Estimate> values;
    bool has_surfaces = true;  //!< whether surfaces of this kind exist
};

//! Returns the light budget per ground area.
std::vector<LightResult> budget_results(const BudgetEstimate& budget,
                                        const CanopyReport& report);

//! Returns the PAR absorbed by leaf sides, by layers and by groups.
std::vector<LightResult> part_results(const CanopyReport& report);

//! Returns the light of each waveband by component, group, soil and reflection.
std::vector<LightResult> band_results(const CanopyReport& report);

//! The parts of a canopy by which assimilation is reported.
enum class CarbonOf { all, components, groups };

//! Returns gross and net assimilation in carbon_unit(). For all leaves over a
//! day, the net carbon balance is included. Net values use the standard errors
//! of gross values.
std::vector<LightResult> carbon_results(const CanopyReport& report,
                                        CarbonOf parts, Span span);

//! Returns the unit of assimilation: per second for a single source, otherwise
//! per day.
inline const char* carbon_unit(Span span) {
    return span == Span::single ? "umol m-2 s-1" : "mol m-2 day-1";
}

//! Returns the scalar quantities. For a single source these are only fractions
//! and areas, since daily sums are undefined.
std::vector<Measured> numbers_of(const CanopyReport& report, Span span);

}  // namespace ideotype
