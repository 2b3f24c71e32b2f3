// SPDX-License-Identifier: Apache-2.0
#include "measured_plant.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/ranges.h>
#include <glm/trigonometric.hpp>

#include "campaign/reading/nodes.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

double highest_insertion(const Plant& plant) {
    double highest = 0;
    for (const Leaf& leaf : plant.leaves)
        highest = std::max(highest, leaf.insertion_height);
    return highest;
}

//! Returns the first column of each way to give a measure: itself, or a height
//! from which it follows.
std::vector<std::string> columns_of(const Measure<Leaf>& measure) {
    std::vector<std::string> names;
    std::optional<LeafHeight> last;
    for (const LeafColumn& each : leaf_columns) {
        if (each.value != measure.value || each.height == last) continue;
        names.push_back(each.name);
        last = each.height;
    }
    return names;
}

//! Reports measures that neither the table nor the crop has.
void require_columns(const LeafTable& table, std::size_t leaves_of_crop,
                     const Problems& problems) {
    if (table.rows.size() == leaves_of_crop) return;
    for (std::size_t m = 0; m < needed_leaf_measures; ++m) {
        if (table.has[m]) continue;
        problems.add(
            table.header,
            "there is no column for the {} of leaves (needed where plants do "
            "not have the {} leaves of the crop); add {}",
            leaf_measures[m].name, leaves_of_crop,
            fmt::join(columns_of(leaf_measures[m]), " or "));
    }
}

//! Returns the height of the tip or of the highest point of a leaf without a
//! digitised midrib [m].
double height_of(const Leaf& leaf, const Blade& blade, LeafHeight of) {
    constexpr int steps = 400;
    double height =
        leaf.insertion_height +
        leaf.petiole_length * std::cos(glm::radians(leaf.petiole_angle)) +
        blade.rachis_length * std::cos(glm::radians(leaf.insertion_angle));
    double highest = height;
    for (int i = 0; i < steps; ++i) {
        const double s = (i + 0.5) / steps;
        height += leaf.length / steps *
                  std::cos(glm::radians(
                      leaf.insertion_angle +
                      leaf.curvature * std::pow(s, blade.curvature_exponent)));
        highest = std::max(highest, height);
    }
    return of == LeafHeight::tip ? height : highest;
}

//! Finds by bisection the curvature at which a leaf has the measured height;
//! the more a leaf bends, the lower are its tip and its highest point.
//! @param problems problems of the leaf
void bend(const LeafRow& row, const Blade& blade, Leaf& leaf,
          const Problems& problems) {
    const std::size_t of_curvature = index_of(&Leaf::curvature);
    const Range limits = leaf_measures[of_curvature].limits;
    leaf.midrib.clear();
    const auto height = [&](double curvature) {
        leaf.curvature = curvature;
        return height_of(leaf, blade, row.of_height);
    };
    Range range = limits;
    // Rulers are read to the nearest centimetre.
    const double lowest = height(range.upper), highest = height(range.lower);
    if (row.height < lowest - 0.01 || row.height > highest + 0.01) {
        problems.add(
            row.places[of_curvature],
            "the {} of the leaf is at {:.4g} m (a leaf of {:.4g} m that leaves "
            "the stalk at {:.4g} m by {:.4g} deg has it at {:.4g} .. {:.4g} "
            "m); correct one of these",
            row.of_height == LeafHeight::tip ? "tip" : "highest point",
            row.height, leaf.length, leaf.insertion_height,
            leaf.insertion_angle, lowest, highest);
        return problems.spoil("curvature");
    }
    while (range.upper - range.lower > 1e-6) {
        const double middle = (range.lower + range.upper) / 2;
        (height(middle) > row.height ? range.lower : range.upper) = middle;
    }
    leaf.curvature = (range.lower + range.upper) / 2;
}

//! Makes heights and internodes agree if the table has only one of them.
//! @param has_internodes whether leaves of the crop have internodes
void stack(const LeafTable& table, bool has_internodes, Plant& plant) {
    if (table.has[index_of(&Leaf::internode)]) return stack_internodes(plant);
    if (!has_internodes || !table.has[index_of(&Leaf::insertion_height)])
        return;
    double below = 0;
    for (Leaf& leaf : plant.leaves) {
        leaf.internode = std::max(0.0, leaf.insertion_height - below);
        below = leaf.insertion_height;
    }
}

//! Replaces measures of each leaf by those of the table.
void overlay(const LeafTable& table, Plant& plant, const Problems& problems) {
    const bool has_same_leaves = plant.leaves.size() == table.rows.size();
    const bool has_internodes =
        !plant.leaves.empty() && plant.leaves.back().internode > 0;
    if (!has_same_leaves) plant.leaves.assign(table.rows.size(), {});
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const LeafRow& row = table.rows[i];
        const Problems own = problems.in("leaf", i);
        for (std::size_t m = 0; m < leaf_measures.size(); ++m) {
            const Measure<Leaf>& measure = leaf_measures[m];
            const bool is_told = row.places[m].line > 0;
            own.locate(measure.name, is_told ? row.places[m] : row.where);
            if (is_told)
                plant.leaves[i].*measure.value = row.leaf.*measure.value;
            else if (table.has[m] ||
                     (!has_same_leaves && m < needed_leaf_measures))
                // The problem of the value is reported already.
                own.spoil(measure.name);
        }
    }
    stack(table, has_internodes, plant);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const LeafRow& row = table.rows[i];
        if (row.of_height != LeafHeight::none && plant.leaves[i].length > 0)
            bend(row, plant.blade, plant.leaves[i], problems.in("leaf", i));
    }
}

}  // namespace

bool is_measured(const std::string& path) {
    return std::filesystem::path(path).extension() == ".csv";
}

void read_measured_plant(const std::string& text, const std::string& file,
                         const std::string& chosen, bool is_crop_known,
                         Plant& plant, const Problems& problems) {
    const LeafTable table = read_leaf_table(text, file, chosen, problems);
    if (table.rows.empty()) return;
    const auto more = static_cast<int>(table.rows.size()) -
                      static_cast<int>(plant.leaves.size());
    const double was_highest = highest_insertion(plant);
    const double was_high = plant.stalk.height;
    if (is_crop_known) require_columns(table, plant.leaves.size(), problems);
    overlay(table, plant, problems);
    if (is_crop_known)
        plant.stalk.height =
            was_high + (highest_insertion(plant) - was_highest);
    problems.locate("stalk.height", table.header);
    for (Organ& organ : plant.organs)
        if (organ.leaf > 0) organ.leaf = std::max(1, organ.leaf + more);
    plant.name = make_name(table.plant.empty()
                               ? std::filesystem::path(file).stem().string()
                               : table.plant);
}

}  // namespace ideotype
