// SPDX-License-Identifier: Apache-2.0
#include "campaign.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "checks.hpp"
#include "draft.hpp"
#include "ideotype/core/hash.hpp"
#include "key_factors.hpp"
#include "measured_plant.hpp"
#include "photosynthesis_table.hpp"
#include "reader.hpp"
#include "report.hpp"
#include "resolve.hpp"
#include "search/sensitivity_design.hpp"
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
            top =
                std::max(top, furthest(*plant, leaf, campaign.field.variation));
    return top;
}

//! What Hansen (arXiv:1604.00772) advises for the most genes of any trait set.
int usual_population_of(const Campaign& campaign) {
    std::size_t most = 1;
    for (const Named<TraitSet>& set : campaign.trait_sets) {
        std::size_t genes = 0;
        for (const TraitNumber& number : trait_numbers(campaign.crop))
            genes += static_cast<std::size_t>(
                std::count(set.value.begin(), set.value.end(),
                           campaign.crop.traits[number.trait].name));
        most = std::max(most, genes);
    }
    return usual_population(campaign.search.optimizer,
                            most + campaign.varied.keys.size());
}

//! A sensitivity study ends with the last row of its design, and with nothing
//! else.
void plan_study(Draft& draft, Campaign& campaign) {
    SensitivitySettings& design = draft.design;
    constexpr int few = 64;
    if (design.method == SensitivityMethod::morris && !draft.has_samples)
        design.samples = few;
    campaign.varied = draft.varied;
    campaign.search.population = 0;
    for (const Case& each : cases(campaign))
        campaign.search.population =
            std::max(campaign.search.population,
                     generation_size(design, search_genes(campaign, each)));
    campaign.stop = {.generations = generations_of(design),
                     .failed_fraction = campaign.stop.failed_fraction};
    campaign.search.design = design;
    campaign.has_light_by_row = true;
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
    if (!draft.is_study) campaign.varied.keys = draft.searched;
    if (uses_cma_es(campaign.search) && !draft.has_population)
        campaign.search.population = usual_population_of(campaign);
    if (draft.is_study) plan_study(draft, campaign);
    draft.campaign.search = campaign.search;
    draft.campaign.stop = campaign.stop;
    // A start is a plant; keys begin where the campaign has them.
    if (!campaign.search.start.empty())
        for (const KeyFactor& each : campaign.varied.keys)
            campaign.search.start.push_back(each.value);
    if (draft.has_photosynthesis)
        campaign.photosynthesis = to_photosynthesis(draft.photosynthesis);
    for (const std::shared_ptr<Draft>& each : draft.neighbours) {
        const Campaign& own = each->campaign;
        Neighbour neighbour{own.name, each->standing, own.crop.baseline,
                            own.optics, own.nir_optics};
        for (const double row : each->rows)
            neighbour.standing.rows.push_back(static_cast<int>(row) - 1);
        if (draft.has_photosynthesis)
            neighbour.photosynthesis = to_photosynthesis(each->photosynthesis);
        for (const Leaf& leaf : neighbour.plant.leaves)
            campaign.reach = std::max(
                campaign.reach,
                furthest(neighbour.plant, leaf, campaign.field.variation));
        campaign.neighbours.push_back(std::move(neighbour));
    }
    std::erase_if(campaign.constraints.traits,
                  [](const TraitConstraint& x) { return !constrains(x); });
    campaign.source = source;
    campaign.warnings = report.warnings();
    campaign.resolved = resolved_text(draft);
    campaign.accuracy = accuracy_keys(draft);
    if (campaign.climates.empty()) campaign.sun_dates = 0;
    campaign.sha256 = sha256(campaign.resolved);
    return campaign;
}

//! Checks a draft whose keys have other values than its file gives them.
void check_again(Draft& draft) {
    Report report(draft.campaign.name);
    check_draft(draft, report);
    report.throw_if_any();
}

