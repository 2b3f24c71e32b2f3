// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "entries.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/accuracy.hpp"
#include "search/outcome.hpp"
#include "search/population.hpp"
#include "search/settings.hpp"
#include "search/stop_rules.hpp"
#include "spec/spec.hpp"

namespace ideotype {

//! The genes and campaign keys that a search or study varies.
struct Variation {
    bool has_traits = true;  //!< whether free genes are factors
    std::vector<KeyFactor> keys;
};

//! The number of best candidates that are re-evaluated at the end, and the
//! accuracy of these evaluations.
struct FinalRule {
    int candidates = 5;
    Accuracy sampling{16384, 16};
};

//! A complete study, ready to be evaluated: the contents of its file, defaults,
//! and derived data. Immutable once made.
struct Campaign {
    std::string source;    //!< text of the campaign file as read
    std::string resolved;  //!< campaign in canonical form, the plant inlined
    std::string sha256;    //!< SHA-256 of the resolved text
    std::vector<Problem> warnings;  //!< possible faults of the campaign
    //! Trait values of the baseline outside the bounds of the search, then the
    //! lines to write instead. Only searches require all values inside.
    std::vector<Problem> outside_bounds;
    //! Tables with bounds that include the baseline, to replace the rule of
    //! bounds; "" if the rule includes it.
    std::string wider_bounds;

    Spec spec;
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    double reach = 0;  //!< largest height of any leaf within the bounds [m]
    ByBand<bool> follows{true};  //!< whether light in a band is traced
    Accuracy sampling;           //!< accuracy of evaluations in the search
    //! Photosynthesis model of the main crop, if leaves assimilate.
    std::optional<Photosynthesis> photosynthesis;
    //! Photosynthesis of each component, the main crop first, if leaves
    //! assimilate.
    std::vector<StatedLeaves> leaves;
    //! Parameters of heat and water exchange, if leaves exchange them.
    std::optional<LeafWater> water{};
    Stomata stomata{};                       //!< stomata of the main crop
    std::vector<ComponentEntry> components;  //!< further components
    SearchSettings search;
    Variation varied;  //!< only traits, unless keys are varied
    //! Whether each row has independent random numbers for light (and for
    //! fields, if there are several); otherwise rows of a generation have
    //! common random numbers.
    bool has_light_by_row = false;
    StopRules stop;
    FinalRule final_rule;
};

//! An objective as named in a campaign.
struct ObjectiveEntry {
    std::string name;      //!< name such as "soybean.net_assimilation"
    std::string quantity;  //!< name without a component
    std::optional<std::size_t>
        component{};  //!< component, if it is of a single component
    Sense sense = Sense::maximise;
};

//! Returns a warning about an unrealistic leaf area index, such as "has a leaf
//! area index of 9.3, ..."; "" for other canopies.
std::string doubt_of_lai(double lai);

//! Returns the names of all components, the main crop first.
std::vector<std::string> component_names(const Campaign& campaign);

//! Returns the objectives of a campaign, at least one.
std::vector<ObjectiveEntry> objectives_of(const Campaign& campaign);

//! Returns the weight of each component in objectives; empty: objectives refer
//! to all plants together.
std::vector<double> component_weights(const Campaign& campaign);

//! Returns the unit of a quantity, or of the land equivalent ratio that
//! replaces it as an objective.
std::string unit_of(const Campaign& campaign, const std::string& quantity);

//! Returns whether any objective or axis of an atlas is of a certain kind.
bool asks_for(const Campaign& campaign, bool (*is_of)(const std::string&));

//! Reads and checks a campaign file and the crop files that it names.
//! @param settings values in the form "table.key=value" that replace those of
//! the file
//! @throws InputError with all problems of both files.
//! @throws Error if a file cannot be read.
Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings = {});

//! Reads and checks the text of a campaign; paths in it are relative to `path`.
Campaign read_campaign_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& settings = {});

//! Reads a campaign as a sensitivity study, which evaluates the design of the
//! table [sensitivity] instead of a search. It has one replicate unless a
//! setting requests more.
Campaign read_study(const std::string& path,
                    const std::vector<std::string>& settings = {});

//! Parses the text of a resolved campaign; messages name the file.
//! parse_campaign(c.resolved, f).resolved == c.resolved.
//! @param settings values in the form "table.key=value" that replace those of
//! the text
//! @throws InputError with all problems.
Campaign parse_campaign(const std::string& text, const std::string& file,
                        const std::vector<std::string>& settings = {});

//! Parses the campaign of a history in the same way. Keys that this version
//! lacks are ignored, with a warning unless they have their former default.
Campaign parse_history_campaign(const std::string& text,
                                const std::string& file,
                                const std::vector<std::string>& settings = {});

//! Checks that the baseline is within the bounds of the search.
//! @throws InputError if it is not.
void require_breedable(const Campaign& campaign);

//! Reads a crop file, or the crop of a campaign file.
//! @throws InputError with all problems.
//! @throws Error if a file cannot be read.
Crop read_crop(const std::string& path);

//! Reads the [photosynthesis] table of a file without other tables. Missing
//! keys have the defaults of a campaign, except that capacity is uniform with
//! depth (profile "none") and does not follow the weather.
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

//! Checks that a component (0: the main crop) has a crop file.
//! @throws Error of wrong usage if it has a mesh.
void require_crop(const Campaign& campaign, std::size_t component);

//! Returns the text of a crop file with a new baseline and the traits of a
//! component, by default the main crop.
std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component = 0);

//! Makes a campaign from a checked description. A pure function.
Campaign resolve(const Spec& spec);

//! Returns the campaign with varied keys set to the last numbers of a genome,
//! and removes these from the genome. The returned campaign has no texts.
//! @throws InputError if the keys contradict each other.
Campaign at_keys(const Campaign& campaign, Genome& genome);

//! Returns the differences of two campaigns in keys that concern a case, one
//! line per key: "light.paths was 4096, is 8192". Entries of other cases, the
//! number of replicates and the limits of workers are ignored.
std::vector<std::string> differences(const Spec& was, const Spec& is,
                                     const Case& chosen);

}  // namespace ideotype
