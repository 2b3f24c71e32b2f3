// SPDX-License-Identifier: Apache-2.0
#include "generations.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checksum.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

const std::string group_name = "generations";

template <class Value>
struct SummaryColumn {
    const char* name;
    const char* unit;  //!< unit; null: unit of the first objective
    const char* meaning;
    Value GenerationSummary::*member;
};

//! Stands for the product of the units of all objectives.
constexpr auto product = "product";

//! The number of trailing columns that exist only with several objectives.
constexpr std::size_t front_columns = 2;

using Summary = GenerationSummary;

constexpr auto number_columns = std::to_array<SummaryColumn<double>>(
    {{"best", nullptr, "first objective of the best row", &Summary::best},
     {"best_standard_error", nullptr,
      "standard error of the first objective of the best row",
      &Summary::best_standard_error},
     {"mean", nullptr,
      "mean of the first objective over rows that meet the constraints, or "
      "over all rows if none does",
      &Summary::mean},
     {"spread", nullptr,
      "standard deviation of the first objective over the same rows as mean",
      &Summary::spread},
     {"diversity", "1", "mean over free genes of standard deviation over range",
      &Summary::diversity},
     {"wall_time", "s", "time since the case began, summed over sessions",
      &Summary::wall_time},
     {"hypervolume", product,
      "hypervolume of the Pareto front of all rows so far",
      &Summary::hypervolume},
     {"hypervolume_standard_error", product,
      "standard error of hypervolume, by a jackknife over randomisations",
      &Summary::hypervolume_standard_error}});

constexpr auto integer_columns = std::to_array<SummaryColumn<std::uint32_t>>(
    {{"failures", "1", "number of rows that failed", &Summary::failures},
     {"evaluations", "1", "number of rows that were evaluated and not copied",
      &Summary::evaluations}});

std::string make_table_path(const std::string& name) {
    return group_name + "/" + name;
}

std::string choose_unit(const SummaryColumn<double>& column,
                        const std::vector<Objective>& objectives) {
    if (!column.unit) return objectives[0].unit;
    if (column.unit != product) return column.unit;
    return fmt::format("{}",
                       fmt::join(mapped(objectives, &Objective::unit), " "));
}

}  // namespace

void Generations::create(hid_t file, const HistoryHeader& header) {
    IDEOTYPE_EXPECT(header.generations > 0);
    IDEOTYPE_EXPECT(!header.schema.objectives.empty());
    const double missing = std::numeric_limits<double>::quiet_NaN();
    const Handle group = create_group(file, group_name);
    create_axis(group, counted("generation", "counted from 0",
                               static_cast<std::size_t>(header.generations)));
    const auto add = [&](const std::string& name, hid_t type,
                         const std::string& unit, const std::string& meaning,
                         const void* empty = nullptr) {
        create_dataset(group, {.name = name,
                               .type = type,
                               .axes = {"generation"},
                               .unit = unit,
                               .meaning = meaning,
                               .empty = empty});
    };
    const std::int64_t none = -1;
    add("committed", bool_type(), "1", "whether the generation is complete");
    add("first_row", H5T_STD_I64LE, "1",
        "first row of the generation in /evaluations");
    add("count", H5T_STD_U32LE, "1", "number of rows of the generation");
    add("best_row", H5T_STD_I64LE, "1",
        "best row of the generation in /evaluations", &none);
    const auto& objectives = header.schema.objectives;
    const std::size_t count =
        number_columns.size() - (objectives.size() > 1 ? 0 : front_columns);
    for (const auto& column : std::span(number_columns).first(count))
        add(column.name, H5T_IEEE_F64LE, choose_unit(column, objectives),
            column.meaning, &missing);
    for (const auto& column : integer_columns)
        add(column.name, H5T_STD_U32LE, column.unit, column.meaning);
    add("checksum", string_type(checksum_size), "",
        "SHA-256 of the rows and this summary");
}

Generations::Generations(hid_t file)
    : committed_(file, make_table_path("committed")),
      first_row_(file, make_table_path("first_row")),
      count_(file, make_table_path("count")),
      best_row_(file, make_table_path("best_row")),
      checksum_(file, make_table_path("checksum")) {
    for (const auto& column : number_columns)
        if (exists(file, make_table_path(column.name)))
            numbers_.emplace_back(file, make_table_path(column.name));
    for (const auto& column : integer_columns)
        counts_.emplace_back(file, make_table_path(column.name));
}

std::uint32_t Generations::committed() const {
    const auto flags = committed_.read<std::int8_t>(0, committed_.rows());
    std::uint32_t count = 0;
    while (count < flags.size() && flags[count] != 0) ++count;
    return count;
}

Span Generations::span(std::uint32_t generation) const {
    IDEOTYPE_EXPECT(generation < capacity());
    return {
        static_cast<hsize_t>(first_row_.read<std::int64_t>(generation, 1)[0]),
        count_.read<std::uint32_t>(generation, 1)[0]};
}

void Generations::set_span(std::uint32_t generation, const Span& span) {
    IDEOTYPE_EXPECT(generation < capacity() && span.count > 0);
    IDEOTYPE_EXPECT(span.first ==
                    (generation == 0 ? 0 : this->span(generation - 1).end()));
    first_row_.write_one(generation, static_cast<std::int64_t>(span.first));
    count_.write_one(generation, static_cast<std::uint32_t>(span.count));
}

std::vector<GenerationSummary> Generations::read(std::uint32_t count) const {
    IDEOTYPE_EXPECT(count <= capacity());
    std::vector<GenerationSummary> summaries(count);
    const auto first = first_row_.read<std::int64_t>(0, count);
    const auto best = best_row_.read<std::int64_t>(0, count);
    for (std::size_t g = 0; g < count; ++g)
        summaries[g].best_slot = static_cast<std::uint32_t>(best[g] - first[g]);
    const auto fill = [&]<class Value>(const Dataset& dataset,
                                       Value GenerationSummary::*member) {
        const auto values = dataset.read<Value>(0, count);
        for (std::size_t g = 0; g < count; ++g)
            summaries[g].*member = values[g];
    };
    for (std::size_t i = 0; i < numbers_.size(); ++i)
        fill(numbers_[i], number_columns[i].member);
    for (std::size_t i = 0; i < counts_.size(); ++i)
        fill(counts_[i], integer_columns[i].member);
    return summaries;
}

void Generations::set_checksum(std::uint32_t generation,
                               const std::string& checksum) {
    IDEOTYPE_EXPECT(checksum.size() == checksum_size);
    checksum_.write_text(generation, checksum);
}

void Generations::set_committed(std::uint32_t generation) {
    IDEOTYPE_EXPECT(generation == 0 ||
                    committed_.read<std::int8_t>(generation - 1, 1)[0] != 0);
    IDEOTYPE_EXPECT(span(generation).count > 0);
    committed_.write_one(generation, std::int8_t{1});
}

void Generations::write(std::uint32_t generation,
                        const GenerationSummary& summary) {
    IDEOTYPE_EXPECT(summary.best_slot < span(generation).count);
    best_row_.write_one(
        generation,
        static_cast<std::int64_t>(span(generation).first) + summary.best_slot);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
        numbers_[i].write_one(generation, summary.*number_columns[i].member);
    for (std::size_t i = 0; i < counts_.size(); ++i)
        counts_[i].write_one(generation, summary.*integer_columns[i].member);
}

}  // namespace ideotype
