#include "ideotype/light/sunlit.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "directions.hpp"
#include "ideotype/light/sampler.hpp"
#include "repeated_faces.hpp"
#include "travel.hpp"

namespace ideotype {

namespace {

//! A flat part of a leaf.
struct Triangle {
    glm::dvec3 corner, u, v;
    glm::dvec3 normal;  //!< unit length
    double area;        //!< [m2]
    bool is_repeated;   //!< of a face that is there already
};

//! All leaf surface, as the triangles that light meets, and points on it.
class LeafArea {
  public:
    explicit LeafArea(const Mesh& mesh) {
        const std::vector<bool> repeated = repeated_faces(mesh);
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
            if (mesh.groups[mesh.face_group[f]].tissue != Tissue::leaf)
                continue;
            const auto& [a, b, c, d] = mesh.faces[f];
            const auto& v = mesh.vertices;
            add(v[a], v[b], v[d], repeated[f]);
            add(v[c], v[d], v[b], repeated[f]);
        }
    }

    double total() const { return ends_.empty() ? 0 : ends_.back(); }

    struct Point {
        glm::dvec3 position, normal;
        bool is_repeated;
    };

    Point at(double share, double s, double t) const {
        const auto found =
            std::upper_bound(ends_.begin(), ends_.end() - 1, share * total());
        const Triangle& triangle =
            triangles_[static_cast<std::size_t>(found - ends_.begin())];
        if (s + t > 1) {
            s = 1 - s;
            t = 1 - t;
        }
        return {triangle.corner + s * triangle.u + t * triangle.v,
                triangle.normal, triangle.is_repeated};
    }

  private:
    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
             bool is_repeated) {
        const glm::dvec3 u = b - a, v = c - a;
        const glm::dvec3 n = glm::cross(u, v);
        const double twice = glm::length(n);
        if (!(twice > 0)) return;
        triangles_.push_back({a, u, v, n / twice, twice / 2, is_repeated});
        ends_.push_back(total() + twice / 2);
    }

    std::vector<Triangle> triangles_;
    std::vector<double> ends_;  //!< summed area up to and with each [m2]
};

//! The part of a point's leaf area that is not on another's.
double own_part(const Scene& scene, const LeafArea::Point& point) {
    if (point.position.z < 0 || point.is_repeated) return 0;
    return 1. / std::max(1, scene.faces_at(scene.placed(point.position)));
}

bool sees(const Scene& scene, const LeafArea::Point& point,
          const glm::dvec3& sun) {
    const glm::dvec3 n =
        glm::dot(point.normal, sun) < 0 ? -point.normal : point.normal;
    const glm::dvec3 from =
        scene.offset_origin(scene.placed(point.position), n);
    return travel(scene, from, sun).group == Hit::sky;
}

}  // namespace

SunlitFractions sunlit_fractions(const Scene& scene, const Mesh& mesh,
                                 const Illumination& illumination,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness) {
    const std::vector<Source>& sources = illumination.sources;
    const LeafArea leaves(mesh);
    const auto points = static_cast<std::uint32_t>(accuracy.paths);
    SunlitFractions result;
    result.fractions.assign(static_cast<std::size_t>(accuracy.randomisations),
                            std::vector<double>(sources.size()));
    if (!(leaves.total() > 0)) return result;
    result.step = 1. / points;
    auto randomisation = randomness.first_randomisation;
    for (std::vector<double>& fractions : result.fractions) {
        PathSampler sampler(randomness.seed, randomness.generation,
                            randomisation++, 0);
        for (std::uint32_t i = 0; i < points; ++i) {
            sampler.begin(i);
            const double share = sampler.next();
            const double s = sampler.next();
            const LeafArea::Point point = leaves.at(share, s, sampler.next());
            const double part = own_part(scene, point);
            for (std::size_t k = 0; k < sources.size(); ++k) {
                if (!sources[k].direction || part == 0) continue;
                const glm::dvec3 d = not_level(*sources[k].direction);
                if (sees(scene, point, -d)) fractions[k] += part * result.step;
            }
        }
    }
    return result;
}

}  // namespace ideotype
