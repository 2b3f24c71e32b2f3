#include <csignal>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "ideotype/cli/mesh_study.hpp"
#include "ideotype/cli/ranks.hpp"
#include "ideotype/cli/verbs.hpp"
#include "ideotype/run/provenance.hpp"
#include "mesh_command.hpp"
#include "report_error.hpp"
#include "run_command.hpp"
#include "verb_name.hpp"

namespace ideotype {

namespace {

void add_row_choice(CLI::App& verb, RowChoice& row) {
    auto* best = verb.add_flag(
        "--best", row.is_best,
        "the best finalist, or the best of the last complete generation");
    verb.add_option("--generation", row.generation, "generation of the row")
        ->excludes(best);
    verb.add_option("--slot", row.slot, "slot of the row")->excludes(best);
}

//! Most verbs would do the same work on each rank.
void require_shared_work(const CLI::App& verb, const Launch& launch) {
    const std::string name = verb.get_name();
    if (launch.size == 1 || name == "run" ||
        (name == "evaluate" && verb.count("--under") > 0))
        return;
    throw Error(
        fmt::format("{}: {} copies of this were started, which would all do "
                    "the same work; start it without mpirun or srun (run and "
                    "evaluate --under share their work between ranks)",
                    name, launch.size),
        ExitCode::usage);
}

}  // namespace

int report_error(const std::exception& error, ExitCode code) {
    fmt::print(stderr, "ideotype: {}\n", error.what());
    return static_cast<int>(code);
}

int run_command_line(int argc, char** argv) {
    // A file beyond `ulimit -f` shall fail with a reason, not kill.
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App app(
        "Designs crop canopies: evolves plants that make the best use of "
        "light.\nExit codes: 0 ok, 1 failed, 2 wrong usage, 3 invalid "
        "campaign, 4 refused, 5 a run stopped early on request and can be "
        "resumed.",
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

    RunCommand run_command;
    run_command.add_to(app, argc, argv);
    app.get_subcommand("run")->callback(
        [&] { action = [&] { return run_command.start(); }; });

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

    const Launch launch = launch_of_this_process();
    try {
        check_verb_name(app, argc > 1 ? argv[1] : "");
        app.parse(argc, argv);
        require_shared_work(*app.get_subcommands().front(), launch);
        return action();
    } catch (const CLI::ParseError& error) {
        // What is wrong with a command line rank 0 tells. Others that end with
        // a code before it would keep its words from being heard.
        if (launch.rank != 0) return static_cast<int>(ExitCode::ok);
        const bool is_fine = app.exit(error) == 0;
        return static_cast<int>(is_fine ? ExitCode::ok : ExitCode::usage);
    } catch (const Error& error) {
        if (error.exit_code() == ExitCode::usage && launch.rank != 0)
            return static_cast<int>(ExitCode::ok);
        return report_error(error, error.exit_code());
    } catch (const std::exception& error) {
        return report_error(error, ExitCode::runtime);
    }
}

}  // namespace ideotype
