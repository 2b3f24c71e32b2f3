// SPDX-License-Identifier: Apache-2.0
#include "problems.hpp"

#include <algorithm>
#include <tuple>

namespace ideotype {

void Problems::locate(const void* value, const Location& where) {
    places_[value] = where;
}

const Location& Problems::where(const void* value) const {
    return all_ ? *all_ : places_.at(value);
}

void Problems::add(const Location& where, const std::string& what) {
    problems_.push_back({where, what});
}

void Problems::spoil(const void* value) {
    unusable_.insert(value);
}

void Problems::add(const void* value, const std::string& what) {
    spoil(value);
    add(where(value), what);
}

bool Problems::usable(std::initializer_list<const void*> values) const {
    return std::none_of(values.begin(), values.end(), [&](const void* value) {
        return unusable_.count(value) != 0 ||
               (!all_ && places_.count(value) == 0);
    });
}

void Problems::add_once(const void* value, const std::string& kind,
                        const std::string& what) {
    spoil(value);
    if (once_.insert({where(value).file, kind}).second) add(where(value), what);
}

void Problems::warn(const void* value, const std::string& what) {
    warn(Problem{where(value), with_short_quotes(what)});
}

void Problems::open(const std::string& file) {
    files_.push_back(file);
}

std::vector<Problem> Problems::sorted(std::vector<Problem> problems) const {
    const auto position = [&](const Problem& problem) {
        const Location& where = problem.where;
        return std::tuple(std::find(files_.begin(), files_.end(), where.file),
                          where.line, where.column);
    };
    std::stable_sort(problems.begin(), problems.end(),
                     [&](const Problem& a, const Problem& b) {
                         return position(a) < position(b);
                     });
    return problems;
}

void Problems::throw_if_any() const {
    if (!problems_.empty()) throw InputError(sorted(problems_));
}

}  // namespace ideotype
