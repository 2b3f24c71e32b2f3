// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "campaign/schema/schema.hpp"
#include "ideotype/core/text.hpp"
#include "measured_plant.hpp"

namespace ideotype {

namespace {

//! Limits of heights above the soil [m]; a tip may hang below the foot of a
//! plant on a ridge.
constexpr Range height_limits{-1, 10};

//! A column of the table; without a kind, it has ranks or is unknown.
struct ReadColumn {
    std::string name;
    const LeafColumn* kind = nullptr;
};

class LeafReader {
  public:
    LeafReader(const std::string& text, const std::string& file,
               const Problems& problems)
        : text_(text), file_(file), problems_(problems) {}

    LeafTable read() {
        int number = 0;
        for (const std::string_view line : lines_of(text_)) {
            ++number;
            const std::size_t first = line.find_first_not_of(" \t,;\"");
            if (first == line.npos || line[first] == '#') continue;
            const Location where{file_, number, 1};
            if (table_.header.line == 0)
                read_header(line, where);
            else if (table_.rows.size() == most_leaves) {
                add(where, fmt::format("there are more leaves than {} (the "
                                       "limit of a plant); remove some",
                                       most_leaves));
                break;
            } else
                read_row(line, where);
        }
        if (table_.header.line == 0) table_.header = {file_, 1, 1};
        if (table_.rows.empty())
            add(table_.header,
                "there are no leaves (a table has a line with the names of its "
                "columns, then one for each leaf); add them");
        sort_by_rank();
        return std::move(table_);
    }

  private:
    void add(const Location& where, const std::string& what) {
        problems_.add(where, what);
    }

    void read_header(std::string_view line, const Location& where) {
        table_.header = where;
        if (line.find(',') == line.npos &&
            line.find_first_of(";\t") != line.npos)
            return add(where,
                       "columns are not separated by commas (numbers "
                       "have a decimal point, so that a comma ends an "
                       "entry); save the table with commas");
        for (const CsvField& field : fields_of(line)) {
            columns_.push_back({std::string(field.text), nullptr});
            ReadColumn& column = columns_.back();
            const auto kind =
                std::ranges::find(leaf_columns, column.name, &LeafColumn::name);
            const Location place{file_, where.line, field.column};
            if (kind != std::end(leaf_columns))
                choose(column, *kind, place);
            else if (column.name == rank_column)
                has_ranks_ = true;
            else {
                table_.has.fill(true);
                add(place, unknown(column.name));
            }
        }
    }

    void choose(ReadColumn& column, const LeafColumn& kind,
                const Location& place) {
        for (const ReadColumn& each : columns_)
            if (each.kind && each.kind->value == kind.value)
                return add(place, fmt::format("{} is given twice ({} too); "
                                              "remove one of the columns",
                                              column.name, each.name));
        column.kind = &kind;
        table_.has[index_of(kind.value)] = true;
        if (!kind.is_from_north) return;
        const auto note = note_of(text_, file_, "row_direction");
        const auto direction =
            note ? number_of(note->text) : std::optional<double>();
        if (direction && *direction >= 0 && *direction <= 360)
            row_direction_ = *direction;
        else
            add(note ? note->where : place,
                "azimuth_from_north_deg needs the direction of the rows in "
                "which the plants stood (0 .. 360 deg clockwise from north); "
                "write a line such as # row_direction: 90");
    }

    std::string unknown(const std::string& name) const {
        for (const Measure<Leaf>& each : leaf_measures)
            if (name == each.name)
                return fmt::format(
                    "column '{}' has no unit; name it {}_{}", name, name,
                    std::string_view(each.unit) == "m" ? "cm" : each.unit);
        std::vector<std::string> names{rank_column};
        for (const LeafColumn& each : leaf_columns) names.push_back(each.name);
        return fmt::format("there is no column '{}'; {}", name,
                           did_you_mean(name, names));
    }

    void read_row(std::string_view line, const Location& where) {
        if (columns_.empty()) return;
        const std::vector<CsvField> fields = fields_of(line);
        if (fields.size() != columns_.size())
            return add(where,
                       fmt::format("there are {} entries (the table has {} "
                                   "columns); give each column one",
                                   fields.size(), columns_.size()));
        table_.rows.push_back(
            {where, static_cast<int>(table_.rows.size()) + 1, {}, {}});
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const ReadColumn& column = columns_[i];
            if (column.kind || column.name == rank_column)
                read_entry(column, fields[i],
                           {file_, where.line, fields[i].column});
        }
    }

