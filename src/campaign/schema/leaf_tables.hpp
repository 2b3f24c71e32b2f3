// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/entries.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

struct Draft;
class Problems;
struct Section;

//! Models of leaves, in the order of LeafRates.
enum class LeafModel { hyperbola, collatz, farquhar };

//! The table [photosynthesis] as it is written. A list has one number for all
//! leaves, or one for each, the lowest first; empty: the model's default.
struct PhotosynthesisTable {
    LeafModel model = LeafModel::hyperbola;
    std::vector<double> theta, rd;  //!< numbers of all models
    std::vector<double> phi, amax;  //!< numbers of the hyperbola
    //! Gross assimilation at an absorbed PPFD of 2000, in place of amax.
    std::vector<double> rate_2000;
    std::vector<double> vmax, alpha, beta, k;  //!< numbers of Collatz
    //! Numbers of Farquhar, with beta.
    std::vector<double> vcmax, jmax, tpu, g1;
    CapacityProfile profile = CapacityProfile::exponential;
    double kn = CanopyNitrogen{}.kn;
    double nitrogen = CanopyNitrogen{}.total;
    std::vector<double> rank_capacity{1};
    bool follows_weather = true;
    double building_days = Photosynthesis{}.building_days;
    double leaf_mass = 45;  //!< dry mass [g m-2 of leaf]
};

//! Returns the defaults of the table for meshes: leaves do not differ by depth
//! and do not follow the weather.
PhotosynthesisTable photosynthesis_of_meshes();

//! Removes numbers that a campaign replaces from the [photosynthesis] of its
//! crop: all numbers if the campaign names another model, and `amax` or
//! `rate_2000`, which follow from each other, if it states either.
//! @param keys keys of the campaign's table
//! @param model model that the campaign names; "": none
void drop_replaced_numbers(Draft& draft, const std::set<std::string>& keys,
                           const std::string& model);

//! Returns the photosynthesis that a table describes.
//! @param table table without problems
Photosynthesis to_photosynthesis(const PhotosynthesisTable& table);

//! Returns the photosynthesis of each component of a campaign, the crop first,
//! with the files that state it; none if leaves do not assimilate.
std::vector<StatedLeaves> stated_leaves(const Draft& draft);

//! Warns of crops with leaves that assimilate by default, which is right for C4
//! plants only.
void check_leaf_models(const Draft& draft, const Problems& problems);

//! The [water] table as it is written.
struct WaterTable {
    LeafWater rules;
    Stomata::Model model = Stomata::Model::medlyn;
    std::optional<double> intercept{}, slope{};
    double limit = 0;  //!< most transpiration on all days [mm]; 0: any
};

Section water_section(WaterTable& table);

//! Returns the stomata of leaves of some photosynthesis. Numbers that the table
//! lacks are those of the kind of leaf: Medlyn's slope of C4 plants, or of the
//! leaf by Farquhar, and those of maize by Ball and Berry.
Stomata to_stomata(const WaterTable& table,
                   const Photosynthesis& photosynthesis);

//! Reports leaves whose photosynthesis does not depend on CO2, and objectives
//! that need the table [water] where it is missing.
void check_water(const Draft& draft, const Problems& problems);

}  // namespace ideotype
