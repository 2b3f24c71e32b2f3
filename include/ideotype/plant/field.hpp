#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Distance between neighbours.
struct Spacing {
    double row = 0;    //!< between rows [m]
    double plant = 0;  //!< between plants of a row [m]
};

//! A lattice of plants that repeats without end.
struct FieldForm {
    int rows = 6;
    int plants = 6;  //!< per row
    Spacing spacing;
    //! Direction of the rows [deg], clockwise from north; 90 is east-west.
    double row_direction = 90;
    double jitter = 10;  //!< largest random turn of a plant [deg]
};

//! One period of an infinite stand, in its own axes: x across the rows, y
//! along the rows, z up, soil at z = 0. The mesh may reach beyond the period.
struct Field {
    Mesh mesh;
    double period_x = 0;       //!< rows x row spacing [m]
    double period_y = 0;       //!< plants x plant spacing [m]
    double row_direction = 0;  //!< of the y axis, clockwise from north [deg]

    double ground_area() const { return period_x * period_y; }  //!< [m2]
};

//! The turn of each plant [deg], row by row: independent and uniform in
//! +-jitter, a function of seed, generation and draw.
std::vector<double> draw_turns(const FieldForm& form, std::uint64_t seed,
                               std::uint32_t generation, std::uint32_t draw);

//! Places a turned copy of the plant at every lattice point. turns has one
//! entry per plant. Groups are those of the plant.
//! @throws Error if the number of turns is not rows x plants.
Field build_field(const Mesh& plant, const FieldForm& form,
                  const std::vector<double>& turns);

}  // namespace ideotype
