// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "climates.hpp"
#include "components.hpp"
#include "constraints.hpp"
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

//! A campaign as it is read.
struct Draft;

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
    double deadline = 60;  //!< deadline of an evaluation, at least [s]
    int attempts = 3;
};

//! A waveband of a campaign.
struct BandEntry {
    std::string name;
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
    std::string sha256;    //!< SHA-256 of the resolved text
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
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    double reach = 0;  //!< no leaf within the bounds reaches higher [m]
    Tessellation tessellation;
    ByBand<PlantOptics> optics = usual_optics;  //!< optics of plants
    ByBand<double> soil_albedo = usual_soil_albedo;
    std::optional<Photosynthesis> photosynthesis;  //!< if leaves assimilate
    std::optional<LeafWater> water{};  //!< if leaves exchange heat and water
    Stomata stomata{};                 //!< stomata of the leaves of the crop
    double water_limit = 0;            //!< limit of transpiration; 0: none [mm]
    double par_fraction = 0.45;
    std::vector<BandEntry> bands;  //!< wavebands that it names
    ByBand<bool> follows{true};    //!< whether light is followed in each
    //! The waveband in which the tolerance bounds the light of leaves.
    std::string bounded_band = wavebands[0].name;
    std::vector<ComponentEntry> components;  //!< components beside the crop
    std::vector<PanelEntry> panels;
    std::vector<ObjectEntry> objects;
    SkyModel sky_model = SkyModel::uniform;  //!< sky model of diffuse light
    //! The number of dates of a climate whose suns stand for all. 0: without a
    //! climate.
    int sun_dates = 3;
    int stages = 10;    //!< stages of canopies that grow
    Accuracy sampling;  //!< accuracy of evaluations in the search
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
    //! The draft whose keys at_keys() varies, if there are any.
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

//! Returns the names of all components, that of the crop's plant first.
std::vector<std::string> component_names(const Campaign& campaign);

//! Returns the objectives of a campaign, at least one.
std::vector<ObjectiveEntry> objectives_of(const Campaign& campaign);

//! Returns the weight of each component in objectives; empty: they are of all
//! plants together.
std::vector<double> component_weights(const Campaign& campaign);

//! Returns the unit of a quantity, or of the ratio that it is as an objective.
std::string unit_of(const Campaign& campaign, const std::string& quantity);

//! Returns whether a quantity of some kind is an objective or tells kinds
//! apart.
bool asks_for(const Campaign& campaign, bool (*is_of)(const std::string&));

//! Returns whether an objective is of what leaves make of light.
bool asks_for_assimilation(const Campaign& campaign);

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

//! Returns the baseline of read_crop().
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

//! Returns the text of a crop file with the traits of a component, the
//! campaign's crop unless another is chosen, and another baseline.
std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component = 0);

//! Returns the campaign with those keys set to the last numbers of a genome of
//! these genes, which are removed.
//! @throws InputError if they contradict the rest of the campaign.
Campaign at_keys(const Campaign& campaign, Genome& genome);

//! Tells how two resolved campaigns differ in what a case is made of, one
//! line per key: "light.paths was 4096, is 8192". Empty if nothing does. Sites,
//! days, climates, spacings and trait sets of other cases, and how many
//! replicates there are, are no part of it.
std::vector<std::string> differences(const std::string& was,
                                     const std::string& is, const Case& chosen);

}  // namespace ideotype
