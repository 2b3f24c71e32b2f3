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

//! `check CAMPAIGN`: validates a campaign, builds one plant, and reports size,
//! cost and whether names of files fit into the folder `out`; or lists cases
//! only.
struct CheckOptions {
    std::string campaign_path;
    std::vector<std::string> settings;  //!< "table.key=value"
    std::string out = "results";
    bool lists_cases = false;
    bool only_count = false;
    bool only_left = false;  //!< only the cases that are not finished in `out`
    bool is_json = false;
};
ExitCode check(const CheckOptions& options);

//! `ideotype schema` has no options.
struct SchemaOptions {};
ExitCode print_schema(const SchemaOptions& options);

//! `status PATH...`: prints a line for each history, live or not, and how to
//! resume stopped ones.
struct StatusOptions {
    std::vector<std::string> paths;
    bool is_json = false;
};
ExitCode status(const StatusOptions& options);

//! `light MESH`: traces and prints the light in any mesh.
struct LightOptions {
    std::string mesh;
    GivenKeys given;  //!< options that are keys of MeshSpec
    bool is_json = false;
};
ExitCode light_in_mesh(const LightOptions& options);
//! Returns the option of a key, such as "--soil-albedo".
std::string option_of_key(const std::string& key);
//! Declares an option for each key of MeshSpec.
void declare_mesh_keys(CLI::App& verb, GivenKeys& given);

//! The choice of one plant of a history.
struct RowChoice {
    bool is_best = false;  //!< choose the best finalist, or the best so far
    std::optional<std::uint32_t> generation;
    std::optional<std::uint32_t> slot;
};

//! `evaluate CAMPAIGN`: evaluates the baseline. `evaluate FILE --generation G
//! --slot S`: recomputes a row.
struct EvaluateOptions {
    std::string path;                   //!< a campaign or a history
    std::vector<std::string> settings;  //!< for a campaign, "table.key=value"
    int case_index = 0;
    RowChoice row;
    bool is_json = false, is_all = false;
};
ExitCode evaluate(const EvaluateOptions& options);

//! `new FILE`: writes a commented campaign for a place and a plant. Numbers are
//! kept as texts; a terminal is asked for every "".
struct NewOptions {
    std::string path;
    std::string name;  //!< name of the campaign; "" is that of the file
    std::string latitude, longitude, utc_offset;  //!< in [deg], [deg] and [h]
    std::string date;
    std::string weather;             //!< weather file, in place of a date
    std::string row, plant_spacing;  //!< distances [m]
    std::string plant;               //!< known crop, or crop file
    std::string objective;
};
ExitCode write_new_campaign(const NewOptions& options);

//! `serve CAMPAIGN`: evaluates the genomes in lines of standard input, and
//! answers in lines.
struct ServeOptions {
    std::string campaign_path;
    std::vector<std::string> settings;  //!< "table.key=value"
    int case_index = 0;
    std::optional<int> threads;  //!< number of threads, see threads_per_rank()
    LogLevel level = LogLevel::info;
};
ExitCode serve(const ServeOptions& options);

//! `export FILE --to X.obj|X.vtp|X.csv|X.toml`: writes a plant or its field.
//! `export FILE --generations --to X.csv`: writes the candidates of all
//! complete generations, even of a truncated file.
struct ExportOptions {
    std::string path;
    RowChoice row;
    std::string to;
    std::string component;  //!< component of the plant; "" is the crop's own
    std::string at;  //!< date or thermal time of the plant; "": full-grown
    bool is_field = false;
    //! Paths per randomisation for the light on faces; by default enough for
    //! the number of faces.
    std::optional<int> paths;
    bool is_generations = false;
};
ExitCode export_plant(const ExportOptions& options);
ExitCode export_generations(const ExportOptions& options);

//! `verify FILE...`: compares histories with their checksums.
ExitCode verify(const std::vector<std::string>& paths);

//! Prints an error for the user, and returns the exit code for the shell.
ExitCode report_error(const std::exception& error);

//! Reports an error in a log and returns its exit code.
ExitCode report_error(const std::exception& error, const Log& log);

//! Adds all verbs to a command line. Parsing sets `action` to the work of the
//! given verb, which returns an exit code.
//! @param words of the command line, the program's name first
void declare_verbs(CLI::App& app, const std::vector<std::string>& words,
                   std::function<int()>& action);

//! Runs a campaign; collective over the ranks that a launcher has started.
ExitCode start_run(const RunOptions& options);

//! Adds the verbs of the Python package to the help of the program.
void declare_python_verbs(CLI::App& app);

//! Tells whether the Python package answers a verb.
bool is_python_verb(const std::string& verb);

//! Replaces this process by the Python that $IDEOTYPE_PYTHON names, else by the
//! first python3 of the PATH, to answer a verb or tell how to install the
//! package. Sets IDEOTYPE_EXECUTABLE to this program if it is unset.
//! @param words verb and its arguments
//! @throws Error (usage) if there is no such Python.
[[noreturn]] void hand_to_python(const std::vector<std::string>& words);

//! The form of a campaign file, from verbs/campaign_form.txt. A key without
//! value gets its default, and a key without note its meaning.
extern const char* const campaign_form;

//! The verbs that Python answers, from verbs.txt of the Python package: in each
//! line the name, the function that answers, and what the verb does.
extern const char* const python_verbs_text;

//! Parses the words, runs the verb, reports errors and returns the exit code.
int run_command_line(int argc, char** argv);

}  // namespace ideotype
