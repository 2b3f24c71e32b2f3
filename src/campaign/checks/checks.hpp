// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "spec/problems.hpp"

namespace ideotype {

//! Trait values of baselines that are outside the bounds of the search. Only
//! searches forbid such values.
struct BaselineDoubts {
    std::vector<Problem>
        outside;  //!< the values, then lines that would correct the bounds
    //! Tables that could replace the rule of bounds: their bounds include the
    //! baseline of the main crop. "" if the rule's bounds already do.
    std::string wider_bounds;
};

//! Checks values against each other, and names for duplicates.
BaselineDoubts check_spec(const Spec& spec, const Problems& problems);

//! Checks values that describe plants and their environment against each other.
//! A search may vary these values by their keys.
void check_stand(const Spec& spec, const Problems& problems);

//! Checks all that may depend on keys that a search varies: check_stand(),
//! components, growth and soil.
void check_variable(const Spec& spec, const Problems& problems);

//! Checks the values of a crop file against each other.
void check_plant(const CropSpec& crop, const Problems& problems);

//! Checks the responses of a crop to density.
//! @param problems problems of the crop
void check_plasticity(const CropSpec& crop, const Problems& problems);

//! Warns of spacings with densities for which responses of crops are not known.
void doubt_densities(const Spec& spec, const Problems& problems);

//! Checks the traits of a crop file, and their bounds under each rule.
void check_traits(const CropSpec& crop, const Problems& problems);

//! Returns whether no problem has been reported for a trait itself.
//! @param problems problems of the crop
bool is_sound(std::size_t trait, const Problems& problems);

//! Checks the free traits and their bounds.
BaselineDoubts check_breeding(const Spec& spec, const Problems& problems);

//! Checks the keys and values of draws.
void check_draws(const Spec& spec, const Problems& problems);

//! Checks objectives, their scenarios, and the search.
void check_search(const Spec& spec, const Problems& problems);

//! Checks the settings for the accuracy of light.
//! @param assimilates whether assimilation is computed
//! @param problems problems of the table [light]
void check_light(const LightSpec& light, bool assimilates,
                 const Problems& problems);

//! Warns if the number of light paths is too small for objectives that depend
//! on the light response of leaves.
//! @param problems problems of the table [light]
void check_paths(const Campaign& campaign, const Problems& problems);

//! Checks sites, days and the light that cases receive.
void check_sky(const Spec& spec, const Problems& problems);

//! Checks that growing plants are fully specified, and that keys for growth are
//! used only with growing plants.
void check_growing(const Spec& spec, const Problems& problems);

//! Checks the positions of components, and objectives that combine components.
void check_components(const Spec& spec, const Problems& problems);

//! Reads the mesh files of objects and components.
//! @param file path of the campaign
void read_meshes(const std::string& file, Spec& spec, const Problems& problems);

//! Reports meshes that are inconsistent with their materials, the field or
//! other tables.
void check_component_meshes(const Spec& spec, const Problems& problems);

//! Reports materials that lack values in a waveband, or that scatter more light
//! than they receive.
//! @param table name of the table of a material, for messages
void check_materials(const std::vector<MaterialSpec>& materials,
                     const std::vector<std::string>& bands,
                     const std::string& table, const Problems& problems);

//! Checks that the positions of panels and objects repeat with the field.
void check_objects(const Spec& spec, const Problems& problems);

//! Reports a surface that scatters too large a fraction of the light.
//! @param prefix prefix of the surface's keys, such as "optics.leaf_"
//! @param limit largest sum of reflectance and transmittance
void check_surface(const std::string& prefix, const Lambertian& surface,
                   double limit, const Problems& problems);

//! Reports surfaces of plants that scatter too large a fraction of the light in
//! any waveband.
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

//! Checks measured lines, and limits or objectives that use the distance from
//! them.
void check_feasibility(const Spec& spec, const Problems& problems);

//! Reports varied keys that are not variable keys of this campaign, ranges and
//! values that these keys do not accept, and contradictory settings.
void check_sensitivity(const Spec& spec, const Problems& problems);

//! Reports parameters that do not belong to the leaf model, and lists of the
//! wrong length.
//! @param leaves number of leaves of the plant; 0: unknown
void check_photosynthesis(const PhotosynthesisSpec& table, std::size_t leaves,
                          const Problems& problems);

}  // namespace ideotype
