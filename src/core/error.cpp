// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/error.hpp"

#include <algorithm>
#include <new>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/text.hpp"

namespace ideotype {

std::string describe_exception(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) != nullptr
               ? "not enough memory"
               : error.what();
}

std::string to_string(const Problem& problem) {
    const Location& where = problem.where;
    IDEOTYPE_EXPECT(where.line >= 0 && where.column >= 0);
    if (where.line == 0) return fmt::format("{}: {}", where.file, problem.what);
    return fmt::format("{}:{}:{}: {}", where.file, where.line, where.column,
                       problem.what);
}

namespace {

std::string join(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        if (!text.empty()) text += '\n';
        text += to_string(problem);
    }
    return text;
}

//! Returns the Levenshtein distance, by dynamic programming over one row.
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

//! Sorts the words of each part of a name: "stalk.diameter_base" becomes
//! "stalk.base_diameter".
std::string sort_words(const std::string& name) {
    std::string result;
    std::vector<std::string> words(1);
    const auto end_part = [&] {
        std::ranges::sort(words);
        for (std::size_t i = 0; i < words.size(); ++i)
            result += (i == 0 ? "" : "_") + words[i];
        words.assign(1, "");
    };
    for (const char c : name) {
        if (c == '.')
            end_part(), result += c;
        else if (c == '_')
            words.emplace_back();
        else
            words.back() += c;
    }
    end_part();
    return result;
}

}  // namespace

std::string shorten_quotes(const std::string& message) {
    constexpr std::size_t longest = 80, cut = 60;
    if (message.size() <= longest) return message;
    std::string result;
    const auto add = [&](std::string_view part) {
        const std::string shown =
            part.size() > longest ? first_bytes(std::string(part), cut) : "";
        if (shown.empty())
            result += part;
        else
            result += fmt::format("{}... ({} bytes)", shown, part.size());
    };
    bool is_quote = false;
    for (std::string_view rest = message; !rest.empty();) {
        const std::size_t end = std::min(
            rest.find_first_of(is_quote ? "\"" : "\" \n"), rest.size());
        const std::string_view part = rest.substr(0, end);
        // Paths outside quotes are not shortened, so that users can copy them.
        if (is_quote || part.find('/') == part.npos)
            add(part);
        else
            result += part;
        if (end < rest.size()) result += rest[end];
        if (end < rest.size() && rest[end] == '"') is_quote = !is_quote;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return result;
}

namespace {

std::vector<Problem> shorten_all(std::vector<Problem> problems) {
    for (Problem& problem : problems)
        problem.what = shorten_quotes(problem.what);
    return problems;
}

}  // namespace

InputError::InputError(std::vector<Problem> problems)
    : Error(join(problems = shorten_all(std::move(problems))),
            ExitCode::invalid_campaign),
      problems_(std::move(problems)) {
    IDEOTYPE_EXPECT(!problems_.empty());
}

std::string nearest_name(const std::string& word,
                         const std::vector<std::string>& candidates) {
    std::string nearest;
    // A suggestion that shares less than half of its letters with the word
    // would confuse.
    std::size_t shortest = word.size() / 2 + 1;
    for (const std::string& candidate : candidates) {
        // Skip words that are much longer: they are too distant, and may be
        // megabytes long.
        if (word.size() >= candidate.size() + shortest) continue;
        // Words in another order count as one mistake.
        const std::size_t distance = std::min(
            edit_distance(word, candidate),
            edit_distance(sort_words(word), sort_words(candidate)) + 1);
        if (distance < shortest) {
            shortest = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string did_you_mean(const std::string& word,
                         const std::vector<std::string>& candidates) {
    const std::string nearest = nearest_name(word, candidates);
    if (!nearest.empty()) return "did you mean '" + nearest + "'?";
    std::string list;
    for (const std::string& candidate : candidates)
        list += (list.empty() ? "use one of " : ", ") + candidate;
    return list;
}

}  // namespace ideotype
