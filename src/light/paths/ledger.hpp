// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "beams/first_hits.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! Sums by index, most of which are zero.
class SparseSums {
  public:
    void resize(std::size_t places) { sums_.resize(places); }

    void add(std::uint32_t place, double energy) {
        if (!(energy > 0)) return;
        if (sums_[place] == 0) places_.push_back(place);
        sums_[place] += energy;
    }

    //! Appends all nonzero sums to `parts` and clears them.
    void drain(std::vector<LeafLight::Part>& parts);

  private:
    std::vector<double> sums_;
    //! Indices of nonzero sums in order of arrival.
    std::vector<std::uint32_t> places_;
};

//! Sums of the light on leaves in one randomisation.
struct LeafSums {
    SparseSums beam;
    std::vector<SparseSums> diffuse;  //!< sums by source
};

//! Indices of the parts for which light is tallied by source, see Tally::parts.
struct PartNumbers {
    explicit PartNumbers(const std::vector<Group>& groups);

    std::uint32_t side(const SurfaceId& object, bool is_adaxial) const {
        return 2 * (object.component - components) + (is_adaxial ? 0 : 1);
    }
    std::uint32_t leaves(const SurfaceId& id) const {
        return 2 * objects + id.component;
    }
    std::uint32_t count() const {
        return 2 * objects + (components > 1 ? components : 0);
    }

    std::uint32_t components = 0, objects = 0;
};

//! The scene, and the groups, layers and pieces by which light is tallied.
struct Counted {
    const RayScene& scene;
    const std::vector<Group>& groups;
    const Layers& layers;
    std::size_t pieces = 0;  //!< number of leading groups tallied by piece
    PartNumbers parts{groups};
};

//! Tallies the light of one source in one randomisation by the place where it
//! is absorbed. Small amounts are summed in two stages to limit rounding
//! errors.
class Ledger {
  public:
    //! @param counted,tally,leaf_sums objects that must outlive the ledger
    Ledger(const Counted& counted, std::uint32_t source, bool is_beam,
           Tally& tally, LeafSums& leaf_sums);

    //! Tallies light at its first hit, where part of it is scattered.
    //! @param energy energy of the hit in the tallied band
    void arrive(const FirstHit& hit, double energy, double sent_on);

    //! Tallies the energy of scattered light that a surface or the sky absorbs.
    void keep(const Hit& hit, bool is_adaxial, double energy);

    //! Adds all collected light to the tally and returns the budget.
    const Budget& close();

  private:
    void keep(std::uint32_t group, double height, bool is_adaxial,
              double energy, const FirstHit* direct);
    void keep_of_piece(std::uint32_t group, double energy,
                       const FirstHit* direct);
    Budget& next();

    const Counted& counted_;
    Tally& tally_;
    Budget& budget_;
    std::vector<double>* parts_ = nullptr;  //!< sums of the parts, if any
    LeafLight* leaf_light_ = nullptr;       //!< light of leaves, if requested
    SparseSums* beam_ = nullptr;
    SparseSums* diffuse_ = nullptr;
    Budget part_;
    int count_ = 0;
};

}  // namespace ideotype
