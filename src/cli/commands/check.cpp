// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign_texts.hpp"
#include "cli/commands.hpp"
#include "cli/formats/json.hpp"
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

std::string across_text(const ObjectiveSpec& objective) {
    constexpr double percent = 100;
    switch (objective.across) {
        case Across::worst:
            return "that of the worst scenario";
        case Across::quantile:
            return fmt::format("the best of the worst {} % of them",
                               percent * objective.tail);
        case Across::cvar:
            return fmt::format("the mean over the worst {} % of them",
                               percent * objective.tail);
        case Across::probability:
            return fmt::format("the weight of those at or above {}",
                               objective.threshold.value_or(0));
        case Across::mean:
            break;
    }
    return "the mean over them";
}

std::string scenario_text(const Campaign& campaign, const Case& chosen) {
    const std::vector<std::string> names = scenario_names(campaign, chosen);
    if (names.empty()) return "";
    return fmt::format(
        "scenarios {} in each evaluation ({}); each objective is {}\n",
        names.size(), fmt::join(names, ", "),
        across_text(campaign.spec.objective));
}

Json to_json(const std::vector<CaseName>& names) {
    Json json = Json::array();
    for (const CaseName& each : names)
        json.push_back(
            {{"index", each.index}, {"name", each.name}, {"seed", each.seed}});
    return json;
}

Json to_json(const std::vector<Problem>& problems) {
    Json list = Json::array();
    for (const auto& [where, key, code, what] : problems)
        list.push_back({{"file", where.file},
                        {"line", where.line},
                        {"column", where.column},
                        {"key", key},
                        {"code", name_of(code)},
                        {"message", what}});
    return list;
}

