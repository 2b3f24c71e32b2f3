// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/canopy.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <numeric>
#include <optional>
#include <utility>

#include "fields/field_light.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

namespace {

Scene with_a_group_per_face(Scene scene) {
    const auto split = [](Mesh& mesh) {
        std::vector<Group> groups;
        groups.reserve(mesh.faces.size());
        for (const std::uint32_t group : mesh.face_group)
            groups.push_back(mesh.groups[group]);
        mesh.groups = std::move(groups);
        std::iota(mesh.face_group.begin(), mesh.face_group.end(), 0u);
    };
    for (Component& each : scene.components) split(each.mesh);
    for (FixedObject& each : scene.objects) split(each.mesh);
    scene.cell.row_ground.clear();
    return scene;
}

//! Computes the light in all fields after the first one [field, evaluation].
//! Several threads share the fields; each thread uses a separate device.
std::vector<std::vector<FieldLight>> light_in_others(
    const Evaluations& evaluations, const std::vector<FirstLook>& looks,
    const Device& device, const Clock& clock, int threads) {
    const int count = evaluations.front()->plan.fields - 1;
    std::vector<std::vector<FieldLight>> fields(
        static_cast<std::size_t>(count));
    std::atomic<int> next = 0;
    const auto work = [&](const Device& own) {
        for (int i = next++; i < count; i = next++)
            fields[static_cast<std::size_t>(i)] =
                light_in_field(evaluations, looks, i + 1, own, clock);
    };
    std::vector<std::future<void>> helpers;
    for (int i = 1; i < std::min(threads, count); ++i)
        helpers.push_back(std::async(std::launch::async,
                                     [&] { work(Device(device.isa())); }));
    work(device);
    for (std::future<void>& each : helpers) each.get();
    return fields;
}

}  // namespace

struct LitCanopy::Parts {
    explicit Parts(CanopyRequest of) : request(std::move(of)) {
        IDEOTYPE_EXPECT(request.scene.cell.ground_area > 0);
        IDEOTYPE_EXPECT(request.layers.count > 0 && request.details.pieces > 0);
    }

    CanopyRequest request;
    Scene split =
        request.details.faces ? with_a_group_per_face(request.scene) : Scene{};
    Evaluation evaluation{request,
                          request.details.faces ? split : request.scene};
    FirstLook look{};
    FieldLight light{};
};

LitCanopy::LitCanopy(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

LitCanopy::LitCanopy(CanopyRequest request, const Device& device,
                     const Clock& clock, int threads)
    : LitCanopy([&] {
          std::vector<CanopyRequest> requests;
          requests.push_back(std::move(request));
          return std::move(
              sharing_light(std::move(requests), device, clock, threads)
                  .front());
      }()) {}

std::vector<LitCanopy> LitCanopy::sharing_light(
    std::vector<CanopyRequest> requests, const Device& device,
    const Clock& clock, int threads) {
    IDEOTYPE_EXPECT(!requests.empty() && threads > 0);
    std::vector<LitCanopy> canopies;
    Evaluations evaluations;
    for (CanopyRequest& each : requests) {
        canopies.push_back(LitCanopy(std::make_unique<Parts>(std::move(each))));
        evaluations.push_back(&canopies.back().parts_->evaluation);
    }
    auto [looks, lights] = first_field(evaluations, device, clock);
    for (std::vector<FieldLight>& field :
         light_in_others(evaluations, looks, device, clock, threads))
        for (std::size_t i = 0; i < canopies.size(); ++i)
            lights[i].append(std::move(field[i]));
    for (std::size_t i = 0; i < canopies.size(); ++i) {
        Parts& parts = *canopies[i].parts_;
        parts.look = std::move(looks[i]);
        parts.light = std::move(lights[i]);
        for (ClosedStomata& each : parts.light.fluxes.closed)
            for (std::vector<double>& flux : each)
                for (double& x : flux) x /= parts.light.fields;
    }
    return canopies;
}

LitCanopy::LitCanopy(LitCanopy&&) noexcept = default;
LitCanopy::~LitCanopy() = default;

const Scene& LitCanopy::scene() const {
    return parts_->evaluation.scene;
}

const CanopyFluxes& LitCanopy::fluxes() const {
    return parts_->light.fluxes;
}

std::vector<std::vector<double>> LitCanopy::light_on_soil() const {
    const Bands& bands = scene().bands;
    const LightSeries& series = scene().light().series;
    const auto steps_of_dates = series.steps_of_dates();
    const std::size_t count = parts_->light.light.front().size();
    std::vector<std::vector<double>> shares(
        count, std::vector<double>(steps_of_dates.size()));
    std::vector<double> above(steps_of_dates.size());
    for (std::size_t b = 0; b < bands.size(); ++b) {
        const auto absorbed =
            absorbed_by_soil(parts_->light.light[b], bands[b].light);
        const double kept = 1 - bands[b].optics.soil_albedo;
        for (std::size_t d = 0; d < steps_of_dates.size(); ++d)
            for (const std::size_t i : steps_of_dates[d]) {
                const TimeStep& step = bands[b].light.series.steps[i];
                above[d] += step.seconds * (step.par.beam + step.par.diffuse);
                for (std::size_t r = 0; r < count && kept > 0; ++r)
                    shares[r][d] += step.seconds * absorbed[r][i] / kept;
            }
    }
    for (std::vector<double>& each : shares)
        for (std::size_t d = 0; d < each.size(); ++d)
            each[d] = above[d] > 0 ? each[d] / above[d] : 0;
    return shares;
}

void LitCanopy::close_stomata(const std::vector<Closure>& closures) {
    FieldLight& light = parts_->light;
    ideotype::close_stomata(
        closures, parts_->look.leaves,
        {light.leaf_area_index, light.leaf_area_of_layers, light.areas_of_rows},
        scene().light().series, light.fluxes);
}

CanopyReport LitCanopy::report() const {
    return report_on(parts_->evaluation, parts_->look, parts_->light);
}

CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock, int threads) {
    return LitCanopy(request, device, clock, threads).report();
}

LightWork find_work(const CanopyRequest& request, const Device& device) {
    return work_in_first_field({request, request.scene}, device);
}

RayScene build_scene(const Device& device, const Field& field, BoxTree tree) {
    const Cell& cell = field.cell;
    return cell.boundary == Boundary::isolated
               ? RayScene::isolated(device, field.mesh, cell.ground_area, tree)
               : RayScene(device, field.mesh, cell.period_x, cell.period_y,
                          tree);
}

Accuracy face_accuracy(const Accuracy& accuracy, std::size_t faces) {
    IDEOTYPE_EXPECT(faces > 0 && accuracy.randomisations > 0);
    constexpr int paths_per_face = 1600;
    constexpr double most_paths = 8e6;
    const double enough =
        std::min(paths_per_face * static_cast<double>(faces), most_paths) /
        accuracy.randomisations;
    // Sobol' nets are most uniform at powers of two.
    const int paths = 1 << static_cast<int>(std::ceil(std::log2(enough)));
    IDEOTYPE_ENSURE(paths >= enough);
    return {std::max(accuracy.paths, paths), accuracy.randomisations, 0,
            accuracy.fields};
}

}  // namespace ideotype
