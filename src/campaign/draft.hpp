// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "campaign/schema/leaf_tables.hpp"

namespace ideotype {

//! One trait of a crop file, which acts on the measures of one of these lists.
struct TraitEntry {
    Trait trait;
    std::vector<std::string> sets, scales, shifts;
};

//! Bounds of one trait under a rule that campaigns choose by its name.
struct BoundsEntry {
    std::string rule;
    std::string trait;
    Range range;
    double change = 0;     //!< relative to the baseline; 0: any
    bool is_bred = false;  //!< whether campaigns with only the rule breed it
};

//! A campaign while it is read: defaults first, then values of the file.
struct Draft {
    //! Fills in the defaults that the structures themselves lack.
    Draft();

    Campaign campaign;
    std::vector<TraitEntry> traits;
    std::vector<BoundsEntry> bounds;  //!< bounds of all rules
    //! Rule of bounds; "traits": ranges of the traits; empty: own_bounds.
    std::string rule = "traits";
    std::vector<Range> own_bounds;    //!< own bounds of each trait
    std::vector<std::string> organs;  //!< present organs besides leaves
    PhotosynthesisTable photosynthesis;
    //! The file of each key of [photosynthesis] that a file states.
    std::map<std::string, std::string> leaf_files;
    WaterTable water;
    MeasuredLines lines;
    Growth growth;  //!< growth of the crop
    //! Differences between plants in the crop file; none: there is no table.
    std::optional<CropVariation> crop_variation;
    bool has_growth = false;          //!< whether the crop file has growth
    bool has_photosynthesis = false;  //!< whether leaves assimilate
    bool has_water = false;           //!< whether leaves exchange water
    bool is_crop_known = true;        //!< whether all files were found
    bool has_climate = false;         //!< whether days come from a climate
    bool has_optimizer = false;       //!< whether a file names the optimizer
    bool has_population = false;      //!< whether a file sets the population
    bool has_finalists = false;       //!< whether a file sets finalists
    bool has_samples = false;         //!< whether a file sets the samples
    bool is_study = false;  //!< whether the campaign is a sensitivity study
    SensitivitySettings design;       //!< design of studies
    Variation varied;                 //!< factors of a study
    std::vector<KeyFactor> searched;  //!< keys that a search varies

    //! Returns the keys that a study or a search varies.
    std::vector<KeyFactor>& factors() {
        return is_study ? varied.keys : searched;
    }

    //! Components beside the crop, each with its own crop and name.
    std::vector<std::shared_ptr<Draft>> components;
    std::vector<double> rows;  //!< rows of a component, from 1
    Standing standing;         //!< places of a component
    //! Whether the component's `campaign.field` has a variation of its own.
    bool has_variation = false;
};

//! Returns the names by which campaigns may choose bounds.
std::vector<std::string> rule_names(const Draft& draft);

//! Returns whether campaigns without trait sets breed the trait.
bool is_bred(const Draft& draft, const Trait& trait, const std::string& rule);

//! Returns the measures that a trait acts on: the list that is not empty.
const std::vector<std::string>& measures_of(const TraitEntry& entry);

//! Returns a trait with the measures and effect of the list that is not empty.
Trait complete(const TraitEntry& entry);

//! Returns whether plants grow in a climate of the campaign.
bool plants_grow(const Campaign& campaign);

//! Returns the crop of a draft with its traits and its growth.
Crop crop_of(const Draft& draft);

//! Returns the bounds of one number of a trait.
//! @param baseline value of the number in the baseline
Range bounds_of(const Draft& draft, std::size_t trait, double baseline);

}  // namespace ideotype
