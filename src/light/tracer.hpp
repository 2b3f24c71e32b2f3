#pragma once

#include <cstdint>
#include <vector>

#include "first_hits.hpp"
#include "ideotype/light/optics.hpp"
#include "ledger.hpp"
#include "travel.hpp"

namespace ideotype {

//! Follows light from its first hits on.
class Tracer {
  public:
    //! All arguments must outlive it.
    Tracer(const Scene& scene, const std::vector<Group>& groups,
           const Optics& optics)
        : scene_(scene), groups_(groups), optics_(optics) {}

    //! Surfaces keep exactly their absorptance of what they meet first. What
    //! they send on is followed in as many paths of equal energy as make each
    //! at most `path_energy`, at least one. They start at hits that are evenly
    //! spread over all the energy that is sent on, in the order of the hits.
    //! Where all hits together send on less than one brings, that is not worth
    //! a path: instead all or nothing of a hit is sent on, with the right odds.
    void trace(const FirstHits& hits, PathSampler& sampler, double path_energy,
               Ledger& ledger) const;

  private:
    //! What light meets: soil is a surface too, and the sky is a black one.
    Lambertian surface(std::uint32_t group) const;

    //! Until surfaces have absorbed the packet or it has left upwards.
    void follow(PhotonPacket packet, PathSampler& sampler,
                Ledger& ledger) const;

    //! Sends a packet on into the half space that a choice, uniform in [0, 1),
    //! decides on.
    void scatter(PhotonPacket& packet, const Hit& hit, bool is_adaxial,
                 double choice, PathSampler& sampler) const;

    const Scene& scene_;
    const std::vector<Group>& groups_;
    const Optics& optics_;
};

}  // namespace ideotype
