// SPDX-License-Identifier: Apache-2.0
#include "history_file.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include <fmt/format.h>

#include "checksum.hpp"
#include "disk/open.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

// Compares bits, since two equal zeros may differ in sign, and NaN never
// compares equal.
bool has_same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

//! Describes the first gene, origin or parent in which two candidates differ in
//! any bit, with both values; returns "" if the candidates are identical.
std::string find_difference(const GeneSpace& genes, const Candidate& was,
                            const Candidate& is) {
    IDEOTYPE_EXPECT(was.genome.size() == genes.size() &&
                    is.genome.size() == genes.size());
    for (std::size_t i = 0; i < genes.size(); ++i)
        if (!has_same_bits(was.genome[i], is.genome[i]))
            return fmt::format("gene {} was {}, is {} [{}]", genes[i].name,
                               was.genome[i], is.genome[i], genes[i].unit);
    if (was.origin != is.origin)
        return fmt::format("its origin was {}, is {}", name_of(was.origin),
                           name_of(is.origin));
    if (was.parents != is.parents)
        return fmt::format("its parents were {} and {}, are {} and {}",
                           was.parents[0], was.parents[1], is.parents[0],
                           is.parents[1]);
    return "";
}

}  // namespace

History::File::File(std::string name, std::optional<FileLock> held,
                    Handle opened)
    : path(std::move(name)),
      lock(std::move(held)),
      id(std::move(opened)),
      mapping(lock ? Mapping::create(id) : nullptr),
      header(read_header(id)),
      evaluations(id, "evaluations", header.schema),
      finals(id, "final", header.final_schema()),
      generations(id),
      journal(id),
      checksums(id, mapping.get()),
      next_generation(generations.committed()) {
    if (mapping)
        for (Columns* columns : {&evaluations, &finals}) columns->use(*mapping);
    for (std::uint32_t g = 0; lock && g < generations.capacity(); ++g) {
        const Span next = generations.span(g);
        if (next.count == 0) break;
        spans.push_back(next);
    }
    IDEOTYPE_ENSURE(!lock || next_generation <= spans.size());
}

Span History::File::span(std::uint32_t generation) const {
    if (generation >= generations.capacity())
        fail(fmt::format("this history has no generation {}", generation));
    if (!lock) return read([&] { return generations.span(generation); });
    return generation < spans.size() ? spans[generation] : Span{};
}

hsize_t History::File::row(std::uint32_t generation, std::uint32_t slot) const {
    const Span rows = span(generation);
    if (slot >= rows.count)
        fail(fmt::format("this history has no generation {} slot {}",
                         generation, slot));
    return rows.first + slot;
}

void History::File::synchronize_each_second() {
    const auto now = std::chrono::steady_clock::now();
    if (now - synchronized < std::chrono::seconds(1)) return;
    synchronize(id);
    synchronized = now;
}

void History::File::require_genes(
    const std::vector<Candidate>& candidates) const {
    for (const Candidate& candidate : candidates)
        if (candidate.genome.size() != header.genes.size())
            fail(fmt::format("a genome has {} genes instead of {}",
                             candidate.genome.size(), header.genes.size()));
}

std::size_t History::File::propose(Columns& columns, const std::string& label,
                                   std::uint32_t first_slot, hsize_t first,
                                   const std::vector<Candidate>& candidates) {
    const auto statuses =
        read([&] { return columns.statuses(first, candidates.size()); });
    const auto known = static_cast<std::size_t>(
        std::find(statuses.begin(), statuses.end(), Status::empty) -
        statuses.begin());
    const auto stored = read([&] { return columns.candidates(first, known); });
    for (std::size_t i = 0; i < known; ++i) {
        const std::string difference =
            find_difference(header.genes, stored[i], candidates[i]);
        if (difference.empty()) continue;
        fail(fmt::format("{} {} differs from the stored candidate: {}; resume "
                         "with the program and campaign that started the case",
                         label, first_slot + i, difference),
             ExitCode::refused);
    }
    if (known == candidates.size()) return known;
    const std::vector<Candidate> rest(
        candidates.begin() + static_cast<std::ptrdiff_t>(known),
        candidates.end());
    const std::vector<Status> proposed(rest.size(), Status::proposed);
    write([&] {
        columns.write(first + known, rest);
        columns.set_statuses(first + known, proposed);
    });
    return known;
}

void History::File::record(Columns& columns, const std::string& label,
                           hsize_t row, const Outcome& outcome,
                           std::uint32_t attempt) {
    check(label, columns.schema(), outcome);
    const Status status = read([&] { return columns.statuses(row, 1)[0]; });
    if (status != Status::proposed)
        fail(label + (status == Status::empty ? " was never proposed"
                                              : " is recorded already"),
             ExitCode::refused);
    write([&] {
        columns.write_outcomes(row, {{{}, outcome, attempt}});
        if (&columns == &finals)
            columns.set_checksum(row,
                                 finalist_checksum(id, row, outcome.status));
        // Do not flush: rows are never buffered, and each write has reached the
        // operating system when it returns. A flush would search all datasets
        // in vain.
        columns.set_statuses(row, {outcome.status});
    });
}

//! Checks that a mapped file has not been truncated, since its lost pages must
//! not be accessed.
void History::File::require_whole() const {
    if (mapping && !mapping->is_whole())
        fail(
            "this file was cut short while it was written (and nothing more "
            "can be saved in it); start again in another folder with --out",
            ExitCode::refused);
}

void History::File::require_in_place() const {
    require_whole();
    if (!is_at(path, get_descriptor(id)))
        fail(
            "this file was deleted, moved or replaced while it was written "
            "(and nothing more can be saved in it); put it back if it was "
            "moved, then continue with --resume",
            ExitCode::refused);
}

void History::File::fail_to_write(const Hdf5Error& error) const {
    const std::string lacking = lacking_space(path);
    fail(
        fmt::format("{}{}; all rows recorded before are safe; free disk space, "
                    "then continue with --resume",
                    error.what(), lacking.empty() ? "" : "; " + lacking));
}

void History::File::check(const std::string& label, const OutcomeSchema& schema,
                          const Outcome& outcome) const {
    if (!is_recorded(outcome.status))
        fail(label + ": the status of an outcome must be done or failed");
    // The numbers of a failed outcome are not stored.
    if (outcome.status == Status::done && !has_form(schema, outcome))
        fail(label + ": an outcome does not have the history's columns");
}

}  // namespace ideotype
