// SPDX-License-Identifier: Apache-2.0
#include "weather_problems.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ideotype {

void Problems::add(int line, int column, std::string what) {
    constexpr std::size_t most = 20;
    if (problems_.size() < most)
        problems_.push_back({{file_, line, column}, std::move(what)});
    else
        ++left_out_;
}

void Problems::stop_if_any() const {
    if (problems_.empty()) return;
    std::vector<Problem> all = problems_;
    if (left_out_ > 0)
        all.push_back({{file_}, fmt::format("{} more problems", left_out_)});
    throw InputError(std::move(all));
}

void Problems::stop(int line, int column, std::string what) {
    add(line, column, std::move(what));
    stop_if_any();
    throw std::logic_error("a problem that was added is not there");
}

std::optional<std::size_t> column_index(const Layout& layout,
                                        const std::string& name,
                                        Problems& problems) {
    const auto& header = layout.header;
    const auto is_it = [&](const CsvField& each) { return each.text == name; };
    const auto found = std::find_if(header.begin(), header.end(), is_it);
    const int line = static_cast<int>(layout.header_line);
    if (found == header.end()) {
        std::vector<std::string> names;
        for (const CsvField& each : header) names.emplace_back(each.text);
        const std::string near = nearest_name(name, names);
        problems.add(
            line, 1,
            fmt::format("there is no column \"{}\"{}", name,
                        near.empty() ? "" : "; is it \"" + near + "\"?"));
        return std::nullopt;
    }
    if (std::find_if(found + 1, header.end(), is_it) != header.end())
        problems.add(line, found->column,
                     fmt::format("two columns have the name \"{}\"; rename one "
                                 "of them",
                                 name));
    return static_cast<std::size_t>(found - header.begin());
}

CsvField entry(const std::vector<CsvField>& fields, std::size_t index) {
    if (index < fields.size()) return fields[index];
    return {{}, fields.back().column};
}

}  // namespace ideotype
