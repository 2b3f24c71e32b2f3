// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "search/population.hpp"

namespace ideotype {

//! Returns an individual with one objective.
inline Individual make_individual(Genome genome, double objective,
                                  double violation = 0,
                                  Status status = Status::done) {
    return {{std::move(genome), Origin::child, {0, 0}},
            status,
            {{objective, 0.1}},
            violation};
}

inline Individual make_failed_individual(Genome genome, double objective) {
    return make_individual(std::move(genome), objective, 0, Status::failed);
}

}  // namespace ideotype
