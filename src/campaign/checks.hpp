// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draft.hpp"
#include "problems.hpp"

namespace ideotype {

//! Checks values against each other: contradictions, duplicate names, a
//! baseline outside its bounds.
void check_draft(Draft& draft, Problems& problems);

//! Checks the values of a crop file against each other.
void check_plant(Draft& draft, Problems& problems);

//! The traits of a crop file, and the bounds of its rules.
void check_traits(Draft& draft, Problems& problems);

//! Whether nothing is wrong with a trait by itself.
bool is_sound(const TraitEntry& entry, const Problems& problems);

//! Checks which traits are bred, and within which limits.
void check_breeding(Draft& draft, Problems& problems);

//! Checks sites, days and the light of their cases.
void check_sky(const Campaign& campaign, Problems& problems);

//! Checks what plants need to grow, and what needs plants that grow.
void check_growing(const Draft& draft, Problems& problems);

//! Checks where components stand, and what is asked of them together.
void check_components(Draft& draft, Problems& problems);

//! Reads the files of fixed objects.
//! @param file of the campaign
void read_objects(const std::string& file, Draft& draft, Problems& problems);

//! Checks how panels and objects repeat with the field.
void check_objects(const Draft& draft, Problems& problems);

//! Reports a surface that reflects and transmits more than all light.
//! @param name of its keys
void check_surface(const std::string& name, const Lambertian& surface,
                   Problems& problems);

//! Returns a name as names are compared.
std::string lower_case(std::string text);

//! Measured lines, and what is asked of the distance from them.
void check_feasibility(Draft& draft, Problems& problems);

//! Reports numbers of other models and lists that differ in length.
//! @param leaves of the plant; 0: not known
void check_photosynthesis(const PhotosynthesisTable& table, std::size_t leaves,
                          Problems& problems);

}  // namespace ideotype
