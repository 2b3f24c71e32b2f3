// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ideotype/light/resolution.hpp"

namespace ideotype {

//! Where the light of one source went [J m-2 of ground].
struct Budget {
    double leaves = 0;
    double stalks = 0;   //!< and sheaths and all other organs
    double objects = 0;  //!< fixed objects
    double soil = 0;
    double reflected = 0;
    double incident = 0;  //!< that entered: into a plot also from soil around
    double unscattered = 0;  //!< of leaves: before it met anything else
    double sent_on = 0;      //!< scattered by what was met first

    Budget& operator+=(const Budget& more) {
        for (double Budget::*part : parts()) this->*part += more.*part;
        return *this;
    }
    Budget& operator*=(double factor) {
        for (double Budget::*part : parts()) this->*part *= factor;
        return *this;
    }

    bool operator==(const Budget&) const = default;

    double total() const {
        return leaves + stalks + soil + reflected + objects;
    }

  private:
    static constexpr std::array<double Budget::*, 8> parts() {
        return {&Budget::leaves,      &Budget::stalks,    &Budget::objects,
                &Budget::soil,        &Budget::reflected, &Budget::incident,
                &Budget::unscattered, &Budget::sent_on};
    }
};

//! The light of one source that pieces of leaves absorb [J m-2 of ground].
struct LeafLight {
    struct Part {
        std::uint32_t place;
        double energy;
    };

    //! Straight from a sun, by triangle of the scene's surfaces.
    std::vector<Part> beam;
    //! All other light, by piece; a piece may have several parts.
    std::vector<Part> diffuse;
};

//! The light that one randomisation found in one waveband [J m-2 of ground].
struct Tally {
    std::vector<Budget> sources;
    std::vector<double> groups;    //!< absorbed, per group of the mesh
    std::vector<double> layers{};  //!< absorbed by leaves, lowest layer first
    std::vector<LeafLight> leaf_light{};  //!< by source, if there are pieces
    //! Absorbed through the faces of leaves: the adaxial (upper) one is that
    //! from which the corners of a face are seen counter-clockwise.
    double adaxial = 0;
    double abaxial = 0;
    //! Absorbed by fixed objects, by source: of each object the adaxial side,
    //! then the abaxial one.
    std::vector<std::vector<double>> objects{};
    std::uint64_t rays = 0;       //!< to first hits
    std::uint64_t next_rays = 0;  //!< of light that was scattered
    //! What its paths can tell; shared by all randomisations of a simulation.
    std::shared_ptr<const Resolution> resolution{};

    //! Of all sources together.
    Budget budget() const {
        Budget sum;
        for (const Budget& budget : sources) sum += budget;
        return sum;
    }

    //! Absorbed by leaves, from all sources.
    double leaves() const { return budget().leaves; }
};

}  // namespace ideotype
