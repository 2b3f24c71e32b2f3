// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/schema/schema.hpp"
#include "ideotype/core/text.hpp"
#include "measured_plant.hpp"

namespace ideotype {

namespace {

//! Limits of heights above the soil [m]; a tip may hang below the foot of a
//! plant on a ridge.
constexpr Range height_limits{-1, 10};

//! A column of the table; without a kind, it has ranks or plants or is unknown.
struct ReadColumn {
    std::string name;
    const LeafColumn* kind = nullptr;
};

bool names_plants(const std::string& column) {
    return std::ranges::find(plant_columns, column) != std::end(plant_columns);
}

//! Returns the names of all columns, units of a measure together:
//! "length_cm/_m/_mm".
std::string known_columns() {
    std::string all =
        fmt::format("{}, {}", rank_column, fmt::join(plant_columns, " or "));
    std::string_view last;
    for (const LeafColumn& each : leaf_columns) {
        const std::string_view name = each.name;
        const std::size_t unit = name.rfind('_');
        const bool is_unit = name.substr(0, unit) == last;
        all += is_unit ? "/" : ", ";
        all += is_unit ? name.substr(unit) : name;
        last = name.substr(0, unit);
    }
    return all;
}

class LeafReader {
  public:
    LeafReader(const std::string& text, const std::string& file,
               const std::string& plant, const Problems& problems)
        : text_(text), file_(file), plant_(plant), problems_(problems) {}

    LeafTable read() {
        int number = 0;
        for (const std::string_view line : lines_of(text_)) {
            ++number;
            const std::size_t first = line.find_first_not_of(" \t,;\"");
            if (first == line.npos || line[first] == '#') continue;
            const Location where{file_, number, 1};
            if (table_.header.line == 0)
                read_header(line, where);
            else if (!read_row(line, where))
                break;
        }
        if (table_.header.line == 0) table_.header = {file_, 1, 1};
        if (plant_at_) check_plants();
        if (table_.rows.empty() && table_.plants.empty())
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
        std::vector<std::string> strange;
        Location first_strange;
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
            else if (names_plants(column.name))
                choose_plants(column, place);
            else {
                table_.has.fill(true);
                const std::string remedy = remedy_for(column.name);
                if (!remedy.empty())
                    add(place, remedy);
                else if (strange.push_back(column.name); strange.size() == 1)
                    first_strange = place;
            }
        }
        if (!strange.empty())
            add(first_strange,
                fmt::format(
                    "there {} '{}' (a table has one line for each leaf "
                    "of a plant); columns are {}",
                    strange.size() == 1 ? "is no column" : "are no columns",
                    fmt::join(strange, "', '"), known_columns()));
    }

    //! Requires that the table has the chosen plant or, without a choice, no
    //! other.
    void check_plants() {
        constexpr std::size_t shown = 5;
        std::vector<std::string>& plants = table_.plants;
        std::string names = fmt::format(
            "{}{}", fmt::join(plants | std::views::take(shown), ", "),
            plants.size() > shown ? ", ..." : "");
        if (plant_.empty() && plants.size() > 1)
            add(table_.header,
                fmt::format("the table has {} plants ({}), but one is needed "
                            "here; choose it by a line such as # plant: {}, "
                            "or give the table to ideotype compare, which "
                            "takes all",
                            plants.size(), names, plants.front()));
        else if (!plant_.empty() && !plants.empty() &&
                 std::ranges::find(plants, plant_) == plants.end()) {
            const std::string nearest = nearest_name(plant_, plants);
            add(table_.header,
                fmt::format("there is no plant '{}' (the table has {}); {}",
                            plant_, names,
                            nearest.empty()
                                ? "correct # plant"
                                : "did you mean '" + nearest + "'?"));
        } else if (!plants.empty())
            table_.plant = plant_.empty() ? plants.front() : plant_;
    }

