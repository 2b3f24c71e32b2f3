// SPDX-License-Identifier: Apache-2.0
#include "history.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "disk/open.hpp"
#include "history_file.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

History::History(std::unique_ptr<File> file) : file_(std::move(file)) {}
History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

History::~History() = default;

std::string History::library_version() {
    return fmt::format("HDF5 {}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR,
                       H5_VERS_RELEASE);
}

OutcomeSchema HistoryHeader::final_schema() const {
    OutcomeSchema final = schema;
    final.randomisations = final_randomisations;
    return final;
}

const HistoryHeader& History::header() const {
    return file_->header;
}

std::uint32_t History::whole_generations() const {
    std::uint32_t count = 0;
    while (count < next_generation() &&
           file_->span(count).end() <= file_->evaluations.whole_rows())
        ++count;
    return count;
}

std::uint64_t History::missing_bytes() const {
    return file_->missing_bytes;
}

void History::begin_session(const SessionRecord& session) {
    file_->write([&] {
        file_->journal.add(session);
        if (!file_->lock->is_exclusive())
            file_->journal.add(
                "this file system has no locks: make sure that no other host "
                "resumes this case at the same time");
        flush(file_->id);
    });
}

std::optional<SessionRecord> History::last_session() const {
    return file_->read([&] { return file_->journal.last_session(); });
}

std::uint64_t History::evaluated() const {
    const auto recorded = [&](const Columns& columns) {
        const auto statuses =
            file_->read([&] { return columns.statuses(0, columns.rows()); });
        return std::count_if(statuses.begin(), statuses.end(), is_recorded);
    };
    return static_cast<std::uint64_t>(recorded(file_->evaluations) +
                                      recorded(file_->finals));
}

std::uint32_t History::next_generation() const {
    // A writer knows the number. While a reader has the file open, the number
    // may grow.
    if (file_->lock) return file_->next_generation;
    std::uint32_t count =
        file_->read([&] { return file_->generations.committed(); });
    if (file_->missing_bytes > 0)
        while (count > 0 &&
               file_->span(count - 1).end() > file_->evaluations.intact_rows())
            --count;
    return count;
}

std::size_t History::propose(std::uint32_t generation, std::size_t size,
                             std::uint32_t slot,
                             const std::vector<Candidate>& candidates) {
    IDEOTYPE_EXPECT(!candidates.empty());
    IDEOTYPE_EXPECT(slot + candidates.size() <= size);
    file_->require_genes(candidates);
    // The rows of a generation follow those of the previous generation.
    const Span before = generation == 0 ? Span{} : file_->span(generation - 1);
    if (generation > 0 && before.count == 0)
        file_->fail_incomplete(generation - 1);
    const Span rows{before.end(), size};
    const Span known = file_->span(generation);
    if (rows.end() > file_->evaluations.rows())
        file_->fail(
            fmt::format("there is no room for the {} rows of "
                        "generation {}",
                        rows.count, generation));
    if (known.count != 0 && known.count != rows.count)
        file_->fail(fmt::format("generation {} had {} candidates before, not "
                                "{}; resume with the program and campaign that "
                                "started the case",
                                generation, known.count, rows.count),
                    ExitCode::refused);
    if (known.count == 0) {
        file_->write([&] { file_->generations.set_span(generation, rows); });
        file_->spans.push_back(rows);
    }
    return file_->propose(file_->evaluations,
                          fmt::format("generation {} slot", generation), slot,
                          rows.first + slot, candidates);
}

bool History::has_room(std::uint32_t generation, std::size_t size) const {
    const hsize_t first =
        generation == 0 ? 0 : file_->span(generation - 1).end();
    return first + size <= file_->evaluations.rows();
}

void History::record(std::uint32_t generation, std::uint32_t slot,
                     const Outcome& outcome, std::uint32_t attempt) {
    file_->record(file_->evaluations,
                  fmt::format("generation {} slot {}", generation, slot),
                  file_->row(generation, slot), outcome, attempt);
}

Row History::row(std::uint32_t generation, std::uint32_t slot) const {
    const hsize_t position = file_->row(generation, slot);
    return file_->read([&] { return file_->evaluations.read(position, 1)[0]; });
}

