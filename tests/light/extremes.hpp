#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/plant/field.hpp"
#include "ideotype/plant/plant.hpp"
#include "reference.hpp"

namespace ideotype {

inline constexpr Period own_cell{0.76, 0.15};
inline const Optics par = leaf_optics(.05, .05, .1);

//! Traces and expects finite fractions that close the balance to rounding.
inline Fractions closing(const Mesh& mesh, Period period, const Optics& optics,
                         const Illumination& light,
                         Sampling sampling = {256, 4}) {
    const Fractions f = trace(mesh, period, optics, light, sampling);
    EXPECT_LT(f.balance_error, 1e-12);
    for (const Estimate& e : {f.leaves, f.soil, f.reflected}) {
        EXPECT_GE(e.mean, 0);
        EXPECT_TRUE(std::isfinite(e.mean));
        EXPECT_TRUE(std::isfinite(e.standard_error));
    }
    for (const Estimate& e : f.groups) EXPECT_TRUE(std::isfinite(e.mean));
    return f;
}

//! One group of leaves, still without faces.
inline Mesh leaves_only() {
    Mesh mesh;
    mesh.groups.push_back({"leaf", Tissue::leaf});
    return mesh;
}

//! A parallelogram from a corner along two edges.
inline void add_leaf(Mesh& mesh, Vec3 corner, Vec3 u, Vec3 v) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto& [x, y, z] = corner;
    mesh.vertices.insert(mesh.vertices.end(),
                         {corner,
                          {x + u.x, y + u.y, z + u.z},
                          {x + u.x + v.x, y + u.y + v.y, z + u.z + v.z},
                          {x + v.x, y + v.y, z + v.z}});
    mesh.faces.push_back({first, first + 1, first + 2, first + 3});
    mesh.face_group.push_back(0);
}

//! A plant of two leaves, the upper one across the row.
inline Mesh two_leaves(double length, double width, double inclination) {
    const PlantForm form{
        "plant",
        {{60, 0.2}, {40, 0.5}},
        {{0.28, 0.885870, 0.895017, 1.149943, 0.379696, 0.0}, 10, 1.5},
        {false, 2, 0.027}};
    return build_plant(
        {{length, width, inclination, 0}, {length, width, inclination, 90}},
        form, {});
}

}  // namespace ideotype
