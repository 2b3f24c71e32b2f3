// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign_texts.hpp"
#include "cli/formats/json.hpp"
#include "cli/verbs.hpp"
#include "history/history.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "run/job/disk.hpp"
#include "run/job/masters.hpp"
#include "run/job/way_on.hpp"
#include "run/progress.hpp"
#include "run/provenance.hpp"
#include "run/run.hpp"
#include "stand/across_scenarios.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

std::vector<std::string> scenario_names(const Campaign& campaign,
                                        const Case& chosen) {
    if (chosen.scenarios.empty()) return {};
    const AcrossScenarios across(campaign, chosen);
    return std::get<std::vector<std::string>>(
        across.measured().axis("scenario").coordinates);
}

std::string scenario_text(const Campaign& campaign, const Case& chosen) {
    const std::vector<std::string> names = scenario_names(campaign, chosen);
    if (names.empty()) return "";
    return fmt::format(
        "scenarios each evaluation is of {} ({}); an objective is {}\n",
        names.size(), fmt::join(names, ", "),
        campaign.spec.objective.across == Across::mean
            ? "their mean"
            : "that of the worst one");
}

Json to_json(const std::vector<CaseName>& all) {
    Json json = Json::array();
    for (const CaseName& each : all)
        json.push_back(
            {{"index", each.index}, {"name", each.name}, {"seed", each.seed}});
    return json;
}

Json to_json(const std::vector<Problem>& problems) {
    Json all = Json::array();
    for (const auto& [where, key, code, what] : problems)
        all.push_back({{"file", where.file},
                       {"line", where.line},
                       {"column", where.column},
                       {"key", key},
                       {"code", name_of(code)},
                       {"message", what}});
    return all;
}

//! Prints, separated by a tab, the index and the number of evaluations of each
//! case that is not finished in a folder.
//! @throws Error (refused) if a history belongs to another campaign.
void list_left(const Campaign& campaign, const std::string& out) {
    const Cases all = cases(campaign);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string path = path_of(out, campaign, all.name(i));
        std::uint64_t evaluated = 0;
        if (history_exists(path)) {
            const History history = History::read(path);
            require_same_campaign(history.header(), campaign, all[i], path);
            if (history.finished()) continue;
            evaluated = history.evaluated();
        }
        fmt::print("{}\t{}\n", i, evaluated);
    }
}

//! Prints the command that runs the campaign.
void tell_next(const std::string& path,
               const std::vector<std::string>& settings) {
    std::vector<std::string> words{"ideotype", "run", path};
    for (const std::string& each : settings) {
        words.emplace_back("--set");
        words.push_back(each);
    }
    fmt::print("next: {}\n", quoted(words));
}

double par_of(const SkyOverview& sky) {
    return sky.par;
}

double diffuse_of(const SkyOverview& sky) {
    return sky.diffuse;
}

double steps_of(const SkyOverview& sky) {
    return static_cast<double>(sky.steps);
}

//! The results of `check`, for the first case unless said otherwise.
struct Findings {
    Mesh plant;
    LightSeries light;
    Field field;
    StandsOverview stands;
    CampaignCost cost;
    DiskRoom room;
    double excess;  //!< violation of constraints by the baseline
    std::size_t genes, free_genes;
};

//! Returns the mean leaf area per place of the field, for plants without
//! deviations from their lines [m2].
double leaf_area_of_place(const Scene& scene, const Case& chosen) {
    double lai = 0;
    for (const Component& each : scene.components)
        lai += lai_of_line(each.mesh, each.ground_per_plant);
    return lai * chosen.spacing.row * chosen.spacing.plant;
}

