// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "verbs.hpp"

namespace ideotype {

namespace {

struct PythonVerb {
    const char* name;
    const char* about;
};

//! The verbs that Python answers, as in `ideotype.__main__.VERBS` of the
//! package.
constexpr std::array python_verbs{
    PythonVerb{"summary",
               "tell the gains of cases as a table, with seeds put together"},
    PythonVerb{"report", "write a page about histories, with all figures"},
    PythonVerb{"compare",
               "compare plants in the same light: how each differs from the "
               "first, with paired errors, on all cores"},
    PythonVerb{"weather",
               "turn weather files of many formats into the one that "
               "campaigns read"},
    PythonVerb{"fidelity",
               "measure what accuracy costs here: error and time of every "
               "setting that trades one for the other, and the cheapest that "
               "will do"},
    PythonVerb{"indices",
               "tell what each objective depends on, from the rows of a "
               "sensitivity study"},
    PythonVerb{"crate",
               "describe finished histories as a Research Object Crate, with "
               "authors and licence"},
    PythonVerb{"ceptometer",
               "compare light that was measured among plants with light that "
               "is computed there"},
    PythonVerb{"fit",
               "make a crop file of a plant that was digitised, and tell how "
               "well each leaf fits"},
    PythonVerb{"play",
               "open a page with sliders that change a plant and its field, "
               "and see light and carbon follow"},
    PythonVerb{"watch", "open a page that follows running campaigns"},
};

//! The program that answers a verb in Python. Its arguments are a message for a
//! missing package, and the words. Files of the working folder cannot replace
//! modules.
constexpr const char* answer_code = R"py(import sys
sys.path[:] = filter(None, sys.path)
try:
    from ideotype.__main__ import answer
except ImportError as error:
    print(f"{sys.argv[1]} ({sys.executable}: {error})", file=sys.stderr)
    sys.exit(2)
sys.exit(answer(sys.argv[2:])))py";

}  // namespace

void declare_python_verbs(CLI::App& app) {
    for (const auto& [name, about] : python_verbs)
        app.add_subcommand(name, about)->group("Of the Python package");
}

bool is_python_verb(const std::string& verb) {
    return std::ranges::find(python_verbs, verb, &PythonVerb::name) !=
           python_verbs.end();
}

void hand_to_python(const std::vector<std::string>& words) {
    const char* named = std::getenv("IDEOTYPE_PYTHON");
    std::string python = named != nullptr && *named != '\0' ? named : "python3";
    const std::string remedy = fmt::format(
        "ideotype: {} is a verb of the Python package, which is not "
        "installed; in the folder of the sources: python3 -m venv .venv && "
        ".venv/bin/pip install . && export "
        "IDEOTYPE_PYTHON=$PWD/.venv/bin/python",
        words.front());
    std::vector<std::string> all{python, "-c", answer_code, remedy};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& each : all) arguments.push_back(each.data());
    arguments.push_back(nullptr);
    // Verbs of the Python package start this program to evaluate plants.
    const auto own = std::filesystem::read_symlink("/proc/self/exe");
    setenv("IDEOTYPE_EXECUTABLE", own.c_str(), 0);
    execvp(python.c_str(), arguments.data());
    throw Error(fmt::format("{}: there is no {} to answer it with, which "
                            "$IDEOTYPE_PYTHON names, or else the PATH has",
                            words.front(), python),
                ExitCode::usage);
}

}  // namespace ideotype
