// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/climate/sun.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/range.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measured_lines.hpp"
#include "ideotype/light/accuracy.hpp"
#include "ideotype/physiology/photosynthesis.hpp"
#include "objects.hpp"
#include "search/outcome.hpp"
#include "search/population.hpp"
#include "search/settings.hpp"
#include "search/stop_rules.hpp"

namespace ideotype {

//! A named entry of an axis of the sweep.
template <class Value>
struct Named {
    std::string name;
    Value value;
};

//! The weather of a period from a file.
struct Climate {
    std::string file;  //!< as written; "" if each site has one of its own
    Period period;
    std::string stamp;  //!< "": that of the format
    ColumnMap columns;
    std::optional<double> wind_height;  //!< above the ground [m]
    std::optional<double> co2;          //!< of the air [umol mol-1]
    //! The day on which plants emerge that then grow; of year 0: they stand as
    //! they are.
    Date emergence{0, 1, 1};

    bool grows() const { return emergence.year > 0; }
};

//! The weather of a site in a climate, as it was read.
struct SiteWeather {
    std::string site, climate;  //!< names
    std::string sha256;         //!< of the file
    double utc_offset = 0;      //!< of dates and hours [h]
    std::vector<Date> dates;
    std::vector<double> hours;  //!< of each day: the middles of steps [h]
    //! Date by date and hour by hour: PAR on a horizontal plane [W m-2], and,
    //! if they are known, temperature [deg C] and relative humidity (0 to 1).
    std::vector<double> beam, diffuse, temperature, humidity;
    //! Near infrared on a horizontal plane, in that order [W m-2]; nothing in
    //! campaigns that do not follow it.
    std::vector<double> nir_beam, nir_diffuse;
    //! If the file tells them, in that order: wind [m s-1], pressure [kPa] and
    //! longwave radiation of the sky [W m-2].
    std::vector<double> wind, pressure, longwave;
};

//! A campaign as it is read.
struct Draft;

//! The traits that may be bred; the others keep the baseline's values.
using TraitSet = std::vector<std::string>;

//! A limit of the first measure that a trait acts on, in the unit of that
//! measure. A plant must keep to it however it is bred.
struct TraitConstraint {
    std::string trait;
    double step = 0;          //!< largest between neighbouring leaves; 0: any
    Range total{0, 1e9};      //!< of all leaves
    bool is_falling = false;  //!< it must not rise from leaf to leaf upwards
    //! Leaves alternate between the two sides of one plane, and none is
    //! further from it [deg]; 0: any.
    double distichous = 0;
    Range range{-1e9, 1e9};  //!< of each leaf
    int highest = 0;  //!< leaves that it limits, from the top down; 0: all
};

//! Whether it asks for anything.
bool constrains(const TraitConstraint& limit);

//! All limits that a plant must keep to. A plant that does not is worse than
//! any that does, and the worse the more it fails: see violation().
struct Constraints {
    Range lai{0, 1000};  //!< one-sided [m2 m-2]
    std::vector<TraitConstraint> traits;
};

//! Returns how far a plant fails its constraints: the sum of the excesses over
//! all limits, each relative to its limit; 0 if all are met.
//! @param traits of the plant's crop
//! @param lai of the plant in its stand
double violation(const Constraints& constraints,
                 const std::vector<Trait>& traits, const Plant& plant,
                 double lai);

//! The measured lines near which plants of the crop must stay.
struct Feasibility {
    std::optional<MeasuredLines> lines;
    //! Largest distance from the mean of the lines, see LineDistance; what is
    //! beyond is a violation, relative to it. 0: none.
    double limit = 0;
};

//! A numeric key of a campaign that a sensitivity study varies.
struct KeyFactor {
    std::string key;  //!< such as "optics.soil_albedo"
    Range range;
    std::string unit{};  //!< "1" if it has none
    //! The value in the campaign; the middle of the range if it has none.
    double value = 0;
};

//! The genes and keys that candidates differ in.
struct Variation {
    bool has_traits = true;  //!< free genes are factors
    std::vector<KeyFactor> keys;
};

//! The number of the best candidates that are evaluated again at the end, and
//! how exactly.
struct FinalRule {
    int candidates = 5;
    Accuracy sampling{16384, 16};
};

//! The time and the attempts that workers may take. It is no part of the study
//! and may differ when a case is resumed.
struct AnswerLimits {
    double deadline = 60;  //!< of an evaluation, at least [s]
    int attempts = 3;
};

//! A waveband of a campaign.
struct BandEntry {
    std::string name;
};

//! The band whose error a tolerance bounds.
enum class BoundedBand { par, nir };

//! The places of the plants of a component in the field.
struct Standing {
    std::vector<int> rows{};  //!< of the field, from 0
    //! Instead of rows: so many of the places of plants that are bred, drawn
    //! for each field. 0: none.
    int mixed = 0;
    int plants = 0;                  //!< in each of its rows; 0: as the field's
    int later = 0;                   //!< it emerges than the crop [d]
    std::optional<double> jitter{};  //!< in the place of the field's [deg]
    //! Variation of its plants, in the place of that of the field.
    std::optional<PlantVariation> variation{};
};

//! A kind of plant that stands in the field beside that of the campaign's crop.
struct ComponentEntry {
    std::string name;
    Standing standing;
    Crop crop;
    std::vector<Range> bounds;  //!< of trait_numbers(crop)
    TraitSet free;              //!< its bred traits; none: it stays as it is
    PlantOptics optics, nir_optics;
    std::optional<Photosynthesis> photosynthesis{};  //!< if leaves assimilate
    Stomata stomata{};                               //!< if they exchange water
};

//! The way in which the values of several scenarios become one objective.
enum class Across { mean, worst };

//! A key that trades speed for accuracy, such as "light.paths".
struct AccuracyKey {
    std::string path;
    double value = 0;
    std::vector<double> values;  //!< to try, the most accurate last
};

//! A whole study as written in a TOML file: immutable once read. Every key,
//! its unit, range and default are listed in docs/campaign_files.md.
struct Campaign {
    std::string source;    //!< the text of the campaign file as it was read
    std::string resolved;  //!< a complete campaign in canonical form: every
                           //!< key with its value, the plant inlined
    std::string sha256;    //!< of resolved
    std::vector<AccuracyKey> accuracy;
    std::vector<Problem> warnings;  //!< what may be wrong with it
    //! Numbers of the baseline that are outside the bounds in which they would
    //! be bred, then the lines to write. Only breeding needs them to be inside.
    std::vector<Problem> outside_bounds;

