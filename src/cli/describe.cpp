// SPDX-License-Identifier: Apache-2.0
#include "describe.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace ideotype {

namespace {

//! Of "TEXT:{a,b}" or "ENUM:value in {a->1,b->0} OR {1,0}" a and b.
std::vector<std::string> choices_of(const std::string& type) {
    std::vector<std::string> choices;
    const auto begin = type.find('{');
    if (begin == type.npos) return choices;
    const auto end = type.find('}', begin);
    for (const std::string& each :
         CLI::detail::split(type.substr(begin + 1, end - begin - 1), ','))
        choices.push_back(each.substr(0, each.find("->")));
    return choices;
}

std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* each : options) names.push_back(each->get_name());
    std::ranges::sort(names);  // not by addresses
    return names;
}

DescribedOption describe(const CLI::Option& option) {
    DescribedOption result;
    for (const std::string& name : option.get_snames())
        result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        result.names.push_back("--" + name);
    result.is_positional = result.names.empty();
    if (result.is_positional) result.names.push_back(option.get_name());
    result.about = option.get_description();
    std::ranges::replace(result.about, '\n', ' ');
    result.needs = names_of(option.get_needs());
    result.excludes = names_of(option.get_excludes());
    result.is_repeated =
        option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll &&
        option.get_expected_max() != 0;
    const std::string type = option.get_type_name();
    result.values = option.get_items_expected_max();
    if (result.values == 0) return result;
    result.value = type.substr(0, type.find(':'));
    result.choices = choices_of(type);
    if (!option.get_default_str().empty())
        result.about += " (" + option.get_default_str() + " if not given)";
    return result;
}

}  // namespace

std::vector<DescribedOption> describe_options(const CLI::App& verb) {
    std::vector<DescribedOption> options;
    for (const CLI::Option* each : verb.get_options())
        if (!each->get_group().empty()) options.push_back(describe(*each));
    return options;
}

void declare_describe(CLI::App& app) {
    app.add_option_function<std::string>(
           "--describe",
           [&app](const std::string& form) {
               throw CLI::CallForVersion(form == "man"    ? man_page(app)
                                         : form == "bash" ? bash_completion(app)
                                                          : zsh_completion(app),
                                         0);
           })
        ->check(CLI::IsMember({"man", "bash", "zsh"}))
        ->group("");
}

}  // namespace ideotype
