// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"

namespace ideotype {

//! Checks values against each other: contradictions, duplicate names, a
//! baseline outside its bounds.
void check_draft(Draft& draft, const Problems& problems);

//! Checks the values of a crop file against each other.
void check_plant(Draft& draft, const Problems& problems);

//! The traits of a crop file, and the bounds of its rules.
void check_traits(Draft& draft, const Problems& problems);

//! Returns whether nothing is wrong with a trait by itself.
//! @param problems of the crop
bool is_sound(std::size_t trait, const Problems& problems);

//! Checks which traits are bred, and within which limits.
void check_breeding(Draft& draft, const Problems& problems);

//! Checks objectives, their scenarios, and how they are searched for.
void check_search(const Draft& draft, const Problems& problems);

//! Checks how exactly light is counted.
//! @param assimilates leaves do
//! @param problems of the table [light]
void check_light(const Accuracy& light, bool assimilates,
                 const Problems& problems);

//! Checks sites, days and the light of their cases.
void check_sky(const Campaign& campaign, const Problems& problems);

//! Checks what plants need to grow, and what needs plants that grow.
void check_growing(const Draft& draft, const Problems& problems);

//! Checks where components stand, and what is asked of them together.
void check_components(Draft& draft, const Problems& problems);

//! Reads the files of fixed objects.
//! @param file of the campaign
void read_objects(const std::string& file, Draft& draft,
                  const Problems& problems);

//! Checks how panels and objects repeat with the field.
void check_objects(const Draft& draft, const Problems& problems);

//! Reports a surface that reflects and transmits too much of the light.
//! @param prefix that its keys begin with, such as "optics.leaf_"
//! @param most part of the light that it may reflect and transmit together
void check_surface(const std::string& prefix, const Lambertian& surface,
                   double most, const Problems& problems);

//! Reports such surfaces of plants in each waveband.
void check_plant_optics(const ByBand<PlantOptics>& optics,
                        const Problems& problems);

//! An objective, and the key of the list that it stands in.
struct ObjectiveKey {
    std::string key, name;
};

//! Returns the objectives of lists that are sound, in their order.
std::vector<ObjectiveKey> objective_keys(const Campaign& campaign,
                                         const Problems& problems);

//! Returns the quantity of an objective, which may be that of one component.
inline std::string quantity_of(const std::string& objective) {
    return objective.substr(objective.find('.') + 1);
}

//! Returns a name as names are compared.
std::string lower_case(std::string text);

//! Measured lines, and what is asked of the distance from them.
void check_feasibility(Draft& draft, const Problems& problems);

//! Reports numbers of other models and lists that differ in length.
//! @param leaves of the plant; 0: not known
void check_photosynthesis(const PhotosynthesisTable& table, std::size_t leaves,
                          const Problems& problems);

}  // namespace ideotype
