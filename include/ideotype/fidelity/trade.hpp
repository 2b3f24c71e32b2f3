// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ideotype/fidelity/probe.hpp"

namespace ideotype {

//! What is wrong with an estimate, relative to the baseline's objective, also
//! for differences: selection asks which of two plants has more in the same
//! light.
struct Inaccuracy {
    Estimate bias;    //!< against the reference
    Scatter scatter;  //!< of one field, and of one randomisation in it
};

//! One value of a parameter, measured.
struct ParameterPoint {
    std::string name;
    std::size_t draws = 0;
    std::array<Inaccuracy, 2> inaccuracy;  //!< by goal
    Cost cost;

    const Inaccuracy& of(Goal goal) const {
        return inaccuracy[goal == Goal::value ? 0 : 1];
    }
};

//! A parameter with a measurement for each of its values.
struct MeasuredParameter {
    Parameter parameter;
    std::vector<ParameterPoint> points;

    const ParameterPoint& own() const { return points[parameter.own]; }
};

//! The trade of speed for accuracy of one case.
struct Trade {
    Variant own;  //!< as the campaign is
    std::size_t case_index = 0;
    Rivals rivals;
    std::vector<MeasuredParameter> parameters;
    Estimate value;  //!< converged, of the baseline, in the objective's unit
    Estimate difference;  //!< converged, between the rivals

    const MeasuredParameter& parameter(const std::string& name) const;
};

//! How long to measure.
struct Effort {
    double seconds = 60;
    //! Draws of each value; a known time or number comes first. Standard
    //! deviations need a few dozen to be known to some 10 %.
    std::size_t least_draws = 32;
    std::size_t most_draws = 1000000;
};

//! What is measured now, and which part of the time is over.
using OnProgress = std::function<void(const std::string& what, double part)>;

//! Measures all parameters of a case. Each value is compared with the reference
//! of its parameter draw by draw; time goes where it makes the biases known
//! best. The converged figures are those of all references together, measured
//! on their own.
Trade measure_trade(const Campaign& campaign, std::size_t case_index,
                    const Device& device, const Effort& effort,
                    const OnProgress& on_progress);

}  // namespace ideotype
