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

//! Computes the light in all fields after the first one. Several threads share
//! the fields; each thread uses a separate device.
std::vector<FieldLight> light_in_others(const Evaluation& evaluation,
                                        const FirstLook& look,
                                        const Device& device,
                                        const Clock& clock, int threads) {
    const int count = evaluation.plan.fields - 1;
    std::vector<FieldLight> fields(static_cast<std::size_t>(count));
    std::atomic<int> next = 0;
    const auto work = [&](const Device& own) {
        for (int i = next++; i < count; i = next++)
            fields[static_cast<std::size_t>(i)] =
                light_in_field(evaluation, look, i + 1, own, clock);
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

CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock, int threads) {
    IDEOTYPE_EXPECT(request.scene.cell.ground_area > 0);
    IDEOTYPE_EXPECT(request.layers.count > 0 && request.details.pieces > 0);
    IDEOTYPE_EXPECT(threads > 0);
    std::optional<Scene> split;
    if (request.details.faces) split = with_a_group_per_face(request.scene);
    const Evaluation evaluation{request, split ? *split : request.scene};
    auto [look, light] = first_field(evaluation, device, clock);
    for (FieldLight& each :
         light_in_others(evaluation, look, device, clock, threads))
        light.append(std::move(each));
    return report_on(evaluation, look, light);
}

RayScene build_scene(const Device& device, const Field& field) {
    const Cell& cell = field.cell;
    return cell.boundary == Boundary::isolated
               ? RayScene::isolated(device, field.mesh, cell.ground_area)
               : RayScene(device, field.mesh, cell.period_x, cell.period_y);
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
