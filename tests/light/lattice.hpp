// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

//! Returns the surfaces of copies of a plant on a lattice.
//! @param turns azimuths of the plants, row by row [deg]; empty: all 0
inline Mesh in_lattice(const Mesh& plant, const FieldForm& form,
                       const std::vector<double>& turns = {}) {
    Scene scene;
    for (const Place& place : places_of(form)) {
        const std::size_t p = scene.components.size();
        const double turn = turns.empty() ? 0 : turns.at(p) * degree;
        Component one;
        one.mesh = plant;
        for (glm::dvec3& v : one.mesh.vertices)
            v = {v.x * std::cos(turn) + v.y * std::sin(turn),
                 v.y * std::cos(turn) - v.x * std::sin(turn), v.z};
        one.places = {place};
        scene.components.push_back(std::move(one));
    }
    Mesh mesh = draw_field(scene, {}).mesh;
    for (std::uint32_t& group : mesh.face_group)
        group %= static_cast<std::uint32_t>(plant.groups.size());
    mesh.groups = plant.groups;
    return mesh;
}

}  // namespace ideotype
