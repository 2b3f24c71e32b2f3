// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "entries.hpp"
#include "ideotype/canopy/field.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sun.hpp"
#include "search/population.hpp"

namespace ideotype {

struct Campaign;

//! A canopy that grows, at one of several moments. A stage stands for the hours
//! around this moment: figures are linear in thermal time between stages.
struct Stage {
    std::uint32_t number = 0;  //!< number of the stage, from 0
    //! Thermal times of the campaign's crop at this stage, at the stage before
    //! and at the stage after, if there are such stages [deg C d].
    double at = 0;
    std::optional<double> before{}, after{};
    double day = 0;  //!< days since emergence
    //! Thermal time of each component since its own emergence at this stage,
    //! and at the stage before [deg C d]; the campaign's crop is the first.
    std::vector<double> ages{}, ages_before{};
    double share = 1;            //!< approximate share of the season's carbon
    std::optional<Date> date{};  //!< only date of the stage, if given
};

//! A point of the sweep: one search with a history of its own.
struct Case {
    int index = 0;
    std::string name;        //!< name, also of the case's file
    std::uint64_t seed = 0;  //!< function of campaign seed and name
    Site site;
    std::string day_name;  //!< name of the day or climate
    DaySpan day;           //!< day, if the case has no climate
    std::string spacing_name;
    Spacing spacing;
    std::string trait_set_name;
    TraitSet traits;
    int replicate = 1;
    //! The scenarios in which each plant is evaluated, with the random numbers
    //! of the case; the case's own site, day and spacing are those of the first
    //! scenario. Empty: the case is its only scenario.
    std::vector<Case> scenarios{};
    //! The case at each stage, if plants grow; scenarios have stages of their
    //! own.
    std::vector<Case> stages{};
    //! Stage of the case, if the case is at one stage.
    std::optional<Stage> stage{};
};

//! Returns the rows of the field, from 0, in which plants are bred.
std::vector<int> bred_rows(const Campaign& campaign);

//! Returns the number of plants of the field that are bred.
std::size_t bred_plants(const Campaign& campaign);

//! Returns whether the entries of an axis are scenarios of one case.
bool is_over(const Campaign& campaign, const std::string& axis);

//! Returns the scenarios of a case, at least one.
std::vector<Case> scenarios(const Case& chosen);

//! Returns each scenario of a case at each of its stages.
std::vector<Case> evaluated_cases(const Case& chosen);

//! Returns the light of a case or its first scenario, on clear days or by
//! weather.
LightSeries light_of(const Campaign& campaign, const Case& chosen);

//! Returns all cases in their order: sites, then days or climates, spacings,
//! trait sets, and replicates fastest. An axis whose entries are scenarios has
//! a single entry "all". A new entry of an axis does not change the name or
//! seed of any other case.
std::vector<Case> cases(const Campaign& campaign);

//! Returns the case of this index.
//! @param path path of the campaign, for the message
//! @throws Error of wrong usage if there is no such case.
Case case_at(const Campaign& campaign, int index, const std::string& path);

//! Returns the climate of a case.
const Climate& climate_of(const Campaign& campaign, const Case& chosen);

//! A plant for each component, the campaign's crop first.
using Plants = std::vector<Plant>;

//! Returns the numbers of the crop's baseline, then those of bred components,
//! in the order of gene_space().
Genome baseline_genome(const Campaign& campaign);

//! Returns the number of genes of a genome, without varied keys.
std::size_t count_genes(const Campaign& campaign);

//! Returns the plants that a genome makes of the baselines of all components.
//! @throws Error if there are too few or too many genes
Plants grow(const Campaign& campaign, const Genome& genome);

//! Returns the genes of a case with their bounds: genes of the crop, then those
//! of bred components, such as "soybean.petiole_length". Genes outside the
//! trait set are not free.
GeneSpace gene_space(const Campaign& campaign, const Case& chosen);

//! Returns the genes of a case and, after them, the keys that a study or search
//! varies. If traits are not varied, no gene of a trait is free.
GeneSpace search_genes(const Campaign& campaign, const Case& chosen);

}  // namespace ideotype
