// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/light_classes.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/tolerance.hpp"
#include "water/leaf_air.hpp"

namespace ideotype {

//! The names of bands other than PAR that heat leaves.
inline constexpr auto nir = "nir", longwave = "longwave";

//! The fields of an evaluation, and the sampling of light in each.
struct Plan {
    explicit Plan(const CanopyRequest& request);

    //! Returns the random numbers that generate the plants of a field.
    Randomness of_plants(int field) const;

    //! Returns the random numbers that trace the light in a field.
    Randomness of_light(int field) const {
        return of_field(field, is_one_of_many ? accuracy.randomisations : 1);
    }

    Accuracy accuracy;  //!< accuracy in each field
    int fields = 1;
    //! Whether each field counts as a single randomisation of the result,
    //! although its light is traced in several randomisations.
    bool is_one_of_many = false;

  private:
    Randomness of_field(int field, int times) const;

    Randomness randomness_;
};

//! One plant of each component, from which fields are made.
struct Lines {
    //! @param scene scene of the request, possibly with different groups
    Lines(const Scene& scene, const CanopyRequest& request);

    //! Whether leaves are cut or rows distinguished, so that `pieces` is
    //! filled.
    bool are_cut = false;
    std::vector<Pieces> pieces;  //!< without their meshes
    std::vector<Mesh> meshes;    //!< meshes of the pieces
    std::vector<Group> groups;   //!< groups of the scene before leaves were cut
    //! Leaf area index of each group for plants that do not deviate from their
    //! line; empty if no plants of the scene deviate.
    std::vector<double> leaf_area_index;
    double height = 0;  //!< height of the highest plant [m]
};

//! Returns the bands in which light is traced, see Evaluation.
//! @throws Error if leaf temperature is computed and there is no near infrared.
Bands bands_of(const Scene& scene);

//! The parts of an evaluation that all fields share.
struct Evaluation {
    const CanopyRequest& request;
    //! Scene of the request, possibly with different groups.
    const Scene& scene;
    Plan plan{request};
    Lines lines{scene, request};
    //! The bands of the scene. If leaves exchange heat, the longwave radiation
    //! of the sky is added as a band in which all surfaces are black.
    Bands bands = bands_of(scene);
};

//! Light and assimilation in some fields, by randomisation of all fields. If
//! each field counts as one randomisation, by field. Areas are sums over
//! fields.
struct FieldLight {
    //! Adds the results of more fields.
    void append(FieldLight more);

    BandTallies light;
    //! Light absorbed by leaves of each row, where rows are distinguished [J
    //! m-2 of ground; band, randomisation, row].
    std::vector<std::vector<std::vector<double>>> rows;
    CanopyFluxes fluxes;  //!< fluxes, if leaves assimilate; closed: sums
    //! Leaf area index by layer [m2 m-2].
    std::vector<double> leaf_area_of_layers;
    SunlitFractions sunlit;      //!< sunlit fractions from points on leaves
    SunlitFractions hit_by_sun;  //!< sunlit fractions from first hits
    std::vector<LightClasses> light_classes;
    std::vector<PlantArea> areas;     //!< areas of components [m2 m-2]
    std::vector<LeafArea> leaf_area;  //!< leaf area index by randomisation
    //! Leaf area index by group of the lines.
    std::vector<double> leaf_area_index;
    std::vector<double> areas_of_groups;  //!< area of all copies of a face [m2]
    //! Leaf area index by row and group, where rows are distinguished.
    std::vector<double> areas_of_rows;
    std::uint64_t paths = 0;
    bool is_capped = false;
    Timing seconds;
    int fields = 0;
};

//! The results of the first field that apply to all fields.
struct FirstLook {
    Layers layers{};                  //!< layers with their thickness
    std::vector<LeafGroup> leaves{};  //!< leaves of each group of the lines
    Simulation trial{};  //!< work that the tolerance requires, without tallies
    BoxTree tree{};      //!< tree of boxes for this work
};

//! Evaluations that differ in the photosynthesis of leaves alone, so that their
//! light is traced once. There is at least one.
using Evaluations = std::vector<const Evaluation*>;

//! The first field, by evaluation.
struct FirstField {
    std::vector<FirstLook> looks;
    std::vector<FieldLight> lights;
};

//! Generates the first field of an evaluation and finds the work that the
//! tolerance requires, by trials.
LightWork work_in_first_field(const Evaluation& all, const Device& device);

//! Generates the first field of evaluations and computes its light and
//! assimilation, with as much work as the tolerance requires.
FirstField first_field(const Evaluations& all, const Device& device,
                       const Clock& clock);

//! Generates another field and computes its light and assimilation, by
//! evaluation. The function is pure, so several threads may compute fields at
//! the same time, each with a separate device.
std::vector<FieldLight> light_in_field(const Evaluations& all,
                                       const std::vector<FirstLook>& looks,
                                       int number, const Device& device,
                                       const Clock& clock);

//! Makes the report of an evaluation from the results of its fields.
CanopyReport report_on(const Evaluation& all, const FirstLook& look,
                       const FieldLight& found);

}  // namespace ideotype
