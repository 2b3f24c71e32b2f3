#include "ideotype/campaign/campaign.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "checks.hpp"
#include "draft.hpp"
#include "ideotype/core/hash.hpp"
#include "photosynthesis_table.hpp"
#include "reader.hpp"
#include "report.hpp"
#include "resolve.hpp"
#include "weather_reader.hpp"

namespace ideotype {

namespace {

//! As high as the highest leaf with all numbers at their upper bounds, or of
//! the baseline, if it stood upright [m].
double reach_of(const Campaign& campaign) {
    std::vector<double> most;
    for (const Range& range : campaign.bounds) most.push_back(range.upper);
    const Plant largest = grow(campaign.crop, most);
    double top = 0;
    for (const Plant* plant : {&campaign.crop.baseline, &largest})
        for (const Leaf& leaf : plant->leaves)
            top = std::max(top, leaf.insertion_height + leaf.length);
    return top;
}

//! What Hansen (arXiv:1604.00772) advises for the most genes of any trait set.
int usual_population(const Campaign& campaign) {
    std::size_t most = 1;
    for (const Named<TraitSet>& set : campaign.trait_sets) {
        std::size_t genes = 0;
        for (const TraitNumber& number : trait_numbers(campaign.crop))
            genes += static_cast<std::size_t>(
                std::count(set.value.begin(), set.value.end(),
                           campaign.crop.traits[number.trait].name));
        most = std::max(most, genes);
    }
    return 4 + static_cast<int>(3 * std::log(static_cast<double>(most)));
}

Campaign complete(Draft& draft, const std::string& source,
                  const Report& report) {
    Campaign campaign = draft.campaign;
    Crop& crop = campaign.crop;
    for (const TraitEntry& entry : draft.traits)
        crop.traits.push_back(complete(entry));
    const std::vector<double> baseline = baseline_numbers(crop);
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        campaign.bounds.push_back(
            bounds_of(draft, numbers[i].trait, baseline[i]));
    campaign.reach = reach_of(campaign);
    if (campaign.search.optimizer == OptimizerKind::cma_es &&
        !draft.has_population)
        draft.campaign.search.population = campaign.search.population =
            usual_population(campaign);
    if (draft.has_photosynthesis)
        campaign.photosynthesis = to_photosynthesis(draft.photosynthesis);
    std::erase_if(campaign.constraints.traits,
                  [](const TraitConstraint& x) { return !constrains(x); });
    campaign.source = source;
    campaign.warnings = report.warnings();
    campaign.resolved = resolved_text(draft);
    if (campaign.climates.empty()) campaign.sun_dates = 0;
    campaign.sha256 = sha256(campaign.resolved);
    return campaign;
}

Campaign parse(const std::string& text, const std::string& file,
               PlantSource source,
               const std::vector<std::string>& settings = {}) {
    Draft draft;
    Report report;
    read_draft(text, file, source, settings, draft, report);
    read_weathers(file, source, draft, report);
    check_draft(draft, report);
    report.throw_if_any();
    return complete(draft, text, report);
}

}  // namespace

Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings) {
    const std::optional<std::string> text = read_text(path);
    if (!text) throw Error("cannot read " + path);
    return parse(*text, path, PlantSource::file_or_table, settings);
}

Plant read_plant(const std::string& path) {
    const std::optional<std::string> text = read_text(path);
    if (!text) throw Error("cannot read " + path);
    Draft draft;
    Report report;
    if (!read_plant_draft(*text, path, draft, report))
        return parse(*text, path, PlantSource::file_or_table).crop.baseline;
    check_plant(draft, report);
    report.throw_if_any();
    return draft.campaign.crop.baseline;
}

Photosynthesis read_photosynthesis(const std::string& path) {
    const std::optional<std::string> text = read_text(path);
    if (!text) throw Error("cannot read " + path);
    PhotosynthesisTable table;
    table.profile = CapacityProfile::none;
    table.follows_weather = false;
    Report report;
    read_tables(*text, path, {one_table(photosynthesis_section(table))},
                report);
    check_photosynthesis(table, 0, report);
    report.throw_if_any();
    return to_photosynthesis(table);
}

SeasonLight read_climate(const std::string& path) {
    const std::optional<std::string> text = read_text(path);
    if (!text) throw Error("cannot read " + path);
    Draft draft;
    Report report;
    Campaign& campaign = draft.campaign;
    campaign.sites.assign(1, {});
    campaign.climates.assign(1, {});
    // It has no [optics].
    report.locate(&campaign.par_fraction, {path, 1, 1});
    read_tables(*text, path, climate_file_tables(campaign), report);
    read_weathers(path, PlantSource::file_or_table, draft, report);
    report.throw_if_any();
    Case chosen;
    chosen.site = campaign.sites.front();
    chosen.day_name = campaign.climates.front().name;
    return {light_of(campaign, chosen), report.warnings()};
}

std::vector<Aim> aims(const Campaign& campaign) {
    std::vector<Aim> all;
    for (const std::string& each : campaign.maximised)
        all.push_back({each, Sense::maximise});
    for (const std::string& each : campaign.minimised)
        all.push_back({each, Sense::minimise});
    return all;
}

std::string crop_text(const Campaign& campaign, const Plant& baseline) {
    Draft draft;
    Report report;
    read_draft(campaign.resolved, campaign.name, PlantSource::table, {}, draft,
               report);
    draft.campaign.crop.baseline = baseline;
    return resolved_plant_text(draft);
}

Campaign parse_campaign(const std::string& text, const std::string& file) {
    return parse(text, file, PlantSource::table);
}

}  // namespace ideotype
