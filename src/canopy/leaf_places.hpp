// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! The parts of leaves that absorb light, at two levels: pieces and places. A
//! place combines the pieces that are the same part of a leaf in identical
//! plants.
struct LeafPlaces {
    //! Assigns pieces to places.
    //! @param is_each whether each piece is a separate place
    LeafPlaces(const Pieces& pieces, const LitLeaves& lit, bool is_each);

    std::size_t count() const { return index.size(); }
    std::size_t pieces() const { return of.size(); }

    std::vector<std::uint32_t> of;  //!< place of each piece
    std::vector<double> per_index;  //!< 1 / leaf area index of each piece
    std::vector<double> index;      //!< leaf area index, by place
    //! Group of each place; places of a group are consecutive.
    std::vector<std::uint32_t> group;
    //! Row of each place; 0 if rows are not distinguished.
    std::vector<std::uint32_t> row;
    std::vector<double> height;  //!< height by place [m]
    std::vector<double> width;  //!< width of each place [m], if pieces store it
    //! Larger absorptance of both faces, by place.
    std::vector<double> absorptance;
};

//! Diffuse light of one source [J m-2 of ground].
struct DiffuseLight {
    //! Collects the diffuse light of pieces.
    //! @param source index of the source; -1: none
    DiffuseLight(const std::vector<Tally>& tallies, int source,
                 std::size_t pieces);

    //! Light in each randomisation, for pieces with light.
    std::vector<std::vector<LeafLight::Part>> parts;
    std::vector<double> sum;  //!< sum over randomisations, by piece
};

//! The diffuse light expected at each place, with which simulated light is
//! compared.
class ExpectedLight {
  public:
    //! Computes the expected light of a place as a mean over the place and its
    //! neighbours, as many as a precise mean requires.
    ExpectedLight(const LeafPlaces& places, const std::vector<Tally>& tallies);

    //! Returns the expected light by place, per leaf area [J m-2].
    std::vector<double> of(const DiffuseLight& light) const;

  private:
    const LeafPlaces& places_;
    std::vector<std::uint32_t> first_;  //!< first place pooled with each place
    std::vector<double> scale_;  //!< factor of sums, by first pooled place
};

}  // namespace ideotype
