// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "ideotype/core/error.hpp"
#include "parallel/session.hpp"
#include "run/log.hpp"
#include "run/run.hpp"
#include "stand/mesh_options.hpp"

namespace CLI {
class App;
}

namespace ideotype {

//! `check CAMPAIGN`: validates, builds one plant, reports size and cost, and
//! whether the names of its files fit into the folder out; or its cases alone.
struct CheckOptions {
    std::string campaign_path;
    std::vector<std::string> settings;  //!< "table.key=value"
    std::string out = "results";
    bool lists_cases = false;
    bool only_count = false;
    bool only_left = false;  //!< the cases that are not finished in `out`
    bool is_json = false;
};
ExitCode check(const CheckOptions& options);

//! `status PATH...`: one line per history or history in a folder, also of live
//! ones, and how to go on with what stopped.
struct StatusOptions {
    std::vector<std::string> paths;
    bool is_json = false;
};
ExitCode status(const StatusOptions& options);

//! `light MESH`: traces and prints the light in any mesh.
ExitCode light_in_mesh(const MeshOptions& options);

//! The plant of a history that is meant.
struct RowChoice {
    bool is_best = false;  //!< the best finalist, or the best so far
    std::optional<std::uint32_t> generation;
    std::optional<std::uint32_t> slot;
};

//! `evaluate CAMPAIGN`: the baseline's light.
//! `evaluate FILE --generation G --slot S`: recomputes a row.
struct EvaluateOptions {
    std::string path;                   //!< a campaign or a history
    std::vector<std::string> settings;  //!< of a campaign: "table.key=value"
    int case_index = 0;
    RowChoice row;
    bool is_json = false, is_all = false;
};
ExitCode evaluate(const EvaluateOptions& options);

//! `new FILE`: writes a commented campaign for a place and a plant. Numbers are
//! as they were written; what is "" is asked for on a terminal.
struct NewOptions {
    std::string path;
    std::string name;                             //!< "": that of the file
    std::string latitude, longitude, utc_offset;  //!< [deg], [h]
    std::string date;
    std::string row, plant_spacing;  //!< [m]
    //! A crop that the program knows, a crop file or measured leaves.
    std::string plant;
    std::string objective;
};
ExitCode write_new_campaign(const NewOptions& options);

//! `serve CAMPAIGN`: evaluates the genomes that lines of the standard input ask
//! for, and answers in lines.
struct ServeOptions {
    std::string campaign_path;
    std::vector<std::string> settings;  //!< "table.key=value"
    int case_index = 0;
    std::optional<int> threads;  //!< see threads_per_rank()
    LogLevel level = LogLevel::info;
};
ExitCode serve(const ServeOptions& options);

//! Returns the day that a text such as 2025-08-07 is, or nothing if it is none.
std::optional<Date> to_date(const std::string& text);

//! `export FILE --to X.obj|X.vtp|X.csv|X.toml`: writes a plant or its field.
//! `export FILE --generations --to X.csv`: writes the candidates of all
//! complete generations, also of a file that was cut short.
struct ExportOptions {
    std::string path;
    RowChoice row;
    std::string to;
    std::string component;  //!< whose plant it is; "": that of the crop
    std::string at;         //!< a date or a thermal time; "": full-grown
    bool is_field = false;
    //! Paths of light per randomisation for the light on faces; not given:
    //! enough for their number.
    std::optional<int> paths;
    bool is_generations = false;
};
ExitCode export_plant(const ExportOptions& options);
ExitCode export_generations(const ExportOptions& options);

//! `verify FILE...`: compares histories with their checksums.
ExitCode verify(const std::vector<std::string>& paths);

//! Tells the user, and returns the code for the shell.
ExitCode report_error(const std::exception& error);

//! Reports an error in a log and returns its exit code.
ExitCode report_error(const std::exception& error, const Log& log);

//! Adds all verbs to a command line. Parsing it sets the action to what the
//! given verb does, which returns an exit code.
//! @param words of the command line, the program's name first
void declare_verbs(CLI::App& app, const std::vector<std::string>& words,
                   std::function<int()>& action);

void declare_run(CLI::App& verb, RunOptions& options);

//! Declares the verb `sensitivity`, which evaluates the design of a study.
void declare_sensitivity(CLI::App& verb, RunOptions& options);

//! Collective over the ranks that a launcher has started, if any.
ExitCode start_run(const RunOptions& options);

//! Adds the verbs that the Python package answers to the help of the program.
void declare_python_verbs(CLI::App& app);

//! Tells whether the Python package answers a verb.
bool is_python_verb(const std::string& verb);

//! Becomes the Python that $IDEOTYPE_PYTHON names, else the first python3 of
//! the PATH, which answers a verb or says how to install the package; sets
//! IDEOTYPE_EXECUTABLE to this program if it is not set.
//! @param words verb and arguments
//! @throws Error of wrong usage if there is no such Python.
[[noreturn]] void hand_to_python(const std::vector<std::string>& words);

//! Parses the command line, runs the verb, reports errors.
int run_command_line(int argc, char** argv);

}  // namespace ideotype
