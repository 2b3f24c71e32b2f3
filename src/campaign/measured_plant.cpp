// SPDX-License-Identifier: Apache-2.0
#include "measured_plant.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "ideotype/crop/measures.hpp"
#include "leaf_table.hpp"
#include "nodes.hpp"

namespace ideotype {

namespace {

double highest_insertion(const Plant& plant) {
    double highest = 0;
    for (const Leaf& leaf : plant.leaves)
        highest = std::max(highest, leaf.insertion_height);
    return highest;
}

//! Reports measures that neither the table nor the crop tells.
void require_columns(const LeafTable& table, std::size_t leaves_of_crop,
                     Report& report) {
    if (table.rows.size() == leaves_of_crop) return;
    for (std::size_t m = 0; m < needed_leaf_measures; ++m) {
        const auto& [name, unit, limits, value, meaning] = leaf_measures[m];
        if (table.has[m]) continue;
        report.add(table.header,
                   fmt::format("there is no column of the {} (the {} leaves of "
                               "the crop cannot stand for {} measured ones); "
                               "add {}_{}",
                               name, leaves_of_crop, table.rows.size(), name,
                               std::string_view(unit) == "m" ? "cm" : unit));
    }
}

//! Puts what the table tells of each leaf in the place of what is there.
void overlay(const LeafTable& table, Plant& plant, Report& report) {
    const bool has_same_leaves = plant.leaves.size() == table.rows.size();
    if (!has_same_leaves) plant.leaves.assign(table.rows.size(), {});
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const LeafRow& row = table.rows[i];
        for (std::size_t m = 0; m < leaf_measures.size(); ++m) {
            double& value = plant.leaves[i].*leaf_measures[m].value;
            const bool is_told = row.places[m].line > 0;
            report.locate(&value, is_told ? row.places[m] : row.where);
            if (is_told)
                value = row.leaf.*leaf_measures[m].value;
            else if (table.has[m] ||
                     (!has_same_leaves && m < needed_leaf_measures))
                report.spoil(&value);  // its own problem is told already
        }
    }
}

}  // namespace

bool is_measured(const std::string& path) {
    return std::filesystem::path(path).extension() == ".csv";
}

void read_measured_plant(const std::string& text, const std::string& file,
                         bool is_crop_known, Plant& plant, Report& report) {
    const LeafTable table = read_leaf_table(text, file, report);
    if (table.rows.empty()) return;
    const auto more = static_cast<int>(table.rows.size()) -
                      static_cast<int>(plant.leaves.size());
    const double was_highest = highest_insertion(plant);
    if (is_crop_known) require_columns(table, plant.leaves.size(), report);
    overlay(table, plant, report);
    if (is_crop_known)
        plant.stalk.height += highest_insertion(plant) - was_highest;
    report.locate(&plant.stalk.height, table.header);
    for (Organ& organ : plant.organs)
        if (organ.leaf > 0) organ.leaf = std::max(1, organ.leaf + more);
    plant.name = make_name(std::filesystem::path(file).stem().string());
}

}  // namespace ideotype
