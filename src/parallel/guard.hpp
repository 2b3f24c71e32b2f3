#pragma once

#include "ideotype/parallel/dispatcher.hpp"

namespace ideotype {

//! Evaluates; whatever goes wrong becomes a failed outcome. Fills in the wall
//! time and the worker.
Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank);

}  // namespace ideotype
