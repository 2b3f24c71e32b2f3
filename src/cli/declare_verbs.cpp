// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "ideotype/core/clock.hpp"
#include "ranks.hpp"
#include "run/job/way_on.hpp"
#include "verbs.hpp"

namespace ideotype {

namespace {

void add_settings(CLI::App& verb, std::vector<std::string>& settings) {
    verb.add_option("--set", settings,
                    "a key of the campaign and its value, which replaces that "
                    "of the file: search.optimizer=random; a table replaces "
                    "the whole table: 'field.variation={}'; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

void add_campaign(CLI::App& verb, std::string& path,
                  std::vector<std::string>& settings) {
    verb.add_option("campaign", path, "campaign file (TOML)")->required();
    add_settings(verb, settings);
}

void add_threads(CLI::App& verb, std::optional<int>& threads) {
    verb.add_option_function<std::string>(
            "--threads",
            [&](const std::string& text) { threads = parse_threads(text); },
            "threads that evaluate, or auto: as many as this process may use "
            "cores; if not given auto, and under mpirun or srun one on each "
            "rank")
        ->type_name("N|auto");
}

void add_log_level(CLI::App& verb, LogLevel& level) {
    static const std::map<std::string, LogLevel> levels{
        {"error", LogLevel::error},
        {"warning", LogLevel::warning},
        {"info", LogLevel::info},
        {"debug", LogLevel::debug}};
    auto* option =
        verb.add_option_function<std::string>(
                "--log-level",
                [&level](const std::string& name) { level = levels.at(name); },
                "what is told of the work: errors, also warnings, also how "
                "far it is (if not given), also each evaluation")
            ->check(CLI::IsMember({"error", "warning", "info", "debug"}))
            ->type_name("LEVEL");
    verb.add_flag_callback(
            "--quiet", [&level] { level = LogLevel::warning; },
            "--log-level warning: results are still printed")
        ->excludes(option);
}

void declare_row(CLI::App& verb, RowChoice& row) {
    verb.add_flag(
        "--best", row.is_best,
        "the best finalist, or the best of the last complete generation");
    verb.add_option("--generation", row.generation, "generation of the row")
        ->excludes("--best");
    verb.add_option("--slot", row.slot, "slot of the row")->excludes("--best");
}

CLI::Option* add_json(CLI::App& verb, bool& is_json) {
    return verb.add_flag("--json", is_json, "print JSON instead of text");
}

void add_case(CLI::App& verb, int& index) {
    verb.add_option("--case", index,
                    "index of the case of the campaign (see check --cases)")
        ->capture_default_str();
}

void declare_check(CLI::App& verb, CheckOptions& options) {
    add_campaign(verb, options.campaign_path, options.settings);
    verb.add_option("--out", options.out,
                    "folder of the histories, whether they exist or not")
        ->capture_default_str();
    const std::vector<CLI::Option*> kinds{
        add_json(verb, options.is_json),
        verb.add_flag("--cases", options.lists_cases,
                      "print only the cases: index, name and seed"),
        verb.add_flag("--count", options.only_count,
                      "print only how many cases there are"),
        verb.add_flag("--left", options.only_left,
                      "print only the cases that are not finished: index and "
                      "evaluations done")};
    for (CLI::Option* each : kinds)
        for (CLI::Option* other : kinds)
            if (each != other) each->excludes(other);
}

double to_seconds(const std::string& text) {
    const auto seconds = parse_duration(text);
    if (seconds && *seconds > 0) return *seconds;
    throw CLI::ValidationError(
        "--wall-time", fmt::format("'{}' is no time; write for example 90, "
                                   "90s, 30m, 2h, 1h30m or 01:30:00",
                                   text));
}

void declare_run(CLI::App& verb, RunOptions& options) {
    add_campaign(verb, options.campaign_path, options.settings);
    verb.add_option("--start", options.start,
                    "plant around which CMA-ES begins (search.start): a plant "
                    "file, or a history, whose best plant is taken");
    add_threads(verb, options.threads);
    verb.add_option("--masters", options.masters,
                    "number of ranks that evolve cases, each with workers of "
                    "its own; if not given, one for each 1,000 ranks, but no "
                    "more than there are cases")
        ->check(CLI::PositiveNumber);
    verb.add_option("--case", options.case_index,
                    "only the case of this index (see check --cases)");
    verb.add_flag("--resume", options.is_resumed,
                  "go on with histories that exist; start the others");
    verb.add_option("--out", options.out, "folder for <campaign>/<case>.h5")
        ->capture_default_str();
    verb.add_option("--isa", options.isa,
                    "instruction set to begin with, the same on all ranks; if "
                    "not given, that of a history that is resumed, or else "
                    "the widest that all ranks have")
        ->check(CLI::IsMember({"sse2", "sse4.2", "avx", "avx2", "avx512"}));
    add_log_level(verb, options.level);
    verb.add_option_function<std::string>(
        "--wall-time",
        [&](const std::string& text) { options.wall_time = to_seconds(text); },
        "time after which to stop cleanly: seconds, or for example 30m, "
        "1h30m, 01:30:00");
}

void declare_sensitivity(CLI::App& verb, RunOptions& options) {
    options.read = read_study;
    options.out = "results/sensitivity";
    declare_run(verb, options);
}

void declare_status(CLI::App& verb, StatusOptions& options) {
    verb.add_option("paths", options.paths, "histories or folders")->required();
    add_json(verb, options.is_json);
}

void declare_evaluate(CLI::App& verb, EvaluateOptions& options) {
    verb.add_option("file", options.path,
                    "campaign (.toml: its baseline) or history (.h5)")
        ->required();
    add_settings(verb, options.settings);
    add_case(verb, options.case_index);
    declare_row(verb, options.row);
    add_json(verb, options.is_json);
    verb.add_flag("--all", options.is_all,
                  "print light by leaf, layer, hour and face, too");
}

void declare_new(CLI::App& verb, NewOptions& options) {
    verb.add_option("file", options.path, "new campaign file (.toml)")
        ->required();
    verb.add_option("--latitude", options.latitude,
                    "latitude of the place [deg], north is positive");
    verb.add_option("--longitude", options.longitude,
                    "longitude of the place [deg], east is positive");
    verb.add_option("--utc-offset", options.utc_offset,
                    "local clock minus UTC [h]; if not given, it follows from "
                    "the longitude");
    verb.add_option("--date", options.date, "date of a clear day: 2025-07-01");
    verb.add_option("--weather", options.weather,
                    "weather file (CSV, hourly), in place of --date: what "
                    "`ideotype weather` writes, or a table with names and "
                    "units in its columns, such as \"global (W/m2)\"");
    verb.add_option("--row", options.row, "distance between rows [m]");
    verb.add_option("--plant-spacing", options.plant_spacing,
                    "distance between plants in a row [m]");
    verb.add_option("--plant", options.plant,
                    "maize, sorghum, soybean or cowpea, whose crop file is "
                    "copied beside the campaign; or a crop file (.toml)");
    verb.add_option("--objective", options.objective,
                    "what to breed for: carbon_balance (if not given), "
                    "net_assimilation, absorbed_par or any other single number "
                    "of a canopy");
    verb.add_option("--name", options.name, "name of the campaign");
}

void declare_serve(CLI::App& verb, ServeOptions& options) {
    add_campaign(verb, options.campaign_path, options.settings);
    add_case(verb, options.case_index);
    add_threads(verb, options.threads);
    add_log_level(verb, options.level);
}

void declare_export(CLI::App& verb, ExportOptions& options) {
    verb.add_option("file", options.path, "history (.h5)")->required();
    declare_row(verb, options.row);
    verb.add_option("--to", options.to, "new file, .obj, .vtp, .csv or .toml")
        ->required();
    auto* component = verb.add_option(
        "--component", options.component,
        "kind of plant, if the field has several; if not given, the crop");
    auto* at = verb.add_option(
        "--at", options.at,
        "age of plants that grow: a date (2025-07-15) or a thermal time since "
        "emergence [deg C d]; if not given, they are full-grown (.obj, .vtp)");
    verb.add_flag("--field", options.is_field,
                  "the whole field instead of one plant (.obj, .vtp)");
    verb.add_option("--paths", options.paths,
                    "light paths per randomisation for the light on faces "
                    "(.vtp); more for less noise")
        ->check(CLI::Range(16, 16777216));
    auto* generations =
        verb.add_flag("--generations", options.is_generations,
                      "all candidates with their fitness instead of one plant "
                      "(.csv); it works for a file that was cut short, too");
    generations->excludes("--field")->excludes("--paths");
    generations->excludes(component)->excludes(at);
    for (const char* each : {"--best", "--generation", "--slot"})
        generations->excludes(each);
}

void declare_light(CLI::App& verb, LightOptions& options) {
    verb.add_option("mesh", options.mesh, "mesh (OBJ, metres, z up)")
        ->required();
    declare_mesh_keys(verb, options.given);
    add_json(verb, options.is_json);
}

void declare_schema(CLI::App& /*verb*/, SchemaOptions& /*options*/) {}

void declare_files(CLI::App& verb, std::vector<std::string>& paths) {
    verb.add_option("files", paths, "histories")->required();
}

}  // namespace

void declare_verbs(CLI::App& app, const std::vector<std::string>& words,
                   std::function<int()>& action) {
    const auto add = [&]<class Options>(
                         const char* name, const char* about,
                         const char* example,
                         void (*declare)(CLI::App&, Options&),
                         ExitCode (*run)(const Options&)) -> Options& {
        const auto options = std::make_shared<Options>();
        CLI::App* verb = app.add_subcommand(name, about);
        verb->footer(fmt::format("Example:\n  ideotype {} {}", name, example));
        declare(*verb, *options);
        verb->callback([&action, options, run] {
            action = [=] { return static_cast<int>(run(*options)); };
        });
        return *options;
    };
    add("new",
        "write a commented campaign for a place and a plant; what is not given "
        "is asked for on a terminal",
        "mine.toml --latitude 42.03 --longitude -93.63", declare_new,
        write_new_campaign);
    add("check", "validate a campaign, and tell its size, cost and cases",
        "campaigns/quickstart.toml", declare_check, check);
    add("schema",
        "print the JSON Schema of campaigns, by which editors complete and "
        "check keys",
        "> campaign.schema.json", declare_schema, print_schema);
    const auto note_start = [&](RunOptions& options) {
        options.command = quoted(words);
        options.launcher = launcher_of(words.front());
    };
    note_start(add(
        "run",
        "evolve the cases of a campaign on the cores of this machine, or on a "
        "cluster (under mpirun or srun)",
        "campaigns/quickstart.toml --resume", declare_run, start_run));
    note_start(add(
        "sensitivity",
        "evaluate the design of a sensitivity study, by Sobol' or Morris, of "
        "the traits and of numeric keys of a campaign; runs, stops and is "
        "resumed like a run, and ideotype indices tells what was found",
        "campaigns/ames_quick.toml", declare_sensitivity, start_run));
    add("status",
        "tell how far histories have come, also while they are written",
        "results", declare_status, status);
    add("evaluate",
        "evaluate one plant in its field: the baseline of a campaign, or a row "
        "of a history, which is computed again and compared bit for bit",
        "campaigns/quickstart.toml", declare_evaluate, evaluate);
    add("light", "tell the light in any mesh",
        "plant.obj --period .76 .15 --sun 60 180", declare_light,
        light_in_mesh);
    add("serve",
        "evaluate the genomes that arrive as lines of JSON on the standard "
        "input, and answer each with a line of JSON, until the input ends; "
        "on all cores, or on all ranks under mpirun or srun",
        "campaigns/ames_quick.toml < genomes > answers", declare_serve, serve);
    add("export",
        "write a plant of a history as OBJ (mesh), VTP (mesh with the PAR "
        "that each face absorbs, for ParaView), CSV (traits) or TOML (plant "
        "file, for campaigns), or all complete generations as CSV",
        "FILE.h5 --best --to best.toml", declare_export, export_plant);
    add("verify",
        "compare histories with their checksums, also while they are written",
        "FILE.h5", declare_files, verify);
    declare_python_verbs(app);
}

}  // namespace ideotype
