// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spec/key.hpp"
#include "spec/spec.hpp"

//! The tables of campaigns and of the files that they name. Each key is
//! declared by one line in spec/tables.
namespace ideotype {

inline constexpr std::size_t most_components = 20;
inline constexpr std::size_t most_leaves = 40;
inline constexpr std::size_t most_organs = 40;
inline constexpr std::size_t most_responses = 40;
inline constexpr std::size_t most_traits = 100;
//! Largest number of entries of an axis.
inline constexpr std::size_t most_entries = 10'000;
inline constexpr std::size_t most_cases = 100'000;
inline constexpr std::size_t most_draws = 1000;

extern const Description spec_table;  //!< campaigns, read into Spec
extern const Description crop_table;  //!< crop files, read into CropSpec
//! Tables of crop files that campaigns may contain too.
extern const Description crop_leaves_table;
//! The table [variation] of crop files.
extern const Description crop_variation_table;
//! Files of measured lines, read into MeasuredLines.
extern const Description lines_table;

extern const Description site_table, day_table, climate_table, weather_table;
//! The location of a site: latitude, longitude and UTC offset.
extern const Description place_table;
extern const Description spacing_table, field_table, variation_table;
extern const Description panel_table, object_table, material_table, band_table;
extern const Description optics_table, crop_optics_table;
extern const Description photosynthesis_table, water_table;
extern const Description soil_table, irrigation_table, prices_table;
//! The key TRAIT, which stands for each trait of a crop, read into Range.
extern const Description own_bounds_table;

//! Finds a key by its name and the name that documents use for its table, such
//! as "site"; returns null if there is none.
const Key* find_key(const std::string& section, const std::string& name);

//! A table, with its name in documents, such as "site", "field.variation" or
//! "leaf".
struct Documented {
    std::string section;
    const Table* table = nullptr;  //!< null: the keys before the first table
    const Description* description = nullptr;
};

//! Returns the default of a key, as TOML or in words.
//! @param section name of its table in documents
std::string default_of(const std::string& section, const Key& key);

//! Returns all tables of campaigns, then those of crop files, each once and in
//! the order in which texts contain them.
const std::vector<Documented>& documented_tables();

}  // namespace ideotype