std::vector<Row> History::rows(std::uint32_t generation) const {
    const Span span = file_->span(generation);
    auto rows = file_->read(
        [&] { return file_->evaluations.read(span.first, span.count); });
    for (const Row& row : rows)
        if (!is_recorded(row.outcome.status))
            file_->fail_incomplete(generation);
    return rows;
}

std::uint32_t History::size(std::uint32_t generation) const {
    return static_cast<std::uint32_t>(file_->span(generation).count);
}

std::uint64_t History::plants() const {
    const std::uint32_t complete = next_generation();
    return complete == 0 ? 0 : file_->span(complete - 1).end();
}

Population History::generation(std::uint32_t generation) const {
    const Span span = file_->span(generation);
    Population population = file_->read(
        [&] { return file_->evaluations.population(span.first, span.count); });
    for (const Individual& individual : population)
        if (!is_recorded(individual.status)) file_->fail_incomplete(generation);
    return population;
}

void History::commit(std::uint32_t generation,
                     const GenerationSummary& summary) {
    if (generation != file_->next_generation)
        file_->fail(fmt::format("generation {} is the next to commit, not {}",
                                file_->next_generation, generation),
                    ExitCode::refused);
    const Span rows = file_->span(generation);
    const auto statuses = file_->read(
        [&] { return file_->evaluations.statuses(rows.first, rows.count); });
    if (statuses.empty() ||
        !std::all_of(statuses.begin(), statuses.end(), is_recorded))
        file_->fail_incomplete(generation);
    file_->write([&] {
        Generations& generations = file_->generations;
        generations.write(generation, summary);
        generations.set_checksum(generation,
                                 file_->checksums.compute(generation, rows));
        flush(file_->id);
        generations.set_committed(generation);
        flush(file_->id);
        file_->synchronize_each_second();
    });
    ++file_->next_generation;
    IDEOTYPE_ENSURE(file_->next_generation <= file_->spans.size());
}

std::vector<GenerationSummary> History::summaries() const {
    return file_->read([&] {
        const Generations& generations = file_->generations;
        return generations.read(generations.committed());
    });
}

void History::propose_final(const std::vector<Candidate>& candidates) {
    if (candidates.size() > file_->finals.rows())
        file_->fail(fmt::format("there are {} finalists, but room for {} only",
                                candidates.size(), file_->finals.rows()));
    file_->require_genes(candidates);
    const std::size_t known = finalists().size();
    if (candidates.size() < known)
        file_->fail(
            fmt::format(
                "there are {} finalists, but there were {} before; resume with "
                "the program and campaign that started the case",
                candidates.size(), known),
            ExitCode::refused);
    file_->propose(file_->finals, "finalist", 0, 0, candidates);
}

std::vector<std::uint32_t> History::pending_final() const {
    const auto statuses = file_->read(
        [&] { return file_->finals.statuses(0, file_->finals.rows()); });
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < statuses.size(); ++slot)
        if (statuses[slot] == Status::proposed) slots.push_back(slot);
    return slots;
}

void History::record_final(std::uint32_t slot, const Outcome& outcome) {
    file_->record(file_->finals, fmt::format("finalist {}", slot), slot,
                  outcome, 1);
}

std::vector<Row> History::finalists() const {
    auto rows = file_->read(
        [&] { return file_->finals.read(0, file_->finals.rows()); });
    std::erase_if(rows, [](const Row& row) {
        return row.outcome.status == Status::empty;
    });
    return rows;
}

void History::require_in_place() const {
    file_->require_in_place();
}

double History::wall_time() const {
    return file_->read([&] { return file_->journal.wall_time(); });
}

void History::set_wall_time(double seconds) {
    IDEOTYPE_EXPECT(seconds >= 0);
    file_->write([&] {
        file_->journal.set_wall_time(seconds);
        flush(file_->id);
    });
}

void History::message(const std::string& text) {
    file_->write([&] {
        file_->journal.add(text);
        flush(file_->id);
    });
}

void History::finish(const std::string& reason) {
    IDEOTYPE_EXPECT(!reason.empty());
    file_->write([&] {
        file_->journal.set_reason(reason);
        flush(file_->id);
        file_->journal.set_finished();
        flush(file_->id);
        synchronize(file_->id);
    });
}

std::optional<std::string> History::finished() const {
    return file_->read([&] { return file_->journal.finished(); });
}

}  // namespace ideotype
