// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "ideotype/core/text.hpp"
#include "spec/problems.hpp"
#include "verbs.hpp"

namespace ideotype {

namespace {

struct PythonVerb {
    std::string name, about;
};

const std::vector<PythonVerb>& python_verbs() {
    static const std::vector<PythonVerb> verbs = [] {
        std::vector<PythonVerb> all;
        for (const std::string_view line : lines_of(python_verbs_text)) {
            const std::size_t name = line.find(' ');
            const std::size_t function = line.find(' ', name + 1);
            all.push_back({std::string(line.substr(0, name)),
                           std::string(line.substr(function + 1))});
        }
        return all;
    }();
    return verbs;
}

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
    for (const auto& [name, about] : python_verbs())
        app.add_subcommand(name, about)->group("Of the Python package");
}

bool is_python_verb(const std::string& verb) {
    return std::ranges::count(python_verbs(), verb, &PythonVerb::name) > 0;
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
    throw wrong_usage(
        "{}: there is no {} to answer it with, which $IDEOTYPE_PYTHON names, "
        "or else the PATH has",
        words.front(), python);
}

}  // namespace ideotype
