// SPDX-License-Identifier: Apache-2.0
#include "light_cue.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ideotype/core/contract.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! Densities of the stands with which light is compared, relative to the
//! reference.
constexpr std::array relative_densities{2 / 3., 3 / 2.};

//! Smallest decrease of ln(L) from the sparse to the dense stand that is taken
//! as competition.
constexpr double least_decrease = 0.02;

//! Standard deviation of the logarithm of density between fields (E).
constexpr double usual_deviation = 0.5;

//! Densities are at most this many times the reference, or its inverse.
constexpr double largest_density = 3;

const Plant& line_of(const Campaign& campaign, std::size_t component) {
    return component == 0 ? campaign.crop.baseline
                          : campaign.components.at(component - 1).crop.baseline;
}

//! Number of young leaves: the highest visible leaves.
constexpr std::ptrdiff_t young_count = 4;

//! Returns for each leaf of a crop, the lowest first, whether it is young.
std::vector<bool> young_leaves(const Growth& growth, double age) {
    const std::vector<LeafDates> dates = leaf_dates(growth);
    const auto visible = std::ranges::count_if(
        dates, [&](const LeafDates& x) { return visible_share(x, age) > 0; });
    std::vector<bool> young(dates.size());
    std::fill(
        young.begin() + std::max<std::ptrdiff_t>(0, visible - young_count),
        young.begin() + visible, true);
    return young;
}

//! Returns ln(L) of a component's young leaves with an upper bound of its
//! standard error; nothing if there are none.
std::optional<Estimate> light_on_young(const Growth& growth, double age,
                                       std::size_t number, const Scene& scene,
                                       const CanopyReport& report) {
    const std::vector<bool> young = young_leaves(growth, age);
    const Component& component = scene.components.at(number);
    const auto is_young = [&](const Group& group) {
        return group.id.is_leaf() && group.id.rank > 0 &&
               young.at(group.id.rank - 1);
    };
    const std::vector<double> areas = face_areas(component.mesh);
    double area = 0;
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (is_young(component.mesh.groups[component.mesh.face_group[f]]))
            area += areas[f] / component.ground_per_plant;
    const DayReport& light = report.par().light;
    Estimate absorbed;
    for (std::size_t g = 0; g < light.groups.size(); ++g)
        if (report.groups[g].id.component == number &&
            is_young(report.groups[g]))
            absorbed = {
                absorbed.mean + light.groups[g].mean,
                absorbed.standard_error + light.groups[g].standard_error};
    if (!(area > 0) || !(absorbed.mean > 0)) return std::nullopt;
    return Estimate{std::log(absorbed.mean / (area * light.day.incident)),
                    absorbed.standard_error / absorbed.mean};
}

//! Returns a campaign in which a component grows alone, with PAR only.
Campaign alone(const Campaign& campaign, std::size_t component) {
    Campaign one = campaign;
    if (component > 0) one.crop = campaign.components.at(component - 1).crop;
    one.components.clear();
    one.spec.components.clear();
    one.spec.panels.clear();
    one.spec.objects.clear();
    one.spec.feasibility = {};
    one.spec.field.row_pattern.clear();
    one.spec.field.boundary = Boundary::periodic;
    one.photosynthesis.reset();
    one.water.reset();
    one.follows = {true};
    return one;
}

//! The sampling with which light is compared: the same for all candidates.
Sampling sampling_of_comparison(const Case& in) {
    constexpr int paths = 4096, fields = 8;
    return {{paths, fields, 0, fields}, {in.seed}};
}

}  // namespace

LightCue::LightCue(const Campaign& campaign, const std::vector<Case>& cases)
    : campaign_(campaign), cases_(cases) {
    if (!cases.front().stage) return;
    for (std::size_t c = 0; c <= campaign.components.size(); ++c) {
        const Plasticity& plasticity = line_of(campaign, c).plasticity;
        if (growth_of(campaign, c) && plasticity.cue == Cue::light &&
            plasticity.reference > 0)
            components_.push_back(c);
    }
}

