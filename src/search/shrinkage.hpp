// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "ideotype/core/estimate.hpp"
#include "population.hpp"

namespace ideotype {

//! Returns the expected value of objective 0 of a selected individual, given
//! the evaluations of its generation. The largest of many noisy values is
//! biased upwards, so the value is shrunk towards the mean of the generation by
//! parametric empirical Bayes (Morris 1983,
//! doi:10.1080/01621459.1983.10477920). Consider n individuals with mean m,
//! variance s2 between individuals and noise variance v. With B = (n - 3) / (n
//! - 1) min(1, v / s2), the value y becomes y - B (y - m); its variance is v (1
//! - (n - 1) / n B) + 2 / (n - 3) B^2 (y - m)^2. Because all individuals use
//! common random numbers, v is the noise of differences within a generation.
//! The noise that they share is added to the standard error.
//! @param chosen slot of an individual that did not fail. If it meets the
//! constraints, it is compared with the individuals that do, else with all.
Estimate shrink(const Population& population, std::size_t chosen);

}  // namespace ideotype
