// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/range.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! A number that describes a part of a plant, with limits for plants of any
//! crop.
template <class Part>
struct Measure {
    const char* name;
    const char* unit;
    Range limits;
    double Part::*value;
    const char* meaning;
};

//! Makes a measure with limits from `lower` to `upper`.
template <class Part>
constexpr Measure<Part> measure(const char* name, const char* unit,
                                double lower, double upper, double Part::*value,
                                const char* meaning) {
    return {name, unit, {lower, upper}, value, meaning};
}

// These limits fit any crop; the ranges of traits are narrower.
inline constexpr std::array leaf_measures{
    measure("length", "m", 0.01, 3, &Leaf::length, "arc length of the midrib"),
    measure("width", "m", 0.001, 0.5, &Leaf::width,
            "largest width of the blade"),
    measure("insertion_angle", "deg", 0, 90, &Leaf::insertion_angle,
            "angle of the base from the stalk; 90 is horizontal"),
    measure("curvature", "deg", 0, 180, &Leaf::curvature,
            "angle by which the tip bends further down"),
    measure("azimuth", "deg", 0, 360, &Leaf::azimuth,
            "azimuth about the stalk; 0 is along the row"),
    measure(
        "insertion_height", "m", 0, 6, &Leaf::insertion_height,
        "height of the insertion above the soil, at most the stalk's height"),
    measure("roll", "deg", -180, 180, &Leaf::roll,
            "turn of the blade about its midrib, halfway along it"),
    measure("twist", "deg", -720, 720, &Leaf::twist,
            "turn of the blade about its midrib from the base to the tip"),
    measure("petiole_length", "m", 0, 1, &Leaf::petiole_length,
            "length from the stalk to the blade"),
    measure("petiole_angle", "deg", 0, 180, &Leaf::petiole_angle,
            "angle of the petiole from the stalk"),
    measure("internode", "m", 0, 1, &Leaf::internode,
            "height above the leaf below, or of the lowest above the soil, "
            "instead of insertion_height")};

//! The number of leading measures that a plant file must specify for every
//! leaf; the other measures default to 0.
inline constexpr std::size_t needed_leaf_measures = 6;

//! The number of measures that are written for every leaf. Other measures,
//! which grasses lack, are written if any leaf has a nonzero value.
inline constexpr std::size_t usual_leaf_measures = 8;

inline constexpr std::array blade_measures{
    measure("folding_angle", "deg", 0, 80, &Blade::folding_angle,
            "rise of each half from flat: the V of the blade"),
    measure("curvature_exponent", "1", 0.1, 10, &Blade::curvature_exponent,
            "angle at arc length s is insertion_angle + curvature s^exponent"),
    measure("leaflet_divergence", "deg", 0, 180, &Blade::leaflet_divergence,
            "azimuth between neighbouring leaflets"),
    measure("rachis_length", "m", 0, 0.5, &Blade::rachis_length,
            "distance by which the middle leaflet begins further out")};

inline constexpr std::array stalk_measures{
    measure("height", "m", 0.05, 6, &Stalk::height, "height above the soil"),
    measure("base_diameter", "m", 0.001, 0.2, &Stalk::base_diameter,
            "diameter at the soil"),
    measure("top_diameter", "m", 0, 0.2, &Stalk::top_diameter,
            "diameter at the top; 0: as at the base")};

inline constexpr std::array sheath_measures{
    measure("length", "m", 0, 1, &Sheath::length,
            "length from the insertion of the leaf down; the part that the "
            "sheath of the leaf below covers does not show"),
    measure("thickness", "m", 0, 0.01, &Sheath::thickness,
            "thickness of the sheath around the stalk")};

//! Measures of the tissue of stalks, sheaths and other organs.
template <class Part>
inline constexpr std::array tissue_measures{
    measure<Part>("capacity", "1", 0, 1, &Part::capacity,
                  "capacity of gross assimilation per area of outer surface "
                  "over that of the highest leaf; 0: it does not assimilate"),
    measure<Part>("density", "kg m-3", 0, 1000, &Part::density,
                  "dry mass per volume, which is built and respires; 0: it "
                  "costs no carbon"),
    measure<Part>("maintenance", "d-1", 0, 0.1, &Part::maintenance,
                  "carbohydrate that dry mass respires at 25 deg C"),
    measure<Part>("construction", "1", 1, 5, &Part::construction,
                  "carbohydrate over the dry mass that is built of it")};

inline constexpr std::array petiole_measures{
    measure("diameter", "m", 0.0001, 0.1, &Petiole::diameter,
            "diameter of all petioles")};

inline constexpr std::array organ_measures{
    measure("offset", "m", -6, 6, &Organ::offset,
            "height of the lowest cone above the stalk's top or the leaf"),
    measure("spread", "m", 0, 3, &Organ::spread,
            "height over which several cones are spread"),
    measure("length", "m", 0.001, 3, &Organ::length, "length of each cone"),
    measure("base_diameter", "m", 0.0001, 0.5, &Organ::base_diameter,
            "diameter where a cone begins"),
    measure("top_diameter", "m", 0, 0.5, &Organ::top_diameter,
            "diameter where a cone ends"),
    measure("inclination", "deg", 0, 180, &Organ::inclination,
            "angle of a cone from the vertical")};

//! A measure of a plant: its name, such as "leaf.length" or "stalk.height", its
//! properties, and pointers to its values.
struct MeasureInfo {
    std::string name;
    const char* unit = "";
    Range limits;
    bool is_of_leaves = false;    //!< whether each leaf has a value
    bool is_direction = false;    //!< whether 0 and 360 deg are the same value
    std::vector<double*> values;  //!< values in the plant, one or one per leaf
};

//! Finds a measure of a plant by name; returns nothing if there is none.
std::optional<MeasureInfo> find_measure(Plant& plant, const std::string& name);

//! Returns all measures of a plant by their names: "leaf.NAME", "blade.NAME",
//! "stalk.NAME", "sheath.NAME", "petiole.NAME", and "ORGAN.NAME" for each other
//! organ.
std::vector<MeasureInfo> measures(Plant& plant);

//! Returns the names of all measures of a plant.
std::vector<std::string> measure_names(Plant plant);

//! Returns whether a measure follows from the internodes of a plant, so that
//! nothing else may change it.
bool follows_internodes(const Plant& plant, const std::string& measure);

}  // namespace ideotype
