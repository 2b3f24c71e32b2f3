// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/fidelity/choice.hpp"
#include "json.hpp"

namespace ideotype {

//! The cheapest combination for a tolerance, or the most accurate one, and
//! what it is really like.
struct Choice {
    Goal goal = Goal::value;
    Randomness::Fields fields = Randomness::Fields::one;
    double tolerance = 0;
    Combination combination;
    std::optional<Check> check;  //!< where the tolerance is met

    bool is_met() const { return combination.error() <= tolerance; }
};

//! One table of all parameters.
void print_trade(const Trade& trade);

//! One line for each, and the keys for the asked tolerance; where it is not
//! met, those of the most accurate.
void print_choices(const Trade& trade, const std::vector<Choice>& choices,
                   double asked);

//! Everything, with the fronts of both goals.
Json to_json(const Trade& trade, const std::vector<Choice>& choices);

}  // namespace ideotype
