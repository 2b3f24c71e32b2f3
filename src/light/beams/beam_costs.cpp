// SPDX-License-Identifier: Apache-2.0
#include "beam_costs.hpp"

#include <algorithm>
#include <cmath>

#include "directions.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! The number of points that a depth buffer processes together, used or not.
constexpr int width = 8;

//! The number of points per pixel for which a depth buffer has space.
constexpr int room = 2 * width;

}  // namespace

BeamLattice lattice_of(const RayScene& scene, const glm::dvec3& direction,
                       std::uint32_t first_hits, int randomisations) {
    IDEOTYPE_EXPECT(first_hits > 0 && randomisations > 0);
    return beam_lattice(scene.period_x(), scene.period_y(), first_hits,
                        std::max(1, room / randomisations), direction);
}

std::size_t replicates_together(const BeamLattice& lattice) {
    constexpr std::size_t most_points = std::size_t{1} << 21;
    const auto points = static_cast<std::size_t>(lattice.points());
    return std::max<std::size_t>(most_points / points / width * width, width);
}

double cost_of_drawing(const RayScene& scene, const glm::dvec3& direction,
                       std::uint32_t first_hits, int randomisations) {
    constexpr double triangle = 0.05, pixel = 0.008, point = 0.006;
    const double fine =
        randomisations >= 4 ? 1 : std::max(1, room / randomisations - 2);
    const double pixels = std::max(1., first_hits / fine);
    const double groups = std::ceil(randomisations * fine / width);
    const double triangles =
        2. * static_cast<double>(scene.surfaces().faces.size());
    // Areas are projected along the light; on average a leaf shows half its
    // area.
    const double pixel_area =
        scene.ground_area() * std::abs(direction.z) / pixels;
    const double area = scene.surface_area() / 2 / std::max(1., triangles);
    const double touched = std::pow(std::sqrt(area / pixel_area) + 1, 2);
    return triangles * (triangle + touched * groups * pixel) +
           point * first_hits * randomisations;
}

bool is_drawn(const RayScene& scene, const Source& source,
              std::uint32_t first_hits, int randomisations) {
    return source.direction && scene.boundary() == Boundary::periodic &&
           cost_of_drawing(scene, not_level(*source.direction), first_hits,
                           randomisations) <
               Costs::ray * first_hits * randomisations;
}

}  // namespace ideotype
