// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ideotype/light/resolution.hpp"

namespace ideotype {

//! The light of one source, divided by the kind of surface that absorbs it [J
//! m-2 of ground].
struct Budget {
    double leaves = 0;
    double organs = 0;   //!< absorbed by stalks, sheaths and other organs
    double objects = 0;  //!< absorbed by fixed objects
    double soil = 0;
    double reflected = 0;
    //! The light that entered; for a plot, this includes light from the
    //! surrounding soil.
    double incident = 0;
    double unscattered = 0;  //!< light that leaves absorb before any scattering
    double sent_on = 0;      //!< light scattered at the first surface

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

//! The light of one source absorbed by pieces of leaves [J m-2 of ground].
struct LeafLight {
    struct Part {
        std::uint32_t place;
        double energy;
    };

    //! The light directly from a sun, by triangle of the scene's surfaces.
    std::vector<Part> beam;
    //! Diffuse and scattered light by piece; a piece may have several entries.
    std::vector<Part> diffuse;
};

//! The light of one randomisation in one waveband [J m-2 of ground].
struct Tally {
    std::vector<Budget> sources;
    std::vector<double> groups;  //!< light absorbed by each group of the mesh
    std::vector<double>
        layers{};  //!< light absorbed by leaves, lowest layer first
    //! The light of pieces of leaves by source; empty without pieces.
    std::vector<LeafLight> leaf_light{};
    //! The light absorbed through each side of leaves. The corners of a face
    //! are counter-clockwise seen from its adaxial (upper) side.
    double adaxial = 0;
    double abaxial = 0;
    //! The light [part][source]. Parts are the adaxial and the abaxial side of
    //! each fixed object, followed by the leaves of each component if there are
    //! several.
    std::vector<std::vector<double>> parts{};
    std::uint64_t rays = 0;  //!< number of rays up to first hits
    //! The number of rays of scattered light.
    std::uint64_t next_rays = 0;
    //! Lower bounds on errors set by the number of paths, shared by all
    //! randomisations of a simulation.
    std::shared_ptr<const Resolution> resolution{};

    //! Returns the budget of all sources together.
    Budget budget() const {
        Budget sum;
        for (const Budget& budget : sources) sum += budget;
        return sum;
    }

    //! Returns the light from all sources that leaves absorb.
    double leaves() const { return budget().leaves; }
};

}  // namespace ideotype
