// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "commands.hpp"
#include "ideotype/core/ending.hpp"
#include "ideotype/core/text.hpp"
#include "ranks.hpp"
#include "run/provenance.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

//! Checks that the first word, unless it is an option, is a command.
//! @throws Error (usage) that suggests the nearest command.
void check_command_name(const CLI::App& app, const std::string& word) {
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({}))
        commands.push_back(command->get_name());
    if (word.empty() || word.starts_with('-') ||
        std::ranges::find(commands, word) != commands.end())
        return;
    throw wrong_usage("there is no command '{}'; {}", word,
                      did_you_mean(word, commands));
}

//! Returns the error about the first unknown option or, if there is none, about
//! the first unexpected argument.
Error unknown_word(const CLI::App& command) {
    const std::vector<std::string> words = command.remaining();
    const auto unknown =
        std::ranges::find_if(words, [](const std::string& each) {
            return each.starts_with('-') && each != "--";
        });
    const std::string how = "see ideotype " + command.get_name() + " --help";
    if (unknown == words.end())
        return wrong_usage("{}: unexpected argument '{}'; {}",
                           command.get_name(),
                           words.empty() ? "" : words.front(), how);
    std::vector<std::string> names;
    for (const CLI::Option* each : command.get_options())
        if (!each->get_group().empty())
            for (const std::string& option : each->get_lnames())
                names.push_back("--" + option);
    const std::string name = unknown->substr(0, unknown->find('='));
    names.push_back("--ranks");
    const std::string nearest = nearest_name(name, names);
    if (nearest == "--ranks")
        return wrong_usage(
            "--ranks was removed: leave it out to use all cores of this "
            "machine, or use N of them with --threads N");
    return wrong_usage("{}: there is no option {}; {}", command.get_name(),
                       name,
                       nearest.empty() ? how : "did you mean " + nearest + "?");
}

//! Refuses several ranks if the command cannot share work among ranks.
void require_shared_work(const CLI::App& command, const Launch& launch) {
    const std::string& name = command.get_name();
    if (launch.size == 1 || name == "run" || name == "sensitivity" ||
        name == "serve")
        return;
    throw wrong_usage(
        "{}: {} copies of this command were started and would all do the same "
        "work; start it without mpirun or srun (only run, sensitivity and "
        "serve share work among ranks)",
        name, launch.size);
}

ExitCode code_of(const std::exception& error) {
    const auto* known = dynamic_cast<const Error*>(&error);
    return known != nullptr ? known->exit_code() : ExitCode::runtime;
}

int run_command(int argc, char** argv) {
    // With this, writing beyond `ulimit -f` returns an error instead of killing
    // the process.
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App app(
        "Designs crop canopies: optimises the shapes of plants for light "
        "interception and carbon gain.\nExit codes: 0 ok, 1 failed, 2 wrong "
        "usage, 3 invalid campaign, 4 refused, 5 stopped early on request and "
        "can be resumed.",
        "ideotype");
    app.set_version_flag("--version", version_text);
    app.set_help_all_flag("--help-all",
                          "Print the help of all commands and exit");
    app.require_subcommand(1);
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    const std::vector<std::string> words(argv, argv + argc);
    std::function<int()> action;
    declare_commands(app, words, action);

    const Launch launch = launch_of_this_process();
    // Only rank 0 reports errors of the command line. If another rank ended
    // first with an error code, the launcher would kill rank 0 before it prints
    // the message.
    const bool is_silent = launch.rank != 0;
    try {
        check_command_name(app, argc > 1 ? argv[1] : "");
        if (argc > 1 && is_python_command(argv[1])) {
            require_shared_work(*app.get_subcommand(argv[1]), launch);
            hand_to_python({words.begin() + 1, words.end()});
        }
        app.parse(argc, argv);
        require_shared_work(*app.get_subcommands().front(), launch);
        return action();
    } catch (const CLI::ExtrasError&) {
        if (is_silent) return 0;
        return static_cast<int>(
            report_error(unknown_word(*app.get_subcommands().front())));
    } catch (const CLI::ParseError& error) {
        if (is_silent) return 0;
        return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
    } catch (const std::exception& error) {
        const auto* known = dynamic_cast<const Error*>(&error);
        if (is_silent && known && known->exit_code() == ExitCode::usage)
            return 0;
        return static_cast<int>(report_error(error));
    }
}

}  // namespace

ExitCode report_error(const std::exception& error) {
    fmt::print(stderr, "ideotype: {}\n",
               printable_lines(describe_exception(error)));
    return code_of(error);
}

ExitCode report_error(const std::exception& error, const Log& log) {
    log.write(LogLevel::error, describe_exception(error));
    return code_of(error);
}

int run_command_line(int argc, char** argv) {
    watch_for_foreign_end();
    const int code = run_command(argc, argv);
    end_in_order();
    // Output may still be buffered. The errno of an earlier failed write is not
    // known.
    errno = 0;
    if ((std::fflush(stdout) == 0 && std::ferror(stdout) == 0) || code != 0)
        return code;
    return static_cast<int>(report_error(Error(
        fmt::format("cannot write to the standard output: {}",
                    errno == 0 ? "a part is lost (is the disk full?)"
                               : std::generic_category().message(errno)))));
}

}  // namespace ideotype
