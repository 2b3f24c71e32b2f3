// SPDX-License-Identifier: Apache-2.0
#include "ideotype/fidelity/choice.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/hash.hpp"
#include "ideotype/run/progress.hpp"
#include "ideotype/stand/stand.hpp"

namespace ideotype {

namespace {

//! Fewer than four randomisations would leave the reported standard errors
//! unknown themselves.
constexpr std::array randomisations{4, 8, 16, 32, 64};
constexpr int most_paths = 1 << 17;

double squared(double x) {
    return x * x;
}

//! What is left out, and thus wrong, differs from plant to plant: only what
//! is computed less finely may be chosen.
bool may_turn(const MeasuredParameter& each) {
    return each.parameter.kind == Parameter::Kind::fineness;
}

int paths_of(const MeasuredParameter& paths, std::size_t value) {
    return paths.parameter.at(value).campaign.sampling.paths;
}

//! Standard deviation of a randomisation as a power of its paths, by least
//! squares of logarithms.
class PathLaw {
  public:
    PathLaw(const MeasuredParameter& paths, Goal goal) {
        double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (std::size_t v = 0; v < paths.points.size(); ++v) {
            const double deviation = paths.points[v].of(goal).scatter.path.mean;
            if (!(deviation > 0)) continue;
            const double x = std::log(paths_of(paths, v));
            const double y = std::log(deviation);
            n += 1;
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
        }
        if (n < 2) return;
        slope_ = (n * sxy - sx * sy) / (n * sxx - sx * sx);
        factor_ = std::exp((sy - slope_ * sx) / n);
    }

    double at(int paths) const { return factor_ * std::pow(paths, slope_); }

  private:
    double factor_ = 0;
    double slope_ = -0.5;
};

//! One field and one randomisation of a model.
struct Model {
    Estimate bias;
    double field_variance = 0;
    double path_ratio = 1;  //!< of the variance, to that of the campaign's own
    Cost cost;
};

double ratio(double a, double b) {
    return b > 0 ? a / b : 1;
}

//! Of variances. Where it may as well be 1 it is: the best of many
//! combinations would else be the one whose scatter was underestimated most.
double path_ratio(Estimate a, Estimate b) {
    const double error = std::hypot(a.standard_error, b.standard_error);
    if (std::abs(a.mean - b.mean) < 3 * error) return 1;
    return squared(ratio(a.mean, b.mean));
}

Model model_of(const Trade& trade, const std::vector<std::size_t>& values,
               Goal goal) {
    const MeasuredParameter& paths = trade.parameter("paths");
    const MeasuredParameter& cell = trade.parameter("cell");
    Model model;
    model.cost = paths.own().cost;
    double bias_variance = 0;
    for (std::size_t k = 0; k < trade.parameters.size(); ++k) {
        const MeasuredParameter& each = trade.parameters[k];
        if (each.parameter.kind == Parameter::Kind::paths) continue;
        const ParameterPoint& point = each.points[values[k]];
        const ParameterPoint& own = each.own();
        const Inaccuracy& inaccuracy = point.of(goal);
        model.bias.mean += std::abs(inaccuracy.bias.mean);
        bias_variance += squared(inaccuracy.bias.standard_error);
        model.path_ratio *=
            path_ratio(inaccuracy.scatter.path, own.of(goal).scatter.path);
        model.cost.geometry *= ratio(point.cost.geometry, own.cost.geometry);
        model.cost.scene *= ratio(point.cost.scene, own.cost.scene);
        model.cost.path *= ratio(point.cost.path, own.cost.path);
        // What is not known of it counts against it, as with biases.
        if (&each == &cell)
            model.field_variance =
                squared(inaccuracy.scatter.field.mean) +
                squared(inaccuracy.scatter.field.standard_error);
    }
    model.bias.standard_error = std::sqrt(bias_variance);
    return model;
}

//! Of the most paths that were measured and are not more than these.
Estimate bias_of_paths(const MeasuredParameter& paths, int most, Goal goal) {
    if (!paths.parameter.may_be_biased()) return {};
    std::size_t found = 0;
    for (std::size_t v = 1; v < paths.points.size(); ++v)
        if (paths_of(paths, v) <= most) found = v;
    return paths.points[found].of(goal).bias;
}

Combination sampled(const Model& model, const PathLaw& law,
                    const Accuracy& accuracy, Randomness::Fields fields,
                    const Estimate& bias_of_paths) {
    Combination result;
    result.accuracy = accuracy;
    result.fields = fields;
    result.bias = {
        model.bias.mean + std::abs(bias_of_paths.mean),
        std::hypot(model.bias.standard_error, bias_of_paths.standard_error)};
    const int n = accuracy.randomisations;
    const int drawn = fields == Randomness::Fields::each ? n : 1;
    result.standard_error =
        std::sqrt(model.field_variance / drawn +
                  model.path_ratio * squared(law.at(accuracy.paths)) / n);
    result.cost = {drawn * model.cost.geometry, drawn * model.cost.scene,
                   model.cost.path * n * accuracy.paths,
                   1.0 * n * accuracy.paths};
    return result;
}

//! Counts through the values of all parameters that change the model.
bool advance(const Trade& trade, std::vector<std::size_t>& values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!may_turn(trade.parameters[k])) continue;
        if (++values[k] < trade.parameters[k].points.size()) return true;
        values[k] = 0;
    }
    return false;
}

}  // namespace

