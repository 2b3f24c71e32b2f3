// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "entries.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/climate/sun.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/accuracy.hpp"
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

//! A campaign while it is being read.
struct Draft;

//! A numeric key of a campaign that a sensitivity study varies.
struct KeyFactor {
    std::string key;  //!< key such as "optics.soil_albedo"
    Range range;
    std::string unit{};  //!< unit; "1": none
    double value = 0;    //!< value in the campaign, or the middle of the range
};

//! The genes and keys in which candidates differ.
struct Variation {
    bool has_traits = true;  //!< whether free genes are factors
    std::vector<KeyFactor> keys;
};

//! The number of the best candidates that are evaluated again at the end, and
//! the accuracy of these evaluations.
struct FinalRule {
    int candidates = 5;
    Accuracy sampling{16384, 16};
};

//! The time and the number of attempts that workers may take. These limits do
//! not belong to the study and may differ when a case is resumed.
struct AnswerLimits {
    double deadline = 60;  //!< least deadline of an evaluation [s]
    int attempts = 3;
};

//! A waveband that a campaign names.
struct BandEntry {
    std::string name;
};

//! The way in which values from several scenarios become one objective.
enum class Across { mean, worst };

//! A key that trades speed for accuracy, such as "light.paths".
struct AccuracyKey {
    std::string path;
    double value = 0;
    std::vector<double> values;  //!< values for `fidelity`, most accurate last
};

//! A whole study as written in a TOML file: immutable once read. Every key,
//! with its unit, range and default, is listed in docs/campaign_files.md.
struct Campaign {
    std::string source;    //!< text of the campaign file as read
    std::string resolved;  //!< campaign in canonical form, the plant inlined
    std::string sha256;    //!< SHA-256 of the resolved text
    std::vector<AccuracyKey> accuracy;
    std::vector<Problem> warnings;  //!< possible faults of the campaign
    //! Numbers of the baseline outside the bounds in which breeding would keep
    //! them, then the lines to write. Only breeding needs all numbers inside.
    std::vector<Problem> outside_bounds;
    //! Tables with bounds that contain the baseline, in place of the rule of
    //! bounds; "" if the rule contains it.
    std::string wider_bounds;

    std::string name;
    std::uint64_t seed = 1;
    int replicates = 1;

    std::vector<Site> sites;
    std::vector<Named<DaySpan>> days;
    std::vector<Named<Climate>> climates;  //!< climates that replace days
    std::vector<SiteWeather> weathers;     //!< weather by site and climate
    std::vector<Named<Spacing>> spacings;
    std::vector<Named<TraitSet>> trait_sets;

    FieldForm field;  //!< field; each case sets its spacing
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    //! Development stage of plants that do not grow, from emergence (0) over
    //! silking (1) to maturity (2); it fixes the capacity of leaves by the
    //! ageing of their crop, and nothing else.
    double stage = 1;
    double reach = 0;  //!< height that no leaf within the bounds exceeds [m]
    Tessellation tessellation;
    ByBand<PlantOptics> optics = usual_optics;  //!< optics of plants
    ByBand<double> soil_albedo = usual_soil_albedo;
    //! Model, if leaves assimilate.
    std::optional<Photosynthesis> photosynthesis;
    //! Photosynthesis of each component, the crop first, if leaves assimilate.
    std::vector<StatedLeaves> leaves;
    //! Rules of the exchange, if leaves exchange heat and water.
    std::optional<LeafWater> water{};
    Stomata stomata{};       //!< stomata of the leaves of the crop
    double water_limit = 0;  //!< most transpiration [mm]; 0: any
    double par_fraction = 0.45;
    std::vector<BandEntry> bands;  //!< wavebands in the campaign file
    ByBand<bool> follows{true};    //!< whether light in a band is followed
    //! Name of the waveband in which the tolerance bounds the light of leaves.
    std::string bounded_band = wavebands[0].name;
    std::vector<ComponentEntry> components;  //!< components beside the crop
    std::vector<PanelEntry> panels;
    std::vector<ObjectEntry> objects;
    SkyModel sky_model = SkyModel::uniform;  //!< sky model of diffuse light
    int sun_dates = 3;  //!< dates of a climate whose suns stand for all; else 0
    int stages = 10;    //!< stages of canopies that grow
    Accuracy sampling;  //!< accuracy of evaluations in the search
    //! Names of objectives, in this order.
    std::vector<std::string> maximised{"absorbed_par"}, minimised;
    //! Weight of each component in the objectives, the bred component first.
    //! Empty: objectives are those of all plants together.
    std::vector<double> weights;
    //! Yield of each component alone, in the unit of the objective, and its
    //! standard error. Empty: the objective is no land equivalent ratio.
    std::vector<double> sole, sole_errors;
    //! Axes whose entries are scenarios of one case, by table name.
    std::vector<std::string> over;
    Across across = Across::mean;
    Constraints constraints;
    Feasibility feasibility;
    SearchSettings search;
    Variation varied;  //!< only traits, unless in a study
    //! Whether each row has light of its own, in a shared field or in fields of
    //! its own; otherwise rows of a generation share light and fields.
    bool has_light_by_row = false;
    //! The draft whose keys at_keys() varies, if any keys are varied.
    std::shared_ptr<const Draft> draft;
    StopRules stop;
    FinalRule final_rule;
    AnswerLimits answer_limits;
};

