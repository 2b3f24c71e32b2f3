// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/fidelity/trade.hpp"

namespace ideotype {

//! A value for every parameter that may be turned, and what an evaluation
//! should then be like. Errors are relative to the baseline's objective.
struct Combination {
    std::vector<std::size_t> values;  //!< by parameter of the trade
    Accuracy accuracy;
    Randomness::Fields fields = Randomness::Fields::one;
    Estimate bias;
    double standard_error = 0;  //!< of one evaluation
    Cost cost;                  //!< of one evaluation; path: of all light [s]

    //! Root mean square, counting what is not known of it against it.
    double error() const;
    double seconds() const { return cost.geometry + cost.scene + cost.path; }
};

//! What a value of each parameter should give with an accuracy: sizes of biases
//! add up, since that they cancel for these plants says nothing of others;
//! costs and variances multiply with the ratios to the campaign's own values.
Combination combine(const Trade& trade, const std::vector<std::size_t>& values,
                    const Accuracy& accuracy, Randomness::Fields fields,
                    Goal goal);

//! All that are not beaten both in cost and in error, cheapest first; of those
//! beyond 5 % only the most accurate, if there is no other.
std::vector<Combination> pareto_front(const Trade& trade, Goal goal,
                                      Randomness::Fields fields);

//! The cheapest whose error is within a tolerance, or the most accurate if
//! none is.
const Combination& cheapest(const std::vector<Combination>& front,
                            double tolerance);

//! The campaign with a combination's values.
Campaign applied(const Trade& trade, const Combination& combination);

//! A line of a campaign file.
struct PastedKey {
    std::string section;  //!< "field", "[day]" if it is an array of tables
    std::string name;
    std::string value;  //!< in TOML
};

//! All that the parameters set.
std::vector<PastedKey> keys_of(const Campaign& campaign);

//! What a combination is really like: evaluations as campaigns make them, each
//! with fresh random numbers, against the trade's converged figures.
struct Check {
    Estimate bias;            //!< relative to the baseline's objective
    Estimate standard_error;  //!< of one evaluation, from their spread
    double seconds = 0;       //!< of one evaluation, as cost, median
};

//! Evaluates for a time [s], but a few times at least.
Check check_combination(const Trade& trade, const Combination& combination,
                        Goal goal, const Device& device, double seconds);

}  // namespace ideotype