double Combination::error() const {
    return std::hypot(bias.mean, bias.standard_error, standard_error);
}

Combination combine(const Trade& trade, const std::vector<std::size_t>& values,
                    const Accuracy& accuracy, Randomness::Fields fields,
                    Goal goal) {
    const MeasuredParameter& paths = trade.parameter("paths");
    Combination result =
        sampled(model_of(trade, values, goal), PathLaw(paths, goal), accuracy,
                fields, bias_of_paths(paths, accuracy.paths, goal));
    result.values = values;
    return result;
}

std::vector<Combination> pareto_front(const Trade& trade, Goal goal,
                                      Randomness::Fields fields) {
    const MeasuredParameter& of_paths = trade.parameter("paths");
    const PathLaw law(of_paths, goal);
    std::vector<std::size_t> values;
    for (const MeasuredParameter& each : trade.parameters)
        values.push_back(may_turn(each) ? 0 : each.parameter.own);
    std::vector<Combination> all;
    do {
        const Model model = model_of(trade, values, goal);
        for (int paths = static_cast<int>(
                 std::bit_ceil(static_cast<unsigned>(paths_of(of_paths, 0))));
             paths <= most_paths; paths *= 2) {
            const Estimate bias = bias_of_paths(of_paths, paths, goal);
            for (const int n : randomisations) {
                Combination next =
                    sampled(model, law, {paths, n}, fields, bias);
                next.values = values;
                all.push_back(std::move(next));
            }
        }
    } while (advance(trade, values));
    std::stable_sort(all.begin(), all.end(),
                     [](const Combination& a, const Combination& b) {
                         return a.seconds() < b.seconds();
                     });
    std::vector<Combination> front;
    for (Combination& each : all)
        if (front.empty() || each.error() < front.back().error())
            front.push_back(std::move(each));
    // Nobody wants a worse one.
    constexpr double worst = 0.05;
    const auto good = std::find_if(
        front.begin(), front.end() - 1,
        [](const Combination& each) { return each.error() <= worst; });
    front.erase(front.begin(), good);
    return front;
}

const Combination& cheapest(const std::vector<Combination>& front,
                            double tolerance) {
    return *std::find_if(
        front.begin(), front.end() - 1,
        [=](const Combination& each) { return each.error() <= tolerance; });
}

