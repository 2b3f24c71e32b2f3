// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! The parts of leaves that absorb light: pieces, and places. A place joins the
//! pieces that are the same part of a leaf in uniform plants.
struct LeafPlaces {
    //! Finds the places of pieces.
    //! @param is_each whether each piece is a separate place
    LeafPlaces(const Pieces& pieces, const LitLeaves& lit, bool is_each);

    std::size_t count() const { return index.size(); }
    std::size_t pieces() const { return of.size(); }

    std::vector<std::uint32_t> of;     //!< place of each piece
    std::vector<double> per_index;     //!< 1 / leaf area index, by piece
    std::vector<double> index;         //!< leaf area index, by place
    std::vector<std::uint32_t> group;  //!< group by place, each in a run
    std::vector<std::uint32_t> row;    //!< row by place; 0 if not distinguished
    std::vector<double> height;        //!< height by place [m]
    std::vector<double> width;        //!< width by place [m], if pieces have it
    std::vector<double> absorptance;  //!< larger of both faces, by place
};

//! Diffuse light of one source [J m-2 of ground].
struct DiffuseLight {
    //! Collects the diffuse light of pieces.
    //! @param source number of the source; -1: none
    DiffuseLight(const std::vector<Tally>& tallies, int source,
                 std::size_t pieces);

    //! Light of each piece that has light, in each randomisation.
    std::vector<std::vector<LeafLight::Part>> parts;
    std::vector<double> sum;  //!< sum over randomisations, by piece
};

//! The diffuse light expected at each place, to compare with simulated light.
class ExpectedLight {
  public:
    //! Finds the expected light of a place as a mean over the place and as many
    //! neighbours as are needed to know the mean well.
    ExpectedLight(const LeafPlaces& places, const std::vector<Tally>& tallies);

    //! Returns the expected light by place, per area of leaf [J m-2].
    std::vector<double> of(const DiffuseLight& light) const;

  private:
    const LeafPlaces& places_;
    std::vector<std::uint32_t> first_;  //!< first place joined to each place
    std::vector<double> scale_;         //!< factor of sums, by first place
};

}  // namespace ideotype
