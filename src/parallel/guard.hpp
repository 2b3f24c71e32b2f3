// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dispatcher.hpp"
#include "rank_clock.hpp"

namespace ideotype {

//! Evaluates; whatever goes wrong becomes a failed outcome. Fills in the wall
//! time and the worker.
Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock);

}  // namespace ideotype