void LightCue::prepare(const Device& device,
                       const std::vector<std::size_t>& lights) {
    if (!comparisons_.empty()) return;
    for (std::size_t number = 0; number < cases_.size(); ++number) {
        if (!lights.empty() && lights[number] < number) {
            comparisons_.push_back(comparisons_[lights[number]]);
            continue;
        }
        const Case& each = cases_[number];
        std::vector<Comparison>& comparisons = comparisons_.emplace_back();
        for (const std::size_t c : components_) {
            const Campaign one = alone(campaign_in(campaign_, each), c);
            const Plasticity& plasticity = one.crop.baseline.plasticity;
            Plant rigid = one.crop.baseline;
            rigid.plasticity = {};
            Case in = each;
            in.stage->ages = {each.stage->ages[c]};
            in.stage->ages_before = {each.stage->ages_before[c]};
            in.stage->ear_shares.clear();
            in.stage->share = 1;
            std::array<double, 2> logs{};
            bool is_known = true;
            for (std::size_t i = 0; i < logs.size(); ++i) {
                in.spacing.row = plasticity.rows;
                in.spacing.plant = 1 / (plasticity.rows * plasticity.reference *
                                        relative_densities[i]);
                const CanopyRequest request =
                    request_of(sampling_of_comparison(in), one, in,
                               scene_of(one, in), {rigid});
                const auto light =
                    light_on_young(*one.crop.growth, in.stage->ages[0], 0,
                                   request.scene, evaluate(request, device));
                is_known = is_known && light;
                logs[i] = light.value_or(Estimate{}).mean;
            }
            comparisons.push_back(is_known ? Comparison(logs) : std::nullopt);
        }
    }
}

void LightCue::Response::set_plants(std::size_t number, const Plants& plants,
                                    Scene& scene) {
    const Case& in = cue_.cases_.at(number);
    for (const std::size_t c : cue_.components_) {
        const Campaign& campaign = campaign_in(cue_.campaign_, in);
        const Plant& line =
            c < plants.size() ? plants[c] : line_of(campaign, c);
        std::vector<double>& densities = densities_[c];
        if (in.stage->number == 0 || densities.empty())
            densities.assign(line.leaves.size(), line.plasticity.reference);
        set_grown_plant(campaign, in, c, respond(line, densities),
                        scene.components.at(c));
    }
}

void LightCue::Response::observe(std::size_t number, const Scene& scene,
                                 const CanopyReport& report) {
    const Case& in = cue_.cases_.at(number);
    const Campaign& campaign = campaign_in(cue_.campaign_, in);
    for (std::size_t i = 0; i < cue_.components_.size(); ++i) {
        const std::size_t c = cue_.components_[i];
        const Growth& growth = *growth_of(campaign, c);
        const double age = in.stage->ages[c];
        const Comparison& compared = cue_.comparisons_.at(number)[i];
        const auto light = light_on_young(growth, age, c, scene, report);
        if (!light || !compared) continue;
        const auto [sparse, dense] = *compared;
        if (sparse - dense < least_decrease) continue;
        // The density of a stand with the same light on young leaves. An
        // uncertain one counts less: densities of fields have a standard
        // deviation of ln(D) of `usual_deviation` before any light is known.
        const double from = std::log(relative_densities[0]),
                     to = std::log(relative_densities[1]),
                     per_light = (to - from) / (dense - sparse);
        const double found =
            std::clamp(from + (light->mean - sparse) * per_light,
                       -std::log(largest_density), std::log(largest_density));
        const double error = light->standard_error * per_light;
        const double weight =
            1 / (1 + error * error / (usual_deviation * usual_deviation));
        std::vector<double>& densities = densities_.at(c);
        const double reference = line_of(campaign, c).plasticity.reference;
        const double before = std::log(densities.back() / reference);
        const double density =
            reference * std::exp(std::lerp(before, found, weight));
        // Leaves that are full-grown by now no longer respond.
        const std::vector<LeafDates> dates = leaf_dates(growth);
        const std::size_t below = dates.size() - densities.size();
        for (std::size_t leaf = 0; leaf < densities.size(); ++leaf)
            if (dates[below + leaf].collar > age) densities[leaf] = density;
    }
}

}  // namespace ideotype
