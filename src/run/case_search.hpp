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

//! The search of one case row by row, between optimizer and history: proposes
//! what can be, keeps what arrives, teaches the optimizer in the order of rows,
//! and commits generations. Both references must outlive it.
class CaseSearch {
  public:
    //! Learns what the history has of complete generations.
    CaseSearch(const Evolution& evolution, History& history);

    //! Returns the next row to evaluate, if one can be proposed now; learns
    //! first.
    std::optional<Work> next();

    //! Keeps an outcome; commits what is complete first.
    void record(const Work& work, const Outcome& outcome);

    //! Teaches the optimizer what is known, in the order of rows, and commits
    //! generations that are complete.
    //! @throws CaseError if too many evaluations of a generation fail.
    void commit();

    //! Why the search is over: the stop rule, or "room" if its history has none
    //! for another generation. None before all that will be is complete.
    std::optional<std::string> ending() const;

  private:
    //! A proposed generation that is not complete.
    struct Open {
        std::size_t size = 0;
        std::size_t learnt = 0;  //!< rows
        Population rows;         //!< that are proposed
        //! Under common random numbers equal genomes have equal outcomes: the
        //! first slot of each, and the later slots that wait for it.
        std::map<Genome, std::uint32_t> first_slots;
        std::multimap<std::uint32_t, std::uint32_t> copies;
    };

    //! A generation that the optimizer has learnt.
    struct Complete {
        std::uint32_t generation = 0;
        GenerationSummary summary;
    };

    void learn();
    void extend();
    void propose();
    bool is_over(std::uint32_t generation) const;
    bool is_proposing() const;
    bool begin_generation();
    void add(const std::vector<Candidate>& candidates);
    void keep(std::uint32_t generation, std::uint32_t slot,
              const Outcome& outcome);
    void copy(std::uint32_t generation, std::uint32_t original);
    std::vector<double> features_of(const Outcome& outcome) const;
    void complete();
    void judge(const GenerationSummary& summary);
    std::uint32_t first_open() const;
    double wall_time() const;

    const Evolution& evolution_;
    History& history_;
    SearchSpace space_;
    Summarizer summarized_;
    double spent_before_;
    Progress progress_;               //!< complete generations
    std::vector<Complete> complete_;  //!< not committed yet
    std::deque<Open> open_;           //!< the first of these is learnt now
    std::uint64_t known_rows_ = 0;    //!< that the optimizer has learnt
    std::deque<Work> waiting_;        //!< proposed, not handed out
    std::optional<std::string> reason_;
    std::uint64_t reason_row_ = 0;  //!< after the rows that gave the reason
};

}  // namespace ideotype