    std::string name;
    std::uint64_t seed = 1;
    int replicates = 1;

    std::vector<Site> sites;
    std::vector<Named<DaySpan>> days;
    std::vector<Named<Climate>> climates;  //!< instead of days
    std::vector<SiteWeather> weathers;     //!< of each site in each of those
    std::vector<Named<Spacing>> spacings;
    std::vector<Named<TraitSet>> trait_sets;

    FieldForm field;  //!< spacing is set per case
    Crop crop;
    std::vector<Range> bounds;  //!< of trait_numbers(crop)
    double reach = 0;  //!< no leaf within the bounds reaches higher [m]
    Tessellation tessellation;
    PlantOptics optics = usual_optics;       //!< of plants, in the PAR band
    double soil_albedo = usual_soil_albedo;  //!< the same of the soil
    std::optional<Photosynthesis> photosynthesis;  //!< if leaves assimilate
    std::optional<LeafWater> water{};  //!< if leaves exchange heat and water
    Stomata stomata{};                 //!< of the crop's leaves then
    double water_limit = 0;            //!< of transpiration; 0: none [mm]
    double par_fraction = 0.45;
    //! Wavebands that light is followed in, beside PAR.
    std::vector<BandEntry> bands;
    bool has_nir = false;  //!< whether near infrared is one of them
    PlantOptics nir_optics = usual_nir_optics;       //!< in the near infrared
    double nir_soil_albedo = usual_nir_soil_albedo;  //!< the same of the soil
    //! The waveband in which the tolerance bounds the light of leaves.
    BoundedBand bounded_band = BoundedBand::par;
    std::vector<ComponentEntry> components;  //!< components beside the crop
    std::vector<PanelEntry> panels;
    std::vector<ObjectEntry> objects;
    SkyModel sky_model = SkyModel::uniform;  //!< of diffuse light
    //! The number of dates of a climate whose suns stand for all. 0: without a
    //! climate.
    int sun_dates = 3;
    int stages = 10;    //!< of canopies that grow
    Accuracy sampling;  //!< of an evaluation during evolution
    //! Quantities that are searched for, in this order.
    std::vector<std::string> maximised{"absorbed_par"}, minimised;
    //! Weight of each component in the objectives, the one that is bred
    //! first. Empty: objectives are those of all plants together.
    std::vector<double> weights;
    //! Yield of each component when it stands alone, in the unit of the
    //! objective, which is then the land equivalent ratio, and standard errors
    //! of that. Empty: the objective is no such ratio.
    std::vector<double> sole, sole_errors;
    //! Axes whose entries are scenarios of one case, by the names of tables.
    std::vector<std::string> over;
    Across across = Across::mean;
    Constraints constraints;
    Feasibility feasibility;
    SearchSettings search;
    Variation varied;  //!< traits alone, but in a sensitivity study
    //! Each row has light of its own in the field of all; else those of a
    //! generation share both.
    bool has_light_by_row = false;
    //! To vary keys again, if there are any: see at_keys().
    std::shared_ptr<const Draft> draft;
    StopRules stop;
    FinalRule final_rule;
    AnswerLimits answer_limits;
};

//! An objective as a campaign asks for it.
struct ObjectiveEntry {
    std::string name;      //!< "net_assimilation" or "soybean.net_assimilation"
    std::string quantity;  //!< its name without that of a component
    std::optional<std::size_t> component{};  //!< if it is of one alone
    Sense sense = Sense::maximise;
};

//! Doubts a canopy with more leaves than fields have, "has a leaf area index of
//! 9.3, ..."; "" for others.
std::string doubt_of_lai(double lai);

//! The names of all components, that of the crop's plant first.
std::vector<std::string> component_names(const Campaign& campaign);

//! Returns the objectives of a campaign, at least one.
std::vector<ObjectiveEntry> objectives_of(const Campaign& campaign);

//! Returns the weight of each component in objectives; empty: they are of all
//! plants together.
std::vector<double> component_weights(const Campaign& campaign);

//! The unit of a quantity, or of the ratio that it is as an objective.
std::string unit_of(const Campaign& campaign, const std::string& quantity);

//! Whether an objective is of what leaves make of light.
bool asks_for_assimilation(const Campaign& campaign);

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

//! One point of the sweep: a single evolution with its own history.
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

//! The rows of the field, from 0, in which plants are bred.
std::vector<int> bred_rows(const Campaign& campaign);

//! The number of plants of the field that are bred.
std::size_t bred_plants(const Campaign& campaign);

//! Whether the entries of an axis are scenarios of one case.
bool is_over(const Campaign& campaign, const std::string& axis);

//! The scenarios of a case, at least one.
std::vector<Case> scenarios(const Case& chosen);

//! Each scenario of a case at each of its stages.
std::vector<Case> evaluated_cases(const Case& chosen);

//! Reads and checks a campaign file and the crop file that it names.
//! @param settings "table.key=value", in the place of what the file says
//! @throws InputError with all problems of both files.
//! @throws Error if a file cannot be read.
Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings = {});