Findings look_at(const Campaign& campaign) {
    const Cases all = cases(campaign);
    const Case first = all.front();
    const Scene scene = scene_of(campaign, first);
    const Mesh plant =
        build_plant(campaign.crop.baseline, campaign.spec.plant.tessellation);
    const Field field = draw_field(scene, randomness_of({}, campaign, first));
    const GeneSpace genes = search_genes(campaign, first);
    Findings found{plant,
                   scene.light().series,
                   field,
                   overview_of(campaign, leaf_area_of_place(scene, first)),
                   CampaignCost(campaign, first),
                   disk_room(campaign, all),
                   0,
                   genes.size(),
                   count_free(genes)};
    found.excess = violation(
        campaign.spec.constraints, campaign.crop.traits, campaign.crop.baseline,
        lai_of_line(plant, scene.components.front().ground_per_plant));
    return found;
}

Json to_json(const CheckOptions& options, const Campaign& campaign,
             const Findings& found) {
    const Cases all = cases(campaign);
    const Case first = all.front();
    const bool grows = !scenarios(first).front().stages.empty();
    return {
        {"file", options.campaign_path},
        {"is_valid", true},
        {"warnings", to_json(campaign.warnings)},
        {"campaign", campaign.spec.name},
        {"cases", to_json(all.names())},
        {"scenarios", scenario_names(campaign, first)},
        {"plant",
         {{"name", campaign.crop.baseline.name},
          {"leaves", campaign.crop.baseline.leaves.size()},
          {"leaf_area_m2", plant_area(found.plant).leaves},
          {"faces", found.plant.faces.size()},
          {"violation", found.excess}}},
        {"field",
         {{"rows", campaign.spec.field.rows},
          {"plants_per_row", campaign.spec.field.plants},
          {"period_x_m", found.field.cell.period_x},
          {"period_y_m", found.field.cell.period_y},
          {"lai",
           plant_area(found.field.mesh).leaves / found.field.cell.ground_area},
          {"lai_of_cases", json_of(found.stands.lai)},
          {"faces", found.field.mesh.faces.size()}}},
        {"light",
         {{"steps", found.light.steps.size()},
          {"days", found.light.days},
          {"par_MJ_per_m2_per_day", found.light.incident() / 1e6},
          {"par_MJ_per_m2_per_day_of_cases",
           json_of(found.stands.over_skies(par_of), 1e6)},
          {"diffuse_fraction",
           found.light.diffuse() / found.light.incident()}}},
        {"leaves", leaves_of(campaign)},
        {"grows", grows},
        {"development_stage", grows ? Json() : Json(campaign.spec.plant.stage)},
        {"search", search_of(campaign)},
        {"genes", found.genes},
        {"free_genes", found.free_genes},
        {"cost", json_of(found.cost, all.size())},
        {"disk",
         {{"largest_case_bytes", found.room.largest},
          {"all_cases_bytes", found.room.all}}}};
}

