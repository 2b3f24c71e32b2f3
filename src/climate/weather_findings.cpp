// SPDX-License-Identifier: Apache-2.0
#include "weather_findings.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ideotype {

void Findings::add(int line, int column, std::string what) {
    constexpr std::size_t most = 20;
    if (problems_.size() < most)
        problems_.push_back({{file_, line, column}, std::move(what)});
    else
        ++left_out_;
}

void Findings::stop_if_any() const {
    if (problems_.empty()) return;
    std::vector<Problem> all = problems_;
    if (left_out_ > 0)
        all.push_back({{file_}, fmt::format("{} more problems", left_out_)});
    throw InputError(std::move(all));
}

void Findings::stop(int line, int column, std::string what) {
    add(line, column, std::move(what));
    stop_if_any();
    throw std::logic_error("a problem that was added is not there");
}

void Findings::doubt(int line, const std::string& text) {
    for (Doubt& each : doubts_)
        if (each.text == text) {
            ++each.count;
            return;
        }
    doubts_.push_back({text, line, 1});
}

void Findings::note(int line, const std::string& text) {
    doubts_.push_back({text, line, 0});
}

std::vector<Problem> Findings::warnings() const {
    std::vector<Problem> all;
    for (const auto& [text, line, count] : doubts_) {
        const std::string times =
            count == 0
                ? ""
                : fmt::format(" ({} time{})", count, count == 1 ? "" : "s");
        all.push_back({{file_, line, line > 0 ? 1 : 0}, text + times});
    }
    return all;
}

}  // namespace ideotype
