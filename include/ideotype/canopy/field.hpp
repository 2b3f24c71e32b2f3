// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/random.hpp"

namespace ideotype {

//! The distances and the direction of a lattice of plants on the ground.
struct Spacing {
    double row = 0;    //!< distance between rows [m]
    double plant = 0;  //!< distance between plants of a row [m]
    //! Direction of the rows [deg], clockwise from north; 90 is east-west.
    double row_direction = 90;
    //! Plants per ground area that sets `plant` [m-2]; 0: `plant` is given.
    double density = 0;
};

//! A lattice of plants, which repeats without end or is a plot alone.
struct FieldForm {
    int rows = 4;
    int plants = 4;  //!< plants per row
    Spacing spacing;
    double jitter = 10;  //!< largest random turn of a plant [deg]
    PlantVariation variation{};
    Boundary boundary = Boundary::periodic;
    //! Rows, and plants of each row, that are cut away on all sides of an
    //! isolated plot; parts of other plants beyond the new edge are cut too.
    int border_rows = 0;
    //! Distances from each row to the next, relative to their mean
    //! `spacing.row`, as a pattern that repeats. Empty: all distances are
    //! equal.
    std::vector<double> row_pattern{};
};

//! Returns the ground of a lattice.
//! @throws Error if nothing is left of a plot.
Cell cell_of(const FieldForm& form);

//! Returns the area of the ground that is nearest to each row of a lattice
//! [m2].
std::vector<double> ground_of_rows(const FieldForm& form);

//! Returns the places of a lattice row by row.
//! @param rows rows of the lattice, from 0; empty: all rows
std::vector<Place> places_of(const FieldForm& form,
                             const std::vector<int>& rows = {});

//! Sets the places of a component in a lattice, and how the component's plants
//! turn and differ there.
void set_places(Component& component, const FieldForm& form,
                const std::vector<int>& rows = {});

//! Makes a component of one plant in a lattice.
Component component_of(const Plant& plant, const FieldForm& form,
                       const Tessellation& tessellation = {});

//! The plants and objects of a scene on the ground. The mesh may reach beyond
//! the period of the cell.
struct Field {
    Mesh mesh;  //!< surfaces with groups_of() the scene
    //! The plant that each face belongs to; plants are counted component by
    //! component and place by place, leaving out places where plants are
    //! missing. Faces of objects have the number of all plants.
    std::vector<std::uint32_t> face_plant;
    //! The first plant of each component, then the number of all plants.
    std::vector<std::uint32_t> first_plant;
    std::vector<std::uint32_t> plant_row{};  //!< row of each plant
    Cell cell;
};

//! Draws the turn of each plant of a component [deg], place by place:
//! independent, and uniform in +-jitter. If the variation gives a fraction of
//! plants across the row, that fraction is turned within 45 deg of across and
//! the other plants within 45 deg of the row, one plant in each of equal parts
//! of these ranges, in random order. The turns are a function of seed,
//! generation, first randomisation and component.
//! @param number number of the component
std::vector<double> draw_plant_azimuths(const Component& component,
                                        const Randomness& randomness,
                                        std::uint32_t number = 0);

//! Draws where the plants of each component stand in a field. Components in
//! rows have all of their places, those of a mixture a random part. Plants then
//! deviate from their places along and across the row, each by itself, and by
//! random numbers that depend on no other variation. A plant that leaves the
//! cell or comes close to its neighbour stays there.
//! @return places by component
std::vector<std::vector<Place>> draw_places(const Scene& scene,
                                            const Randomness& randomness);

//! Draws a field of a scene: which plants are missing or late, how each plant
//! differs from its line and how it is turned.
//! @param lines meshes to place instead of the components' meshes, with the
//! same faces in other groups; empty: the components' meshes
Field draw_field(const Scene& scene, const Randomness& randomness,
                 std::span<const Mesh> lines = {});

//! Returns a scene in which the plants of a field are fixed: each component
//! becomes one mesh, and no further placement is random. Leaves do not
//! assimilate.
Scene as_drawn(Scene scene, const Field& field);

}  // namespace ideotype
