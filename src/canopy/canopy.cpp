// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/canopy.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "fields/field_light.hpp"
#include "ideotype/core/contract.hpp"

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

//! @param scene scene of the request, perhaps with other groups
CanopyReport evaluate(const CanopyRequest& request, const Scene& scene,
                      const Device& device, const Clock& clock) {
    const Evaluation evaluation{request, scene};
    auto [look, light] = first_field(evaluation, device, clock);
    for (int number = 1; number < evaluation.plan.fields; ++number)
        light.append(light_in_field(evaluation, look, number, device, clock));
    return report_on(evaluation, look, light);
}

}  // namespace

CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock) {
    IDEOTYPE_EXPECT(request.scene.cell.ground_area > 0);
    IDEOTYPE_EXPECT(request.layers.count > 0 && request.details.pieces > 0);
    if (!request.details.faces)
        return evaluate(request, request.scene, device, clock);
    return evaluate(request, with_a_group_per_face(request.scene), device,
                    clock);
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
    // Sobol' nets are most even at powers of two.
    const int paths = 1 << static_cast<int>(std::ceil(std::log2(enough)));
    IDEOTYPE_ENSURE(paths >= enough);
    return {std::max(accuracy.paths, paths), accuracy.randomisations, 0,
            accuracy.fields};
}

}  // namespace ideotype
