// SPDX-License-Identifier: Apache-2.0
#include "repeated_faces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

std::uint64_t mixed(std::uint64_t x) {
    // The mixing function is that of Steele et al. 2014,
    // doi:10.1145/2660193.2660195.
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

std::uint64_t hash_of(const glm::dvec3& v) {
    // Adding zero makes positive and negative zero equal.
    const auto bits = [](double x) {
        return std::bit_cast<std::uint64_t>(x + 0.0);
    };
    return mixed(bits(v.x) + 3 * bits(v.y) + 5 * mixed(bits(v.z)));
}

using Corners = std::array<std::array<double, 3>, 4>;

Corners sorted_corners(const Mesh& mesh, std::size_t face) {
    Corners corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3& v = mesh.vertices[mesh.faces[face][i]];
        corners[i] = {v.x, v.y, v.z};
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

}  // namespace

std::vector<bool> repeated_faces(const Mesh& mesh) {
    const std::vector<std::uint64_t> hashes = mapped(mesh.vertices, hash_of);

    // A hash table of the first face of each set of corners, indexed by the sum
    // of the corners' hashes.
    constexpr std::uint32_t none = ~std::uint32_t{0};
    const std::size_t places = std::bit_ceil(2 * mesh.faces.size() + 1);
    std::vector<std::uint32_t> table(places, none);
    const bool moves = std::ranges::any_of(
        mesh.groups, [](const auto& group) { return group.pose > 0; });
    std::vector<std::uint64_t> sums(mesh.faces.size());
    std::vector<bool> repeated(mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        for (const std::uint32_t v : mesh.faces[f]) sums[f] += hashes[v];
        // Faces of different orientations do not repeat each other.
        if (moves) sums[f] += mixed(mesh.groups.at(mesh.face_group[f]).pose);
        std::size_t place = sums[f] & (places - 1);
        for (; table[place] != none; place = (place + 1) & (places - 1))
            if (sums[table[place]] == sums[f] &&
                sorted_corners(mesh, table[place]) == sorted_corners(mesh, f))
                break;
        repeated[f] = table[place] != none;
        if (!repeated[f]) table[place] = f;
    }
    return repeated;
}

}  // namespace ideotype
