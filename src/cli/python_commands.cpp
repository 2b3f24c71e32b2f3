// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "commands.hpp"
#include "ideotype/core/text.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

struct PythonCommand {
    std::string name, about;
};

const std::vector<PythonCommand>& python_commands() {
    static const std::vector<PythonCommand> commands = [] {
        std::vector<PythonCommand> list;
        for (const std::string_view line : split_lines(python_commands_text)) {
            const std::size_t name = line.find(' ');
            const std::size_t function = line.find(' ', name + 1);
            list.push_back({std::string(line.substr(0, name)),
                            std::string(line.substr(function + 1))});
        }
        return list;
    }();
    return commands;
}

//! The Python code that runs a command. Its arguments are the message to print
//! if the package is missing, and the words of the command. It removes the
//! working folder from sys.path, so that files there cannot replace modules.
constexpr const char* answer_code = R"py(import sys
sys.path[:] = filter(None, sys.path)
try:
    from ideotype.__main__ import answer
except ImportError as error:
    print(f"{sys.argv[1]} ({sys.executable}: {error})", file=sys.stderr)
    sys.exit(2)
sys.exit(answer(sys.argv[2:])))py";

}  // namespace

void declare_python_commands(CLI::App& app) {
    for (const auto& [name, about] : python_commands())
        app.add_subcommand(name, about)
            ->group("Commands of the Python package");
}

bool is_python_command(const std::string& command) {
    return std::ranges::count(python_commands(), command,
                              &PythonCommand::name) > 0;
}

void hand_to_python(const std::vector<std::string>& words) {
    const char* named = std::getenv("IDEOTYPE_PYTHON");
    std::string python = named != nullptr && *named != '\0' ? named : "python3";
    const std::string remedy = fmt::format(
        "ideotype: {} is a command of the Python package, which is not "
        "installed; install it from the source folder: python3 -m venv .venv "
        "&& .venv/bin/pip install . && export "
        "IDEOTYPE_PYTHON=$PWD/.venv/bin/python",
        words.front());
    std::vector<std::string> line{python, "-c", answer_code, remedy};
    line.insert(line.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& each : line) arguments.push_back(each.data());
    arguments.push_back(nullptr);
    // Commands of the Python package start this program to evaluate plants.
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    setenv("IDEOTYPE_EXECUTABLE", program.c_str(), 0);
    execvp(python.c_str(), arguments.data());
    throw wrong_usage(
        "{}: cannot start {} for this command of the Python package; set "
        "IDEOTYPE_PYTHON to a Python interpreter, or put python3 on the PATH",
        words.front(), python);
}

}  // namespace ideotype
