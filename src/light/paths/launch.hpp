// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/sampler.hpp"
#include "travel.hpp"

namespace ideotype {

//! Launches the light of one source into a scene. In a periodic stand, light
//! enters through the top of the cell. In an isolated plot, it enters through
//! the bounding box. Light directly from the source enters through the top and
//! the sides that face it, light from the infinite soil around the plot through
//! the bottom and all sides. Soil in the shadow of the box is excluded. This is
//! all the light that enters, because light that has been in the box is traced
//! until it is absorbed or lost to the sky, also over the soil outside.
class Launcher {
  public:
    Launcher(const RayScene& scene, const Source& source, double soil_albedo);

    //! Returns the energy of all paths divided by the energy of the source. If
    //! a sky is not uniform, paths through the sides carry more or less than an
    //! equal share, in proportion to the brightness of their part of the sky.
    double entering() const { return entering_; }

    //! Returns the orientation index of moving objects for this light.
    std::uint32_t pose() const { return source_.pose; }

    //! Returns an entering packet. Its energy is 0 if it comes from soil in the
    //! shadow of the box.
    PhotonPacket launch(PathSampler& sampler, double energy) const;

  private:
    enum class From { source, soil };

    //! A face of the box, at its lower or upper end along an axis.
    struct Portal {
        int axis;
        bool is_upper;
        From from;
        double area;  //!< area of level ground that receives equal energy [m2]
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
