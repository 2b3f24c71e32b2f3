// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "beams/first_hits.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"
#include "ledger.hpp"

namespace ideotype {

//! Light that a surface sends on, as a path.
struct ScatteredPath {
    Hit hit;  //!< where it is
    bool is_adaxial;
    std::uint32_t source;
    double energy;   //!< [J m-2 of ground]
    double started;  //!< with that much
};

//! The way in which light of a source arrives at its first hits in a band.
struct Arrival {
    std::uint32_t source;
    bool is_beam;
    double start;              //!< place of the first path: uniform in [0, 1)
    double path_energy;        //!< [J m-2 of ground]
    double scale = 1;          //!< energy in the band over that of the hits
    double scale_by_soil = 1;  //!< scale for light that soil sent into a plot
};

//! Follows light of one band from its first hits on.
class Tracer {
  public:
    //! Keeps its arguments.
    //! @param counted must outlive it
    Tracer(const Counted& counted, const Optics& optics,
           const std::vector<Source>& sources);

    //! Counts the light of first hits and adds paths of the light that is sent
    //! on. Surfaces keep exactly their absorptance of what they meet first.
    //! The light that they send on sets out in as many paths of equal energy as
    //! make each at most `path_energy`, at least one. They start at hits that
    //! are evenly spread over all the energy that is sent on, in the order of
    //! the hits. Where all hits together send on less than one brings, that is
    //! not worth a path: instead all or nothing of a hit is sent on, with the
    //! right odds.
    void arrive(const FirstHits& hits, const Arrival& how, Tally& tally,
                std::vector<ScatteredPath>& paths, LeafSums& leaf_sums) const;

    //! Follows paths until surfaces have absorbed all of them or they have left
    //! upwards; no path is left. From surface to surface they go on together,
    //! each time ordered by place, with the points of a new net (array-RQMC,
    //! L'Ecuyer et al. 2008, doi:10.1287/opre.1080.0556): paths that are near
    //! each other, of whatever source, set out into different directions.
    //! @param randomness of the randomisation
    //! @param net that no other paths of it have
    void follow(std::vector<ScatteredPath>& paths, const Randomness& randomness,
                std::uint32_t net, Tally& tally, LeafSums& leaf_sums) const;

  private:
    //! Returns the face that light meets: soil is a surface too, and the sky is
    //! a black one.
    const Lambertian& surface(std::uint32_t group, bool is_adaxial) const {
        const std::size_t others = ~group;
        return (others < 2 ? surfaces_[others] : surfaces_[2 + group])
            .face(is_adaxial);
    }

    //! Follows a path to the next thing it meets, which keeps some or all of
    //! it.
    void go_on(ScatteredPath& path, PathSampler& numbers, Ledger& ledger) const;

    const Counted& counted_;
    const RayScene& scene_;
    std::vector<Material> surfaces_;    //!< soil, sky and those of groups
    std::vector<std::uint32_t> poses_;  //!< poses of sources
};

}  // namespace ideotype
