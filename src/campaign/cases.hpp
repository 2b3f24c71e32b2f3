// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "entries.hpp"
#include "ideotype/climate/sun.hpp"
#include "search/population.hpp"

namespace ideotype {

struct Campaign;

//! One of several moments of the season at which a growing canopy is evaluated.
//! A stage represents the hours around its moment: between stages, quantities
//! are interpolated linearly in thermal time.
struct Stage {
    std::uint32_t number = 0;  //!< number of the stage, from 0
    //! Thermal times of the main crop at this stage and, if they exist, at the
    //! previous and the next stage [deg C d].
    double at = 0;
    std::optional<double> before{}, after{};
    double day = 0;  //!< days since emergence
    //! Thermal time of each component since its emergence, the main crop first,
    //! at this stage and at the previous one [deg C d].
    std::vector<double> ages{}, ages_before{};
    //! Component::ear_share of each component; if empty, 0.
    std::vector<double> ear_shares{};
    double share = 1;  //!< approximate share of the season's carbon
    //! Date, if the stage represents a single date.
    std::optional<Date> date{};
};

//! The name of a case, and of its entry on each axis. If the entries of an axis
//! are scenarios, the entry is "all".
struct CaseName {
    int index = 0;
    std::string name;        //!< name, which is also that of the history file
    std::uint64_t seed = 0;  //!< derived from campaign seed and name
    std::string site_name;
    std::string day_name;  //!< name of the day or climate
    std::string spacing_name;
    std::string trait_set_name;
    int replicate = 1;
};

//! A combination of axis entries: one search with one history. Site, day and
//! spacing are those of the first scenario.
struct Case : CaseName {
    //! The draw of a scenario, and the campaign with its values; none: the
    //! campaign has no draws.
    std::string draw_name{};
    std::shared_ptr<const Campaign> drawn{};
    Site site{};
    DaySpan day{};  //!< day, if the case has no climate
    Spacing spacing{};
    TraitSet traits{};
    double weight = 1;  //!< weight among the scenarios of a case
    //! The scenarios in which each plant is evaluated, all with the random
    //! numbers of the case. If empty, the case itself is the only scenario.
    std::vector<Case> scenarios{};
    //! The case at each stage, if plants grow. If there are scenarios, they
    //! contain the stages.
    std::vector<Case> stages{};
    std::optional<Stage> stage{};  //!< stage that the case represents, if any
};

//! Returns the indices, from 0, of the rows that contain plants of the main
//! crop.
std::vector<int> bred_rows(const Campaign& campaign);

//! Returns the number of plants of the main crop in the field.
std::size_t bred_plants(const Campaign& campaign);

//! Returns the scenarios of a case. There is at least one.
std::vector<Case> scenarios(const Case& chosen);

//! Returns the campaign with the values of the draw of a case, if it is of a
//! draw.
inline const Campaign& campaign_in(const Campaign& campaign,
                                   const Case& chosen) {
    return chosen.drawn ? *chosen.drawn : campaign;
}

//! Returns each scenario of a case at each of its stages.
std::vector<Case> evaluated_cases(const Case& chosen);

//! Returns the light on clear days, or from the weather, for a case or its
//! first scenario.
LightSeries light_of(const Campaign& campaign, const Case& chosen);

//! Returns the number of cases of a campaign.
std::size_t count_cases(const Spec& spec);

//! Makes the name of a case. This takes much less time than making the case.
CaseName case_name(const Spec& spec, std::size_t index);

//! The cases of a campaign, or a range of them. Cases are made on demand, since
//! there may be very many. The campaign must outlive this object.
class Cases {
  public:
    explicit Cases(const Campaign& campaign);

    std::size_t size() const { return count_; }

    //! Returns the index in the campaign of case i of this range.
    int index(std::size_t i) const { return static_cast<int>(first_ + i); }

    CaseName name(std::size_t i) const;
    std::vector<CaseName> names() const;

    //! Makes a case.
    //! @throws std::out_of_range if there is no such case
    Case at(std::size_t i) const;
    Case operator[](std::size_t i) const { return at(i); }
    Case front() const { return at(0); }
    Case back() const { return at(count_ - 1); }

    //! Makes the case with a name; returns nothing if there is none.
    std::optional<Case> find(const std::string& name) const;

    //! Returns a range of these cases.
    Cases part(std::size_t first, std::size_t count) const;

    //! Returns the range that contains only the case with this index.
    //! @param path path of the campaign in messages
    //! @throws Error of wrong usage if there is no such case.
    Cases only(int index, const std::string& path) const;

    //! Iterates over cases, making each one on access.
    class Iterator {
      public:
        Iterator(const Cases& all, std::size_t i) : all_(&all), i_(i) {}
        Case operator*() const { return all_->at(i_); }
        Iterator& operator++() {
            ++i_;
            return *this;
        }
        bool operator==(const Iterator& other) const { return i_ == other.i_; }

