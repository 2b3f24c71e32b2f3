// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "ideotype/crop/measures.hpp"
#include "leaf_table.hpp"

namespace ideotype {

//! A column of a table of leaves; its measure is (zero + sign x) / per_unit.
struct LeafColumn {
    const char* name;
    double Leaf::*value;
    double per_unit = 1;
    double sign = 1;
    double zero = 0;
    bool is_from_north = false;
    //! The height from which the measure follows, if the number is a height.
    LeafHeight height = LeafHeight::none;
};

// Angles as in exported plants come first among columns of their measure.
inline constexpr LeafColumn leaf_columns[]{
    {"length_cm", &Leaf::length, 100},
    {"length_m", &Leaf::length},
    {"length_mm", &Leaf::length, 1000},
    {"width_cm", &Leaf::width, 100},
    {"width_m", &Leaf::width},
    {"width_mm", &Leaf::width, 1000},
    {"insertion_angle_deg", &Leaf::insertion_angle},
    {"insertion_angle_from_vertical_deg", &Leaf::insertion_angle},
    {"insertion_angle_from_horizontal_deg", &Leaf::insertion_angle, 1, -1, 90},
    {"curvature_deg", &Leaf::curvature},
    {"tip_height_cm", &Leaf::curvature, 100, 1, 0, false, LeafHeight::tip},
    {"tip_height_m", &Leaf::curvature, 1, 1, 0, false, LeafHeight::tip},
    {"tip_height_mm", &Leaf::curvature, 1000, 1, 0, false, LeafHeight::tip},
    {"top_height_cm", &Leaf::curvature, 100, 1, 0, false, LeafHeight::top},
    {"top_height_m", &Leaf::curvature, 1, 1, 0, false, LeafHeight::top},
    {"top_height_mm", &Leaf::curvature, 1000, 1, 0, false, LeafHeight::top},
    {"azimuth_deg", &Leaf::azimuth},
    {"azimuth_from_row_clockwise_deg", &Leaf::azimuth},
    {"azimuth_from_row_counterclockwise_deg", &Leaf::azimuth, 1, -1},
    {"azimuth_from_north_deg", &Leaf::azimuth, 1, 1, 0, true},
    {"insertion_height_cm", &Leaf::insertion_height, 100},
    {"insertion_height_m", &Leaf::insertion_height},
    {"insertion_height_mm", &Leaf::insertion_height, 1000},
    {"roll_deg", &Leaf::roll},
    {"twist_deg", &Leaf::twist},
    {"petiole_length_cm", &Leaf::petiole_length, 100},
    {"petiole_length_m", &Leaf::petiole_length},
    {"petiole_length_mm", &Leaf::petiole_length, 1000},
    {"petiole_angle_deg", &Leaf::petiole_angle},
    {"internode_cm", &Leaf::internode, 100},
    {"internode_m", &Leaf::internode},
    {"internode_mm", &Leaf::internode, 1000},
};
inline constexpr auto rank_column = "leaf";

//! Returns the place of a measure in leaf_measures.
inline std::size_t index_of(double Leaf::*value) {
    return static_cast<std::size_t>(
        std::find_if(
            leaf_measures.begin(), leaf_measures.end(),
            [&](const Measure<Leaf>& each) { return each.value == value; }) -
        leaf_measures.begin());
}

}  // namespace ideotype