//! Reports ends of ranges that contradict the rest of the campaign.
void try_ends(Draft& draft, Report& report) {
    for (const KeyFactor& factor : draft.factors())
        for (const double end : {factor.range.lower, factor.range.upper}) try {
                Draft varied = draft;
                set_key(varied, factor, end);
                check_again(varied);
            } catch (const InputError& error) {
                report.add(
                    &factor.range,
                    fmt::format("{}.keys: with {} of {}, {}",
                                draft.is_study ? "sensitivity" : "search", end,
                                factor.key, error.problems().front().what));
                break;
            }
}

Campaign parse(const std::string& text, const std::string& file,
               PlantSource source,
               const std::vector<std::string>& settings = {},
               bool is_study = false) {
    Draft draft;
    draft.is_study = is_study;
    Report report;
    read_draft(text, file, source, settings, draft, report);
    read_weathers(file, source, draft, report);
    read_objects(file, draft, report);
    check_draft(draft, report);
    if (report.empty()) try_ends(draft, report);
    report.throw_if_any();
    Campaign campaign = complete(draft, text, report);
    if (!campaign.varied.keys.empty())
        campaign.draft = std::make_shared<const Draft>(std::move(draft));
    return campaign;
}

}  // namespace

Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings) {
    const std::string text = read_text(path);
    return read_campaign_text(text, path, settings);
}

Campaign read_campaign_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& settings) {
    return parse(text, path, PlantSource::file_or_table, settings);
}

Campaign read_study(const std::string& path,
                    const std::vector<std::string>& settings) {
    // Replicates would be the same study with other random numbers.
    std::vector<std::string> all{"replicates=1"};
    all.insert(all.end(), settings.begin(), settings.end());
    return parse(read_text(path), path, PlantSource::file_or_table, all, true);
}

Crop read_crop(const std::string& path, const Plant* other) {
    const std::string text = read_text(path);
    Draft draft;
    Report report;
    if (is_measured(path)) {
        draft.is_crop_known = other != nullptr;
        if (other) draft.campaign.crop.baseline = *other;
        read_measured_draft(text, path, draft, report);
    } else if (!read_plant_draft(text, path, draft, report)) {
        return parse(text, path, PlantSource::file_or_table).crop;
    }
    check_plant(draft, report);
    report.throw_if_any();
    Crop crop = draft.campaign.crop;
    for (const TraitEntry& entry : draft.traits)
        crop.traits.push_back(complete(entry));
    crop.rules = rule_names(draft);
    return crop;
}

Plant read_plant(const std::string& path) {
    return read_crop(path).baseline;
}

Photosynthesis read_photosynthesis(const std::string& path) {
    const std::string text = read_text(path);
    PhotosynthesisTable table = photosynthesis_of_meshes();
    Report report;
    read_tables(text, path, {one_table(photosynthesis_section(table))}, report);
    check_photosynthesis(table, 0, report);
    report.throw_if_any();
    return to_photosynthesis(table);
}

SeasonLight read_climate(const std::string& path) {
    const std::string text = read_text(path);
    Draft draft;
    Report report;
    Campaign& campaign = draft.campaign;
    campaign.sites.assign(1, {});
    campaign.climates.assign(1, {});
    // It has no [optics].
    report.locate(&campaign.par_fraction, {path, 1, 1});
    read_tables(text, path, climate_file_tables(campaign), report);
    read_weathers(path, PlantSource::file_or_table, draft, report);
    report.throw_if_any();
    Case chosen;
    chosen.site = campaign.sites.front();
    chosen.day_name = campaign.climates.front().name;
    return {light_of(campaign, chosen), report.warnings()};
}

void require_breedable(const Campaign& campaign) {
    if (!campaign.outside_bounds.empty())
        throw InputError(campaign.outside_bounds);
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

Campaign at_keys(const Campaign& campaign, Genome& genome) {
    const std::vector<KeyFactor>& keys = campaign.varied.keys;
    const std::size_t plain = campaign.bounds.size();
    if (keys.empty() || genome.size() != plain + keys.size()) return campaign;
    Draft draft = *campaign.draft;
    for (std::size_t i = 0; i < keys.size(); ++i)
        set_key(draft, keys[i], genome[plain + i]);
    genome.resize(plain);
    check_again(draft);
    return complete(draft, campaign.source, Report());
}

}  // namespace ideotype
