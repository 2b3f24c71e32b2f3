// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/common.hpp>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

using Face = std::array<std::uint32_t, 4>;
using Faces = std::vector<std::uint32_t>;

//! Numbers that are joined to each other.
class Joined {
  public:
    explicit Joined(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t first(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = first(a);
        b = first(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

bool is_leaf(const Mesh& mesh, std::uint32_t face) {
    return mesh.groups[mesh.face_group[face]].id.is_leaf();
}

//! For each face of a leaf the first that it is joined to, by vertices at the
//! same place.
//! @param part by group: faces are joined only if it is the same
Joined joined_faces(const Mesh& mesh, const Faces& part) {
    // Corners by what they are of and where they are.
    using Corner =
        std::tuple<std::uint32_t, double, double, double, std::uint32_t>;
    std::vector<Corner> corners;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        if (!is_leaf(mesh, f)) continue;
        for (const std::uint32_t v : mesh.faces[f]) {
            const glm::dvec3& p = mesh.vertices[v];
            corners.emplace_back(part[mesh.face_group[f]], p.x, p.y, p.z, f);
        }
    }
    std::sort(corners.begin(), corners.end());
    const auto place = [](const Corner& c) {
        return std::tie(std::get<0>(c), std::get<1>(c), std::get<2>(c),
                        std::get<3>(c));
    };
    Joined joined(mesh.faces.size());
    for (std::size_t i = 1; i < corners.size(); ++i)
        if (place(corners[i - 1]) == place(corners[i]))
            joined.join(std::get<4>(corners[i - 1]), std::get<4>(corners[i]));
    return joined;
}

//! The faces of each blade, in the order of groups and first faces.
std::vector<Faces> blades(const Mesh& mesh) {
    Faces groups(mesh.groups.size());
    std::iota(groups.begin(), groups.end(), 0u);
    Joined joined = joined_faces(mesh, groups);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        if (is_leaf(mesh, f)) order.emplace_back(joined.first(f), f);
    std::sort(order.begin(), order.end());
    std::stable_sort(
        order.begin(), order.end(), [&](const auto& a, const auto& b) {
            return mesh.face_group[a.second] < mesh.face_group[b.second];
        });
    std::vector<Faces> result;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || order[i].first != order[i - 1].first)
            result.emplace_back();
        result.back().push_back(order[i].second);
    }
    return result;
}

//! Returns the length of the edges that a single face of a blade has [m].
double circumference(const Mesh& mesh, const Faces& blade) {
    using Place = std::array<double, 3>;
    std::vector<std::pair<Place, Place>> edges;
    for (const std::uint32_t f : blade) {
        const auto& face = mesh.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const glm::dvec3& a = mesh.vertices[face[i]];
            const glm::dvec3& b = mesh.vertices[face[(i + 1) % face.size()]];
            if (a == b) continue;
            const Place first{a.x, a.y, a.z}, second{b.x, b.y, b.z};
            edges.push_back(std::minmax(first, second));
        }
    }
    std::sort(edges.begin(), edges.end());
    double length = 0;
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        while (next < edges.size() && edges[next] == edges[i]) ++next;
        const auto& [a, b] = edges[i];
        if (next - i == 1)
            length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return length;
}

//! Divides faces into four of the same shape, at the middles of their edges.
class Divider {
  public:
    explicit Divider(Mesh& mesh) : mesh_(mesh) {}

    //! Adds the parts of a face to the mesh, divided so many times.
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
        // The fold is from b to d, see face_areas(): the parts at both its ends
        // keep it, the other two are flat.
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

//! The number of faces of the blade of each face that is to be divided, else 0.
std::vector<std::size_t> coarse_blades(const Mesh& mesh) {
    // Leaves of built plants have as many.
    constexpr std::size_t fine_enough = 24;
    // Groups of one organ are one where the light of each face is counted.
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
        result.push_back(is_leaf(mesh, f) && faces < fine_enough ? faces : 0);
    }
    return result;
}

class Cutter {
  public:
    explicit Cutter(const Mesh& mesh) : areas_(face_areas(mesh)) {
        result_.mesh = mesh;
        result_.mesh.groups.clear();
        IDEOTYPE_EXPECT(mesh.face_group.size() == mesh.faces.size());
        result_.uncut_groups = mesh.groups.size();
        centres_.reserve(mesh.faces.size());
        for (const auto& face : mesh.faces) {
            glm::dvec3 sum(0);
            for (const std::uint32_t v : face) sum += mesh.vertices[v];
            centres_.push_back(sum / 4.);
        }
    }

