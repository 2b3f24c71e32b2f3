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

//! A whole study, ready to be evaluated: what its file says, with all that was
//! left open, and what follows from it. Immutable once made.
struct Campaign {
    std::string source;    //!< text of the campaign file as read
    std::string resolved;  //!< campaign in canonical form, the plant inlined
    std::string sha256;    //!< SHA-256 of the resolved text
    std::vector<Problem> warnings;  //!< possible faults of the campaign
    //! Numbers of the baseline outside the bounds in which breeding would keep
    //! them, then the lines to write. Only breeding needs all numbers inside.
    std::vector<Problem> outside_bounds;
    //! Tables with bounds that contain the baseline, in place of the rule of
    //! bounds; "" if the rule contains it.
    std::string wider_bounds;

    Spec spec;
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    double reach = 0;  //!< height that no leaf within the bounds exceeds [m]
    ByBand<bool> follows{true};  //!< whether light in a band is followed
    Accuracy sampling;           //!< accuracy of evaluations in the search
    //! Model, if leaves assimilate.
    std::optional<Photosynthesis> photosynthesis;
    //! Photosynthesis of each component, the crop first, if leaves assimilate.
    std::vector<StatedLeaves> leaves;
    //! Rules of the exchange, if leaves exchange heat and water.
    std::optional<LeafWater> water{};
    Stomata stomata{};                       //!< stomata of the crop's leaves
    std::vector<ComponentEntry> components;  //!< components beside the crop
    SearchSettings search;
    Variation varied;  //!< only traits, unless in a study
    //! Whether each row has light of its own, in a shared field or in fields of
    //! its own; otherwise rows of a generation share light and fields.
    bool has_light_by_row = false;
    StopRules stop;
    FinalRule final_rule;
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

//! Parses the campaign of a history in the same way. Keys that this version
//! does not have are passed over, with a warning unless they have their former
//! default.
Campaign parse_history_campaign(const std::string& text,
                                const std::string& file,
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

//! Checks that a component (0: the plant) has a crop.
//! @throws Error of wrong usage if it has a mesh.
void require_crop(const Campaign& campaign, std::size_t component);

//! Returns the text of a crop file with another baseline and the traits of a
//! component, by default the campaign's crop.
std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component = 0);

//! Makes a campaign of a description without problems: a pure function.
Campaign resolve(const Spec& spec);

//! Returns the campaign with varied keys set to the last numbers of a genome,
//! which are removed from the genome. It has no texts.
//! @throws InputError if the keys contradict each other.
Campaign at_keys(const Campaign& campaign, Genome& genome);

//! Returns how two campaigns differ in the keys that concern a case, one
//! line per key: "light.paths was 4096, is 8192". Empty if no key differs.
//! Sites, days, climates, spacings and trait sets of other cases, the number of
//! replicates, and the limits of workers are ignored.
std::vector<std::string> differences(const Spec& was, const Spec& is,
                                     const Case& chosen);

}  // namespace ideotype
