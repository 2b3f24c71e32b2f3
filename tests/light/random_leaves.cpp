// SPDX-License-Identifier: Apache-2.0
#include "random_leaves.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "ideotype/core/random.hpp"

namespace ideotype {

namespace {

using std::numbers::pi;

constexpr double side = 0.02;

//! Returns the share of leaves with normals within t [rad] of the vertical.
double share_within(LeafAngles angles, double t) {
    switch (angles) {
        case LeafAngles::spherical:
            return 1 - std::cos(t);
        case LeafAngles::planophile:
            return (2 * t + std::sin(2 * t)) / pi;
        case LeafAngles::erectophile:
            return (2 * t - std::sin(2 * t)) / pi;
        case LeafAngles::uniform:
            return 2 * t / pi;
        case LeafAngles::horizontal:
            return 1;
    }
    return 1;
}

double angle_of(LeafAngles angles, double share) {
    double lower = 0, upper = pi / 2;
    for (int i = 0; i < 50; ++i) {
        const double middle = (lower + upper) / 2;
        (share_within(angles, middle) < share ? lower : upper) = middle;
    }
    return angles == LeafAngles::horizontal ? 0 : (lower + upper) / 2;
}

}  // namespace

Mesh random_leaves(LeafAngles angles, double lai, double height,
                   std::uint64_t realisation) {
    const auto count =
        static_cast<std::uint32_t>(std::lround(lai / (side * side)));
    Mesh mesh;
    mesh.groups.push_back({"leaves"});
    RandomStream stream(realisation, Purpose::jitter);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double t = angle_of(angles, (i + .5) / count);
        // The azimuths are multiples of the golden ratio of a turn, so that any
        // subset of consecutive leaves is evenly distributed over the circle.
        const double a = 2 * pi * std::fmod(i * std::numbers::phi, 1.0);
        const double spin = stream.uniform(0, 2 * pi);
        const double margin = side;
        const glm::dvec3 centre{stream.uniform(), stream.uniform(),
                                stream.uniform(margin, height - margin)};
        const glm::dvec3 down{std::cos(t) * std::cos(a),
                              std::cos(t) * std::sin(a), -std::sin(t)};
        const glm::dvec3 level{-std::sin(a), std::cos(a), 0};
        for (int corner = 0; corner < 4; ++corner) {
            const double turn = spin + corner * pi / 2;
            const double r = side / std::numbers::sqrt2;
            const double u = r * std::cos(turn), v = r * std::sin(turn);
            mesh.vertices.push_back({centre.x + u * down.x + v * level.x,
                                     centre.y + u * down.y + v * level.y,
                                     centre.z + u * down.z + v * level.z});
        }
        mesh.faces.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
        mesh.face_group.push_back(0);
    }
    return mesh;
}

}  // namespace ideotype
