// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/crop/plant_variation.hpp"
#include "ideotype/light/boundary.hpp"

namespace ideotype {

//! How a lattice of plants lies on the ground.
struct Spacing {
    double row = 0;    //!< between rows [m]
    double plant = 0;  //!< between plants of a row [m]
    //! Direction of the rows [deg], clockwise from north; 90 is east-west.
    double row_direction = 90;
};

//! A lattice of plants, which repeats without end or is a plot alone.
struct FieldForm {
    int rows = 4;
    int plants = 4;  //!< per row
    Spacing spacing;
    double jitter = 10;  //!< largest random turn of a plant [deg]
    PlantVariation variation{};
    Boundary boundary = Boundary::periodic;
    //! Rows, and plants of each row, that are cut away on all sides of an
    //! isolated plot, with whatever of the others hangs over its edge.
    int border_rows = 0;

    std::size_t count() const {
        return static_cast<std::size_t>(rows) *
               static_cast<std::size_t>(plants);
    }
};

//! Plants on the ground, in axes of their own: x across the rows, y along the
//! rows, z up, soil at z = 0. The mesh may reach beyond the period.
struct Field {
    Mesh mesh;
    //! The plant that each face is of; plants are counted row by row, without
    //! places where one is missing.
    std::vector<std::uint32_t> face_plant;
    Boundary boundary = Boundary::periodic;
    double period_x = 0;     //!< rows x row spacing, if periodic [m]
    double period_y = 0;     //!< plants x plant spacing, if periodic [m]
    double ground_area = 0;  //!< that belongs to the plants [m2]
};

//! The turn of each plant [deg], row by row: independent, and uniform in
//! +-jitter. Where the variation tells how many plants stand across the row, so
//! many are within 45 deg of that and the others within 45 deg of the row, one
//! in each of equal parts of these ranges, in random order. A function of seed,
//! generation and first randomisation.
std::vector<double> draw_plant_azimuths(const FieldForm& form,
                                        const Randomness& randomness);

//! Places a turned plant at every lattice point. turns has one entry per
//! plant. Groups are those of the first plant.
//! @param plants one that all are copies of, or one for each point, without
//! faces where a plant is missing
//! @throws Error if the number of turns is not rows x plants, or nothing is
//! left of a plot.
Field build_field(std::span<const Mesh> plants, const FieldForm& form,
                  const std::vector<double>& turns);

//! The same with copies of one plant.
Field build_field(const Mesh& plant, const FieldForm& form,
                  const std::vector<double>& turns);

//! The same with turns that are drawn.
Field draw_field(const Mesh& plant, const FieldForm& form,
                 const Randomness& randomness);

//! The same with plants that differ by the variation of the form, which are
//! drawn too.
//! @param mesh the plant without deviations; the faces of all have its groups
Field draw_field(const Plant& plant, const Mesh& mesh,
                 const Tessellation& tessellation, const FieldForm& form,
                 const Randomness& randomness);

}  // namespace ideotype
