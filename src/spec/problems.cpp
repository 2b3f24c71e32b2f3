// SPDX-License-Identifier: Apache-2.0
#include "problems.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace ideotype {

std::string lower_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

struct Problems::Collected {
    std::vector<std::string> files;
    std::optional<Location> everywhere;
    KeyNaming naming = nullptr;
    std::map<std::string, Location> places;
    std::set<std::string> unusable;
    std::set<std::pair<std::string, std::string>> once;
    std::vector<Problem> problems, warnings;
    std::set<std::string> passed_over;
};

Problems::Problems() : all_(std::make_shared<Collected>()) {}

Problems::Problems(const std::string& file) : Problems() {
    all_->everywhere = Location{file};
}

Problems::Problems(KeyNaming naming) : Problems(std::string()) {
    all_->naming = naming;
}

std::optional<std::string> Problems::name_of(const std::string& key) const {
    if (!all_->naming) return std::nullopt;
    const std::string path = prefix_ + key;
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string name = all_->naming(path.substr(0, dot));
    if (dot == path.size()) return name;
    return name + ": " + path.substr(dot + 1);
}

Problems Problems::in(const std::string& table) const {
    Problems part = *this;
    part.prefix_ += table + '.';
    return part;
}

Problems Problems::in(const std::string& table, std::size_t entry) const {
    return in(fmt::format("{}[{}]", table, entry));
}

void Problems::locate(const std::string& key, const Location& where) const {
    all_->places[prefix_ + key] = where;
}

const Location& Problems::where(const std::string& key) const {
    return all_->everywhere ? *all_->everywhere
                            : all_->places.at(prefix_ + key);
}

void Problems::spoil(const std::string& key) const {
    all_->unusable.insert(prefix_ + key);
}

bool Problems::usable(const Keys& keys) const {
    return std::ranges::all_of(keys, [&](const std::string& key) {
        const std::string path = prefix_ + key;
        return !all_->unusable.contains(path) &&
               (all_->everywhere || all_->places.contains(path));
    });
}

bool Problems::empty() const {
    return all_->problems.empty();
}

std::string Problems::written(const std::string& key) const {
    std::string path;
    bool is_number = false;
    for (const char c : prefix_ + key) {
        if (c == '[') is_number = true;
        if (!is_number) path += c;
        if (c == ']') is_number = false;
    }
    return path;
}

Problem Problems::problem(const std::string& key, ProblemCode code,
                          const std::string& what) const {
    return {where(key), written(key), code, what};
}

Problem Problems::named_by(const std::string& key, Problem problem) const {
    problem.key = written(key);
    return problem;
}

void Problems::add(const Problem& problem) const {
    all_->problems.push_back(problem);
}

void Problems::add_once(const std::string& key, const std::string& kind,
                        ProblemCode code, const std::string& text) const {
    spoil(key);
    if (all_->once.insert({where(key).file, kind}).second)
        add(problem(key, code, text));
}

void Problems::rule(const Keys& keys, const std::function<std::string()>& fault,
                    ProblemCode code) const {
    const std::string what = usable(keys) ? fault() : "";
    if (!what.empty()) add(keys.front(), code, "{}", what);
}

void Problems::warn(Problem warning) const {
    warning.what = shorten_quotes(warning.what);
    all_->warnings.push_back(std::move(warning));
}

void Problems::pass_over(const std::string& key) const {
    all_->passed_over.insert(key);
}

const std::set<std::string>& Problems::passed_over() const {
    return all_->passed_over;
}

void Problems::open(const std::string& file) const {
    all_->files.push_back(file);
}

std::vector<Problem> Problems::warnings() const {
    return sorted(all_->warnings);
}

std::vector<Problem> Problems::sorted(std::vector<Problem> problems) const {
    const auto position = [&](const Problem& problem) {
        const Location& where = problem.where;
        return std::tuple(std::ranges::find(all_->files, where.file),
                          where.line, where.column);
    };
    std::ranges::stable_sort(problems, {}, position);
    return problems;
}

void Problems::throw_if_any() const {
    if (!empty()) throw InputError(sorted(all_->problems));
}

void Problems::throw_wrong_usage() const {
    if (empty()) return;
    std::string message;
    for (const Problem& each : all_->problems)
        message += (message.empty() ? "" : "\n") + each.what;
    throw Error(shorten_quotes(message), ExitCode::usage);
}

}  // namespace ideotype