    //! Halves the faces until there are so many pieces.
    void cut(const Mesh& mesh, std::uint32_t* first, std::uint32_t* last,
             std::size_t pieces) {
        if (pieces < 2 || last - first < 2) return add(mesh, first, last);
        glm::dvec3 lower = centres_[*first], upper = lower;
        for (const std::uint32_t* f = first; f != last; ++f) {
            lower = glm::min(lower, centres_[*f]);
            upper = glm::max(upper, centres_[*f]);
        }
        const glm::dvec3 extent = upper - lower;
        int axis = extent.y > extent.x ? 1 : 0;
        if (extent.z > extent[axis]) axis = 2;
        std::sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(centres_[a][axis], a) <
                   std::pair(centres_[b][axis], b);
        });
        double whole = 0, part = 0;
        for (const std::uint32_t* f = first; f != last; ++f)
            whole += areas_[*f];
        const std::size_t left = pieces / 2;
        const double wanted =
            whole * static_cast<double>(left) / static_cast<double>(pieces);
        std::uint32_t* middle = first + 1;
        for (part = areas_[*first];
             middle != last - 1 && part + areas_[*middle] / 2 < wanted;
             ++middle)
            part += areas_[*middle];
        cut(mesh, first, middle, left);
        cut(mesh, middle, last, pieces - left);
    }

    //! Returns the pieces together with the groups that are no leaves.
    Pieces result(const Mesh& mesh) {
        result_.count = result_.group.size();
        result_.like.resize(result_.count);
        std::iota(result_.like.begin(), result_.like.end(), 0u);
        std::vector<std::uint32_t> place(mesh.groups.size(), none);
        for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
            if (is_leaf(mesh, f)) continue;
            std::uint32_t& group = place[mesh.face_group[f]];
            if (group == none) group = add_group(mesh, mesh.face_group[f]);
            result_.mesh.face_group[f] = group;
        }
        IDEOTYPE_ENSURE(result_.group.size() == result_.mesh.groups.size());
        return std::move(result_);
    }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::uint32_t add_group(const Mesh& mesh, std::uint32_t group) {
        result_.mesh.groups.push_back(mesh.groups[group]);
        result_.group.push_back(group);
        return static_cast<std::uint32_t>(result_.group.size() - 1);
    }

    void add(const Mesh& mesh, const std::uint32_t* first,
             const std::uint32_t* last) {
        double area = 0, moment = 0;
        const std::uint32_t piece = add_group(mesh, mesh.face_group[*first]);
        for (const std::uint32_t* f = first; f != last; ++f) {
            result_.mesh.face_group[*f] = piece;
            area += areas_[*f];
            moment += areas_[*f] * centres_[*f].z;
        }
        result_.area.push_back(area);
        result_.height.push_back(area > 0 ? moment / area : 0);
    }

    Pieces result_;
    std::vector<double> areas_;
    std::vector<glm::dvec3> centres_;
};

}  // namespace

Pieces cut_leaves(const Mesh& mesh, std::size_t per_blade) {
    IDEOTYPE_EXPECT(per_blade > 0);
    // Pieces of very fine meshes may be small too.
    constexpr std::size_t faces_of_piece = 16;
    Cutter cutter(mesh);
    for (Faces& blade : blades(mesh))
        cutter.cut(mesh, blade.data(), blade.data() + blade.size(),
                   std::max(per_blade, blade.size() / faces_of_piece));
    return cutter.result(mesh);
}

Pieces cut_coarse_leaves(const Mesh& mesh, std::size_t copies, double tolerance,
                         std::size_t per_blade) {
    IDEOTYPE_EXPECT(copies > 0 && tolerance >= 0 && per_blade > 0);
    // With 4 pieces a leaflet assimilates .3 % too much, with 64 .06 %, with
    // 256 next to nothing. More faces in all would take longer than they are
    // worth.
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

std::vector<double> blade_widths(const Mesh& mesh) {
    const std::vector<double> areas = face_areas(mesh);
    std::vector<double> widths(mesh.groups.size()), all(mesh.groups.size());
    for (const Faces& blade : blades(mesh)) {
        double area = 0;
        for (const std::uint32_t f : blade) area += areas[f];
        const double around = circumference(mesh, blade);
        const std::uint32_t group = mesh.face_group[blade.front()];
        widths[group] +=
            area *
            (around - std::sqrt(std::max(around * around - 16 * area, 0.))) / 4;
        all[group] += area;
    }
    for (std::size_t g = 0; g < widths.size(); ++g)
        widths[g] = all[g] > 0 ? widths[g] / all[g] : 0;
    return widths;
}

Pieces uncut(const Mesh& mesh) {
    Pieces pieces;
    pieces.mesh = mesh;
    pieces.uncut_groups = mesh.groups.size();
    for (std::uint32_t g = 0; g < mesh.groups.size(); ++g)
        pieces.group.push_back(g);
    return pieces;
}

}  // namespace ideotype
