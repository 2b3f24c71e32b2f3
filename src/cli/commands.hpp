// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/error.hpp"
#include "run/log.hpp"
#include "run/run.hpp"
#include "spec/mesh_spec.hpp"

namespace CLI {
class App;
}

namespace ideotype {

//! `check CAMPAIGN`: validates a campaign, builds one plant, and reports size
//! and cost. Also checks that file names fit into the folder `out`. On request
//! it only lists cases.
struct CheckOptions {
    std::string campaign_path;
    std::vector<std::string> settings;  //!< "table.key=value"
    std::string out = "results";
    bool lists_cases = false;
    bool only_count = false;
    bool only_left = false;  //!< only cases that are unfinished in `out`
    bool is_json = false;
};
ExitCode check(const CheckOptions& options);

//! `ideotype schema` has no options.
struct SchemaOptions {};
ExitCode print_schema(const SchemaOptions& options);

//! `status PATH...`: prints one line for each history, whether running or not,
//! and the commands that resume stopped runs.
struct StatusOptions {
    std::vector<std::string> paths;
    bool is_json = false;
};
ExitCode status(const StatusOptions& options);

//! `light MESH`: computes and prints the light absorbed by any mesh.
struct LightOptions {
    std::string mesh;
    GivenKeys given;  //!< values of keys of MeshSpec that are given as options
    bool is_json = false;
};
ExitCode light_in_mesh(const LightOptions& options);
//! Returns the option for a key, such as "--soil-albedo".
std::string option_of_key(const std::string& key);
//! Declares one option for each key of MeshSpec.
void declare_mesh_keys(CLI::App& command, GivenKeys& given);

//! Selects one plant of a history.
struct RowChoice {
    //! Selects the best finalist, or the best plant so far.
    bool is_best = false;
    std::optional<std::uint32_t> generation;
    std::optional<std::uint32_t> slot;
};

//! `evaluate CAMPAIGN`: evaluates the baseline. `evaluate HISTORY --generation
//! G --slot S`: recomputes a row and compares it bit for bit.
struct EvaluateOptions {
    std::string path;  //!< a campaign or a history
    //! Settings "table.key=value", for a campaign only.
    std::vector<std::string> settings;
    int case_index = 0;
    RowChoice row;
    bool is_json = false, is_all = false;
};
ExitCode evaluate(const EvaluateOptions& options);

//! `new FILE`: writes a commented campaign for a site and a crop. Numbers are
//! stored as texts. "" marks a missing answer, for which the command asks on a
//! terminal.
struct NewOptions {
    std::string path;
    std::string name;  //!< name of the campaign; "": from the file name
    std::string latitude, longitude, utc_offset;  //!< in [deg], [deg] and [h]
    std::string date;
    std::string weather;             //!< weather file, which replaces a date
    std::string row, plant_spacing;  //!< distances [m]
    std::string plant;               //!< built-in crop, or crop file
    std::string objective;
};
ExitCode write_new_campaign(const NewOptions& options);

//! `serve CAMPAIGN`: reads genomes from standard input, one per line, evaluates
//! them and answers each with a line.
struct ServeOptions {
    std::string campaign_path;
    std::vector<std::string> settings;  //!< "table.key=value"
    int case_index = 0;
    std::optional<int> threads;  //!< number of threads, see threads_per_rank()
    LogLevel level = LogLevel::info;
};
ExitCode serve(const ServeOptions& options);

//! `export FILE --to X.obj|X.vtp|X.csv|X.toml`: writes a plant or the field in
//! which it stands. `export FILE --generations --to X.csv`: writes the
//! candidates of all complete generations, even if the file is truncated.
struct ExportOptions {
    std::string path;
    RowChoice row;
    std::string to;
    std::string component;  //!< component to write; "": the main crop
    std::string at;  //!< date or thermal time of growing plants; "": full-grown
    bool is_field = false;
    //! Light paths per randomisation for the PAR of each face. The default
    //! depends on the number of faces.
    std::optional<int> paths;
    bool is_generations = false;
};
ExitCode export_plant(const ExportOptions& options);
ExitCode export_generations(const ExportOptions& options);

//! `verify FILE...`: compares histories with their checksums.
ExitCode verify(const std::vector<std::string>& paths);

//! Prints an error and returns the exit code for the shell.
ExitCode report_error(const std::exception& error);

//! Writes an error to a log and returns its exit code.
ExitCode report_error(const std::exception& error, const Log& log);

//! Adds all commands to a command-line parser. After parsing, `action` is the
//! function of the given command, which returns an exit code.
//! @param words words of the command line, the program's name first
void declare_commands(CLI::App& app, const std::vector<std::string>& words,
                      std::function<int()>& action);

//! Runs a campaign. Collective over the ranks that a launcher has started.
ExitCode start_run(const RunOptions& options);

//! Adds the commands of the Python package to the help of the program.
void declare_python_commands(CLI::App& app);

//! Returns whether a command belongs to the Python package.
bool is_python_command(const std::string& command);

//! Replaces this process by a Python interpreter that runs a command of the
//! package, or prints how to install the package. The interpreter is
//! $IDEOTYPE_PYTHON or, if this is unset, the first python3 on the PATH. If
//! IDEOTYPE_EXECUTABLE is unset, it is set to this program.
//! @param words the command and its arguments
//! @throws Error (usage) if the interpreter cannot be started.
[[noreturn]] void hand_to_python(const std::vector<std::string>& words);

//! The template of new campaign files, from commands/campaign_form.txt. Keys
//! without a value get their default, and keys without a comment their meaning.
extern const char* const campaign_form;

//! The commands of the Python package, from its commands.txt. Each line states
//! the name, the function to call, and the help text.
extern const char* const python_commands_text;

//! Parses the command line, runs the command, reports errors and returns the
//! exit code.
int run_command_line(int argc, char** argv);

}  // namespace ideotype
