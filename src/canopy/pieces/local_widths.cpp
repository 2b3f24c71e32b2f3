// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "blades.hpp"
#include "ideotype/canopy/pieces.hpp"

namespace ideotype {

namespace {

//! The width of a blade as a function of the distance from one of its ends
//! along edges.
class WidthProfile {
  public:
    WidthProfile(const Mesh& mesh, const Faces& blade,
                 const std::vector<double>& areas)
        : mesh_(mesh) {
        for (const std::uint32_t f : blade) add_edges(f);
        // The vertex farthest from any other vertex is an end of the blade.
        const std::vector<double> first = distances_from(0);
        from_end_ = distances_from(static_cast<std::size_t>(
            std::max_element(first.begin(), first.end()) - first.begin()));
        length_ = *std::max_element(from_end_.begin(), from_end_.end());
        if (!(length_ > 0)) return;
        for (const std::uint32_t f : blade)
            for_each_section(f, [&](std::size_t section, double share) {
                widths_[section] += share * areas[f] * sections / length_;
            });
    }

    //! Returns the mean width of the blade at a face [m].
    double at(std::uint32_t face) const {
        double width = 0;
        if (length_ > 0)
            for_each_section(face, [&](std::size_t section, double share) {
                width += share * widths_[section];
            });
        return width;
    }

  private:
    using Place = std::array<double, 3>;
    static constexpr std::size_t sections = 64;

    static Place place_of(const glm::dvec3& at) { return {at.x, at.y, at.z}; }

    void add_edges(std::uint32_t f) {
        const auto& face = mesh_.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const glm::dvec3& a = mesh_.vertices[face[i]];
            const glm::dvec3& b = mesh_.vertices[face[(i + 1) % face.size()]];
            const std::size_t from = number_of(a), to = number_of(b);
            const double length = glm::distance(a, b);
            edges_[from].emplace_back(to, length);
            edges_[to].emplace_back(from, length);
        }
    }

    std::size_t number_of(const glm::dvec3& at) {
        const auto [found, is_new] =
            numbers_.emplace(place_of(at), edges_.size());
        if (is_new) edges_.emplace_back();
        return found->second;
    }

    //! Returns the lengths of shortest paths along edges (Dijkstra 1959,
    //! doi:10.1007/BF01386390).
    std::vector<double> distances_from(std::size_t start) const {
        using Step = std::pair<double, std::size_t>;
        std::vector<double> found(edges_.size(),
                                  std::numeric_limits<double>::infinity());
        std::priority_queue<Step, std::vector<Step>, std::greater<>> next;
        next.emplace(found[start] = 0, start);
        while (!next.empty()) {
            const auto [far, vertex] = next.top();
            next.pop();
            if (far > found[vertex]) continue;
            for (const auto& [to, length] : edges_[vertex])
                if (far + length < found[to])
                    next.emplace(found[to] = far + length, to);
        }
        return found;
    }

    //! Calls a function with each section that a face overlaps and the share of
    //! the face in that section.
    template <class Take>
    void for_each_section(std::uint32_t f, Take take) const {
        double first = length_, last = 0;
        for (const std::uint32_t v : mesh_.faces[f]) {
            const double far =
                from_end_[numbers_.at(place_of(mesh_.vertices[v]))];
            first = std::min(first, far);
            last = std::max(last, far);
        }
        const double scale = sections / length_;
        const auto end =
            std::min(static_cast<std::size_t>(last * scale) + 1, sections);
        for (auto i = std::min(static_cast<std::size_t>(first * scale),
                               sections - 1);
             i < end; ++i) {
            const double from = static_cast<double>(i) / scale;
            const double covered =
                std::min(last, from + 1 / scale) - std::max(first, from);
            take(i, last > first ? std::max(covered, 0.) / (last - first) : 1);
        }
    }

    const Mesh& mesh_;
    std::map<Place, std::size_t> numbers_;  //!< vertex indices by position
    //! Neighbours of each vertex, and their distances [m].
    std::vector<std::vector<std::pair<std::size_t, double>>> edges_;
    std::vector<double> from_end_;  //!< distances of vertices from one end [m]
    double length_ = 0;             //!< length of the blade [m]
    std::array<double, sections> widths_{};  //!< widths by section [m]
};

}  // namespace

std::vector<double> local_widths(const Pieces& pieces) {
    Mesh uncut = pieces.mesh;
    uncut.groups.assign(pieces.uncut_groups, {});
    for (std::size_t g = 0; g < pieces.group.size(); ++g)
        uncut.groups[pieces.group[g]] = pieces.mesh.groups[g];
    for (std::uint32_t& group : uncut.face_group) group = pieces.group[group];
    const std::vector<double> areas = face_areas(uncut);
    std::vector<double> widths(pieces.count);
    for (const Faces& blade : blades(uncut)) {
        const WidthProfile profile(uncut, blade, areas);
        for (const std::uint32_t f : blade) {
            const std::uint32_t v = pieces.mesh.face_group[f];
            widths[v] += areas[f] / pieces.area[v] * profile.at(f);
        }
    }
    return widths;
}

}  // namespace ideotype
