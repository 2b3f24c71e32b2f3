// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "ideotype/core/ending.hpp"
#include "ideotype/core/text.hpp"
#include "ranks.hpp"
#include "run/provenance.hpp"
#include "spec/problems.hpp"
#include "verbs.hpp"

namespace ideotype {

namespace {

//! Looks whether the first word, if it is no option, is a verb.
//! @throws Error of wrong usage that names the nearest verb.
void check_verb_name(const CLI::App& app, const std::string& word) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app.get_subcommands({}))
        verbs.push_back(verb->get_name());
    if (word.empty() || word.starts_with('-') ||
        std::ranges::find(verbs, word) != verbs.end())
        return;
    throw wrong_usage("there is no command '{}'; {}", word,
                      did_you_mean(word, verbs));
}

//! Tells the first unknown word that looks like an option, or else the first.
Error unknown_word(const CLI::App& verb) {
    const std::vector<std::string> words = verb.remaining();
    const auto found = std::ranges::find_if(words, [](const std::string& each) {
        return each.starts_with('-') && each != "--";
    });
    const std::string how = "see ideotype " + verb.get_name() + " --help";
    if (found == words.end())
        return wrong_usage("{}: '{}' is one word too many; {}", verb.get_name(),
                           words.empty() ? "" : words.front(), how);
    std::vector<std::string> names;
    for (const CLI::Option* each : verb.get_options())
        if (!each->get_group().empty())
            for (const std::string& option : each->get_lnames())
                names.push_back("--" + option);
    const std::string name = found->substr(0, found->find('='));
    names.push_back("--ranks");
    const std::string nearest = nearest_name(name, names);
    if (nearest == "--ranks")
        return wrong_usage(
            "--ranks is gone: all cores of this machine are used without it, N "
            "of them with --threads N");
    return wrong_usage("{}: there is no option {}; {}", verb.get_name(), name,
                       nearest.empty() ? how : "did you mean " + nearest + "?");
}

//! Refuses several ranks for verbs that would all do the same.
void require_shared_work(const CLI::App& verb, const Launch& launch) {
    const std::string& name = verb.get_name();
    if (launch.size == 1 || name == "run" || name == "sensitivity" ||
        name == "serve")
        return;
    throw wrong_usage(
        "{}: {} copies of this were started, which would all do the same work; "
        "start it without mpirun or srun (run, sensitivity and serve share "
        "their work between ranks)",
        name, launch.size);
}

ExitCode code_of(const std::exception& error) {
    const auto* own = dynamic_cast<const Error*>(&error);
    return own != nullptr ? own->exit_code() : ExitCode::runtime;
}

int run_verb(int argc, char** argv) {
    // A file beyond `ulimit -f` shall fail with a reason, not kill.
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App app(
        "Designs crop canopies: evolves plants that make the best use of "
        "light.\nExit codes: 0 ok, 1 failed, 2 wrong usage, 3 invalid "
        "campaign, 4 refused, 5 a run stopped early on request and can be "
        "resumed.",
        "ideotype");
    app.set_version_flag("--version", version_text);
    app.set_help_all_flag("--help-all", "print the help of all verbs");
    app.require_subcommand(1);
    const std::vector<std::string> words(argv, argv + argc);
    std::function<int()> action;
    declare_verbs(app, words, action);

    const Launch launch = launch_of_this_process();
    // Rank 0 alone tells what is wrong with a command line: a rank that ended
    // with a code before it would keep its words from being heard.
    const bool is_silent = launch.rank != 0;
    try {
        check_verb_name(app, argc > 1 ? argv[1] : "");
        if (argc > 1 && is_python_verb(argv[1])) {
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
        const auto* own = dynamic_cast<const Error*>(&error);
        if (is_silent && own && own->exit_code() == ExitCode::usage) return 0;
        return static_cast<int>(report_error(error));
    }
}

}  // namespace

ExitCode report_error(const std::exception& error) {
    fmt::print(stderr, "ideotype: {}\n", printable_lines(reason_of(error)));
    return code_of(error);
}

ExitCode report_error(const std::exception& error, const Log& log) {
    log.write(LogLevel::error, reason_of(error));
    return code_of(error);
}

int run_command_line(int argc, char** argv) {
    watch_for_foreign_end();
    const int code = run_verb(argc, argv);
    end_in_order();
    // Output may still be buffered, and of a part that was lost before only the
    // loss is known.
    errno = 0;
    if ((std::fflush(stdout) == 0 && std::ferror(stdout) == 0) || code != 0)
        return code;
    return static_cast<int>(report_error(Error(
        fmt::format("cannot write to the standard output: {}",
                    errno == 0 ? "a part is lost (is the disk full?)"
                               : std::generic_category().message(errno)))));
}

}  // namespace ideotype
