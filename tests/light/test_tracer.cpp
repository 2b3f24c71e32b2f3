// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "expectations.hpp"

namespace ideotype {
namespace {

//! The destinations of photons, as shares of all photons.
struct Ends {
    double leaf = 0, other_leaf = 0, soil = 0, sky = 0;
};

//! Follows single photons by a loop over all triangles and their images in
//! neighbouring cells; each photon ends entirely in one place. A slow reference
//! for simulate(), with random numbers of another kind.
class PlainTracer {
  public:
    PlainTracer(const Mesh& mesh, const Optics& optics, double period)
        : mesh_(mesh), optics_(optics), period_(period) {}

    Ends follow(const glm::dvec3& direction, int photons, std::uint64_t seed) {
        random_.seed(seed);
        ends_ = {};
        for (int i = 0; i < photons; ++i)
            follow(
                {period_ * uniform_(random_), period_ * uniform_(random_), top},
                direction);
        for (double* part :
             {&ends_.leaf, &ends_.other_leaf, &ends_.soil, &ends_.sky})
            *part /= photons;
        return ends_;
    }

  private:
    static constexpr double top = 2;  //!< above all leaves [m]

    struct Met {
        double distance = std::numeric_limits<double>::infinity();
        std::size_t face = 0;
        glm::dvec3 normal{0, 0, 1};  //!< normal of the adaxial side
    };

    void follow(glm::dvec3 at, glm::dvec3 direction) {
        for (;;) {
            const Met met = meet(at, direction);
            const double vertical =
                ((direction.z > 0 ? top : 0) - at.z) / direction.z;
            const double edge = std::min(to_edge(at.x, direction.x),
                                         to_edge(at.y, direction.y));
            if (edge < std::min(met.distance, vertical)) {
                at = wrapped(at + edge * direction);
            } else if (vertical < met.distance) {
                if (direction.z > 0) {
                    ends_.sky += 1;
                    return;
                }
                if (uniform_(random_) >= optics_.soil_albedo) {
                    ends_.soil += 1;
                    return;
                }
                at = at + vertical * direction;
                direction = lambertian({0, 0, 1});
            } else {
                const std::uint32_t group = mesh_.face_group[met.face];
                const bool is_adaxial = glm::dot(direction, met.normal) < 0;
                const glm::dvec3 back = is_adaxial ? met.normal : -met.normal;
                const Lambertian& face =
                    optics_.of(mesh_.groups[group].material).face(is_adaxial);
                const double chance = uniform_(random_);
                if (chance >= face.scattered()) {
                    (group == 0 ? ends_.leaf : ends_.other_leaf) += 1;
                    return;
                }
                at = at + met.distance * direction;
                direction =
                    lambertian(chance < face.reflectance ? back : -back);
            }
        }
    }

    //! Returns the nearest face that a ray hits in this cell.
    Met meet(const glm::dvec3& at, const glm::dvec3& direction) const {
        Met nearest;
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
            for (const auto& [i, j, k] :
                 {std::array{0, 1, 3}, std::array{2, 3, 1}})
                for (int x = -1; x <= 1; ++x)
                    for (int y = -1; y <= 1; ++y) {
                        const glm::dvec3 shift{x * period_, y * period_, 0};
                        const auto corner = [&](int c) {
                            return mesh_.vertices[mesh_.faces[f][static_cast<
                                       std::size_t>(c)]] +
                                   shift;
                        };
                        const glm::dvec3 a = corner(i), b = corner(j) - a,
                                         c = corner(k) - a;
                        const double distance =
                            distance_to(at - a, direction, b, c);
                        if (distance < nearest.distance)
                            nearest = {distance, f,
                                       glm::normalize(glm::cross(b, c))};
                    }
        return nearest;
    }

    //! Returns the distance along a ray to a triangle, given by its edges b and
    //! c from a first corner at the origin.
    static double distance_to(const glm::dvec3& from,
                              const glm::dvec3& direction, const glm::dvec3& b,
                              const glm::dvec3& c) {
        constexpr double never = std::numeric_limits<double>::infinity();
        const glm::dvec3 normal = glm::cross(b, c);
        const double along = glm::dot(direction, normal);
        if (along == 0) return never;
        const double distance = -glm::dot(from, normal) / along;
        if (!(distance > 1e-9)) return never;
        const glm::dvec3 point = from + distance * direction;
        const double square = glm::dot(normal, normal);
        const double u = glm::dot(glm::cross(point, c), normal) / square;
        const double v = glm::dot(glm::cross(b, point), normal) / square;
        return u >= 0 && v >= 0 && u + v <= 1 ? distance : never;
    }

