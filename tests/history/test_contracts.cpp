// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "checksum.hpp"
#include "columns.hpp"
#include "contracts.hpp"
#include "dataset.hpp"
#include "disk/open.hpp"
#include "generations.hpp"
#include "history_file.hpp"
#include "journal.hpp"
#include "layout.hpp"
#include "sample_history.hpp"

namespace ideotype {

namespace {

//! The parts of a history that is open for writing and whose generation 0 is
//! proposed.
class Parts {
  public:
    Parts() {
        History history = History::create(path_, sample_header());
        propose(history, 0, sample_candidates(0));
    }

    Handle file() const { return open_to_write(path_); }

  private:
    Folder folder_;
    const std::string path_ = folder_ / "case.h5";
};

//! Breaks a contract of a history's generations.
template <class Action>
void with_generations(Action action) {
    const Parts parts;
    const Handle file = parts.file();
    Generations generations(file);
    action(generations);
}

//! Breaks a contract of a history's rows.
template <class Action>
void with_columns(Action action) {
    const Parts parts;
    const Handle file = parts.file();
    Columns columns(file, "evaluations", sample_header().schema);
    action(columns);
}

//! Breaks a contract of a new history.
template <class Action>
void with_history(Action action) {
    const Folder folder;
    History history = History::create(folder / "case.h5", sample_header());
    action(history);
}

void create(const HistoryHeader& header) {
    const Folder folder;
    History::create(folder / "case.h5", header);
}

std::vector<Row> row_of(Outcome outcome) {
    return {{sample_candidate(0, 0), std::move(outcome), 1}};
}

}  // namespace

TEST(Contracts, OfHeadersAreNoticed) {
    HistoryHeader no_rows = sample_header(), crossed = no_rows,
                  no_genes = no_rows, no_errors = no_rows, no_finals = no_rows;
    no_rows.population = 0;
    crossed.genes[0].lower = 2;
    no_genes.genes.clear();
    no_errors.schema.randomisations = 0;
    no_finals.final_randomisations = 0;
    expect_noticed({
        {"header.population > 0 && header.generations > 0",
         [=] { create(no_rows); }},
        {"header.finalists >= 0 && header.final_randomisations > 0",
         [=] { create(no_finals); }},
        {"gene.lower <= gene.upper", [=] { create(crossed); }},
        {"!genes.empty() && !schema.objectives.empty()",
         [=] { create(no_genes); }},
        {"schema.randomisations > 0", [=] { create(no_errors); }},
    });
}

TEST(Contracts, OfGenerationsAreNoticed) {
    const std::string sum(checksum_size, '0');
    expect_noticed({
        {"generation < most()",
         [] { with_generations([](const auto& it) { it.span(5); }); }},
        {"generation < most() && span.count > 0",
         [] { with_generations([](auto& it) {
                  it.set_span(5, {0, 4});
              }); }},
        {"generation < most() && span.count > 0",
         [] { with_generations([](auto& it) {
                  it.set_span(1, {4, 0});
              }); }},
        {"span.first == (generation == 0 ? 0 : this->span(generation - "
         "1).end())",
         [] { with_generations([](auto& it) {
                  it.set_span(1, {5, 4});
              }); }},
        {"count <= most()",
         [] { with_generations([](const auto& it) { it.read(6); }); }},
        {"summary.best_slot < span(generation).count",
         [] {
             with_generations([](auto& it) { it.write(0, {.best_slot = 4}); });
         }},
        {"checksum.size() == checksum_size",
         [] { with_generations([](auto& it) { it.set_checksum(0, "f"); }); }},
        {"generation == 0 || committed_.read<std::int8_t>(generation - 1, "
         "1)[0] != 0",
         [] { with_generations([](auto& it) { it.set_committed(1); }); }},
        {"span(generation).count > 0",
         [] {
             with_generations([](auto& it) {
                 it.set_committed(0);
                 it.set_committed(1);
             });
         }},
    });
}

TEST(Contracts, OfRowsAreNoticed) {
    Candidate short_one = sample_candidate(0, 0);
    short_one.genome.pop_back();
    Outcome proposed = sample_outcome(0, 0), lacking = proposed;
    proposed.status = Status::proposed;
    lacking.quantities.pop_back();
    expect_noticed({
        {"candidate.genome.size() == genome_.width()",
         [=] { with_columns([&](auto& it) { it.write(0, {short_one}); }); }},
        {"is_recorded(outcome.status)",
         [=] {
             with_columns(
                 [&](auto& it) { it.write_outcomes(0, row_of(proposed)); });
         }},
        {"has_form(schema, outcome)",
         [=] {
             with_columns(
                 [&](auto& it) { it.write_outcomes(0, row_of(lacking)); });
         }},
        {"checksum.size() == checksum_size",
         [] { with_columns([](auto& it) { it.set_checksum(0, ""); }); }},
        {"is_recorded(status)",
         [] {
             const Parts parts;
             finalist_checksum(parts.file(), 0, Status::empty);
         }},
        {"rows.count > 0",
         [] {
             const Parts parts;
             const Handle file = parts.file();
             GenerationChecksums(file, nullptr).of(1, {4, 0});
         }},
    });
}

TEST(Contracts, OfDatasetsAreNoticed) {
    const auto with_genomes = [](auto action) {
        const Parts parts;
        const Handle file = parts.file();
        Dataset genomes(file, "evaluations/genome");
        action(genomes);
    };
    expect_noticed({
        {"count % width_ == 0",
         [=] {
             with_genomes([](Dataset& it) {
                 it.write(0, std::vector{1., 2.});
             });
         }},
        {"width_ == 1",
         [=] { with_genomes([](Dataset& it) { it.read_text(0, 1); }); }},
        {"id_ >= 0", [] { Handle().close("close nothing"); }},
        {"!name.empty() && value != nullptr",
         [] {
             const Parts parts;
             create_attribute(parts.file(), "none", H5T_NATIVE_INT, nullptr);
         }},
        {"!form.name.empty() && form.type >= 0",
         [] {
             const Parts parts;
             create_dataset(parts.file(), {.name = "untyped"});
         }},
    });
}

TEST(Contracts, OfHistoriesAreNoticed) {
    expect_noticed({
        {"!candidates.empty()",
         [] { with_history([](auto& it) { it.propose(0, 4, 0, {}); }); }},
        {"slot + candidates.size() <= size",
         [] {
             with_history(
                 [](auto& it) { it.propose(0, 4, 1, sample_candidates(0)); });
         }},
        {"seconds >= 0",
         [] { with_history([](auto& it) { it.set_wall_time(-1); }); }},
        {"!reason.empty()",
         [] { with_history([](auto& it) { it.finish(""); }); }},
        {"reason.size() <= reason_size",
         [] {
             with_history([](auto& it) { it.finish(std::string(65, 'r')); });
         }},
        {"!session.started.empty() && session.ranks > 0",
         [] {
             with_history([](auto& it) {
                 it.begin_session({"", "node", "run", 1});
             });
         }},
        {"!session.started.empty() && session.ranks > 0",
         [] {
             with_history([](auto& it) {
                 it.begin_session({"now", "node", "run", 0});
             });
         }},
    });
}

}  // namespace ideotype