    void choose_plants(const ReadColumn& column, const Location& place) {
        if (plant_at_)
            add(place, fmt::format("{} is given twice ({} too); remove one of "
                                   "the columns",
                                   column.name, columns_[*plant_at_].name));
        plant_at_ = columns_.size() - 1;
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

    //! Returns the message on an unknown column that resembles a known one, or
    //! else an empty text.
    static std::string remedy_for(const std::string& name) {
        for (const Measure<Leaf>& each : leaf_measures)
            if (name == each.name)
                return fmt::format(
                    "column '{}' has no unit; name it {}_{}", name, name,
                    std::string_view(each.unit) == "m" ? "cm" : each.unit);
        std::vector<std::string> names{rank_column};
        for (const LeafColumn& each : leaf_columns) names.push_back(each.name);
        const std::string nearest = nearest_name(name, names);
        return nearest.empty()
                   ? ""
                   : fmt::format("there is no column '{}'; did you mean '{}'?",
                                 name, nearest);
    }

    //! Returns whether the plant has room for further leaves.
    bool read_row(std::string_view line, const Location& where) {
        if (columns_.empty()) return true;
        const std::vector<CsvField> fields = fields_of(line);
        if (fields.size() != columns_.size()) {
            add(where, fmt::format("there are {} entries (the table has {} "
                                   "columns); give each column one",
                                   fields.size(), columns_.size()));
            return true;
        }
        if (plant_at_ && !is_of_plant(fields[*plant_at_], where)) return true;
        if (table_.rows.size() == most_leaves) {
            add(where, fmt::format("there are more leaves than {} (the limit "
                                   "of a plant); remove some",
                                   most_leaves));
            return false;
        }
        table_.rows.push_back(
            {where, static_cast<int>(table_.rows.size()) + 1, {}, {}});
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const ReadColumn& column = columns_[i];
            if (column.kind || column.name == rank_column)
                read_entry(column, fields[i],
                           {file_, where.line, fields[i].column});
        }
        return true;
    }

    //! Returns whether a line belongs to the plant that is read: the chosen one
    //! or else the first.
    bool is_of_plant(const CsvField& field, const Location& where) {
        const std::string name(field.text);
        if (name.empty())
            add({file_, where.line, field.column},
                fmt::format("{} is empty; name the plant of the leaf",
                            columns_[*plant_at_].name));
        else if (std::ranges::find(table_.plants, name) == table_.plants.end())
            table_.plants.push_back(name);
        return name == (plant_.empty() && !table_.plants.empty()
                            ? table_.plants.front()
                            : plant_);
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

    //! Sorts leaves and numbers them from 1. Field books count the leaves of a
    //! plant from the first that it had, so that the lowest living leaf may
    //! have any rank.
    void sort_by_rank() {
        auto& rows = table_.rows;
        std::ranges::stable_sort(rows, {}, &LeafRow::rank);
        if (!has_ranks_ || rows.empty()) return;
        const int lowest = rows.front().rank;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const int expected = lowest + static_cast<int>(i);
            if (rows[i].rank == expected) continue;
            return add(rows[i].where,
                       rows[i].rank < expected
                           ? fmt::format("leaf {} is given twice (each leaf "
                                         "has one line); remove one of the "
                                         "lines",
                                         rows[i].rank)
                           : fmt::format("leaf {} is missing (the lowest is "
                                         "{}, and ranks have no gaps); add it "
                                         "or renumber the leaves",
                                         expected, lowest));
        }
        if (lowest > 1)
            problems_.warn(Problem{
                rows.front().where,
                fmt::format("leaves {} .. {} of this table become leaves 1 .. "
                            "{} (the lowest leaf has rank 1, and lower leaves "
                            "are taken as absent)",
                            lowest, rows.back().rank, rows.size())});
        for (LeafRow& row : rows) row.rank -= lowest - 1;
    }

    const std::string& text_;
    const std::string& file_;
    const std::string& plant_;
    const Problems& problems_;
    LeafTable table_;  //!< table; header line 0: not read yet
    std::vector<ReadColumn> columns_;
    std::optional<std::size_t> plant_at_;  //!< column that names plants
    bool has_ranks_ = false;
    double row_direction_ = 0;  //!< azimuth of the row [deg]
};

}  // namespace

LeafTable read_leaf_table(const std::string& text, const std::string& file,
                          const std::string& plant, const Problems& problems) {
    return LeafReader(text, file, plant, problems).read();
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
