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

//! A case can't go on by itself; others can.
class CaseError : public Error {
  public:
    using Error::Error;
};

//! Sees a case evolve; for progress lines.
class Watcher {
  public:
    virtual ~Watcher() = default;

    //! Hears that an evaluation of a row or a finalist is durable.
    virtual void on_evaluation(const Task& task, const Outcome& outcome) = 0;

    //! Hears that a generation is complete.
    virtual void on_generation(std::uint32_t generation,
                               const GenerationSummary& summary) = 0;

    //! Hears that the finalists are about to be evaluated.
    virtual void on_final(const std::string& reason) = 0;
};

//! Returns the genes, baseline and senses of objectives of a case.
SearchSpace search_space(const Campaign& campaign, const Case& chosen);

//! The parts that an evolution works with; all must outlive it.
struct Evolution {
    const Campaign& campaign;
    const Case& chosen;
    //! The optimizer, which has learnt no generation yet.
    Optimizer& optimizer;
    Dispatcher& dispatcher;
    Watcher& watcher;
    //! Seconds since this session began to work on the case.
    std::function<double()> elapsed;
};

//! Evolves a case, as the loop of a master, from where its history stands until
//! a stop rule holds and the finalists are evaluated, or a stop is requested of
//! the dispatcher. Pauses while evaluations are under way. The history must
//! outlive it.
//! @throws CaseError if too many evaluations of a generation fail.
Routine<Ending> evolve_case(Evolution evolution, History& history);

}  // namespace ideotype