//! Reads and checks the text of a campaign file that would be at this path:
//! files that it names are looked for from there.
Campaign read_campaign_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& settings = {});

//! Reads a campaign as a sensitivity study, which evaluates the design of its
//! [sensitivity] instead of searching, with one replicate unless a setting asks
//! for more.
Campaign read_study(const std::string& path,
                    const std::vector<std::string>& settings = {});

//! Parses the text of a resolved campaign; file is used in messages.
//! parse_campaign(c.resolved, f).resolved == c.resolved.
//! @throws InputError
Campaign parse_campaign(const std::string& text, const std::string& file);

//! @throws InputError if the baseline is outside its bounds.
void require_breedable(const Campaign& campaign);

//! Reads a crop file, a table of measured leaves (.csv) with the crop that it
//! names, or the crop of a campaign file.
//! @param other plant that tells what a table does not if it names no crop
//! @throws InputError with all problems.
//! @throws Error if a file cannot be read.
Crop read_crop(const std::string& path, const Plant* other = nullptr);

//! The baseline of read_crop().
Plant read_plant(const std::string& path);

//! Reads the [photosynthesis] table of a file, which has nothing else in it.
//! What it leaves out is as in a campaign, but leaves do not differ by depth
//! (profile "none") nor follow the weather.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
Photosynthesis read_photosynthesis(const std::string& path);