    void read_entry(const ReadColumn& column, const CsvField& field,
                    const Location& place) {
        LeafRow& row = table_.rows.back();
        const std::optional<double> number = number_of(field.text);
        if (!number || !std::isfinite(*number))
            return add(
                place,
                fmt::format("{} is \"{}\" (which is no number); write one with "
                            "a decimal point, or leave the column out",
                            column.name, field.text));
        if (!column.kind) return read_rank(*number, place);
        const LeafColumn& kind = *column.kind;
        const Measure<Leaf>& measure = leaf_measures[index_of(kind.value)];
        double value = (kind.zero + kind.sign * *number) / kind.per_unit;
        Range limits =
            kind.height == LeafHeight::none ? measure.limits : height_limits;
        if (kind.value == &Leaf::azimuth) {
            limits.lower = -limits.upper;
            if (std::abs(*number) <= limits.upper)
                value = std::fmod(
                    value - (kind.is_from_north ? row_direction_ : 0) +
                        2 * limits.upper,
                    limits.upper);
        }
        const bool is_inside =
            kind.value == &Leaf::azimuth
                ? std::abs(*number) <= limits.upper
                : value >= limits.lower && value <= limits.upper;
        if (!is_inside)
            return add(
                place,
                fmt::format("{} is {} (expected: {} .. {}); check the "
                            "unit and the convention of the column",
                            column.name, *number, limits.lower * kind.per_unit,
                            limits.upper * kind.per_unit));
        row.of_height = std::max(row.of_height, kind.height);
        if (kind.height == LeafHeight::none)
            row.leaf.*kind.value = value;
        else
            row.height = value;
        row.places[index_of(kind.value)] = place;
    }

    void read_rank(double number, const Location& place) {
        if (number != std::round(number) || number < 1 || number > most_leaves)
            add(place, fmt::format("leaf is {} (expected: 1 for the lowest, 2 "
                                   "for the next, at most {}); correct it",
                                   number, most_leaves));
        else
            table_.rows.back().rank = static_cast<int>(number);
    }

    void sort_by_rank() {
        std::ranges::stable_sort(table_.rows, {}, &LeafRow::rank);
        for (std::size_t i = 0; has_ranks_ && i < table_.rows.size(); ++i) {
            const int expected = static_cast<int>(i) + 1;
            if (table_.rows[i].rank == expected) continue;
            return add(
                table_.rows[i].where,
                table_.rows[i].rank < expected
                    ? fmt::format("leaf {} is given twice (each leaf has one "
                                  "line); remove one of the lines",
                                  table_.rows[i].rank)
                    : fmt::format("leaf {} is missing (leaves are "
                                  "counted from the lowest, 1); add it "
                                  "or count anew",
                                  expected));
        }
    }

    const std::string& text_;
    const std::string& file_;
    const Problems& problems_;
    LeafTable table_;  //!< table; header line 0: not read yet
    std::vector<ReadColumn> columns_;
    bool has_ranks_ = false;
    double row_direction_ = 0;  //!< azimuth of the row [deg]
};

}  // namespace

LeafTable read_leaf_table(const std::string& text, const std::string& file,
                          const Problems& problems) {
    return LeafReader(text, file, problems).read();
}

std::optional<Written> note_of(const std::string& text, const std::string& file,
                               const std::string& name) {
    int number = 0;
    for (const std::string_view line : lines_of(text)) {
        ++number;
        const std::size_t mark = line.find_first_not_of(" \t\"");
        if (mark == line.npos || line[mark] != '#') continue;
        const std::size_t begin = line.find_first_not_of(" \t", mark + 1);
        if (begin == line.npos || !line.substr(begin).starts_with(name + ':'))
            continue;
        // Spreadsheet programs fill up lines with commas and quote texts.
        constexpr auto around = " \t\",;";
        const std::size_t from =
            line.find_first_not_of(around, begin + name.size() + 1);
        if (from == line.npos) continue;
        const std::size_t last = line.find_last_not_of(around);
        return Written{std::string(line.substr(from, last - from + 1)),
                       {file, number, static_cast<int>(from) + 1}};
    }
    return std::nullopt;
}

}  // namespace ideotype
