// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! Diffuse light of one source [J m-2 of ground].
struct DiffuseLight {
    //! Collects the diffuse light of pieces.
    //! @param source index of the source; -1: none
    DiffuseLight(const std::vector<Tally>& tallies, int source,
                 std::size_t pieces);

    //! Light in each randomisation, for pieces with light.
    std::vector<std::vector<LeafLight::Part>> parts;
    std::vector<double> sum;         //!< sum over randomisations, by piece
    std::vector<std::uint32_t> lit;  //!< pieces with light, in any order
};

//! The parts of leaves that absorb light, at two levels: pieces and places. The
//! pieces of a place respond to light together. They are the same part of
//! leaves of one rank, and neighbouring parts, as many as a precise mean of
//! their diffuse light requires. The light of each piece is compared with this
//! mean, the expected light of the place.
struct LeafPlaces {
    //! Assigns pieces to places.
    //! @param tallies with leaf light, from which the size of places follows;
    //! with a single tally, each piece is a separate place
    LeafPlaces(const Pieces& pieces, const LitLeaves& lit,
               const std::vector<Tally>& tallies);

    std::size_t count() const { return index.size(); }
    std::size_t pieces() const { return of.size(); }

    //! Returns the expected light by place, per leaf area [J m-2].
    std::vector<double> expected(const DiffuseLight& light) const;

    //! Returns the fraction of a place's area that a piece has.
    double share(std::size_t piece) const {
        return per_index[piece] > 0 ? 1 / (per_index[piece] * index[of[piece]])
                                    : 0;
    }

    std::vector<std::uint32_t> of;  //!< place of each piece
    std::vector<double> per_index;  //!< 1 / leaf area index of each piece
    std::vector<double> index;      //!< leaf area index, by place
    //! Group of each place; places of a group are consecutive.
    std::vector<std::uint32_t> group;
    //! Row of each place; 0 if rows are not distinguished.
    std::vector<std::uint32_t> row;
    std::vector<double> height;  //!< mean height by place [m]
    //! Mean width of each place [m], if pieces store it.
    std::vector<double> width;
    //! Larger absorptance of both faces, by place.
    std::vector<double> absorptance;

  private:
    void match(const Pieces& pieces, const LitLeaves& lit, bool is_each);
    void join(const std::vector<std::uint32_t>& first);

    double randomisations_;
};

}  // namespace ideotype
