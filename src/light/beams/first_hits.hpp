// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "depth_buffer.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/sampler.hpp"
#include "paths/launch.hpp"

namespace ideotype {

//! The place at which light of a source meets something for the first time.
struct FirstHit {
    std::uint32_t group;     //!< group, soil or sky, as in Hit
    std::uint32_t triangle;  //!< triangle of the scene's surfaces, if it is one
    float height;            //!< [m]
    bool is_adaxial;         //!< the side of the face that is met
    bool is_direct;          //!< straight from the source
    double energy;           //!< energy that arrives [J m-2 of ground]
};

//! The first hits of one source in one randomisation, which are seen in a depth
//! buffer or found by rays. Their energies sum to the energy that enters.
//! Neighbours in their order are near each other: by x in a depth buffer, and
//! by blocks of the stand.
class FirstHits {
  public:
    //! Takes the hits that a randomisation of a beam's depth buffer sees.
    //! @param scene,buffer must outlive it
    FirstHits(const RayScene& scene, const DepthBuffer& buffer,
              std::size_t randomisation, double energy);

    //! Follows so many rays of this energy.
    FirstHits(const RayScene& scene, const Launcher& launcher,
              PathSampler& sampler, std::uint32_t rays, double energy);

    bool are_drawn() const { return buffer_; }

    using Iterator = std::vector<FirstHit>::const_iterator;
    Iterator begin() const { return hits_.begin(); }
    Iterator end() const { return hits_.end(); }
    std::size_t size() const { return hits_.size(); }
    const FirstHit& operator[](std::size_t i) const { return hits_[i]; }

    //! Returns the point of a hit that is not the sky, and the normal there.
    Hit at(std::size_t i) const;

  private:
    void order();

    const RayScene& scene_;
    const DepthBuffer* buffer_ = nullptr;
    std::size_t randomisation_ = 0;
    std::vector<FirstHit> hits_;
    std::vector<Hit> points_;  //!< if found by rays
};

}  // namespace ideotype
