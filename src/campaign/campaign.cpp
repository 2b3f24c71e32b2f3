// SPDX-License-Identifier: Apache-2.0
#include "campaign.hpp"

#include <array>
#include <cmath>

#include "campaign/checks/checks.hpp"
#include "campaign/weather_reader.hpp"
#include "ideotype/core/hash.hpp"
#include "spec/files.hpp"
#include "spec/reader.hpp"
#include "spec/varied_keys.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

//! Tries values of each varied key, and reports those that contradict other
//! keys. Also collects ranges and values that exclude the value from which a
//! search starts.
void try_ranges(const Spec& spec, const Problems& problems,
                BaselineDoubts& doubts) {
    const std::string table = spec.is_study ? "sensitivity" : "search";
    const std::vector<KeyFactor>& factors =
        spec.is_study ? spec.sensitivity.keys : spec.search.keys;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const KeyFactor& factor = factors[i];
        const bool has_range = factor.values.empty();
        const std::string own_key = has_range ? "range" : "values";
        const Problems key_problems = problems.in(table).in("keys", i);
        const auto [lower, upper] = bounds_of(factor);
        if (!spec.is_study && !factor.is_known)
            doubts.outside.push_back(key_problems.problem(
                own_key, ProblemCode::contradiction,
                fmt::format("search.keys: the values of {} do not include {} "
                            "(the value of this campaign, from which the "
                            "search starts); add it, or change the value",
                            factor.key, value_in(spec, factor.key))));
        else if (!spec.is_study &&
                 (factor.number < lower || factor.number > upper))
            doubts.outside.push_back(key_problems.problem(
                own_key, ProblemCode::contradiction,
                fmt::format("search.keys: {} is {} in this campaign (outside "
                            "the range {} .. {}, but the search starts from "
                            "this value); widen the range, or change the value",
                            factor.key, factor.number, lower, upper)));
        for (const double number : tried_numbers(factor)) {
            Spec varied = spec;
            set_keys(varied, {factor}, std::array{number});
            const Problems stand_problems(spec.name);
            check_variable(varied, stand_problems);
            try {
                stand_problems.throw_if_any();
            } catch (const InputError& error) {
                key_problems.add(own_key, ProblemCode::contradiction,
                                 "{}.keys: if {} is {}, then {}", table,
                                 factor.key, text_of(factor, number),
                                 error.problems().front().what);
                if (has_range) break;
            }
        }
    }
}

Campaign parse(const std::string& text, const std::string& file,
               TextSource source, const std::vector<std::string>& settings = {},
               bool is_study = false) {
    Problems problems;
    Spec spec = read_spec(text, file, source, settings, is_study, problems);
    if (!spec.passed_over.empty())
        problems.warn({Location{file}, "", ProblemCode::doubt,
                       passed_over_text(spec.passed_over)});
    read_weathers(file, source, spec, problems);
    read_meshes(file, spec, problems);
    complete_factors(spec);
    BaselineDoubts doubts = check_spec(spec, problems);
    if (problems.empty()) try_ranges(spec, problems, doubts);
    problems.throw_if_any();
    Campaign campaign = resolve(spec);
    check_paths(campaign, problems.in("light"));
    campaign.source = text;
    campaign.resolved = resolved_text(campaign.spec);
    campaign.sha256 = sha256(campaign.resolved);
    campaign.warnings = problems.warnings();
    campaign.outside_bounds = std::move(doubts.outside);
    campaign.wider_bounds = std::move(doubts.wider_bounds);
    return campaign;
}

}  // namespace

Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings) {
    return read_campaign_text(read_text(path), path, settings);
}

Campaign read_campaign_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& settings) {
    return parse(text, path, TextSource::file, settings);
}

Campaign read_study(const std::string& path,
                    const std::vector<std::string>& settings) {
    // Use one replicate by default: others would only repeat the study with
    // other random numbers.
    std::vector<std::string> with_replicates{"replicates=1"};
    with_replicates.insert(with_replicates.end(), settings.begin(),
                           settings.end());
    return parse(read_text(path), path, TextSource::file, with_replicates,
                 true);
}

Campaign parse_campaign(const std::string& text, const std::string& file,
                        const std::vector<std::string>& settings) {
    return parse(text, file, TextSource::resolved, settings);
}

Campaign parse_history_campaign(const std::string& text,
                                const std::string& file,
                                const std::vector<std::string>& settings) {
    return parse(text, file, TextSource::history, settings);
}

Crop read_crop(const std::string& path) {
    const std::string text = read_text(path);
    Problems problems;
    const auto crop = read_crop_spec(text, path, problems);
    if (!crop) return parse(text, path, TextSource::file).crop;
    check_plant(*crop, problems);
    problems.throw_if_any();
    Crop result = crop_of(*crop);
    result.rules = rule_names(*crop);
    return result;
}

void require_breedable(const Campaign& campaign) {
    if (!campaign.outside_bounds.empty())
        throw InputError(campaign.outside_bounds);
}

void require_crop(const Campaign& campaign, std::size_t component) {
    if (component > 0 && campaign.spec.components.at(component - 1).has_mesh())
        throw wrong_usage(
            "component \"{}\" has a mesh, not a crop; export it as .obj or "
            ".vtp",
            campaign.spec.components[component - 1].name);
}

std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component) {
    require_crop(campaign, component);
    CropSpec crop = component == 0
                        ? campaign.spec.plant.crop
                        : campaign.spec.components.at(component - 1).crop;
    crop.baseline = baseline;
    // A search may turn leaves beyond 0 to 360 deg, but files must not contain
    // such azimuths.
    for (Leaf& leaf : crop.baseline.leaves)
        if (leaf.azimuth < 0 || leaf.azimuth > 360)
            leaf.azimuth -= 360 * std::floor(leaf.azimuth / 360);
    return crop_file_text(crop);
}

}  // namespace ideotype