      private:
        const Cases* all_;
        std::size_t i_;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, count_}; }

  private:
    const Campaign* campaign_;
    std::size_t first_ = 0, count_;
};

//! Returns all cases. Their order is by site, day or climate, spacing, trait
//! set and replicate; replicates vary fastest. If the entries of an axis are
//! scenarios, the axis has the single entry "all". A new entry on an axis does
//! not change the name or seed of other cases.
Cases cases(const Campaign& campaign);
Cases cases(Campaign&& gone) = delete;

//! Returns the case with this index.
//! @param path path of the campaign in messages
//! @throws Error of wrong usage if there is no such case.
Case case_at(const Campaign& campaign, int index, const std::string& path);

//! Returns the climate of a case.
const Climate& climate_of(const Campaign& campaign, const Case& chosen);

//! A plant for each component, the main crop first.
using Plants = std::vector<Plant>;

//! Returns the trait values of the baseline, followed by those of optimised
//! components, in the order of gene_space().
Genome baseline_genome(const Campaign& campaign);

//! Returns the number of genes of a genome, not counting varied keys.
std::size_t count_genes(const Campaign& campaign);

//! Makes the plants of all components from a genome.
//! @throws Error if there are too few or too many genes
Plants grow(const Campaign& campaign, const Genome& genome);

//! Returns the spacing of a component's rows and plants in a case.
//! @param component number of the component; 0: the main crop
Spacing spacing_of(const Campaign& campaign, const Case& chosen,
                   std::size_t component);

//! Returns the plant of a component as it grows at the density of its rows in a
//! case.
//! @param component number of the component; 0: the main crop
Plant at_density(const Campaign& campaign, const Case& chosen,
                 std::size_t component, const Plant& plant);

//! Returns the genes of a case with their bounds. Genes of the main crop come
//! first, followed by genes of optimised components, such as
//! "soybean.petiole_length". Genes outside the trait set are not free.
GeneSpace gene_space(const Campaign& campaign, const Case& chosen);

//! Returns the genes of a case, followed by the varied campaign keys. If traits
//! are not varied, no gene of a trait is free.
GeneSpace search_genes(const Campaign& campaign, const Case& chosen);

//! Returns the pressure of the standard atmosphere at an elevation [m] in kPa.
double standard_pressure(double elevation);

//! Returns the longwave radiation of the sky [W m-2], from a clear sky
//! (Brutsaert 1975, doi:10.1029/WR011i005p00742) and clouds (Crawford and
//! Duchon 1999, doi:10.1175/1520-0450(1999)038<0474:AIPFEE>2.0.CO;2),
//!
//!     [(1 - s) + 1.24 s (e / T)^(1/7)] sigma T^4
//!
//! @param temperature temperature T of the air [deg C], in the equation in K
//! @param vapour vapour pressure e of the air [hPa]
//! @param clearness s: light over that of a clear sky, 0 to 1
double sky_longwave(double temperature, double vapour, double clearness);

//! Fills in wind, pressure and longwave radiation that are missing in the
//! weather: a wind of 2 m s-1 at a height of 2 m (Allen et al. 1998, FAO 56),
//! the standard pressure at the elevation, and sky_longwave(). At night and
//! when the sun is low, sky_longwave() uses the last clearness of daylight.
//! Missing temperature or humidity is replaced by that of clear days. The
//! series then lists the estimated variables.
//! @param par_fraction fraction of PAR in the solar radiation of a clear sky
void estimate_air(LightSeries& series, const Site& site, double par_fraction);

//! Adds stages to a case with growing plants, from the first leaf to maturity
//! or to the end of the period. Their times are chosen so that linear
//! interpolation reproduces light interception over time as well as possible.
void add_stages(const Campaign& campaign, Case& one);

//! Returns the stage at noon of a date, or at a thermal time of the main crop
//! [deg C d]. The stage represents the hours of that day.
//! @param one case without scenarios, or one scenario of a case
//! @throws Error of wrong usage if plants do not grow, or if the time is out of
//! season.
Stage stage_on(const Campaign& campaign, const Case& one,
               const std::variant<Date, double>& when);

//! Returns the hours of a period that a stage represents. Each hour is weighted
//! by the share of it that the stage represents.
LightSeries at_stage(const Campaign& campaign, const Case& chosen,
                     LightSeries series);

//! Returns the growth of a component (0: the main crop), or null if it does not
//! grow.
const Growth* growth_of(const Campaign& campaign, std::size_t component);

//! The thermal time of a stage [deg C d], and the approximate fraction of light
//! that the green leaves of the baseline then intercept.
struct StageTime {
    double at, interception;
};

//! Returns the thermal times of a campaign's stages up to a time. A single
//! stage is at the middle of the time during which light interception is
//! largest.
std::vector<StageTime> stage_times(const Campaign& campaign,
                                   double ground_per_plant, double last);

}  // namespace ideotype
