// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "evolve_case.hpp"
#include "search/stop_rules.hpp"
#include "search/summary.hpp"

namespace ideotype {

//! Connects the optimizer and the history in the asynchronous search of one
//! case: proposes rows, stores outcomes and commits generations. Outcomes may
//! arrive in any order, but are passed to the optimizer in the order of rows,
//! so that results do not depend on the number of workers. Both constructor
//! arguments must outlive the search.
class CaseSearch {
  public:
    //! Passes the complete generations of the history to the optimizer.
    CaseSearch(const Evolution& evolution, History& history);

    //! Returns the next row to evaluate, if one can be proposed now.
    std::optional<Work> next();

    //! Commits complete generations, then stores an outcome.
    void record(const Work& work, const Outcome& outcome);

    //! Passes known rows to the optimizer in order, and commits complete
    //! generations.
    //! @throws CaseError if too many evaluations of a generation fail.
    void commit();

    //! Returns the reason why the search ended: the stop rule, or "room" if
    //! there is no room for another generation in the history. Returns nothing
    //! until all generations are complete.
    std::optional<std::string> ending() const;

  private:
    //! A generation that has been proposed but is not complete.
    struct Open {
        std::size_t size = 0;
        std::size_t learnt = 0;  //!< number of rows passed to the optimizer
        Population rows;         //!< proposed rows
        //! Equal genomes have equal outcomes under common random numbers, so
        //! each is evaluated once. `first_slots` contains the first slot of
        //! each genome; `copies` contains later slots that wait for its
        //! outcome.
        std::map<Genome, std::uint32_t> first_slots;
        std::multimap<std::uint32_t, std::uint32_t> copies;
    };

    //! A complete generation that is not yet committed.
    struct Complete {
        std::uint32_t generation = 0;
        GenerationSummary summary;
    };

    void learn();
    void extend();
    void propose();
    bool is_over(std::uint32_t generation) const;
    bool is_proposing() const {
        return !open_.empty() && open_.back().rows.size() < open_.back().size;
    }
    bool begin_generation();
    void add(const std::vector<Candidate>& candidates);
    void keep(std::uint32_t generation, std::uint32_t slot,
              const Outcome& outcome);
    void copy(std::uint32_t generation, std::uint32_t original);
    std::vector<double> features_of(const Outcome& outcome) const;
    void complete();
    void judge(const GenerationSummary& summary, const Population& rows);
    std::uint32_t first_open() const {
        return static_cast<std::uint32_t>(progress_.generations.size());
    }
    //! Returns the wall time of all sessions of the case [s].
    double wall_time() const { return spent_before_ + evolution_.elapsed(); }

    const Evolution& evolution_;
    History& history_;
    SearchSpace space_;
    Summarizer summarized_;
    double spent_before_;
    Progress progress_;               //!< complete generations
    std::vector<Complete> complete_;  //!< complete generations to commit
    std::deque<Open>
        open_;  //!< open generations; only rows of the first are learnt
    std::uint64_t known_rows_ = 0;  //!< rows passed to the optimizer
    std::deque<Work> waiting_;  //!< proposed work that is not handed out yet
    std::optional<std::string> reason_;
    std::uint64_t reason_row_ =
        0;  //!< number of known rows when the stop rule applied
};

}  // namespace ideotype
