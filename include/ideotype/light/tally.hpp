// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ideotype/light/resolution.hpp"

namespace ideotype {

//! The parts of the light of one source, by where it went [J m-2 of ground].
struct Budget {
    double leaves = 0;
    double organs = 0;   //!< stalks, sheaths and other organs
    double objects = 0;  //!< fixed objects
    double soil = 0;
    double reflected = 0;
    //! Light that entered: into a plot also from soil around.
    double incident = 0;
    double unscattered = 0;  //!< light of leaves before it met anything else
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
        return leaves + organs + soil + reflected + objects;
    }

  private:
    static constexpr std::array<double Budget::*, 8> parts() {
        return {&Budget::leaves,      &Budget::organs,    &Budget::objects,
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

    //! The light straight from a sun, by triangle of the scene's surfaces.
    std::vector<Part> beam;
    //! The light that is no beam, by piece; a piece may have several parts.
    std::vector<Part> diffuse;
};

//! The light that one randomisation found in one waveband [J m-2 of ground].
struct Tally {
    std::vector<Budget> sources;
    std::vector<double> groups;    //!< absorbed, per group of the mesh
    std::vector<double> layers{};  //!< absorbed by leaves, lowest layer first
    //! Light of pieces by source, if there are pieces.
    std::vector<LeafLight> leaf_light{};
    //! The light absorbed through the faces of leaves: the adaxial (upper) one
    //! is that from which the corners of a face are seen counter-clockwise.
    double adaxial = 0;
    double abaxial = 0;
    //! Light that parts absorb, by source: the adaxial and the abaxial side of
    //! each fixed object, then leaves of each component if there are several.
    std::vector<std::vector<double>> parts{};
    std::uint64_t rays = 0;  //!< number of rays to first hits
    //! Number of rays of light that was scattered.
    std::uint64_t next_rays = 0;
    //! The amounts that the paths can tell; shared by all randomisations of a
    //! simulation.
    std::shared_ptr<const Resolution> resolution{};

    //! Returns the budget of all sources together.
    Budget budget() const {
        Budget sum;
        for (const Budget& budget : sources) sum += budget;
        return sum;
    }

    //! Returns the light that leaves absorb, from all sources.
    double leaves() const { return budget().leaves; }
};

}  // namespace ideotype