void print(const CheckOptions& options, const Campaign& campaign,
           const Findings& found) {
    const Cases all = cases(campaign);
    const Case first = all.front();
    const StandsOverview& stands = found.stands;
    fmt::print("{}: no errors\n", options.campaign_path);
    fmt::print("campaign  {}, {} case{}\n", campaign.spec.name, all.size(),
               all.size() == 1 ? "" : "s (--cases lists them)");
    fmt::print("{}{}", objective_text(campaign),
               scenario_text(campaign, first));
    fmt::print("plant     {}, {} leaves, {:.4f} m2 of leaf, {} faces\n",
               campaign.crop.baseline.name,
               campaign.crop.baseline.leaves.size(),
               plant_area(found.plant).leaves, found.plant.faces.size());
    fmt::print("{}{}", leaves_text(campaign), growth_text(campaign, first));
    if (!campaign.spec.field.variation.is_any())
        fmt::print(
            "advice    plants are all alike; what is bred in such a "
            "field gains less where plants differ: [field.variation]\n");
    else if (campaign.sampling.fields == 1)
        fmt::print(
            "advice    errors of rows lack how fields differ; each plant in "
            "several small fields has them: light.fields = 4\n");
    fmt::print("field     {} x {} plants, period {} x {} m, LAI {}, {} faces\n",
               campaign.spec.field.rows, campaign.spec.field.plants,
               text_of(stands.period_x, "{:.4g}"),
               text_of(stands.period_y, "{:.4g}"),
               text_of(stands.lai, "{:.2f}"), found.field.mesh.faces.size());
    fmt::print("light     {} {}, {} MJ m-2 day-1 of PAR, {} % diffuse\n",
               text_of(stands.over_skies(steps_of), "{:.0f}"),
               campaign.spec.climates.empty()
                   ? "instants with the sun up"
                   : fmt::format("time steps with the suns of {} of {} dates",
                                 std::min(campaign.spec.light.dates.value_or(0),
                                          found.light.days),
                                 found.light.days),
               text_of(stands.over_skies(par_of), "{:.3f}", 1e6),
               text_of(stands.over_skies(diffuse_of), "{:.0f}", 0.01));
    fmt::print("{}\n", campaign.spec.climates.empty() ? "sun" : "climate");
    print_table(rows_of(stands.skies, !campaign.spec.climates.empty()), 10);
    if (!campaign.spec.climates.empty())
        fmt::print(
            "          temperature and humidity are weighted by light; "
            "sunrise, noon and sunset are those of the middle date\n");
    if (const Json season = rows_of(stages_overview(campaign, first));
        !season.empty()) {
        fmt::print("season\n");
        print_table(season, 10);
    }
    if (found.excess > 0)
        fmt::print(
            "          the plant fails the [constraints] by {:.3g} of their "
            "limits: all that is bred must first leave that behind\n",
            found.excess);
    fmt::print("genes     {} of {} free\n", found.free_genes, found.genes);
    for (const KeyFactor& each : campaign.varied.keys)
        fmt::print("          {} {} .. {} is one of them\n", each.key,
                   each.range.lower, each.range.upper);
    fmt::print("{}", search_text(campaign));
    fmt::print("cost      {} per case{}\n", cost_text(found.cost),
               all.size() == 1 ? "" : " (measured on the first)");
    fmt::print("{}", cost_table(found.cost, all.size()));
    fmt::print(
        "workers   up to {} are busy while generations of {} plants end\n",
        busy_workers(campaign.search, all.size()), campaign.search.population);
    const auto mebibytes = [](std::uint64_t bytes) {
        return static_cast<double>(bytes) / (1 << 20);
    };
    fmt::print(
        "disk      {:.2f} MiB per case, {:.2f} MiB for all of them, "
        "reserved when a case begins\n",
        mebibytes(found.room.largest), mebibytes(found.room.all));
    tell_next(options.campaign_path, options.settings);
}

}  // namespace

ExitCode check(const CheckOptions& options) try {
    Campaign campaign = read_campaign(options.campaign_path, options.settings);
    if (options.lists_cases || options.only_count || options.only_left) {
        if (options.lists_cases) {
            fmt::print("{:>5}  {:<40}  {:>20}\n", "index", "case", "seed");
            for (const CaseName& each : cases(campaign).names())
                fmt::print("{:>5}  {:<40}  {:>20}\n", each.index, each.name,
                           each.seed);
        } else if (options.only_count)
            fmt::print("{}\n", cases(campaign).size());
        else
            list_left(campaign, options.out);
        return ExitCode::ok;
    }
    // `check` breeds no plants, but most checked campaigns are for breeding.
    campaign.warnings.insert(campaign.warnings.end(),
                             campaign.outside_bounds.begin(),
                             campaign.outside_bounds.end());
    for (const Problem& warning : campaign.warnings)
        if (!options.is_json)
            fmt::print(stderr, "ideotype: warning: {}\n", to_string(warning));
    require_names_fit(campaign, cases(campaign), options.out);
    const Findings found = look_at(campaign);
    if (options.is_json)
        fmt::print("{}\n", to_text(to_json(options, campaign, found)));
    else
        print(options, campaign, found);
    return ExitCode::ok;
} catch (const InputError& error) {
    if (options.is_json)
        fmt::print("{}\n", to_text({{"file", options.campaign_path},
                                    {"is_valid", false},
                                    {"problems", to_json(error.problems())}}));
    throw;
}

}  // namespace ideotype
