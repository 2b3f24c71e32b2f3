// SPDX-License-Identifier: Apache-2.0
#include "weather_doubts.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ideotype {

void Doubts::count(int line, const std::string& text) {
    const auto found =
        std::find_if(doubts_.begin(), doubts_.end(),
                     [&](const Doubt& each) { return each.text == text; });
    if (found == doubts_.end())
        doubts_.push_back({text, line, 1});
    else
        ++found->count;
}

void Doubts::note(int line, const std::string& text) {
    doubts_.push_back({text, line, 0});
}

std::vector<Problem> Doubts::warnings() const {
    std::vector<Problem> all;
    for (const Doubt& doubt : doubts_)
        all.push_back(
            {{file_, doubt.line, doubt.line > 0 ? 1 : 0},
             doubt.count == 0
                 ? doubt.text
                 : fmt::format("{} ({} time{})", doubt.text, doubt.count,
                               doubt.count == 1 ? "" : "s")});
    return all;
}

}  // namespace ideotype
