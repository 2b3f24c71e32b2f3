// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/sampler.hpp"
#include "travel.hpp"

namespace ideotype {

//! Lets the light of one source enter a scene.
//!
//! A periodic stand is lit through the top of its cell. An isolated plot is lit
//! through its bounding box, by two kinds of light that together are all there
//! is, since light that has been in the box is followed until it is absorbed or
//! lost to the sky, also by way of the soil outside: light straight from the
//! source, through the top and the lit sides; light from the source by way of
//! the infinite soil plane around, through the bottom and all sides, without
//! that from soil in the box's own shadow.
class Launcher {
  public:
    Launcher(const RayScene& scene, const Source& source, double soil_albedo);

    //! Returns the energy that all paths share, over the energy of the source.
    //! Paths from a sky that is not uniform through the sides carry more or
    //! less than their share, as the sky is brighter or darker there than on
    //! average.
    double entering() const { return entering_; }

    //! Returns the pose of what moves, for this light.
    std::uint32_t pose() const { return source_.pose; }

    //! Returns a packet that enters; without energy if it comes from soil that
    //! the box may shade.
    PhotonPacket launch(PathSampler& sampler, double energy) const;

  private:
    enum class From { source, soil };

    //! A face of the box: at its lower or upper end along an axis.
    struct Portal {
        int axis;
        bool is_upper;
        From from;
        double area;  //!< area of horizontal ground with the same energy [m2]
    };

    void add_portals(double soil_albedo);
    PhotonPacket enter(const Portal& portal, PathSampler& sampler,
                       double energy) const;
    glm::dvec3 from_above(PathSampler& sampler) const;
    bool is_lit(const glm::dvec3& soil, PathSampler& sampler) const;

    const RayScene& scene_;
    const Source& source_;
    std::vector<Portal> portals_;  //!< empty for a periodic stand
    double entering_ = 1;
};

}  // namespace ideotype
