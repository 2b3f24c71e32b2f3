// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iterator>
#include <utility>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/light_classes.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! Returns the mean of independent randomisations, element by element.
std::vector<double> mean_of(const std::vector<std::vector<double>>& all);
Tally mean_of(const std::vector<Tally>& tallies);
FluxTally mean_of(const std::vector<FluxTally>& tallies);
LightClasses mean_of(const std::vector<LightClasses>& classes);

//! Adds elements by index; an empty sum becomes a copy of the summand.
template <class All>
void add(All& all, const All& more) {
    if (all.empty()) all.resize(more.size());
    IDEOTYPE_EXPECT(more.size() <= all.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] += more[i];
}

//! Moves items to the end of a list.
template <class All>
void append(All& all, All more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

inline void append(SunlitFractions& all, SunlitFractions more) {
    append(all.fractions, std::move(more.fractions));
    all.steps = std::move(more.steps);
}

//! Sums the light absorbed by leaves by row [randomisation, row]; empty if rows
//! are not distinguished.
//! @param groups groups of the pieces' mesh
std::vector<std::vector<double>> light_of_rows(
    const std::vector<Tally>& tallies, const Pieces& pieces,
    const std::vector<Group>& groups);

//! Adds the light of pieces to their groups of the uncut mesh.
void add_up_pieces(std::vector<Tally>& tallies, const Pieces& pieces,
                   std::size_t groups);

}  // namespace ideotype
