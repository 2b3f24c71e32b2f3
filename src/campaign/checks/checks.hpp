// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "spec/problems.hpp"

namespace ideotype {

//! Trait values of baselines outside the bounds of the search. Only searches
//! forbid them.
struct BaselineDoubts {
    std::vector<Problem>
        outside;  //!< the values, then the lines to write instead
    //! Tables with bounds that include the baseline of the main crop, to
    //! replace the rule of bounds; "": the rule includes it.
    std::string wider_bounds;
};

//! Checks values against each other: contradictions, duplicate names.
BaselineDoubts check_spec(const Spec& spec, const Problems& problems);

//! Checks values of plants and their environment against each other. A search
//! may vary them by their keys.
void check_stand(const Spec& spec, const Problems& problems);

//! Checks the values of a crop file against each other.
void check_plant(const CropSpec& crop, const Problems& problems);

//! Checks the traits of a crop file, and the bounds under each rule.
void check_traits(const CropSpec& crop, const Problems& problems);

//! Returns whether a trait by itself has no problem.
//! @param problems problems of the crop
bool is_sound(std::size_t trait, const Problems& problems);

//! Checks the free traits and their bounds.
BaselineDoubts check_breeding(const Spec& spec, const Problems& problems);

//! Checks objectives, their scenarios, and the search.
void check_search(const Spec& spec, const Problems& problems);

//! Checks the accuracy settings of light.
//! @param assimilates whether leaves assimilate
//! @param problems problems of the table [light]
void check_light(const LightSpec& light, bool assimilates,
                 const Problems& problems);

//! Warns if there are too few light paths for objectives that depend on the
//! light response of leaves.
//! @param problems problems of the table [light]
void check_paths(const Campaign& campaign, const Problems& problems);

//! Checks sites, days and the light of their cases.
void check_sky(const Spec& spec, const Problems& problems);

//! Checks the requirements of growing plants, and keys that require growth.
void check_growing(const Spec& spec, const Problems& problems);

//! Checks the positions of components, and objectives of several components.
void check_components(const Spec& spec, const Problems& problems);

//! Reads the files of objects and of meshes of components.
//! @param file path of the campaign
void read_meshes(const std::string& file, Spec& spec, const Problems& problems);

//! Reports meshes that do not fit their materials, the field or other tables.
void check_component_meshes(const Spec& spec, const Problems& problems);

//! Reports materials without values in a waveband, or that scatter more light
//! than they receive.
//! @param table name of the table of a material, for messages
void check_materials(const std::vector<MaterialSpec>& materials,
                     const std::vector<std::string>& bands,
                     const std::string& table, const Problems& problems);

//! Checks that panels and objects repeat with the field.
void check_objects(const Spec& spec, const Problems& problems);

//! Reports a surface that scatters too much of the light.
//! @param prefix prefix of the surface's keys, such as "optics.leaf_"
//! @param limit largest sum of reflectance and transmittance
void check_surface(const std::string& prefix, const Lambertian& surface,
                   double limit, const Problems& problems);

//! Reports surfaces of plants that scatter too much light in any waveband.
void check_plant_optics(const ByBand<PlantOptics>& optics,
                        const Problems& problems);

//! An objective, and the key of the list that contains it.
struct ObjectiveKey {
    std::string key, name;
};

//! Returns the objectives in the order of their lists.
std::vector<ObjectiveKey> objective_keys(const Spec& spec);

//! Returns the quantity of an objective, without the name of a component.
inline std::string quantity_of(const std::string& objective) {
    return objective.substr(objective.find('.') + 1);
}

//! Checks measured lines, and limits or objectives of the distance from them.
void check_feasibility(const Spec& spec, const Problems& problems);

//! Reports varied keys that are not numeric keys of this campaign, ranges
//! beyond those of the keys, and contradictory settings.
void check_sensitivity(const Spec& spec, const Problems& problems);

//! Reports parameters of other models, and lists of unequal length.
//! @param leaves number of leaves of the plant; 0: unknown
void check_photosynthesis(const PhotosynthesisSpec& table, std::size_t leaves,
                          const Problems& problems);

}  // namespace ideotype
