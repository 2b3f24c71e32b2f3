#include <csignal>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "ideotype/app/mesh_study.hpp"
#include "ideotype/app/provenance.hpp"
#include "ideotype/app/verbs.hpp"
#include "ideotype/app/wall_time.hpp"
#include "mesh_command.hpp"
#include "verb_name.hpp"

namespace ideotype {

namespace {

int report_error(const std::exception& error, ExitCode code) {
    fmt::print(stderr, "ideotype: {}\n", error.what());
    return static_cast<int>(code);
}

std::string joined_command(int argc, char** argv) {
    std::string command;
    for (int i = 0; i < argc; ++i)
        command += (i > 0 ? " " : "") + std::string(argv[i]);
    return command;
}

double to_seconds(const std::string& text) {
    if (const auto seconds = parse_wall_time(text)) return *seconds;
    throw CLI::ValidationError(
        "--wall-time", fmt::format("'{}' is no time; write for example 90, "
                                   "90s, 30m, 2h, 1h30m or 01:30:00",
                                   text));
}

void add_row_choice(CLI::App& verb, RowChoice& row) {
    auto* best = verb.add_flag(
        "--best", row.is_best,
        "the best finalist, or the best of the last complete generation");
    verb.add_option("--generation", row.generation, "generation of the row")
        ->excludes(best);
    verb.add_option("--slot", row.slot, "slot of the row")->excludes(best);
}

//! run is the one verb that may have many ranks.
int run_with_session(const RunOptions& options) {
    StopFlag stop;
    const Session session;
    int code = 0;
    try {
        return static_cast<int>(run(options, session, stop));
    } catch (const Error& error) {
        code = report_error(error, error.exit_code());
    } catch (const std::exception& error) {
        code = report_error(error, ExitCode::runtime);
    }
    // Rank 0 has told the others to leave. It would wait for ever for one
    // that fails by itself.
    if (session.rank() != 0) session.abort(code);
    return code;
}

}  // namespace

int run_command_line(int argc, char** argv) {
    // A file beyond `ulimit -f` shall fail with a reason, not kill.
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App app(
        "Designs crop canopies: evolves plants that make the best use of "
        "light.\nExit codes: 0 ok, 1 failed, 2 wrong usage, 3 invalid "
        "campaign, 4 refused.",
        "ideotype");
    app.set_version_flag("--version", version_text());
    app.require_subcommand(1);
    std::function<int()> action;
    const auto on = [&](CLI::App* verb, std::function<ExitCode()> function) {
        verb->callback([&action, function] {
            action = [function] { return static_cast<int>(function()); };
        });
    };

    std::string check_path;
    auto* check_verb = app.add_subcommand(
        "check", "validate a campaign; report its size and cost");
    check_verb->add_option("campaign", check_path, "campaign file (TOML)")
        ->required();
    std::string check_out = "results";
    check_verb
        ->add_option("--out", check_out, "folder that the histories will be in")
        ->capture_default_str();
    on(check_verb, [&] { return check(check_path, check_out); });

    PlanOptions plan_options;
    auto* plan_verb = app.add_subcommand(
        "plan", "list the cases of a campaign with index, seed and cost");
    plan_verb->add_option("campaign", plan_options.campaign_path)->required();
    plan_verb->add_flag("--count", plan_options.only_count,
                        "print only how many cases there are");
    plan_verb
        ->add_flag("--left", plan_options.only_left,
                   "print only the cases that are not finished: index and "
                   "evaluations done")
        ->excludes("--count");
    plan_verb
        ->add_option("--out", plan_options.out,
                     "folder in which --left looks for histories")
        ->capture_default_str();
    on(plan_verb, [&] { return plan(plan_options); });

    RunOptions run_options;
    std::string wall_time;
    auto* run_verb = app.add_subcommand(
        "run", "evolve the cases of a campaign, alone or under mpirun");
    run_verb->add_option("campaign", run_options.campaign_path)->required();
    run_verb->add_option("--case", run_options.case_index,
                         "only the case of this index (see plan)");
    run_verb->add_flag("--resume", run_options.is_resumed,
                       "go on with histories that exist; start the others");
    run_verb
        ->add_option("--out", run_options.out,
                     "folder for <campaign>/<case>.h5")
        ->capture_default_str();
    run_verb
        ->add_option("--isa", run_options.isa,
                     "instruction set to begin with, the same on all ranks; "
                     "if not given the widest that all have, and for a "
                     "history that is resumed its own")
        ->check(CLI::IsMember({"sse2", "sse4.2", "avx", "avx2", "avx512"}));
    run_verb->add_option("--wall-time", wall_time,
                         "time after which to stop cleanly: seconds, or for "
                         "example 30m, 1h30m, 01:30:00");
    run_options.command = joined_command(argc, argv);
    run_verb->callback([&] {
        if (!wall_time.empty()) run_options.wall_time = to_seconds(wall_time);
        action = [&] { return run_with_session(run_options); };
    });

    StatusOptions status_options;
    auto* status_verb = app.add_subcommand(
        "status", "how far histories have come, also while they are written");
    status_verb
        ->add_option("paths", status_options.paths, "histories or folders")
        ->required();
    status_verb->add_flag(
        "--resumable", status_options.only_resumable,
        "print only the files of unfinished cases that nobody "
        "works on");
    on(status_verb, [&] { return status(status_options); });

    EvaluateOptions evaluate_options;
    auto* evaluate_verb = app.add_subcommand(
        "evaluate",
        "the light in one canopy: a campaign's baseline, or a row of a "
        "history, which is recomputed and compared bit for bit, or any mesh, "
        "or many plants under the cases of a campaign");
    CrossOptions cross_options;
    auto* evaluate_path =
        evaluate_verb->add_option("files", cross_options.plants,
                                  "campaign (.toml: its baseline) or history "
                                  "(.h5); with --under several, "
                                  "plant files (.toml) too");
    auto* under = evaluate_verb->add_option(
        "--under", cross_options.under,
        "campaign in whose cases all plants are evaluated, the best of each "
        "history");
    under->needs(evaluate_path);
    evaluate_verb
        ->add_option("--case", evaluate_options.case_index,
                     "case of the campaign")
        ->capture_default_str();
    add_row_choice(*evaluate_verb, evaluate_options.row);
    evaluate_verb->add_flag("--json", evaluate_options.is_json);
    MeshOptions mesh_options;
    add_mesh_options(*evaluate_verb, mesh_options);
    evaluate_verb->add_option_function<double>(
        "--tolerance",
        [&](double tolerance) {
            mesh_options.tolerance = tolerance;
            evaluate_options.tolerance = tolerance;
        },
        "relative standard error of the leaves' total: of a mesh (0.001 if not "
        "given), or of a second look at a row of a history, in the same "
        "field");
    evaluate_verb->get_option("--paths")->excludes("--tolerance");
    evaluate_verb->get_option("--mesh")
        ->excludes(evaluate_path)
        ->excludes("--case")
        ->excludes("--best")
        ->excludes("--generation")
        ->excludes("--slot");
    for (const char* other : {"--mesh", "--case", "--best", "--generation",
                              "--slot", "--tolerance"})
        under->excludes(other);
    on(evaluate_verb, [&] {
        mesh_options.is_json = cross_options.is_json = evaluate_options.is_json;
        if (!mesh_options.path.empty()) return evaluate_mesh(mesh_options);
        if (!cross_options.under.empty()) return cross_evaluate(cross_options);
        if (cross_options.plants.size() > 1)
            throw Error("evaluate: several plants need --under CAMPAIGN",
                        ExitCode::usage);
        if (!cross_options.plants.empty())
            evaluate_options.path = cross_options.plants.front();
        return evaluate(evaluate_options);
    });

    FidelityOptions fidelity_options;
    auto* fidelity_verb = app.add_subcommand(
        "fidelity",
        "measure what accuracy costs here: error and time of every setting "
        "that trades one for the other, and the cheapest that will do");
    fidelity_verb->add_option("campaign", fidelity_options.campaign_path)
        ->required();
    fidelity_verb->add_option("--case", fidelity_options.case_index)
        ->capture_default_str();
    fidelity_verb
        ->add_option("--tolerance", fidelity_options.tolerance,
                     "relative error of one evaluation that will do")
        ->check(CLI::Range(1e-5, 0.05))
        ->capture_default_str();
    fidelity_verb
        ->add_option("--seconds", fidelity_options.seconds,
                     "to measure, about; at least what a few draws take")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    fidelity_verb->add_option("--json", fidelity_options.json_path,
                              "also write everything to this file");
    on(fidelity_verb, [&] { return fidelity(fidelity_options); });

    ExportOptions export_options;
    auto* export_verb = app.add_subcommand(
        "export",
        "write a plant of a history as OBJ (mesh), VTP (mesh with the PAR "
        "that each face absorbs, for ParaView), CSV (traits) or TOML (plant "
        "file, for campaigns), or all "
        "complete generations as CSV");
    export_verb->add_option("file", export_options.path)->required();
    add_row_choice(*export_verb, export_options.row);
    export_verb
        ->add_option("--to", export_options.to,
                     "new file, .obj, .vtp, .csv or .toml")
        ->required();
    export_verb->add_flag("--field", export_options.is_field,
                          "the whole field instead of one plant (.obj, .vtp)");
    export_verb
        ->add_option("--paths", export_options.paths,
                     "light paths per randomisation for the light on faces "
                     "(.vtp); more for less noise")
        ->check(CLI::Range(16, 16777216));
    export_verb
        ->add_flag("--generations", export_options.is_generations,
                   "all candidates with their fitness instead of one plant "
                   "(.csv), also of a file that was cut short")
        ->excludes("--best")
        ->excludes("--generation")
        ->excludes("--slot")
        ->excludes("--field")
        ->excludes("--paths");
    on(export_verb, [&] {
        return export_options.is_generations
                   ? export_generations(export_options)
                   : export_plant(export_options);
    });

    std::vector<std::string> packed_paths;
    auto* pack_verb = app.add_subcommand(
        "pack",
        "compress finished histories; each is checked before it is replaced");
    pack_verb->add_option("files", packed_paths, "histories")->required();
    on(pack_verb, [&] { return pack(packed_paths); });

    try {
        check_verb_name(app, argc > 1 ? argv[1] : "");
        app.parse(argc, argv);
        return action();
    } catch (const CLI::ParseError& error) {
        const bool is_fine = app.exit(error) == 0;
        return static_cast<int>(is_fine ? ExitCode::ok : ExitCode::usage);
    } catch (const Error& error) {
        return report_error(error, error.exit_code());
    } catch (const std::exception& error) {
        return report_error(error, ExitCode::runtime);
    }
}

}  // namespace ideotype
