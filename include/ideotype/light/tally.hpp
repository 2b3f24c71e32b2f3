// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ideotype/light/resolution.hpp"

namespace ideotype {

//! The parts of the light of one source, by the place where they end [J m-2 of
//! ground].
struct Budget {
    double leaves = 0;
    double organs = 0;   //!< light of stalks, sheaths and other organs
    double objects = 0;  //!< light of fixed objects
    double soil = 0;
    double reflected = 0;
    //! The light that entered; in a plot also from the soil around it.
    double incident = 0;
    double unscattered = 0;  //!< light that leaves absorb before any scattering
    double sent_on = 0;      //!< light that the first surface has scattered

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
    //! The light without beams, by piece; a piece may have several parts.
    std::vector<Part> diffuse;
};

//! The light of one randomisation in one waveband [J m-2 of ground].
struct Tally {
    std::vector<Budget> sources;
    std::vector<double> groups;  //!< absorbed light per group of the mesh
    std::vector<double>
        layers{};  //!< light that leaves absorb, lowest layer first
    //! The light of pieces of leaves by source, if there are pieces.
    std::vector<LeafLight> leaf_light{};
    //! The light absorbed through the faces of leaves: the corners of a face
    //! are counter-clockwise seen from its adaxial (upper) side.
    double adaxial = 0;
    double abaxial = 0;
    //! The light by part and source: the adaxial and the abaxial side of each
    //! fixed object, then leaves of each component if there are several.
    std::vector<std::vector<double>> parts{};
    std::uint64_t rays = 0;  //!< number of rays to first hits
    //! The number of rays of scattered light.
    std::uint64_t next_rays = 0;
    //! The least errors that the paths allow, shared by all randomisations of a
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
