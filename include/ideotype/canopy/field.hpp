// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/random.hpp"

namespace ideotype {

//! The spacing and the orientation of a lattice of plants on the ground.
struct Spacing {
    double row = 0;    //!< distance between rows [m]
    double plant = 0;  //!< distance between plants of a row [m]
    //! Direction of the rows [deg], clockwise from north; 90 is east-west.
    double row_direction = 90;
    //! Plant density that determines `plant` [m-2]; 0: `plant` is given.
    double density = 0;

    //! Returns the density of plants in these rows [m-2].
    double plants_per_area() const { return 1 / (row * plant); }

    //! Derives `plant` from a density.
    void follow_density() {
        if (density > 0 && row > 0) plant = 1 / (density * row);
    }
};

//! A lattice of plants that is either an infinite periodic field or an isolated
//! plot.
struct FieldForm {
    int rows = 4;
    int plants = 4;  //!< plants per row
    Spacing spacing;
    double jitter = 10;  //!< largest random rotation of a plant [deg]
    PlantVariation variation{};
    Boundary boundary = Boundary::periodic;
    //! Number of rows, and of plants at both ends of each row, that are cut
    //! from all sides of an isolated plot. Parts of the remaining plants beyond
    //! the new edge are cut too.
    int border_rows = 0;
    //! Distances from each row to the next relative to their mean
    //! `spacing.row`, as a repeating pattern. Empty: all distances are equal.
    std::vector<double> row_pattern{};
};

//! Returns the ground cell of a lattice.
//! @throws Error if the borders leave nothing of a plot.
Cell cell_of(const FieldForm& form);

//! Returns the area of the ground that is nearest to each row of a lattice
//! [m2].
std::vector<double> ground_of_rows(const FieldForm& form);

//! Returns the plant positions of a lattice row by row.
//! @param rows rows of the lattice, from 0; empty: all rows
std::vector<Place> places_of(const FieldForm& form,
                             const std::vector<int>& rows = {});

//! Sets the positions of a component's plants in a lattice, and their rotation
//! and variation.
void set_places(Component& component, const FieldForm& form,
                const std::vector<int>& rows = {});

//! Makes a component from one plant in a lattice.
Component component_of(const Plant& plant, const FieldForm& form,
                       const Tessellation& tessellation = {});

//! The plants and objects of a scene on the ground. The mesh may reach beyond
//! the period of the cell.
struct Field {
    Mesh mesh;  //!< surfaces with the groups of groups_of()
    //! The plant that each face belongs to. Plants are numbered component by
    //! component and position by position; positions without a plant are
    //! skipped. Faces of objects store the number of all plants.
    std::vector<std::uint32_t> face_plant;
    //! The first plant of each component, then the number of all plants.
    std::vector<std::uint32_t> first_plant;
    std::vector<std::uint32_t> plant_row{};  //!< row of each plant
    Cell cell;
};

//! Samples the rotation of each plant of a component [deg], position by
//! position: independent and uniform in +-jitter. If the variation specifies a
//! fraction of plants across the row, that fraction is rotated to within 45 deg
//! of across and the other plants to within 45 deg of the row. Both ranges are
//! stratified: each is divided into equal parts with one plant each, in random
//! order. The rotations depend only on seed, generation, first randomisation
//! and component.
//! @param number number of the component
std::vector<double> draw_plant_azimuths(const Component& component,
                                        const Randomness& randomness,
                                        std::uint32_t number = 0);

//! Samples the positions of the plants of each component in a field. Components
//! in rows occupy all their positions, those of a mixture a random subset. Each
//! plant then deviates independently from its position along and across the
//! row. The random numbers are independent of all other variation. A plant that
//! would leave the cell or come close to its neighbour does not deviate.
//! @return positions by component
std::vector<std::vector<Place>> draw_places(const Scene& scene,
                                            const Randomness& randomness);

//! Generates a random field of a scene: the missing and late plants, and the
//! deviation of each plant from its line and its rotation.
//! @param lines meshes to place instead of the components' meshes, with the
//! same faces in different groups; empty: the components' meshes
Field draw_field(const Scene& scene, const Randomness& randomness,
                 std::span<const Mesh> lines = {});

//! Returns a scene in which the plants of a field are fixed: each component
//! becomes one mesh, and no further placement is random. Leaves do not
//! assimilate.
Scene as_drawn(Scene scene, const Field& field);

}  // namespace ideotype
