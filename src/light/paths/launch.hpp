// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/sampler.hpp"
#include "travel.hpp"

namespace ideotype {

//! Launches the light of one source into a scene. A periodic stand is lit
//! through the top of its cell. An isolated plot is lit through its bounding
//! box, by light straight from the source, through the top and the lit sides,
//! and by light from the infinite soil around, through the bottom and all
//! sides, without soil in the box's own shadow. Both are all light that enters,
//! since light that has been in the box is followed until it is absorbed or
//! lost to the sky, also over the soil outside.
class Launcher {
  public:
    Launcher(const RayScene& scene, const Source& source, double soil_albedo);

    //! Returns the energy of all paths over the energy of the source. Paths
    //! through the sides from a sky that is not uniform carry more or less than
    //! an equal share, in proportion to the brightness of their part of the
    //! sky.
    double entering() const { return entering_; }

    //! Returns the number of the pose of moving objects for this light.
    std::uint32_t pose() const { return source_.pose; }

    //! Returns an entering packet, without energy if it comes from soil in the
    //! box's shadow.
    PhotonPacket launch(PathSampler& sampler, double energy) const;

  private:
    enum class From { source, soil };

    //! A face of the box: at its lower or upper end along an axis.
    struct Portal {
        int axis;
        bool is_upper;
        From from;
        double area;  //!< area of level ground with equal energy [m2]
    };

    void add_portals(double soil_albedo);
    PhotonPacket enter(const Portal& portal, PathSampler& sampler,
                       double energy) const;
    glm::dvec3 from_above(PathSampler& sampler) const;
    bool is_lit(const glm::dvec3& soil, PathSampler& sampler) const;

    const RayScene& scene_;
    const Source& source_;
    std::vector<Portal> portals_;  //!< portals; none for a periodic stand
    double entering_ = 1;
};

}  // namespace ideotype
