// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/pieces.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/common.hpp>

#include "blades.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

Joined joined_faces(const Mesh& mesh, const Faces& part) {
    // A vertex identified by its surface and its position.
    using Corner =
        std::tuple<std::uint32_t, double, double, double, std::uint32_t>;
    std::vector<Corner> corners;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        if (!is_cut(mesh, f)) continue;
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

std::vector<Faces> blades(const Mesh& mesh) {
    Faces groups(mesh.groups.size());
    std::iota(groups.begin(), groups.end(), 0u);
    Joined joined = joined_faces(mesh, groups);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        if (is_cut(mesh, f)) order.emplace_back(joined.first(f), f);
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

namespace {

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

    //! Halves the faces until the number of pieces is reached.
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

    //! Returns the pieces, followed by the groups of other organs.
    Pieces result(const Mesh& mesh) {
        result_.count = result_.group.size();
        result_.like.resize(result_.count);
        std::iota(result_.like.begin(), result_.like.end(), 0u);
        std::vector<std::uint32_t> place(mesh.groups.size(), none);
        for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
            if (is_cut(mesh, f)) continue;
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
    // Blades of very fine meshes get more pieces, with this number of faces
    // each.
    constexpr std::size_t faces_of_piece = 16;
    // Organs assimilate little, so a few pieces per organ are sufficient.
    constexpr std::size_t faces_of_organ_piece = 4;
    Cutter cutter(mesh);
    for (Faces& part : blades(mesh)) {
        const bool is_leaf =
            mesh.groups[mesh.face_group[part.front()]].id.is_leaf();
        cutter.cut(mesh, part.data(), part.data() + part.size(),
                   is_leaf ? std::max(per_blade, part.size() / faces_of_piece)
                           : part.size() / faces_of_organ_piece);
    }
    return cutter.result(mesh);
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
