// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "ideotype/climate/radiance.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Chooses directions of light from a sky in proportion to what they carry to
//! horizontal ground, radiance times cos z. The map from the unit square
//! is continuous and one to one, so that evenly spread points stay so, and
//! nothing is rejected or weighted. Uniform and overcast skies are exact to
//! rounding, clear ones to 2e-7 in the probability of any set of directions.
//! A clear one takes some 0.3 ms to set up; copies share that.
class SkySampler {
  public:
    //! Of a uniform sky.
    SkySampler() = default;

    //! @throws Error if the sky is clear and its sun below the horizon.
    explicit SkySampler(const SkyRadiance& sky);

    const SkyRadiance& radiance() const { return radiance_; }

    //! A direction of travel (unit length, z up, never upwards) from two
    //! numbers uniform in [0, 1).
    glm::dvec3 sample(double u, double v) const;

    //! Integral of relative_radiance() times cos z over the hemisphere.
    double horizontal_irradiance() const;

    //! Radiance of the light that travels in a direction, over that of a
    //! uniform sky with the same irradiance of level ground.
    double relative_brightness(const glm::dvec3& travel) const;

  private:
    class ClearSky;
    SkyRadiance radiance_;
    std::shared_ptr<const ClearSky> clear_;
};

}  // namespace ideotype
