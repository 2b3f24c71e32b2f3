#include "ideotype/canopy/canopy.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/tolerance.hpp"

namespace ideotype {

namespace {

//! The part of a randomised day that a relative error of rounding may reach.
constexpr double balance_tolerance = 1e-9;

}  // namespace

Mesh build_plant(const CanopyModel& model,
                 const std::vector<LeafTraits>& traits) {
    return build_plant(traits, model.plant, model.tessellation);
}

Field build_field(const CanopyModel& model, const Mesh& plant,
                  const Draws& draws, std::uint32_t draw) {
    return build_field(
        plant, model.field,
        draw_plant_azimuths(model.field, draws.seed, draws.generation, draw));
}

Scene build_scene(const Device& device, const Field& field) {
    return field.boundary == Boundary::isolated
               ? Scene::isolated(device, field.mesh, field.ground_area)
               : Scene(device, field.mesh, field.period_x, field.period_y);
}

void for_each_field(const CanopyModel& model, const Mesh& plant,
                    const Draws& draws,
                    const std::function<void(const Field&, const Accuracy&,
                                             const Randomness&)>& visit) {
    const bool is_one = draws.fields == Draws::Fields::one;
    const int fields = is_one ? 1 : draws.sampling.randomisations;
    Accuracy sampling = draws.sampling;
    sampling.randomisations /= fields;
    for (std::uint32_t f = 0; f < static_cast<std::uint32_t>(fields); ++f)
        visit(build_field(model, plant, draws, f), sampling,
              {draws.seed, draws.generation, f});
}

Accuracy sunlit_sampling(const Accuracy& sampling) {
    return {std::min(sampling.paths, 2048), sampling.randomisations};
}

CanopyReport study(const CanopyModel& model, const Device& device,
                   const std::vector<LeafTraits>& traits, const Draws& draws,
                   Detail detail) {
    const Illumination& light = model.light.light;
    CanopyReport result;
    result.layers = model.layers;
    std::vector<Tally> tallies;
    SunlitFractions sunlit;
    const auto append = [](auto& all, auto more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    const auto trace = [&](const Field& field, Accuracy sampling,
                           const Randomness& randomness) {
        const Scene scene = build_scene(device, field);
        Simulation found =
            simulate_to_tolerance(scene, field.mesh.groups, model.optics, light,
                                  sampling, randomness, result.layers);
        append(tallies, std::move(found.tallies));
        sampling.paths = found.paths;
        result.paths += sampling.all_paths();
        result.is_capped |= found.is_capped;
        if (detail == Detail::full) {
            SunlitFractions found_sunlit =
                sunlit_fractions(scene, field.mesh, light,
                                 sunlit_sampling(sampling), randomness);
            append(sunlit.fractions, std::move(found_sunlit.fractions));
            sunlit.step = std::max(sunlit.step, found_sunlit.step);
        }
        result.groups = field.mesh.groups;
        result.boundary = field.boundary;
        result.ground_area = field.ground_area;
        result.lai = leaf_area(field.mesh) / result.ground_area;
    };
    for_each_field(model, build_plant(model, traits), draws, trace);
    for (const Tally& tally : tallies)
        result.leaves_by_randomisation.push_back(tally.leaves());
    result.light = report(tallies, model.light);
    if (detail == Detail::full) add_sunlit(result.light, sunlit, model.light);
    if (!(result.light.balance_error < balance_tolerance))
        throw Error(fmt::format("the energy balance is off by {:.3g}",
                                result.light.balance_error));
    return result;
}

}  // namespace ideotype
