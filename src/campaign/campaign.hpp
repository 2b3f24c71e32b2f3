// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
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

//! A complete study, ready to be evaluated: the contents of its file with all
//! defaults, and derived data. It is not changed after it has been made.
struct Campaign {
    std::string source;             //!< text of the campaign file as read
    std::string resolved;           //!< canonical text, with the plant inlined
    std::string sha256;             //!< SHA-256 of the resolved text
    std::vector<Problem> warnings;  //!< possible faults of the campaign
    //! Trait values of the baseline outside the bounds of the search, followed
    //! by lines that would correct the bounds. Only searches require all values
    //! inside.
    std::vector<Problem> outside_bounds;
    //! Tables that could replace the rule of bounds: their bounds include the
    //! baseline. "" if the rule's bounds already do.
    std::string wider_bounds;

    Spec spec;
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    double reach = 0;  //!< largest height of any leaf within the bounds [m]
    ByBand<bool> follows{true};  //!< wavebands in which light is traced
    Accuracy sampling;           //!< accuracy of evaluations in the search
    //! Photosynthesis model of the main crop, if assimilation is computed.
    std::optional<Photosynthesis> photosynthesis;
    //! Photosynthesis of each component, the main crop first, if assimilation
    //! is computed.
    std::vector<StatedLeaves> leaves;
    //! Parameters of heat and water exchange, if these are computed.
    std::optional<LeafWater> water{};
    Stomata stomata{};  //!< stomata of the main crop
    //! Components besides the main crop.
    std::vector<ComponentEntry> components;
    SearchSettings search;
    Variation varied;  //!< only traits, unless keys are varied
    //! Whether each row uses independent random numbers for light, and for
    //! fields if there are several. Otherwise the rows of a generation use
    //! common random numbers.
    bool has_light_by_row = false;
    StopRules stop;
    FinalRule final_rule;
};

//! An objective that a campaign names.
struct ObjectiveEntry {
    std::string name;      //!< name such as "soybean.net_assimilation"
    std::string quantity;  //!< name without the component
    std::optional<std::size_t>
        component{};  //!< component, if it refers to a single one
    Sense sense = Sense::maximise;
};

//! Returns a warning if a leaf area index is unrealistic, such as "has a leaf
//! area index of 9.3, ..."; otherwise "".
std::string doubt_of_lai(double lai);

//! Returns the names of all components, the main crop first.
std::vector<std::string> component_names(const Campaign& campaign);

//! Returns the objectives of a campaign. There is at least one.
std::vector<ObjectiveEntry> objectives_of(const Campaign& campaign);

//! Returns the weight of each component in objectives. If empty, objectives
//! refer to all plants together.
std::vector<double> component_weights(const Campaign& campaign);

//! Returns the unit of a quantity, or of the land equivalent ratio that
//! replaces it as an objective.
std::string unit_of(const Campaign& campaign, const std::string& quantity);

//! Returns the unit of the value of an objective over all scenarios.
std::string unit_of(const Campaign& campaign, const ObjectiveEntry& objective);

//! Returns whether a condition holds for any objective or axis of an atlas.
bool asks_for(const Campaign& campaign, bool (*is_of)(const std::string&));

//! Reads and checks a campaign file and the crop files that it names.
//! @param settings values in the form "table.key=value", which replace values
//! of the file
//! @throws InputError with all problems of all these files.
//! @throws Error if a file cannot be read.
Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings = {});

//! Reads and checks the text of a campaign; paths in it are relative to `path`.
Campaign read_campaign_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& settings = {});

//! Reads a campaign as a sensitivity study: instead of a search, it evaluates
//! the design given by the table [sensitivity]. It uses one replicate unless a
//! setting requests more.
Campaign read_study(const std::string& path,
                    const std::vector<std::string>& settings = {});

//! Parses the text of a resolved campaign; parse_campaign(c.resolved,
//! f).resolved equals c.resolved.
//! @param file name of the file in messages
//! @param settings values in the form "table.key=value", which replace values
//! of the text
//! @throws InputError with all problems.
Campaign parse_campaign(const std::string& text, const std::string& file,
                        const std::vector<std::string>& settings = {});

//! Parses the campaign of a history in the same way. Keys that this version
//! does not know are ignored, with a warning unless they have their former
//! default.
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

//! Reads the [photosynthesis] table of a file without other tables. Defaults
//! are those of a campaign, except that capacity is uniform with depth (profile
//! "none") and does not depend on the weather.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
Photosynthesis read_photosynthesis(const std::string& path);

//! The light of a season, and warnings about the file that it was read from.
struct SeasonLight {
    LightSeries series;
    std::vector<Problem> warnings;
};

//! Reads the tables [site] and [climate] of a file without other tables, and
//! the weather file that [climate] names.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
SeasonLight read_climate(const std::string& path);

//! Checks that a component (0: the main crop) is given by a crop file.
//! @throws Error of wrong usage if it is given by a mesh.
void require_crop(const Campaign& campaign, std::size_t component);

//! Returns the text of a crop file with a new baseline and with the traits of a
//! component, by default the main crop.
std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component = 0);

//! Makes a campaign from a checked specification. A pure function.
Campaign resolve(const Spec& spec);

//! Returns a campaign with other values of variable keys, without texts.
//! @param numbers numbers of the keys, as for set_keys()
//! @throws InputError if the keys contradict each other.
Campaign with_keys(const Campaign& campaign, const std::vector<KeyFactor>& keys,
                   std::span<const double> numbers);

//! Returns whether a draw changes plants or light, not only assimilation, grain
//! or prices.
bool draws_change_light(const Spec& spec);

//! Sets varied keys from the last numbers of a genome, removes these numbers
//! from the genome, and returns the resulting campaign without texts.
//! @throws InputError if the keys contradict each other.
Campaign at_keys(const Campaign& campaign, Genome& genome);

//! Lists the differences between two campaigns in keys that affect a case, one
//! line per key: "light.paths was 4096, is 8192". Axis entries of other cases,
//! the number of replicates and the limits of workers are ignored.
std::vector<std::string> differences(const Spec& was, const Spec& is,
                                     const Case& chosen);

}  // namespace ideotype
