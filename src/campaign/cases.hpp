// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "climates.hpp"
#include "constraints.hpp"
#include "ideotype/canopy/field.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sun.hpp"
#include "search/population.hpp"

namespace ideotype {

struct Campaign;

//! A canopy that grows, at one of several moments. It stands for the hours
//! around that: by thermal time, figures are linear between stages.
struct Stage {
    std::uint32_t number = 0;  //!< from 0
    //! Thermal times of the campaign's crop at this stage, and at those before
    //! and after it, if there are [deg C d].
    double at = 0;
    std::optional<double> before{}, after{};
    double day = 0;  //!< since emergence
    //! Thermal time of each component since its own emergence, and at the stage
    //! before [deg C d]; the campaign's crop is the first.
    std::vector<double> ages{}, ages_before{};
    double share = 1;            //!< about the part of the season's carbon
    std::optional<Date> date{};  //!< whose hours alone it stands for, if given
};

//! A point of the sweep: a single evolution with its own history.
struct Case {
    int index = 0;
    std::string name;        //!< also the name of its file
    std::uint64_t seed = 0;  //!< a function of campaign seed and name only
    Site site;
    std::string day_name;  //!< or that of its climate
    DaySpan day;           //!< without a climate
    std::string spacing_name;
    Spacing spacing;
    std::string trait_set_name;
    TraitSet traits;
    int replicate = 1;
    //! The scenarios that each plant is evaluated in, with the random numbers
    //! of the case; its own site, day and spacing are those of the first.
    //! Empty: it is the only one.
    std::vector<Case> scenarios{};
    //! The case at each stage, where plants grow; scenarios have stages of
    //! their own.
    std::vector<Case> stages{};
    std::optional<Stage> stage{};  //!< if it is one of those
};

//! Returns the rows of the field, from 0, in which plants are bred.
std::vector<int> bred_rows(const Campaign& campaign);

//! Returns the number of plants of the field that are bred.
std::size_t bred_plants(const Campaign& campaign);

//! Returns whether the entries of an axis are scenarios of one case.
bool is_over(const Campaign& campaign, const std::string& axis);

//! Returns the scenarios of a case, at least one.
std::vector<Case> scenarios(const Case& chosen);

//! Each scenario of a case at each of its stages.
std::vector<Case> evaluated_cases(const Case& chosen);

//! Returns the light of a case, or of the first of its scenarios: of its clear
//! days, or of its weather.
LightSeries light_of(const Campaign& campaign, const Case& chosen);

//! Returns all cases in their order: sites, then days or climates, spacings,
//! trait sets, and replicates fastest; of axes whose entries are scenarios one,
//! which is called "all". Adding an entry to an axis does not change the name
//! or seed of any other case.
std::vector<Case> cases(const Campaign& campaign);

//! Returns the case of this index.
//! @param path of the campaign, for the message
//! @throws Error of wrong usage if there is none.
Case case_at(const Campaign& campaign, int index, const std::string& path);

//! Returns the climate of a case.
const Climate& climate_of(const Campaign& campaign, const Case& chosen);

//! A plant for each component, that of the campaign's crop first.
using Plants = std::vector<Plant>;

//! Returns the numbers of the crop's baseline, then those of components that
//! are bred: as gene_space().
Genome baseline_genome(const Campaign& campaign);

//! Returns the number of genes of a genome, without keys that are varied.
std::size_t count_genes(const Campaign& campaign);

//! Returns the plants that a genome makes of the baselines of all components.
//! @throws Error if it has too few or too many genes
Plants grow(const Campaign& campaign, const Genome& genome);

//! Returns the genes of a case with their bounds, those of the crop first, then
//! those of components that are bred, "soybean.petiole_length". Genes outside
//! the trait set are not free.
GeneSpace gene_space(const Campaign& campaign, const Case& chosen);

//! Returns the genes of a case and, behind them, the keys that a study or a
//! search varies. Where traits are not varied, no gene of them is free.
GeneSpace search_genes(const Campaign& campaign, const Case& chosen);

}  // namespace ideotype
