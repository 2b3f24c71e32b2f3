// SPDX-License-Identifier: Apache-2.0
#include "depth_buffer.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/wide_vectors.hpp"

namespace ideotype {

namespace {

constexpr std::size_t batch = 64;

//! A vertex on the ground, in pixels, and its height [m].
struct Corner {
    double u, v, z;
};

//! Triangles that are rasterised together. A point is inside a triangle if a (u
//! - u0) + b (v - v0) >= 0 for all three edges. For two faces with a common
//! edge these values differ only in sign, so that no light passes between the
//! faces.
struct Batch {
    using Numbers = std::array<double, batch>;

    std::array<Numbers, 3> u, v, z;                //!< corners
    std::array<Numbers, 3> a, b, u0, v0, inverse;  //!< edge coefficients
    Numbers least_u, most_u, least_v, most_v, least_z, most_z;
    Numbers slope_u, slope_v;  //!< slopes of the height
    Numbers area;  //!< twice the area, positive if the front is visible
    std::array<std::uint32_t, batch> code;
    std::size_t count = 0;
};

double lesser(double a, double b) {
    return a < b ? a : b;
}

double greater(double a, double b) {
    return a > b ? a : b;
}

//! Returns the coordinate j / n within a pixel after a cyclic shift.
float shifted(double shift, int j, int n) {
    const double at = shift + static_cast<double>(j) / n;
    return static_cast<float>(at - std::floor(at));
}

//! Rounds down without a library call.
std::int64_t floored(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

//! Computes all values that depend on the corners.
IDEOTYPE_FOR_WIDE_VECTORS void set_up(Batch& t) {
    for (std::size_t i = 0; i < batch; ++i) {
        const double bu = t.u[1][i] - t.u[0][i], bv = t.v[1][i] - t.v[0][i];
        const double cu = t.u[2][i] - t.u[0][i], cv = t.v[2][i] - t.v[0][i];
        const double zb = t.z[1][i] - t.z[0][i], zc = t.z[2][i] - t.z[0][i];
        const double area = bu * cv - bv * cu;
        t.area[i] = area;
        t.slope_u[i] = (zb * cv - zc * bv) / area;
        t.slope_v[i] = (zc * bu - zb * cu) / area;
    }
    for (std::size_t i = 0; i < batch; ++i) {
        t.least_u[i] = lesser(lesser(t.u[0][i], t.u[1][i]), t.u[2][i]);
        t.most_u[i] = greater(greater(t.u[0][i], t.u[1][i]), t.u[2][i]);
        t.least_v[i] = lesser(lesser(t.v[0][i], t.v[1][i]), t.v[2][i]);
        t.most_v[i] = greater(greater(t.v[0][i], t.v[1][i]), t.v[2][i]);
        t.least_z[i] = lesser(lesser(t.z[0][i], t.z[1][i]), t.z[2][i]);
        t.most_z[i] = greater(greater(t.z[0][i], t.z[1][i]), t.z[2][i]);
    }
    for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t f = e == 2 ? 0 : e + 1;
        for (std::size_t i = 0; i < batch; ++i) {
            const double pu = t.u[e][i], pv = t.v[e][i];
            const double qu = t.u[f][i], qv = t.v[f][i];
            // An edge is traversed in the same direction in both of its faces.
            const bool is_other = (qu < pu) | ((qu == pu) & (qv < pv));
            const double sign =
                (t.area[i] > 0 ? 1. : -1.) * (is_other ? -1. : 1.);
            const double fu = is_other ? qu : pu, tu = is_other ? pu : qu;
            const double fv = is_other ? qv : pv, tv = is_other ? pv : qv;
            t.u0[e][i] = fu;
            t.v0[e][i] = fv;
            t.a[e][i] = sign * (fv - tv);
            t.b[e][i] = sign * (tu - fu);
            t.inverse[e][i] = 1 / t.b[e][i];
        }
    }
}

//! The edge values and the height of a triangle at the points of a pixel, by
//! lane, minus the values at the pixel's corner.
struct alignas(32) Lanes {
    DepthBuffer::Floats edge0, edge1, edge2, height;
};

struct Target {
    const BeamLattice& lattice;
    const std::vector<DepthBuffer::Places>& places;
    std::vector<DepthBuffer::Points>& points;
};

IDEOTYPE_FOR_WIDE_VECTORS void draw_batch(const Batch& t, const Target& target,
                                          std::vector<Lanes>& lanes) {
    const std::int64_t n = target.lattice.pixels;
    const std::int64_t number_u = target.lattice.number_u;
    const std::int64_t number_v = target.lattice.number_v;
    const std::int64_t next_v = number_v < 0 ? number_v + n : number_v;
    const double per_n = 1 / static_cast<double>(n);
    using Floats = DepthBuffer::Floats;
    const std::size_t groups = lanes.size();
    for (std::size_t i = 0; i < t.count; ++i) {
        // Light only grazes a triangle without projected area.
        if (t.area[i] == 0) continue;
        const double a0 = t.a[0][i], a1 = t.a[1][i], a2 = t.a[2][i];
        const double b0 = t.b[0][i], b1 = t.b[1][i], b2 = t.b[2][i];
        const double slope_u = t.slope_u[i], slope_v = t.slope_v[i];
        const auto fa0 = static_cast<float>(a0), fb0 = static_cast<float>(b0);
        const auto fa1 = static_cast<float>(a1), fb1 = static_cast<float>(b1);
        const auto fa2 = static_cast<float>(a2), fb2 = static_cast<float>(b2);
        const auto fzu = static_cast<float>(slope_u);
        const auto fzv = static_cast<float>(slope_v);
        for (std::size_t k = 0; k < groups; ++k) {
            const auto& [su, sv] = target.places[k];
            lanes[k] = {fa0 * su + fb0 * sv, fa1 * su + fb1 * sv,
                        fa2 * su + fb2 * sv, fzu * su + fzv * sv};
        }
        const Floats least_z = static_cast<float>(t.least_z[i]) + Floats{};
        const Floats most_z = static_cast<float>(t.most_z[i]) + Floats{};
        const DepthBuffer::Codes code =
            (t.code[i] + (t.area[i] > 0 ? 1u : 0u)) + DepthBuffer::Codes{};
        // The largest increase of an edge value within a pixel.
        const double most0 = greater(0, a0) + greater(0, b0);
        const double most1 = greater(0, a1) + greater(0, b1);
        const double most2 = greater(0, a2) + greater(0, b2);
        // A pixel is examined if it may contain a point. With the slack,
        // rounding can only add pixels.
        constexpr double slack = 1e-6;
        const std::int64_t first_u = floored(t.least_u[i] - slack);
        const std::int64_t last_u = floored(t.most_u[i] + slack);
        for (std::int64_t u = first_u; u <= last_u; ++u) {
            const auto du = static_cast<double>(u);
            const double c0 = a0 * (du - t.u0[0][i]);
            const double c1 = a1 * (du - t.u0[1][i]);
            const double c2 = a2 * (du - t.u0[2][i]);
            const double v0 = t.v0[0][i] - (c0 + most0) * t.inverse[0][i];
            const double v1 = t.v0[1][i] - (c1 + most1) * t.inverse[1][i];
            const double v2 = t.v0[2][i] - (c2 + most2) * t.inverse[2][i];
            double low = t.least_v[i] - 1, high = t.most_v[i];
            low = b0 > 0 ? greater(low, v0) : low;
            low = b1 > 0 ? greater(low, v1) : low;
            low = b2 > 0 ? greater(low, v2) : low;
            high = b0 < 0 ? lesser(high, v0) : high;
            high = b1 < 0 ? lesser(high, v1) : high;
            high = b2 < 0 ? lesser(high, v2) : high;
            const std::int64_t first_v = -floored(-(low - slack));
            const std::int64_t last_v = floored(high + slack);
            if (first_v > last_v) continue;
            const std::int64_t number = u * number_u + first_v * number_v;
            std::int64_t pixel =
                number - n * floored(static_cast<double>(number) * per_n);
            pixel += pixel < 0 ? n : pixel >= n ? -n : 0;
            const double z0 = t.z[0][i] + slope_u * (du - t.u[0][i]);
            for (std::int64_t v = first_v; v <= last_v; ++v) {
                const auto dv = static_cast<double>(v);
                const auto e0 = static_cast<float>(c0 + b0 * (dv - t.v0[0][i]));
                const auto e1 = static_cast<float>(c1 + b1 * (dv - t.v0[1][i]));
                const auto e2 = static_cast<float>(c2 + b2 * (dv - t.v0[2][i]));
                const auto z =
                    static_cast<float>(z0 + slope_v * (dv - t.v[0][i]));
                const std::size_t from =
                    static_cast<std::size_t>(pixel) * groups;
                for (std::size_t k = 0; k < groups; ++k) {
                    const Lanes& at = lanes[k];
                    auto& [height, seen] = target.points[from + k];
                    Floats h = z + at.height;
                    h = h < least_z ? least_z : h;
                    h = h > most_z ? most_z : h;
                    const auto is_seen = (e0 + at.edge0 >= 0.f) &
                                         (e1 + at.edge1 >= 0.f) &
                                         (e2 + at.edge2 >= 0.f) & (h > height);
                    height = is_seen ? h : height;
                    seen = is_seen ? code : seen;
                }
                pixel += next_v;
                pixel -= pixel >= n ? n : 0;
            }
        }
    }
}

void draw(const Surfaces& surfaces, std::uint32_t pose,
          const std::vector<Corner>& corners, const Target& target) {
    std::vector<Lanes> lanes(target.places.size());
    Batch triangles{};
    const auto flush = [&] {
        set_up(triangles);
        draw_batch(triangles, target, lanes);
        triangles.count = 0;
    };
    const auto add = [&](std::uint32_t code, const Corner& a, const Corner& b,
                         const Corner& c) {
        const std::size_t i = triangles.count++;
        const std::array<const Corner*, 3> all{&a, &b, &c};
        for (std::size_t k = 0; k < 3; ++k) {
            triangles.u[k][i] = all[k]->u;
            triangles.v[k][i] = all[k]->v;
            triangles.z[k][i] = all[k]->z;
        }
        triangles.code[i] = code;
        if (triangles.count == batch) flush();
    };
    std::uint32_t code = 0;
    for (std::size_t f = 0; f < surfaces.faces.size(); ++f, code += 4) {
        if (!surfaces.is_there(f, pose)) continue;
        const auto& [a, b, c, d] = surfaces.faces[f];
        add(code, corners[a], corners[b], corners[d]);
        if (c != d) add(code + 2, corners[c], corners[d], corners[b]);
    }
    if (triangles.count > 0) flush();
}

}  // namespace

DepthBuffer::DepthBuffer(const RayScene& scene, const glm::dvec3& direction,
                         const BeamLattice& lattice,
                         const std::vector<glm::dvec2>& shifts,
                         std::uint32_t pose)
    : lattice_(lattice),
      direction_(direction),
      per_pixel_(static_cast<std::size_t>(lattice.fine)),
      lanes_((shifts.size() * per_pixel_ + width - 1) / width * width) {
    IDEOTYPE_EXPECT(scene.boundary() == Boundary::periodic);
    IDEOTYPE_EXPECT(direction.z < 0 && !shifts.empty());
    // Spare lanes contain no point.
    const Floats nowhere = std::numeric_limits<float>::quiet_NaN() + Floats{};
    places_.assign(lanes_ / width, {nowhere, nowhere});
    std::size_t lane = 0;
    for (const glm::dvec2& shift : shifts)
        for (int j = 0; j < lattice.fine; ++j, ++lane) {
            IDEOTYPE_EXPECT(shift.x >= 0 && shift.x < 1 && shift.y >= 0 &&
                            shift.y < 1);
            Places& places = places_[lane / width];
            const int v = lattice.generator * j % lattice.fine;
            places.u[lane % width] = shifted(shift.x, j, lattice.fine);
            places.v[lane % width] = shifted(shift.y, v, lattice.fine);
        }
    // Just below the soil, so that a face on the soil hides it.
    const float ground = std::nextafter(static_cast<float>(scene.soil()), -1.f);
    points_.assign(static_cast<std::size_t>(lattice.pixels) * places_.size(),
                   {ground + Floats{}, Triangle::soil + Codes{}});

    const glm::dvec2 &su = lattice.step_u, &sv = lattice.step_v;
    const double determinant = su.x * sv.y - su.y * sv.x;
    std::vector<Corner> corners;
    corners.reserve(scene.surfaces().vertices.size());
    for (const glm::dvec3& p : scene.surfaces().vertices) {
        const double x = p.x - p.z * (direction.x / direction.z);
        const double y = p.y - p.z * (direction.y / direction.z);
        corners.push_back({(x * sv.y - y * sv.x) / determinant,
                           (y * su.x - x * su.y) / determinant, p.z});
    }
    draw(scene.surfaces(), pose, corners, {lattice_, places_, points_});
}

glm::dvec3 DepthBuffer::position(std::size_t randomisation,
                                 std::size_t point) const {
    IDEOTYPE_EXPECT(point < points() &&
                    (randomisation + 1) * per_pixel_ <= lanes_);
    const std::size_t lane = randomisation * per_pixel_ + point % per_pixel_;
    const std::size_t pixel = point / per_pixel_;
    const glm::dvec2 ground =
        static_cast<double>(pixel) * lattice_.step_one +
        double{places_[lane / width].u[lane % width]} * lattice_.step_u +
        double{places_[lane / width].v[lane % width]} * lattice_.step_v;
    const double z = height(randomisation, point);
    return {ground.x + z * (direction_.x / direction_.z),
            ground.y + z * (direction_.y / direction_.z), z};
}

}  // namespace ideotype
