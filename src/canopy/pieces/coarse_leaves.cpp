// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "blades.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

using Face = std::array<std::uint32_t, 4>;

//! Divides faces into four of similar shape, at the middles of their edges.
class Divider {
  public:
    explicit Divider(Mesh& mesh) : mesh_(mesh) {}

    void add(const Face& face, std::size_t times) {
        if (times == 0) {
            mesh_.faces.push_back(face);
            return;
        }
        const auto [a, b, c, d] = face;
        const std::uint32_t ab = middle(a, b), bc = middle(b, c);
        if (c == d) {
            const std::uint32_t ca = middle(c, a);
            for (const Face& part : {Face{a, ab, ca, ca}, Face{ab, b, bc, bc},
                                     Face{ca, bc, c, c}, Face{ab, bc, ca, ca}})
                add(part, times - 1);
            return;
        }
        // A face is folded along the line from b to d, see face_areas(). The
        // two parts at the ends of this line contain the fold, the other two
        // are flat.
        const std::uint32_t cd = middle(c, d), da = middle(d, a);
        const std::uint32_t centre = middle(b, d);
        for (const Face& part :
             {Face{a, ab, centre, da}, Face{ab, b, bc, centre},
              Face{c, cd, centre, bc}, Face{cd, d, da, centre}})
            add(part, times - 1);
    }

  private:
    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
        const auto [found, is_new] =
            middles_.try_emplace(std::minmax(a, b), next);
        if (is_new)
            mesh_.vertices.push_back((mesh_.vertices[a] + mesh_.vertices[b]) /
                                     2.);
        return found->second;
    }

    Mesh& mesh_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

//! Returns, for each face to be subdivided, the number of faces of its blade; 0
//! for other faces.
std::vector<std::size_t> coarse_blades(const Mesh& mesh) {
    // The number of faces per leaf of built plants.
    constexpr std::size_t fine_enough = 24;
    // If each face is a group, all groups of one organ are combined.
    using Organ = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
    std::map<Organ, std::uint32_t> organs;
    Faces organ;
    for (const Group& group : mesh.groups) {
        const auto next = static_cast<std::uint32_t>(organs.size());
        const SurfaceId& id = group.id;
        organ.push_back(organs.try_emplace({id.organ, id.rank, id.part}, next)
                            .first->second);
    }
    Joined joined = joined_faces(mesh, organ);
    std::vector<std::size_t> count(mesh.faces.size()), result;
    for (std::uint32_t f = 0; f < count.size(); ++f) ++count[joined.first(f)];
    for (std::uint32_t f = 0; f < count.size(); ++f) {
        const std::size_t faces = count[joined.first(f)];
        result.push_back(is_cut(mesh, f) && faces < fine_enough ? faces : 0);
    }
    return result;
}

}  // namespace

Pieces cut_coarse_leaves(const Mesh& mesh, std::size_t copies, double tolerance,
                         std::size_t per_blade) {
    IDEOTYPE_EXPECT(copies > 0 && tolerance >= 0 && per_blade > 0);
    // A leaflet of 4 pieces assimilates 0.3 % too much, one of 64 pieces 0.06
    // %, and the error is negligible with 256 pieces. Scenes that would exceed
    // most_faces are divided less, because the extra accuracy is not worth the
    // time.
    constexpr double low_tolerance = 0.001;
    constexpr std::size_t most_faces = 1u << 17;
    const std::vector<std::size_t> blade = coarse_blades(mesh);
    std::vector<std::size_t> times;
    std::size_t wanted = per_blade;
    if (tolerance > 0 && tolerance <= low_tolerance) wanted *= 4;
    for (std::size_t all = most_faces + 1; all > most_faces; wanted /= 4) {
        times.assign(blade.size(), 0);
        all = 0;
        for (std::size_t f = 0; f < blade.size(); ++f) {
            if (blade[f] == 0) continue;
            while (2 * blade[f] << 2 * times[f] < wanted) ++times[f];
            if (times[f] > 0) all += copies << 2 * times[f];
        }
        if (all == 0) return cut_leaves(mesh, per_blade);
    }
    Mesh divided = mesh;
    divided.faces.clear();
    divided.face_group.clear();
    Divider divider(divided);
    for (std::size_t f = 0; f < times.size(); ++f) {
        divider.add(mesh.faces[f], times[f]);
        divided.face_group.resize(divided.faces.size(), mesh.face_group[f]);
        if (times[f] > 0)
            per_blade = std::max(per_blade, blade[f] << 2 * times[f]);
    }
    return cut_leaves(divided, per_blade);
}

}  // namespace ideotype