    //! Returns the distance along a ray to the side of the cell.
    double to_edge(double at, double direction) const {
        if (direction == 0) return std::numeric_limits<double>::infinity();
        return ((direction > 0 ? period_ : 0) - at) / direction + 1e-12;
    }

    glm::dvec3 wrapped(glm::dvec3 at) const {
        at.x -= period_ * std::floor(at.x / period_);
        at.y -= period_ * std::floor(at.y / period_);
        return at;
    }

    //! Returns a direction with a density proportional to the cosine to the
    //! normal: towards a random point of the unit sphere around the tip of the
    //! normal.
    glm::dvec3 lambertian(const glm::dvec3& normal) {
        for (;;) {
            const glm::dvec3 in_cube{2 * uniform_(random_) - 1,
                                     2 * uniform_(random_) - 1,
                                     2 * uniform_(random_) - 1};
            const double length = glm::length(in_cube);
            if (length > 1 || length < 1e-3) continue;
            const glm::dvec3 sum = normal + in_cube / length;
            if (glm::length(sum) > 1e-6) return glm::normalize(sum);
        }
    }

    const Mesh& mesh_;
    const Optics& optics_;
    double period_;
    std::mt19937_64 random_;
    std::uniform_real_distribution<> uniform_;
    Ends ends_;
};

//! Makes inclined leaves that extend beyond the cell and shade each other.
Mesh leaning_leaves() {
    Mesh mesh;
    mesh.groups = {{"leaf01", {0, 0, 1}}, {"leaf02", {0, 0, 2}, 1}};
    for (std::uint32_t i = 0; i < 5; ++i) {
        const double turn = 1.3 * i, rise = .25 * i - .4;
        const glm::dvec3 along{.7 * std::cos(turn), .7 * std::sin(turn), rise};
        const glm::dvec3 across{-.2 * std::sin(turn), .2 * std::cos(turn), .05};
        const glm::dvec3 base{.2 * i, .9 - .17 * i, .5 + .1 * i};
        for (const glm::dvec3& corner : {base - across, base - across + along,
                                         base + across + along, base + across})
            mesh.vertices.push_back(corner);
        mesh.faces.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
        mesh.face_group.push_back(i % 2);
    }
    return mesh;
}

TEST(Tracer, AgreesWithPhotonsThatAreFollowedOneByOne) {
    const Mesh mesh = leaning_leaves();
    Optics optics;
    optics.materials = {{.35, .2, .25}, {.5, .4, .1}};
    optics.soil_albedo = .3;
    const glm::dvec3 direction = glm::normalize(glm::dvec3{.5, -.3, -1});
    PlainTracer plain(mesh, optics, 1);
    constexpr int batches = 20, photons = 4000;
    std::array<std::vector<double>, 4> counted, traced;
    for (int b = 0; b < batches; ++b) {
        const Ends ends = plain.follow(direction, photons, 35 + b);
        counted[0].push_back(ends.leaf);
        counted[1].push_back(ends.other_leaf);
        counted[2].push_back(ends.soil);
        counted[3].push_back(ends.sky);
    }
    const RayScene scene(widest_device(), mesh, 1, 1);
    for (const Tally& tally :
         simulate(scene, mesh.groups, optics, {{{direction, 1, {}}}},
                  {1 << 14, 16}, {})) {
        traced[0].push_back(tally.groups[0]);
        traced[1].push_back(tally.groups[1]);
        traced[2].push_back(tally.budget().soil);
        traced[3].push_back(tally.budget().reflected);
    }
    for (std::size_t part = 0; part < 4; ++part) {
        SCOPED_TRACE(part);
        const Estimate a = estimate(counted[part]), b = estimate(traced[part]);
        EXPECT_GT(a.mean, .02);
        EXPECT_LT(a.standard_error, .003);
        EXPECT_LT(b.standard_error, .001);
        EXPECT_NEAR(b.mean, a.mean,
                    4 * std::hypot(a.standard_error, b.standard_error));
    }
}

}  // namespace
}  // namespace ideotype
