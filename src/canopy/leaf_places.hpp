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

//! The leaves that absorb light, at three levels. Pieces of identical plants
//! that are the same part of a leaf are a part. Neighbouring parts of leaves of
//! one rank are a place; a place has as many parts as a precise mean of their
//! diffuse light requires. The leaves of a place respond to light together. The
//! light of each piece is compared with the mean of its place, the expected
//! light.
struct LeafPlaces {
    //! Assigns pieces to parts and places.
    //! @param tallies with leaf light, from which the size of places follows;
    //! with a single tally, each piece is a separate part and place
    LeafPlaces(const Pieces& pieces, const LitLeaves& lit,
               const std::vector<Tally>& tallies);

    std::size_t count() const { return index.size(); }
    std::size_t pieces() const { return of.size(); }

    //! Returns the expected light by place, per leaf area [J m-2].
    std::vector<double> expected(const DiffuseLight& light) const;

    //! Calls a function with the number, the height and the fraction of the
    //! area of each part of a place.
    template <class Take>
    void for_parts(std::size_t place, const Take& take) const {
        for (std::size_t j = first_part[place]; j < first_part[place + 1]; ++j)
            take(j, part_height[j],
                 index[place] > 0 ? part_index[j] / index[place] : 0);
    }

    std::vector<std::uint32_t> of;    //!< place of each piece
    std::vector<std::uint32_t> part;  //!< part of each piece
    std::vector<double> per_index;    //!< 1 / leaf area index of each piece
    std::vector<double> part_index;   //!< leaf area index, by part
    std::vector<double> part_height;  //!< mean height by part [m]
    //! First part of each place, followed by the number of parts.
    std::vector<std::size_t> first_part;
    std::vector<double> index;  //!< leaf area index, by place
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
    void take_means();

    double randomisations_;
};

}  // namespace ideotype
