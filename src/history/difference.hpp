// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "search/genome.hpp"
#include "search/population.hpp"

namespace ideotype {

//! The first gene, origin or parent in which two candidates differ in any
//! bit, with both values; empty if they are the same.
std::string first_difference(const GeneSpace& genes, const Candidate& was,
                             const Candidate& is);

}  // namespace ideotype
