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

//! A path of scattered light.
struct ScatteredPath {
    Hit hit;  //!< current position of the light
    bool is_adaxial;
    std::uint32_t source;
    double energy;   //!< energy of the path [J m-2 of ground]
    double started;  //!< initial energy [J m-2 of ground]
};

//! The parameters with which light of a source arrives at its first hits in a
//! band.
struct Arrival {
    std::uint32_t source;
    bool is_beam;
    double start;        //!< position of the first path, in [0, 1)
    double path_energy;  //!< energy of a path [J m-2 of ground]
    double scale = 1;    //!< energy in the band relative to the hit's energy
    double scale_by_soil = 1;  //!< factor for light from soil outside a plot
};

//! Traces light of one band from its first hits on.
class Tracer {
  public:
    //! Makes a tracer that refers to its arguments; `counted` must outlive it.
    Tracer(const Counted& counted, const Optics& optics,
           const std::vector<Source>& sources);

    //! Tallies the light of first hits and adds paths of scattered light.
    //! Surfaces absorb exactly their absorptance of first hits. Scattered light
    //! starts in at least one path; all paths have equal energy, at most
    //! `path_energy`. Their starting hits are evenly spaced in the cumulative
    //! scattered energy, in the order of hits. If all hits together scatter
    //! less than the energy of one hit, all or nothing of a hit is scattered,
    //! at random and without bias.
    void arrive(const FirstHits& hits, const Arrival& how, Tally& tally,
                std::vector<ScatteredPath>& paths, LeafSums& leaf_sums) const;

    //! Traces paths until all are absorbed or have left upwards; `paths` is
    //! then empty. All paths move from surface to surface together. Before each
    //! move they are sorted by position and use the points of a new net
    //! (array-RQMC, L'Ecuyer et al. 2008, doi:10.1287/opre.1080.0556). Paths
    //! that are close together, from any sources, therefore leave in different
    //! directions.
    //! @param randomness random numbers of the randomisation
    //! @param net index of a net that no other paths of the randomisation use
    void follow(std::vector<ScatteredPath>& paths, const Randomness& randomness,
                std::uint32_t net, Tally& tally, LeafSums& leaf_sums) const;

  private:
    //! Returns the optics of a face. Soil and the black sky count as surfaces.
    const Lambertian& surface(std::uint32_t group, bool is_adaxial) const {
        const std::size_t others = ~group;
        return (others < 2 ? surfaces_[others] : surfaces_[2 + group])
            .face(is_adaxial);
    }

    //! Traces a path to the next surface, which absorbs some or all of its
    //! energy.
    void go_on(ScatteredPath& path, PathSampler& numbers, Ledger& ledger) const;

    const Counted& counted_;
    const RayScene& scene_;
    std::vector<Material> surfaces_;    //!< materials of soil, sky and groups
    std::vector<std::uint32_t> poses_;  //!< orientation indices of the sources
};

}  // namespace ideotype