Campaign applied(const Trade& trade, const Combination& combination) {
    Variant variant = trade.own;
    for (std::size_t k = 0; k < trade.parameters.size(); ++k)
        if (may_turn(trade.parameters[k]))
            trade.parameters[k].parameter.values[combination.values[k]].apply(
                variant);
    variant.campaign.sampling = combination.accuracy;
    variant.campaign.first_tolerance = 0;
    return variant.campaign;
}

std::vector<PastedKey> keys_of(const Campaign& campaign) {
    const auto number = [](auto x) { return fmt::format("{}", x); };
    const auto list = [](const std::vector<std::string>& names) {
        return names.empty()
                   ? "[]"
                   : fmt::format("[\"{}\"]", fmt::join(names, "\", \""));
    };
    const Optics& optics = campaign.optics;
    std::vector<PastedKey> keys{
        campaign.climates.empty()
            ? PastedKey{"[day]", "step_minutes",
                        number(campaign.days[0].value.step_minutes)}
            : PastedKey{"light", "dates", number(campaign.sun_dates)},
        {"field", "rows", number(campaign.field.rows)},
        {"field", "plants", number(campaign.field.plants)},
        {"plant", "organs", list(organ_names(campaign.crop.baseline))},
        {"plant", "cells_along", number(campaign.tessellation.cells_along)},
        {"plant", "stalk_sides", number(campaign.tessellation.stalk_sides)},
        {"optics", "leaf_reflectance", number(optics.leaf.reflectance)},
        {"optics", "leaf_transmittance", number(optics.leaf.transmittance)},
        {"optics", "stalk_reflectance", number(optics.stalk.reflectance)},
        {"optics", "stalk_transmittance", number(optics.stalk.transmittance)},
        {"optics", "sheath_reflectance", number(optics.sheath.reflectance)},
        {"optics", "sheath_transmittance", number(optics.sheath.transmittance)},
        {"optics", "soil_albedo", number(optics.soil_albedo)},
        {"light", "paths", number(campaign.sampling.paths)},
        {"light", "randomisations", number(campaign.sampling.randomisations)},
        {"light", "tolerance", number(campaign.sampling.tolerance)},
        {"light", "first_tolerance", number(campaign.first_tolerance)}};
    // The only other sky that a parameter sets.
    if (campaign.sky_model == SkyModel::uniform)
        keys.push_back({"light", "sky", "\"uniform\""});
    return keys;
}

Check check_combination(const Trade& trade, const Combination& combination,
                        Goal goal, const Device& device, double budget) {
    CanopyRequest request = request_of({applied(trade, combination)},
                                       trade.case_index, trade.rivals[0]);
    request.randomness.seed = derive_seed(request.randomness.seed, "check");
    request.randomness.fields = combination.fields;
    const Crop& crop = trade.own.campaign.crop;
    constexpr std::size_t least = 8, most = 64;
    std::vector<double> found, seconds;
    const double until = now() + budget;
    while (found.size() < least || (found.size() < most && now() < until)) {
        request.randomness.generation =
            static_cast<std::uint32_t>(found.size());
        const auto objective = [&](const Genome& genome) {
            request.stand = grow(crop, genome);
            const CanopyReport report =
                evaluate(request, device, processor_seconds);
            seconds.push_back(report.seconds.total());
            return measure_objective(aims(trade.own.campaign).front().quantity,
                                     report)
                .estimate.mean;
        };
        const double value = objective(trade.rivals[0]);
        found.push_back(
            goal == Goal::value ? value : objective(trade.rivals[1]) - value);
    }
    const Estimate& truth =
        goal == Goal::value ? trade.value : trade.difference;
    const double scale = 1 / std::abs(trade.value.mean);
    const auto n = static_cast<double>(found.size());
    const Estimate mean = estimate(found);
    const double deviation = mean.standard_error * std::sqrt(n);
    return {{scale * (mean.mean - truth.mean),
             scale * std::hypot(mean.standard_error, truth.standard_error)},
            {scale * deviation, scale * deviation / std::sqrt(2 * (n - 1))},
            median(seconds)};
}

}  // namespace ideotype
