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

//! The error that one case cannot go on, while other cases can.
class CaseError : public Error {
  public:
    using Error::Error;
};

//! An observer of the evolution of a case, for progress lines.
class Watcher {
  public:
    virtual ~Watcher() = default;

    //! Is told that an evaluation of a row or a finalist is durable.
    virtual void on_evaluation(const Task& task, const Outcome& outcome) = 0;

    //! Learns that a generation of so many plants is complete.
    virtual void on_generation(std::uint32_t generation, std::uint32_t plants,
                               const GenerationSummary& summary) = 0;

    //! Is told that the finalists are about to be evaluated.
    virtual void on_final(const std::string& reason) = 0;
};

//! Returns the genes, baseline and senses of objectives of a case.
SearchSpace search_space(const Campaign& campaign, const Case& chosen);

//! The parts of an evolution, all of which must outlive the evolution.
struct Evolution {
    const Campaign& campaign;
    const Case& chosen;
    Optimizer& optimizer;  //!< optimizer that has learnt nothing yet
    Dispatcher& dispatcher;
    Watcher& watcher;
    std::function<double()> elapsed;  //!< time of the case in this session [s]
};

//! Evolves a case, as the loop of a master, from the state of its history until
//! a stop rule holds and the finalists are evaluated, or the dispatcher is
//! asked to stop. Pauses while evaluations are under way. The history must
//! outlive the routine.
//! @throws CaseError if too many evaluations of a generation fail.
Routine<Ending> evolve_case(Evolution evolution, History& history);

}  // namespace ideotype
