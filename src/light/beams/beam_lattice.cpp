// SPDX-License-Identifier: Apache-2.0
#include "beam_lattice.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! The metric that gives the lengths of steps on the ground as seen along the
//! light.
struct Measure {
    double xx, xy, yy;

    double product(const glm::dvec2& a, const glm::dvec2& b) const {
        return xx * a.x * b.x + xy * (a.x * b.y + a.y * b.x) + yy * a.y * b.y;
    }
    double squared(const glm::dvec2& step) const { return product(step, step); }
};

Measure measure(const glm::dvec3& direction) {
    const double level = std::hypot(direction.x, direction.y);
    if (!(level > 0)) return {1, 0, 1};
    const double x = direction.x / level, y = direction.y / level;
    const double less = 1 - direction.z * direction.z;
    return {1 - less * x * x, -less * x * y, 1 - less * y * y};
}

//! Replaces the steps of a lattice by its two shortest steps (Lagrange's
//! reduction).
BeamLattice reduced(BeamLattice lattice, const Measure& measure) {
    for (;;) {
        if (measure.squared(lattice.step_v) < measure.squared(lattice.step_u)) {
            std::swap(lattice.step_u, lattice.step_v);
            std::swap(lattice.number_u, lattice.number_v);
        }
        const double times =
            std::round(measure.product(lattice.step_u, lattice.step_v) /
                       measure.squared(lattice.step_u));
        if (times == 0) return lattice;
        lattice.step_v -= times * lattice.step_u;
        lattice.number_v -= static_cast<std::int64_t>(times) * lattice.number_u;
        if (!(measure.squared(lattice.step_v) <
              measure.squared(lattice.step_u)))
            return lattice;
    }
}

//! The numbers of points per pixel, each with the generator that distributes
//! them well.
constexpr std::array<std::pair<int, int>, 5> sublattices{
    {{1, 1}, {5, 2}, {7, 3}, {11, 3}, {13, 5}}};

bool is_coprime_to_fields(std::int64_t pixels) {
    return pixels % 2 != 0 && pixels % 3 != 0 && pixels % 5 != 0 &&
           pixels % 7 != 0;
}

}  // namespace

BeamLattice beam_lattice(double period_x, double period_y, std::int64_t points,
                         int lanes, const glm::dvec3& direction) {
    IDEOTYPE_EXPECT(period_x > 0 && period_y > 0);
    IDEOTYPE_EXPECT(points > 0 && lanes > 0);
    IDEOTYPE_EXPECT(direction.z < 0);
    const Measure measure = ideotype::measure(direction);

    BeamLattice lattice;
    for (const auto& [fine, generator] : sublattices)
        if (fine <= lanes) {
            lattice.fine = fine;
            lattice.generator = generator;
        }
    lattice.pixels = (points + lattice.fine - 1) / lattice.fine;
    while (!is_coprime_to_fields(lattice.pixels)) ++lattice.pixels;
    BeamLattice best;
    double longest = -1;
    // Multiples of the golden ratio distribute the tested generators evenly
    // over all generators.
    constexpr int generators = 24;
    constexpr double golden = 0.6180339887498949;
    for (int i = 1; i <= generators; ++i) {
        const double part = i * golden - std::floor(i * golden);
        const auto generator = static_cast<std::int64_t>(
            part * static_cast<double>(lattice.pixels));
        const auto n = static_cast<double>(lattice.pixels);
        lattice.step_one = {period_x / n,
                            period_y * static_cast<double>(generator) / n};
        lattice.step_u = lattice.step_one;
        lattice.number_u = 1;
        lattice.step_v = {0, period_y};
        lattice.number_v = 0;
        const BeamLattice found = reduced(lattice, measure);
        if (measure.squared(found.step_u) > longest) {
            longest = measure.squared(found.step_u);
            best = found;
        }
    }
    const glm::dvec2 &u = best.step_u, &v = best.step_v;
    if (u.x * v.y < u.y * v.x) {
        best.step_v = -v;
        best.number_v = -best.number_v;
    }
    IDEOTYPE_ENSURE(best.points() >= points);
    IDEOTYPE_ENSURE(best.step_u.x * best.step_v.y >
                    best.step_u.y * best.step_v.x);
    best.number_u %= best.pixels;
    best.number_v %= best.pixels;
    return best;
}

}  // namespace ideotype
