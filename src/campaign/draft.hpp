// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "campaign/schema/photosynthesis_table.hpp"
#include "campaign/schema/water_table.hpp"

namespace ideotype {

//! One trait as a crop file gives it: it acts on the measures of one of these
//! lists.
struct TraitEntry {
    Trait trait;
    std::vector<std::string> sets, scales, shifts;
};

//! Bounds of one trait under a rule that campaigns choose by its name.
struct BoundsEntry {
    std::string rule;
    std::string trait;
    Range range;
    double change = 0;  //!< from the baseline, relative to it; 0: any
    //! Campaigns that choose the rule, but no trait set, breed such traits and
    //! no others.
    bool is_bred = false;
};

//! A campaign while it is read: defaults first, then what the file says.
struct Draft {
    //! Fills in the defaults that the structures themselves don't have.
    Draft();

    Campaign campaign;
    std::vector<TraitEntry> traits;
    std::vector<BoundsEntry> bounds;  //!< bounds of all rules
    //! The choice of bounds: a rule, "traits" for their own ranges, or, if it
    //! is empty, own_bounds.
    std::string rule = "traits";
    std::vector<Range> own_bounds;    //!< own bounds of each trait
    std::vector<std::string> organs;  //!< that plants have besides leaves
    PhotosynthesisTable photosynthesis;
    WaterTable water;
    MeasuredLines lines;
    Growth growth;                    //!< growth of the crop
    bool has_growth = false;          //!< the crop file tells it
    bool has_photosynthesis = false;  //!< leaves assimilate
    bool has_water = false;           //!< leaves exchange heat and water
    bool is_crop_known = true;        //!< no file is missing
    bool has_climate = false;         //!< instead of days
    bool has_population = false;      //!< none that the optimizer chooses
    bool has_finalists = false;       //!< a number of them is given
    bool has_samples = false;         //!< none that the method chooses
    bool is_study = false;            //!< of sensitivity, and no search
    SensitivitySettings design;       //!< design of studies
    Variation varied;                 //!< by studies
    std::vector<KeyFactor> searched;  //!< keys that searches vary

    //! Returns the keys that are varied, by a study or a search.
    std::vector<KeyFactor>& factors() {
        return is_study ? varied.keys : searched;
    }

    //! Components that are not bred: each has its crop and its name.
    std::vector<std::shared_ptr<Draft>> components;
    std::vector<double> rows;  //!< of the field that a component has, from 1
    Standing standing;         //!< standing of a component, without its rows
    //! Whether plants of a component differ as its own `campaign.field` tells.
    bool has_variation = false;
};

//! Returns the names that campaigns may choose bounds by.
std::vector<std::string> rule_names(const Draft& draft);

//! Returns whether campaigns without trait sets breed the trait.
bool is_bred(const Draft& draft, const Trait& trait, const std::string& rule);

//! Returns the measures that the trait acts on: the list that has any.
const std::vector<std::string>& measures_of(const TraitEntry& entry);

//! Returns the trait with the measures that it acts on, from the list that has
//! any, and the way in which it does.
Trait complete(const TraitEntry& entry);

//! Returns whether plants grow in a climate of the campaign.
bool plants_grow(const Campaign& campaign);

//! Returns the crop of a draft with its traits and its growth.
Crop crop_of(const Draft& draft);

//! Returns the bounds of one number of a trait.
//! @param baseline its value in the baseline
Range bounds_of(const Draft& draft, std::size_t trait, double baseline);

}  // namespace ideotype
