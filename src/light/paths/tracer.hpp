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

//! Scattered light as a path.
struct ScatteredPath {
    Hit hit;  //!< place of the light
    bool is_adaxial;
    std::uint32_t source;
    double energy;   //!< energy of the path [J m-2 of ground]
    double started;  //!< initial energy
};

//! The way in which light of a source arrives at its first hits in a band.
struct Arrival {
    std::uint32_t source;
    bool is_beam;
    double start;              //!< place of the first path, in [0, 1)
    double path_energy;        //!< energy of a path [J m-2 of ground]
    double scale = 1;          //!< energy in the band over that of the hits
    double scale_by_soil = 1;  //!< scale for light from soil outside a plot
};

//! Follows light of one band from the first hits on.
class Tracer {
  public:
    //! Makes a tracer that keeps its arguments; `counted` must outlive it.
    Tracer(const Counted& counted, const Optics& optics,
           const std::vector<Source>& sources);

    //! Counts the light of first hits and adds paths of scattered light.
    //! Surfaces keep exactly their absorptance of first hits. Scattered light
    //! starts in at least one path; all have equal energy, at most
    //! `path_energy`. Paths start at hits that are evenly spread over the
    //! scattered energy, in the order of the hits. If all hits together scatter
    //! less than the energy of one hit, all or nothing of a hit is scattered,
    //! with the right odds.
    void arrive(const FirstHits& hits, const Arrival& how, Tally& tally,
                std::vector<ScatteredPath>& paths, LeafSums& leaf_sums) const;

    //! Follows paths until all are absorbed or have left upwards; no path is
    //! left. All paths go from surface to surface together, each time ordered
    //! by place, with the points of a new net (array-RQMC, L'Ecuyer et al.
    //! 2008, doi:10.1287/opre.1080.0556): near paths, of any sources, start
    //! into different directions.
    //! @param randomness random numbers of the randomisation
    //! @param net number of a net that no other paths of the randomisation have
    void follow(std::vector<ScatteredPath>& paths, const Randomness& randomness,
                std::uint32_t net, Tally& tally, LeafSums& leaf_sums) const;

  private:
    //! Returns the optics of a face; soil and the black sky are surfaces too.
    const Lambertian& surface(std::uint32_t group, bool is_adaxial) const {
        const std::size_t others = ~group;
        return (others < 2 ? surfaces_[others] : surfaces_[2 + group])
            .face(is_adaxial);
    }

    //! Follows a path to the next surface, which keeps some or all energy.
    void go_on(ScatteredPath& path, PathSampler& numbers, Ledger& ledger) const;

    const Counted& counted_;
    const RayScene& scene_;
    std::vector<Material> surfaces_;    //!< materials of soil, sky and groups
    std::vector<std::uint32_t> poses_;  //!< poses of the sources
};

}  // namespace ideotype
