// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! The parts of leaves that absorb light: pieces, and places. A place joins the
//! pieces that are the same part of a leaf in plants that are alike.
struct LeafPlaces {
    //! Finds the places of pieces.
    //! @param is_each whether each piece is a place of its own
    LeafPlaces(const Pieces& pieces, const LitLeaves& lit, bool is_each);

    std::size_t count() const { return index.size(); }
    std::size_t pieces() const { return of.size(); }

    std::vector<std::uint32_t> of;     //!< the place of each piece
    std::vector<double> per_index;     //!< 1 / leaf area index, of pieces
    std::vector<double> index;         //!< leaf area index, of places
    std::vector<std::uint32_t> group;  //!< group of places, each in a run
    std::vector<std::uint32_t> row;    //!< row of places; 0 if none is told
    std::vector<double> height;        //!< height of places [m]
    //! The absorptance of places, of the face that absorbs more.
    std::vector<double> absorptance;
};

//! Diffuse light of one source [J m-2 of ground].
struct DiffuseLight {
    //! Collects the diffuse light of pieces.
    //! @param source -1: none
    DiffuseLight(const std::vector<Tally>& tallies, int source,
                 std::size_t pieces);

    //! The light of each piece that has some, in each randomisation.
    std::vector<std::vector<LeafLight::Part>> parts;
    std::vector<double> sum;  //!< over randomisations, of pieces
};

//! The diffuse light that is expected at each place, with which the simulated
//! one is compared.
class ExpectedLight {
  public:
    //! Finds the expected light of a place as a mean over the place and as many
    //! of its neighbours as it takes to know the mean well.
    ExpectedLight(const LeafPlaces& places, const std::vector<Tally>& tallies);

    //! Returns the expected light by place, per area of leaf [J m-2].
    std::vector<double> of(const DiffuseLight& light) const;

  private:
    const LeafPlaces& places_;
    std::vector<std::uint32_t> first_;  //!< that each place is joined to
    std::vector<double> scale_;         //!< scale of sums of first places
};

}  // namespace ideotype
