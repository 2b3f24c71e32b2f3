#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/fidelity/choice.hpp"
#include "json.hpp"

namespace ideotype {

//! The cheapest combination for a tolerance, and what it is really like.
struct Choice {
    Goal goal = Goal::value;
    Randomness::Fields fields = Randomness::Fields::one;
    double tolerance = 0;
    std::optional<Combination> combination;
    std::optional<Check> check;
};

//! One table of all parameters.
void print_trade(const Trade& trade);

//! One line for each, and the keys of those that meet the asked tolerance.
void print_choices(const Trade& trade, const std::vector<Choice>& choices,
                   double asked);

//! Everything, with the fronts of both goals.
Json to_json(const Trade& trade, const std::vector<Choice>& choices);

}  // namespace ideotype
