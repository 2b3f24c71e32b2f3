// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "beams/first_hits.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! Sums by place, most of which are zero.
class SparseSums {
  public:
    void resize(std::size_t places) { sums_.resize(places); }

    void add(std::uint32_t place, double energy) {
        if (!(energy > 0)) return;
        if (sums_[place] == 0) places_.push_back(place);
        sums_[place] += energy;
    }

    //! Appends all sums and begins again.
    void drain(std::vector<LeafLight::Part>& parts);

  private:
    std::vector<double> sums_;
    std::vector<std::uint32_t> places_;  //!< places with a sum, by arrival
};

//! The sums of the light of leaves in one randomisation by place.
struct LeafSums {
    SparseSums beam;
    std::vector<SparseSums> diffuse;  //!< sums by source
};

//! Numbers of the parts with light counted for each source, see
//! Tally::parts.
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

//! The scene, groups, layers and pieces that light is counted by.
struct Counted {
    const RayScene& scene;
    const std::vector<Group>& groups;
    const Layers& layers;
    std::size_t pieces = 0;  //!< leading groups with light counted by place
    PartNumbers parts{groups};
};

//! Counts the ends of the light of one source in one randomisation. Small parts
//! are summed in two steps to limit their rounding errors.
class Ledger {
  public:
    //! @param counted,tally,leaf_sums objects that must outlive the ledger
    Ledger(const Counted& counted, std::uint32_t source, bool is_beam,
           Tally& tally, LeafSums& leaf_sums);

    //! Counts light at its first hit, which scatters part of it.
    //! @param energy energy of the hit in the counted band
    void arrive(const FirstHit& hit, double energy, double sent_on);

    //! Counts the energy that a surface or the sky keeps of scattered light.
    void keep(const Hit& hit, bool is_adaxial, double energy);

    //! Adds all counted light to the tally, and returns the budget.
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
    std::vector<double>* parts_ = nullptr;  //!< sums of parts, if there are any
    LeafLight* leaf_light_ = nullptr;       //!< light of leaves, if asked for
    SparseSums* beam_ = nullptr;
    SparseSums* diffuse_ = nullptr;
    Budget part_;
    int count_ = 0;
};

}  // namespace ideotype
