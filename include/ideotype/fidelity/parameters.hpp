// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/canopy/request.hpp"

namespace ideotype {

//! A campaign, and how its light is arranged: all that trades speed for
//! accuracy.
struct Variant {
    Campaign campaign;
    Skies skies = Skies::shared;
    //! Paths of skies for their energy, relative to those of the sun.
    double sky_effort = 1;
    std::size_t pieces = pieces_of_blade;  //!< where leaves assimilate
    int randomisations = 2;                //!< of a draw
};

//! One position of a parameter.
struct ParameterValue {
    std::string name;
    std::function<void(Variant&)> apply;
};

//! One thing that trades speed for accuracy.
struct Parameter {
    //! How finely the same is computed; what is left out, or is no key of a
    //! campaign; how often it is sampled; how the same work is arranged.
    enum class Kind { fineness, omission, paths, arrangement };

    std::string name;
    Kind kind = Kind::fineness;
    std::vector<ParameterValue> values;
    std::size_t reference = 0;  //!< the value that counts as converged
    std::size_t own = 0;        //!< the campaign's value
    int effort = 1;  //!< paths of a draw, relative to those of others
    //! In what surroundings the values are compared.
    Variant base;

    //! Whether its values may give different means. Noise in the light of
    //! few paths lowers assimilation, and nothing else.
    bool may_be_biased() const;

    //! The surroundings with one of the values.
    Variant at(std::size_t value) const;
};

//! The parameters of a case. Those that compare leaves, stalks, hours or optics
//! do so in a cell of 2 x 2 plants with all else converged, where draws are
//! cheap and share their random numbers; cells are compared as the campaign has
//! them. Where there is nothing to trade, as with the scattering of black
//! surfaces, a parameter is left out.
std::vector<Parameter> parameters(const Campaign& campaign,
                                  std::size_t case_index);

//! The case of a variant's campaign.
Case case_of(const Variant& variant, std::size_t case_index);

//! How the first generation of a case evaluates a plant.
CanopyRequest request_of(const Variant& variant, std::size_t case_index,
                         const Genome& genome);

}  // namespace ideotype
