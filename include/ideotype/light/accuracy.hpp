#pragma once

#include <vector>

#include "ideotype/light/transport.hpp"

namespace ideotype {

//! What simulate() finds with just enough paths.
struct Simulation {
    std::vector<Tally> tallies;
    int paths = 0;           //!< per randomisation
    bool is_capped = false;  //!< the most paths did not meet the tolerance
};

//! As simulate(), with as few paths as the tolerance asks for: those are
//! guessed from a short trial and doubled until the standard error is within
//! the tolerance. The trial has random numbers of its own, of the
//! randomisations that follow, and is not part of the result: else an error
//! that is too small by chance would be likelier to be reported (Stein 1945,
//! doi:10.1214/aoms/1177731088). With equal paths two scenes share all random
//! numbers, and the result is that of simulate() with these paths.
Simulation simulate_to_tolerance(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Sampling& sampling,
    const Randomness& randomness, const Layers& layers = {});

}  // namespace ideotype
