#pragma once

#include <cstdint>
#include <vector>

#include "first_hits.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! What tallies count by, besides sources.
struct Counted {
    const Scene& scene;
    const std::vector<Group>& groups;
    const Layers& layers;
};

//! Counts where light of one source goes in one randomisation. Many small parts
//! are added up in two steps, so that their rounding does not add up.
class Ledger {
  public:
    //! @param counted,tally must outlive it
    Ledger(const Counted& counted, std::uint32_t source, bool is_beam,
           Tally& tally);

    //! Light that arrives for the first time, part of which is sent on.
    void arrive(const FirstHit& hit, double sent_on);

    //! What something keeps of light that has been scattered.
    void keep(const Hit& hit, bool is_adaxial, double energy);

    //! The budget so far.
    const Budget& close();

  private:
    void keep(std::uint32_t group, double height, bool is_adaxial,
              double energy, const FirstHit* direct);
    Budget& next();

    const Counted& counted_;
    Tally& tally_;
    Budget& budget_;
    LeafLight* leaf_light_ = nullptr;
    std::vector<double> beam_;  //!< of triangles, if asked for
    Budget part_;
    int count_ = 0;
};

}  // namespace ideotype
