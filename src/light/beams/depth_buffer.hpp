// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "beam_lattice.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Computes the faces that parallel light meets first in a periodic stand, at
//! the points of shifted lattices, one lattice per randomisation. Faces are
//! projected along the light onto the ground. The projection repeats with the
//! cell, so each face is rasterised once. Each point stores the highest face:
//! shifting a face by periods does not change its height. This is exact for any
//! overhang and any number of wraps. An edge belongs to the faces on both of
//! its sides. Of faces at equal height the first in the mesh is visible; where
//! there is no face, the soil is visible.
class DepthBuffer {
  public:
    //! A visible triangle of the scene's surfaces with its visible side.
    struct Triangle {
        std::uint32_t code;

        std::uint32_t face() const { return code / 4; }
        std::uint32_t number() const { return code / 2; }
        //! Returns whether light falls on the adaxial side.
        bool is_adaxial() const { return code & 1; }
        bool is_soil() const { return code == soil; }

        static constexpr std::uint32_t soil = ~std::uint32_t{0};
    };

    //! Rasterises all surfaces.
    //! @param direction direction of the light, downwards
    //! @param shifts shifts of the lattices, in [0, 1) of a pixel
    //! @param pose orientation index of moving objects
    DepthBuffer(const RayScene& scene, const glm::dvec3& direction,
                const BeamLattice& lattice,
                const std::vector<glm::dvec2>& shifts, std::uint32_t pose = 0);

    std::size_t points() const {
        return static_cast<std::size_t>(lattice_.points());
    }

    //! Returns the visible triangle at a point of a randomisation.
    Triangle triangle(std::size_t randomisation, std::size_t point) const {
        const std::size_t i = place(randomisation, point);
        return {points_[i / width].code[i % width]};
    }

    //! Returns the height of the visible surface [m].
    float height(std::size_t randomisation, std::size_t point) const {
        const std::size_t i = place(randomisation, point);
        return points_[i / width].height[i % width];
    }

    //! Returns the point at which light meets the surface, in any of the cells
    //! [m]. On the soil, its height is only rounding error.
    glm::dvec3 position(std::size_t randomisation, std::size_t point) const;

    //! The number of points processed as one vector. The width does not affect
    //! rounding.
    static constexpr std::size_t width = 8;
    using Floats = float __attribute__((vector_size(32)));
    using Codes = std::uint32_t __attribute__((vector_size(32)));

    //! The visible triangles at the points of one vector.
    struct alignas(32) Points {
        Floats height;
        Codes code;
    };

    //! The positions of a vector's points within a pixel, in [0, 1).
    struct alignas(32) Places {
        Floats u, v;
    };

  private:
    std::size_t place(std::size_t randomisation, std::size_t point) const {
        const std::size_t fine = per_pixel_;
        return point / fine * lanes_ + randomisation * fine + point % fine;
    }

    BeamLattice lattice_;
    glm::dvec3 direction_;
    std::size_t per_pixel_;
    std::size_t lanes_;  //!< number of points of all randomisations in a pixel,
                         //!< with spare ones
    std::vector<Places> places_;  //!< positions [lane / width]
    std::vector<Points> points_;  //!< visible triangles [pixel][lane / width]
};

}  // namespace ideotype
