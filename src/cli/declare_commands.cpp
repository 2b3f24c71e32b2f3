// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "commands.hpp"
#include "ideotype/core/clock.hpp"
#include "ranks.hpp"
#include "run/job/way_on.hpp"

namespace ideotype {

namespace {

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
    command
        .add_option("--set", settings,
                    "set a key of the campaign in place of the file's value: "
                    "search.optimizer=random; a table replaces the whole "
                    "table: 'field.variation={}'; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

void add_campaign(CLI::App& command, std::string& path,
                  std::vector<std::string>& settings) {
    command.add_option("campaign", path, "campaign file (TOML)")->required();
    add_settings(command, settings);
}

void add_threads(CLI::App& command, std::optional<int>& threads) {
    command
        .add_option_function<std::string>(
            "--threads",
            [&](const std::string& text) { threads = parse_threads(text); },
            "number of evaluation threads, or auto: one for each core that "
            "this process may use; default: auto, or one on each rank under "
            "mpirun or srun")
        ->type_name("N|auto");
}

void add_log_level(CLI::App& command, LogLevel& level) {
    static const std::map<std::string, LogLevel> levels{
        {"error", LogLevel::error},
        {"warning", LogLevel::warning},
        {"info", LogLevel::info},
        {"debug", LogLevel::debug}};
    auto* option =
        command
            .add_option_function<std::string>(
                "--log-level",
                [&level](const std::string& name) { level = levels.at(name); },
                "messages to print: errors, also warnings, also progress "
                "(default), also each evaluation")
            ->check(CLI::IsMember({"error", "warning", "info", "debug"}))
            ->type_name("LEVEL");
    command
        .add_flag_callback(
            "--quiet", [&level] { level = LogLevel::warning; },
            "same as --log-level warning; results are still printed")
        ->excludes(option);
}

void declare_row(CLI::App& command, RowChoice& row) {
    command.add_flag(
        "--best", row.is_best,
        "the best finalist, or the best plant of the last complete generation");
    command.add_option("--generation", row.generation, "generation of the row")
        ->excludes("--best");
    command.add_option("--slot", row.slot, "slot of the row in its generation")
        ->excludes("--best");
}

CLI::Option* add_json(CLI::App& command, bool& is_json) {
    return command.add_flag("--json", is_json, "print JSON instead of text");
}

void add_case(CLI::App& command, int& index) {
    command
        .add_option("--case", index,
                    "index of the case (listed by check --cases)")
        ->capture_default_str();
}

void declare_check(CLI::App& command, CheckOptions& options) {
    add_campaign(command, options.campaign_path, options.settings);
    command
        .add_option("--out", options.out,
                    "folder of the histories; it need not exist")
        ->capture_default_str();
    const std::vector<CLI::Option*> kinds{
        add_json(command, options.is_json),
        command.add_flag("--cases", options.lists_cases,
                         "print only the cases: index, name and seed"),
        command.add_flag("--count", options.only_count,
                         "print only the number of cases"),
        command.add_flag("--left", options.only_left,
                         "print only the unfinished cases: index and number of "
                         "evaluations done")};
    for (CLI::Option* kind : kinds)
        for (CLI::Option* other : kinds)
            if (kind != other) kind->excludes(other);
}

double to_seconds(const std::string& text) {
    const auto seconds = parse_duration(text);
    if (seconds && *seconds > 0) return *seconds;
    throw CLI::ValidationError(
        "--wall-time", fmt::format("'{}' is not a duration; write for example "
                                   "90, 90s, 30m, 2h, 1h30m or 01:30:00",
                                   text));
}

void declare_run(CLI::App& command, RunOptions& options) {
    add_campaign(command, options.campaign_path, options.settings);
    command.add_option("--start", options.start,
                       "initial plant of CMA-ES (search.start): a plant file, "
                       "or a history, from which the best plant is taken");
    add_threads(command, options.threads);
    command
        .add_option("--masters", options.masters,
                    "number of ranks that run searches, each with a separate "
                    "group of workers; default: one for each 1,000 ranks, at "
                    "most the number of cases")
        ->check(CLI::PositiveNumber);
    command.add_option(
        "--case", options.case_index,
        "run only the case with this index (listed by check --cases)");
    command.add_flag("--resume", options.is_resumed,
                     "resume existing histories and start the other cases");
    command.add_option("--out", options.out, "folder for <campaign>/<case>.h5")
        ->capture_default_str();
    command
        .add_option("--isa", options.isa,
                    "instruction set of new histories, the same on all ranks; "
                    "default: that of the resumed history, else the widest "
                    "that all ranks support")
        ->check(CLI::IsMember({"sse2", "sse4.2", "avx", "avx2", "avx512"}));
    add_log_level(command, options.level);
    command.add_option_function<std::string>(
        "--wall-time",
        [&](const std::string& text) { options.wall_time = to_seconds(text); },
        "stop cleanly after this time: seconds, or for example 30m, 1h30m, "
        "01:30:00");
}

void declare_sensitivity(CLI::App& command, RunOptions& options) {
    options.read = read_study;
    options.out = "results/sensitivity";
    declare_run(command, options);
}

void declare_status(CLI::App& command, StatusOptions& options) {
    command.add_option("paths", options.paths, "histories or folders")
        ->required();
    add_json(command, options.is_json);
}

void declare_evaluate(CLI::App& command, EvaluateOptions& options) {
    command
        .add_option("file", options.path,
                    "campaign (.toml: its baseline) or history (.h5)")
        ->required();
    add_settings(command, options.settings);
    add_case(command, options.case_index);
    declare_row(command, options.row);
    add_json(command, options.is_json);
    command.add_flag("--all", options.is_all,
                     "also print light by leaf, layer, hour and face");
}

void declare_new(CLI::App& command, NewOptions& options) {
    command.add_option("file", options.path, "new campaign file (.toml)")
        ->required();
    command.add_option("--latitude", options.latitude,
                       "latitude of the site [deg], north is positive");
    command.add_option("--longitude", options.longitude,
                       "longitude of the site [deg], east is positive");
    command.add_option(
        "--utc-offset", options.utc_offset,
        "local clock minus UTC [h]; default: derived from the longitude");
    command.add_option("--date", options.date,
                       "date of a clear day, such as 2025-07-01");
    command.add_option("--weather", options.weather,
                       "hourly weather file (CSV) instead of --date: from "
                       "`ideotype weather`, or a table whose column names "
                       "include the unit, such as \"global (W/m2)\"");
    command.add_option("--row", options.row, "distance between rows [m]");
    command.add_option("--plant-spacing", options.plant_spacing,
                       "distance between plants in a row [m]");
    command.add_option(
        "--plant", options.plant,
        "maize, sorghum, soybean or cowpea (the crop file is copied to the "
        "folder of the campaign), or a crop file (.toml)");
    command.add_option(
        "--objective", options.objective,
        "quantity to maximise: carbon_balance (default), net_assimilation, "
        "absorbed_par or any other single number of a canopy");
    command.add_option("--name", options.name, "name of the campaign");
}

void declare_serve(CLI::App& command, ServeOptions& options) {
    add_campaign(command, options.campaign_path, options.settings);
    add_case(command, options.case_index);
    add_threads(command, options.threads);
    add_log_level(command, options.level);
}

void declare_export(CLI::App& command, ExportOptions& options) {
    command.add_option("file", options.path, "history (.h5)")->required();
    declare_row(command, options.row);
    command
        .add_option("--to", options.to, "new file, .obj, .vtp, .csv or .toml")
        ->required();
    auto* component = command.add_option(
        "--component", options.component,
        "component to write, if the field has several; default: the main crop");
    auto* at = command.add_option(
        "--at", options.at,
        "age of plants that grow: a date (2025-07-15) or a thermal time since "
        "emergence [deg C d]; default: full-grown plants (.obj, .vtp)");
    command.add_flag("--field", options.is_field,
                     "the whole field instead of one plant (.obj, .vtp)");
    command
        .add_option("--paths", options.paths,
                    "light paths per randomisation for the PAR absorbed by "
                    "each face (.vtp); more paths reduce the noise")
        ->check(CLI::Range(16, 16777216));
    auto* generations =
        command.add_flag("--generations", options.is_generations,
                         "all candidates and their objectives instead of one "
                         "plant (.csv); also works for truncated histories");
    generations->excludes("--field")->excludes("--paths");
    generations->excludes(component)->excludes(at);
    for (const char* option : {"--best", "--generation", "--slot"})
        generations->excludes(option);
}

void declare_light(CLI::App& command, LightOptions& options) {
    command.add_option("mesh", options.mesh, "mesh (OBJ, metres, z up)")
        ->required();
    declare_mesh_keys(command, options.given);
    add_json(command, options.is_json);
}

void declare_schema(CLI::App& /*command*/, SchemaOptions& /*options*/) {}

void declare_files(CLI::App& command, std::vector<std::string>& paths) {
    command.add_option("files", paths, "histories")->required();
}

}  // namespace

void declare_commands(CLI::App& app, const std::vector<std::string>& words,
                      std::function<int()>& action) {
    const auto add = [&]<class Options>(
                         const char* name, const char* about,
                         const char* example,
                         void (*declare)(CLI::App&, Options&),
                         ExitCode (*run)(const Options&)) -> Options& {
        const auto options = std::make_shared<Options>();
        CLI::App* command = app.add_subcommand(name, about);
        command->group("Commands");
        command->footer(
            fmt::format("Example:\n  ideotype {} {}", name, example));
        declare(*command, *options);
        command->callback([&action, options, run] {
            action = [=] { return static_cast<int>(run(*options)); };
        });
        return *options;
    };
    add("new",
        "write a commented campaign file for a site and a crop; on a terminal, "
        "asks for missing values",
        "mine.toml --latitude 42.03 --longitude -93.63", declare_new,
        write_new_campaign);
    add("check", "validate a campaign and print its size, cost and cases",
        "campaigns/quickstart.toml", declare_check, check);
    add("schema",
        "print the JSON Schema of campaign files, with which editors complete "
        "and check keys",
        "> campaign.schema.json", declare_schema, print_schema);
    const auto note_start = [&](RunOptions& options) {
        options.command = quoted(words);
        options.launcher = launcher_of(words.front());
    };
    note_start(
        add("run",
            "optimise the plants of each case of a campaign, on the cores of "
            "this machine or on a cluster (under mpirun or srun)",
            "campaigns/quickstart.toml --resume", declare_run, start_run));
    note_start(
        add("sensitivity",
            "evaluate the design of a sensitivity study (Sobol' or Morris) of "
            "traits and numeric keys of a campaign; stops and resumes like "
            "run; ideotype indices computes the indices",
            "campaigns/ames_quick.toml", declare_sensitivity, start_run));
    add("status", "print the progress of histories, also of running ones",
        "results", declare_status, status);
    add("evaluate",
        "evaluate one plant in its field: the baseline of a campaign, or a row "
        "of a history, which is recomputed and compared bit for bit",
        "campaigns/quickstart.toml", declare_evaluate, evaluate);
    add("light", "compute the light absorbed by any mesh",
        "plant.obj --period 0.76 0.15 --sun 60 180", declare_light,
        light_in_mesh);
    add("serve",
        "evaluate genomes read as lines of JSON from standard input, and "
        "answer each with a line of JSON; uses all cores, or all ranks under "
        "mpirun or srun",
        "campaigns/ames_quick.toml < genomes > answers", declare_serve, serve);
    add("export",
        "write a plant of a history as OBJ (mesh), VTP (mesh with the PAR "
        "absorbed by each face, for ParaView), CSV (traits) or TOML (plant "
        "file, for campaigns), or all complete generations as CSV",
        "FILE.h5 --best --to best.toml", declare_export, export_plant);
    add("verify", "verify the checksums of histories, also of running ones",
        "FILE.h5", declare_files, verify);
    declare_python_commands(app);
}

}  // namespace ideotype
