// SPDX-License-Identifier: Apache-2.0
// What shells complete, as scripts of their own languages. Values that are none
// of a few words are completed as paths.
#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "describe.hpp"

namespace ideotype {

namespace {

std::vector<std::string> verb_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands({}))
        names.push_back(verb->get_name());
    return names;
}

std::string join(const std::vector<std::string>& words,
                 std::string_view separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

//! Cases of what may follow an option with a value, then that of all options.
std::string bash_cases(const std::string& verb, const CLI::App& options,
                       std::vector<std::string> words) {
    std::string cases;
    std::vector<std::string> paths;
    for (const DescribedOption& each : describe_options(options)) {
        if (each.is_positional) continue;
        words.insert(words.end(), each.names.begin(), each.names.end());
        if (each.values == 0) continue;
        for (const std::string& name : each.names)
            if (each.choices.empty())
                paths.push_back(fmt::format("'{} {}'", verb, name));
            else
                cases += fmt::format("    '{} {}') words='{}' ;;\n", verb, name,
                                     join(each.choices, " "));
    }
    if (!paths.empty())
        cases += fmt::format("    {}) ;;\n", join(paths, " | \\\n        "));
    return cases + fmt::format("    '{} '*) {}words='{}' ;;\n", verb,
                               verb.empty() ? "" : "[[ $word != -* ]] || ",
                               join(words, " "));
}

//! Text within '...[text]' of _arguments.
std::string zsh_text(const std::string& text) {
    std::string result;
    for (const char each : text) {
        if (each == '[' || each == ']' || each == ':' || each == '\\')
            result += '\\';
        result += each == '\'' ? "'\\''" : std::string(1, each);
    }
    return result;
}

std::string zsh_argument(const DescribedOption& option) {
    if (option.is_positional)
        return fmt::format(" '{}:{}:_files'", option.values > 1 ? "*" : "",
                           option.names.front());
    const std::string value =
        option.choices.empty()
            ? ":value:_files"
            : fmt::format(":value:({})", join(option.choices, " "));
    std::string values;
    for (int i = 0; i < std::min(option.values, 4); ++i) values += value;
    std::string text;
    for (const std::string& name : option.names)
        text += fmt::format(" '{}{}[{}]{}'", option.is_repeated ? "*" : "",
                            name, zsh_text(option.about), values);
    return text;
}

std::string zsh_arguments(const CLI::App& verb) {
    std::string text;
    for (const DescribedOption& each : describe_options(verb))
        text += zsh_argument(each);
    return text;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
    std::string cases;
    for (const CLI::App* verb : app.get_subcommands({}))
        cases += bash_cases(verb->get_name(), *verb, {});
    cases += bash_cases("", app, verb_names(app));
    return fmt::format(
        "# Completion of ideotype for bash, made by ideotype --describe bash.\n"
        "_ideotype() {{\n"
        "    local word=${{COMP_WORDS[COMP_CWORD]}} verb='' words=''\n"
        "    [ \"$COMP_CWORD\" -lt 2 ] || verb=${{COMP_WORDS[1]}}\n"
        "    case \"$verb ${{COMP_WORDS[COMP_CWORD - 1]}}\" in\n"
        "{}    esac\n"
        "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
        "}}\n"
        "complete -o default -F _ideotype ideotype",
        cases);
}

std::string zsh_completion(const CLI::App& app) {
    std::string verbs, cases;
    for (const CLI::App* verb : app.get_subcommands({})) {
        verbs += fmt::format("        '{}:{}'\n", verb->get_name(),
                             zsh_text(verb->get_description()));
        cases += fmt::format("    {}) _arguments{} ;;\n", verb->get_name(),
                             zsh_arguments(*verb));
    }
    return fmt::format(
        "#compdef ideotype\n"
        "# Completion of ideotype for zsh, made by ideotype --describe zsh.\n"
        "local -a verbs=(\n{}    )\n"
        "if ((CURRENT == 2)); then\n"
        "    _describe verb verbs\n"
        "    _arguments{}\n"
        "    return\n"
        "fi\n"
        "shift words\n"
        "((CURRENT--))\n"
        "case $words[1] in\n{}esac",
        verbs, zsh_arguments(app), cases);
}

}  // namespace ideotype
