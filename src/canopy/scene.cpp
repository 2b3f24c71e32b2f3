// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/scene.hpp"

#include <algorithm>

#include "ideotype/core/contract.hpp"

namespace ideotype {

bool Scene::assimilates() const {
    return std::ranges::any_of(components, [](const Component& each) {
        return each.photosynthesis.has_value();
    });
}

bool Scene::has_living_organs() const {
    return std::ranges::any_of(components, [](const Component& each) {
        return each.photosynthesis && each.plant &&
               std::ranges::any_of(
                   list_organs(*each.plant), [](const PlantOrgan& organ) {
                       return organ.is_present && organ.tissue.is_living();
                   });
    });
}

std::vector<Group> groups_of(const Scene& scene, std::span<const Mesh> lines) {
    IDEOTYPE_EXPECT(lines.empty() || lines.size() == scene.components.size());
    std::vector<Group> groups;
    std::uint32_t number = 0;
    const auto add = [&](const Mesh& mesh, bool is_object) {
        for (Group group : mesh.groups) {
            group.id.component = number;
            if (is_object) group.id.organ = SurfaceId::object;
            groups.push_back(std::move(group));
        }
        ++number;
    };
    for (std::size_t c = 0; c < scene.components.size(); ++c)
        add(lines.empty() ? scene.components[c].mesh : lines[c], false);
    for (const FixedObject& each : scene.objects) add(each.mesh, true);
    return groups;
}

void set_plant(Component& component, const Plant& plant, std::uint32_t first) {
    component.mesh = build_plant(plant, component.tessellation);
    for (Group& group : component.mesh.groups) group.material += first;
    component.plant = plant;
}

}  // namespace ideotype
