// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/error.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace ideotype {

std::string to_string(const Problem& problem) {
    const Location& where = problem.where;
    if (where.line == 0) return fmt::format("{}: {}", where.file, problem.what);
    return fmt::format("{}:{}:{}: {}", where.file, where.line, where.column,
                       problem.what);
}

namespace {

std::string joined(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        if (!text.empty()) text += '\n';
        text += to_string(problem);
    }
    return text;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted =
                diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

}  // namespace

InputError::InputError(std::vector<Problem> problems)
    : Error(joined(problems), ExitCode::invalid_campaign),
      problems_(std::move(problems)) {}

std::string nearest_name(const std::string& word,
                         const std::vector<std::string>& candidates) {
    std::string nearest;
    // A suggestion that shares less than half of the letters only confuses.
    std::size_t least = word.size() / 2 + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string did_you_mean(const std::string& word,
                         const std::vector<std::string>& candidates) {
    const std::string nearest = nearest_name(word, candidates);
    if (!nearest.empty()) return "did you mean '" + nearest + "'?";
    std::string all;
    for (const std::string& each : candidates)
        all += (all.empty() ? "use one of " : ", ") + each;
    return all;
}

}  // namespace ideotype