//! An objective in the form in which a campaign names it.
struct ObjectiveEntry {
    std::string name;      //!< name such as "soybean.net_assimilation"
    std::string quantity;  //!< name without a component
    std::optional<std::size_t> component{};  //!< component, if only one counts
    Sense sense = Sense::maximise;
};

//! Returns a doubt about a canopy with more leaves than fields have, such as
//! "has a leaf area index of 9.3, ..."; "" for other canopies.
std::string doubt_of_lai(double lai);

//! Returns the names of all components, the campaign's crop first.
std::vector<std::string> component_names(const Campaign& campaign);

//! Returns the objectives of a campaign, at least one.
std::vector<ObjectiveEntry> objectives_of(const Campaign& campaign);

//! Returns the weight of each component in objectives; empty: objectives are
//! those of all plants together.
std::vector<double> component_weights(const Campaign& campaign);

//! Returns the unit of a quantity, or of the ratio that replaces the quantity
//! as an objective.
std::string unit_of(const Campaign& campaign, const std::string& quantity);

//! Returns whether a kind of quantity is an objective or an axis of an atlas.
bool asks_for(const Campaign& campaign, bool (*is_of)(const std::string&));

//! Returns whether an objective depends on the assimilation of leaves.
bool asks_for_assimilation(const Campaign& campaign);

//! Reads and checks a campaign file and the crop file that it names.
//! @param settings "table.key=value", each replacing a value of the file
//! @throws InputError with all problems of both files.
//! @throws Error if a file cannot be read.
Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings = {});

//! Reads and checks a campaign's text, in which paths are relative to `path`.
Campaign read_campaign_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& settings = {});

//! Reads a campaign as a sensitivity study, which evaluates the design of the
//! table [sensitivity] instead of searching, with one replicate unless a
//! setting asks for more.
Campaign read_study(const std::string& path,
                    const std::vector<std::string>& settings = {});

//! Parses the text of a resolved campaign; messages name the file.
//! parse_campaign(c.resolved, f).resolved == c.resolved.
//! @param settings "table.key=value", each replacing a value of the text
//! @throws InputError with all problems.
Campaign parse_campaign(const std::string& text, const std::string& file,
                        const std::vector<std::string>& settings = {});

//! Checks the baseline.
//! @throws InputError if the baseline is outside its bounds.
void require_breedable(const Campaign& campaign);

//! Reads a crop file, or the crop of a campaign file.
//! @throws InputError with all problems.
//! @throws Error if a file cannot be read.
Crop read_crop(const std::string& path);

//! Reads the [photosynthesis] table of a file that has no other tables. Missing
//! keys have the defaults of a campaign, except that leaves do not differ by
//! depth (profile "none") nor follow the weather.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
Photosynthesis read_photosynthesis(const std::string& path);

//! The light of a season, and warnings about its file.
struct SeasonLight {
    LightSeries series;
    std::vector<Problem> warnings;
};

//! Reads the tables [site] and [climate] of a file without other tables, and
//! the weather file that [climate] names.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
SeasonLight read_climate(const std::string& path);

//! Returns the text of a crop file with another baseline and the traits of a
//! component, by default the campaign's crop.
std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component = 0);

//! Returns the campaign with varied keys set to the last numbers of a genome,
//! which are removed from the genome.
//! @throws InputError if the keys contradict the rest of the campaign.
Campaign at_keys(const Campaign& campaign, Genome& genome);

//! Tells how two resolved campaigns differ in the keys that concern a case, one
//! line per key: "light.paths was 4096, is 8192". Empty if no key differs.
//! Sites, days, climates, spacings and trait sets of other cases, and the
//! number of replicates, are ignored.
std::vector<std::string> differences(const std::string& was,
                                     const std::string& is, const Case& chosen);

}  // namespace ideotype
