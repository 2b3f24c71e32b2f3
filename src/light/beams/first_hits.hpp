// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "depth_buffer.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/sampler.hpp"
#include "paths/launch.hpp"

namespace ideotype {

//! The point where light of a source first meets a surface or the sky.
struct FirstHit {
    std::uint32_t group;     //!< group, soil or sky, as in Hit
    std::uint32_t triangle;  //!< triangle of the scene's surfaces, if any
    float height;            //!< height of the point [m]
    bool is_adaxial;         //!< whether the adaxial side is hit
    bool is_direct;          //!< whether light comes directly from the source
    double energy;           //!< arriving energy [J m-2 of ground]
};

//! The first hits of one source in one randomisation, from a depth buffer or
//! from rays. Their energies sum to the energy that enters. Consecutive hits
//! are close together: hits of a depth buffer are ordered by x, hits of rays by
//! blocks of the stand.
class FirstHits {
  public:
    //! Extracts the hits of a randomisation from a beam's depth buffer.
    //! @param scene,buffer objects that must outlive this one
    FirstHits(const RayScene& scene, const DepthBuffer& buffer,
              std::size_t randomisation, double energy);

    //! Traces a number of rays with equal energies.
    FirstHits(const RayScene& scene, const Launcher& launcher,
              PathSampler& sampler, std::uint32_t rays, double energy);

    bool are_drawn() const { return buffer_; }

    using Iterator = std::vector<FirstHit>::const_iterator;
    Iterator begin() const { return hits_.begin(); }
    Iterator end() const { return hits_.end(); }
    std::size_t size() const { return hits_.size(); }
    const FirstHit& operator[](std::size_t i) const { return hits_[i]; }

    //! Returns position and normal of a hit that is not the sky.
    Hit at(std::size_t i) const;

  private:
    void order();

    const RayScene& scene_;
    const DepthBuffer* buffer_ = nullptr;
    std::size_t randomisation_ = 0;
    std::vector<FirstHit> hits_;
    std::vector<Hit> points_;  //!< positions of hits, if found by rays
};

}  // namespace ideotype
