// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "campaign/campaign.hpp"
#include "history/history.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/routine.hpp"
#include "parallel/dispatcher.hpp"
#include "search/optimizer.hpp"

namespace ideotype {

enum class Ending { finished, drained };

//! An error that ends one case, while other cases continue.
class CaseError : public Error {
  public:
    using Error::Error;
};

//! Observes the evolution of a case, for progress lines.
class Watcher {
  public:
    virtual ~Watcher() = default;

    //! Called when the evaluation of a row or a finalist is stored durably.
    virtual void on_evaluation(const Task& task, const Outcome& outcome) = 0;

    //! Called when a generation is complete.
    virtual void on_generation(std::uint32_t generation, std::uint32_t plants,
                               const GenerationSummary& summary) = 0;

    //! Called before finalists are evaluated.
    virtual void on_final(const std::string& reason) = 0;
};

//! Returns the genes and the baseline of a case, and whether each objective is
//! maximised or minimised.
SearchSpace search_space(const Campaign& campaign, const Case& chosen);

//! The objects that an evolution uses; all of them must outlive it.
struct Evolution {
    const Campaign& campaign;
    const Case& chosen;
    Optimizer& optimizer;  //!< optimizer that has not learnt any rows
    Dispatcher& dispatcher;
    Watcher& watcher;
    std::function<double()> elapsed;  //!< time of the case in this session [s]
};

//! Evolves a case from the state of its history until a stop rule applies and
//! the finalists are evaluated, or until a stop is requested. This is the main
//! loop of a master: a coroutine that suspends while evaluations are in flight.
//! The history must outlive it.
//! @throws CaseError if too many evaluations of a generation fail.
Routine<Ending> evolve_case(Evolution evolution, History& history);

}  // namespace ideotype