//! The light of a season, and what may be wrong with its file.
struct SeasonLight {
    LightSeries series;
    std::vector<Problem> warnings;
};

//! Reads the tables [site] and [climate] of a file that has nothing else, and
//! the weather that they name.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
SeasonLight read_climate(const std::string& path);

//! The text of a crop file with the traits of a component, the campaign's crop
//! unless another is chosen, and another baseline.
std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component = 0);

//! The light of a case, or of the first of its scenarios: of its clear days, or
//! of its weather.
LightSeries light_of(const Campaign& campaign, const Case& chosen);

//! All cases in their order: sites, then days or climates, spacings, trait
//! sets, and replicates fastest; of axes whose entries are scenarios one, which
//! is called "all". Adding an entry to an axis does not change the
//! name or seed of any other case.
std::vector<Case> cases(const Campaign& campaign);

//! The case of this index.
//! @param path of the campaign, for the message
//! @throws Error of wrong usage if there is none.
Case case_at(const Campaign& campaign, int index, const std::string& path);

//! The climate of a case.
const Climate& climate_of(const Campaign& campaign, const Case& chosen);

//! One plant for each component, that of the campaign's crop first.
using Plants = std::vector<Plant>;

//! The numbers of the crop's baseline, then those of components that are bred:
//! as gene_space().
Genome baseline_genome(const Campaign& campaign);

//! The number of genes of a genome, without keys that are varied.
std::size_t count_genes(const Campaign& campaign);

//! The plants that a genome makes of the baselines of all components.
//! @throws Error if it has too few or too many genes
Plants grow(const Campaign& campaign, const Genome& genome);

//! The genes of a case with their bounds, those of the crop first, then those
//! of components that are bred, "soybean.petiole_length". Genes outside the
//! trait set are not free.
GeneSpace gene_space(const Campaign& campaign, const Case& chosen);

//! Returns the genes of a case and, behind them, the keys that a study or a
//! search varies. Where traits are not varied, no gene of them is free.
GeneSpace search_genes(const Campaign& campaign, const Case& chosen);

//! The campaign with those keys set to the last numbers of a genome of these
//! genes, which are removed.
//! @throws InputError if they contradict the rest of the campaign.
Campaign at_keys(const Campaign& campaign, Genome& genome);

//! Tells how two resolved campaigns differ in what a case is made of, one
//! line per key: "light.paths was 4096, is 8192". Empty if nothing does. Sites,
//! days, climates, spacings and trait sets of other cases, and how many
//! replicates there are, are no part of it.
std::vector<std::string> differences(const std::string& was,
                                     const std::string& is, const Case& chosen);

}  // namespace ideotype