//! Prints a line for each unfinished case in a folder: its index and its number
//! of evaluations, separated by a tab.
//! @throws Error (refused) if a history belongs to another campaign.
void list_left(const Campaign& campaign, const std::string& out) {
    const Cases listed = cases(campaign);
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const std::string path = path_of(out, campaign, listed.name(i));
        std::uint64_t evaluated = 0;
        if (history_exists(path)) {
            const History history = History::read(path);
            require_same_campaign(history.header(), campaign, listed[i], path);
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
    for (const std::string& setting : settings) {
        words.emplace_back("--set");
        words.push_back(setting);
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

//! Returns the values that a gene may have.
std::string domain_of(const Gene& gene) {
    if (!gene.values.empty())
        return fmt::format("{} {}", gene.is_choice() ? "a choice of" : "one of",
                           fmt::join(gene.values, ", "));
    return fmt::format("{}{} .. {}", gene.is_discrete() ? "whole numbers " : "",
                       gene.lower, gene.upper);
}

Json to_json(const GeneSpace& keys) {
    Json json = Json::array();
    for (const Gene& gene : keys)
        json.push_back({{"name", gene.name},
                        {"kind", name_of(gene.kind)},
                        {"unit", gene.unit},
                        {"lower", gene.lower},
                        {"upper", gene.upper},
                        {"values", gene.values}});
    return json;
}

//! The results of `check`. Unless stated otherwise, they apply to the first
//! case.
struct Findings {
    Mesh plant;
    LightSeries light;
    Field field;
    StandsOverview stands;
    CampaignCost cost;
    DiskRoom room;
    double excess;  //!< constraint violation of the baseline
    std::size_t genes, free_genes;
    GeneSpace keys;  //!< genes that are keys of the campaign
};

//! Returns the mean leaf area per planting position [m2], without within-line
//! variation.
double leaf_area_of_place(const Scene& scene, const Case& chosen) {
    double lai = 0;
    for (const Component& each : scene.components)
        lai += lai_of_line(each.mesh, each.ground_per_plant);
    return lai * chosen.spacing.row * chosen.spacing.plant;
}

Findings look_at(const Campaign& campaign) {
    const Cases campaign_cases = cases(campaign);
    const Case first = campaign_cases.front();
    const Scene scene = scene_of(campaign, first);
    const Mesh plant =
        build_plant(campaign.crop.baseline, campaign.spec.plant.tessellation);
    const Field field = draw_field(scene, randomness_of({}, campaign, first));
    const GeneSpace genes = search_genes(campaign, first);
    const auto keys = static_cast<std::ptrdiff_t>(campaign.varied.keys.size());
    Findings findings{plant,
                      scene.light().series,
                      field,
                      overview_of(campaign, leaf_area_of_place(scene, first)),
                      CampaignCost(campaign, first),
                      disk_room(campaign, campaign_cases),
                      0,
                      genes.size(),
                      count_free(genes),
                      {genes.end() - keys, genes.end()}};
    findings.excess = violation(
        campaign.spec.constraints, campaign.crop.traits, campaign.crop.baseline,
        lai_of_line(plant, scene.components.front().ground_per_plant));
    return findings;
}

Json to_json(const CheckOptions& options, const Campaign& campaign,
             const Findings& findings) {
    const Cases campaign_cases = cases(campaign);
    const Case first = campaign_cases.front();
    const bool grows = !scenarios(first).front().stages.empty();
    return {
        {"file", options.campaign_path},
        {"is_valid", true},
        {"warnings", to_json(campaign.warnings)},
        {"campaign", campaign.spec.name},
        {"cases", to_json(campaign_cases.names())},
        {"scenarios", scenario_names(campaign, first)},
        {"plant",
         {{"name", campaign.crop.baseline.name},
          {"leaves", campaign.crop.baseline.leaves.size()},
          {"leaf_area_m2", plant_area(findings.plant).leaves},
          {"faces", findings.plant.faces.size()},
          {"violation", findings.excess}}},
        {"field",
         {{"rows", campaign.spec.field.rows},
          {"plants_per_row", campaign.spec.field.plants},
          {"period_x_m", findings.field.cell.period_x},
          {"period_y_m", findings.field.cell.period_y},
          {"lai", plant_area(findings.field.mesh).leaves /
                      findings.field.cell.ground_area},
          {"lai_of_cases", json_of(findings.stands.lai)},
          {"faces", findings.field.mesh.faces.size()}}},
        {"light",
         {{"steps", findings.light.steps.size()},
          {"days", findings.light.days},
          {"par_MJ_per_m2_per_day", findings.light.incident() / 1e6},
          {"par_MJ_per_m2_per_day_of_cases",
           json_of(findings.stands.over_skies(par_of), 1e6)},
          {"diffuse_fraction",
           findings.light.diffuse() / findings.light.incident()}}},
        {"leaves", leaves_of(campaign)},
        {"grows", grows},
        {"development_stage", grows ? Json() : Json(campaign.spec.plant.stage)},
        {"search", search_of(campaign)},
        {"genes", findings.genes},
        {"keys", to_json(findings.keys)},
        {"free_genes", findings.free_genes},
        {"cost", json_of(findings.cost, campaign_cases.size())},
        {"disk",
         {{"largest_case_bytes", findings.room.largest},
          {"all_cases_bytes", findings.room.all}}}};
}

void print(const CheckOptions& options, const Campaign& campaign,
           const Findings& findings) {
    const Cases campaign_cases = cases(campaign);
    const Case first = campaign_cases.front();
    const StandsOverview& stands = findings.stands;
    fmt::print("{}: no errors\n", options.campaign_path);
    fmt::print("campaign  {}, {} case{}\n", campaign.spec.name,
               campaign_cases.size(),
               campaign_cases.size() == 1 ? "" : "s (--cases lists them)");
    fmt::print("{}{}", objective_text(campaign),
               scenario_text(campaign, first));
    const Plant& plant = campaign.crop.baseline;
    fmt::print(
        "plant     {}, {} leaves, {:.4f} m2 of leaf{}, {} faces\n", plant.name,
        plant.leaves.size(), plant_area(findings.plant).leaves,
        plant.plasticity.responses.empty()
            ? ""
            : fmt::format(" at {:g} plants m-2", plant.plasticity.reference),
        findings.plant.faces.size());
    fmt::print("{}{}", leaves_text(campaign), growth_text(campaign, first));
    if (!campaign.spec.field.variation.is_any())
        fmt::print(
            "advice    the stand is uniform; gains found in uniform stands are "
            "smaller in variable ones: set [field.variation]\n");
    else if (campaign.sampling.fields == 1)
        fmt::print(
            "advice    standard errors of rows omit differences between "
            "fields; evaluate each plant in several small fields to include "
            "them: light.fields = 4\n");
    fmt::print("field     {} x {} plants, period {} x {} m, LAI {}, {} faces\n",
               campaign.spec.field.rows, campaign.spec.field.plants,
               text_of(stands.period_x, "{:.4g}"),
               text_of(stands.period_y, "{:.4g}"),
               text_of(stands.lai, "{:.2f}"), findings.field.mesh.faces.size());
    fmt::print("light     {} {}, {} MJ m-2 day-1 of PAR, {} % diffuse\n",
               text_of(stands.over_skies(steps_of), "{:.0f}"),
               campaign.spec.climates.empty()
                   ? "instants with the sun up"
                   : fmt::format("time steps with the suns of {} of {} dates",
                                 std::min(campaign.spec.light.dates.value_or(0),
                                          findings.light.days),
                                 findings.light.days),
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
    if (findings.excess > 0)
        fmt::print(
            "          the baseline violates [constraints] by {:.3g} of their "
            "limits; the search must first find plants that satisfy them\n",
            findings.excess);
    fmt::print("genes     {} of {} free\n", findings.free_genes,
               findings.genes);
    for (const Gene& gene : findings.keys)
        fmt::print("          including {}, {}\n", gene.name, domain_of(gene));
    fmt::print("{}", search_text(campaign));
    fmt::print("cost      {} per case{}\n", cost_text(findings.cost),
               campaign_cases.size() == 1 ? "" : " (measured on the first)");
    fmt::print("{}", cost_table(findings.cost, campaign_cases.size()));
    fmt::print(
        "workers   more than {} would be idle at the end of each generation of "
        "{} plants\n",
        busy_workers(campaign.search, campaign_cases.size()),
        campaign.search.population);
    const auto mebibytes = [](std::uint64_t bytes) {
        return static_cast<double>(bytes) / (1 << 20);
    };
    fmt::print(
        "disk      {:.2f} MiB per case, {:.2f} MiB in total, reserved when a "
        "case starts\n",
        mebibytes(findings.room.largest), mebibytes(findings.room.all));
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
    // `check` runs no search, but most checked campaigns will be used for one.
    // Therefore report baselines outside the bounds too.
    campaign.warnings.insert(campaign.warnings.end(),
                             campaign.outside_bounds.begin(),
                             campaign.outside_bounds.end());
    for (const Problem& warning : campaign.warnings)
        if (!options.is_json)
            fmt::print(stderr, "ideotype: warning: {}\n", to_string(warning));
    require_names_fit(campaign, cases(campaign), options.out);
    const Findings findings = look_at(campaign);
    if (options.is_json)
        fmt::print("{}\n", to_text(to_json(options, campaign, findings)));
    else
        print(options, campaign, findings);
    return ExitCode::ok;
} catch (const InputError& error) {
    if (options.is_json)
        fmt::print("{}\n", to_text({{"file", options.campaign_path},
                                    {"is_valid", false},
                                    {"problems", to_json(error.problems())}}));
    throw;
}

}  // namespace ideotype
