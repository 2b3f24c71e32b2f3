#include "verb_name.hpp"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

void check_verb_name(const CLI::App& app, const std::string& word) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app.get_subcommands({}))
        verbs.push_back(verb->get_name());
    if (word.empty() || word.starts_with('-') ||
        std::ranges::find(verbs, word) != verbs.end())
        return;
    const std::string nearest = nearest_name(word, verbs);
    throw Error(
        fmt::format("there is no command '{}'; {}", word,
                    nearest.empty()
                        ? fmt::format("use one of {}", fmt::join(verbs, ", "))
                        : "did you mean '" + nearest + "'?"),
        ExitCode::usage);
}

}  // namespace ideotype
