// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/light_classes.hpp"
#include "ideotype/canopy/request.hpp"
#include "ideotype/canopy/water.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/report.hpp"

namespace ideotype {

class Device;

//! The time that an evaluation took [s].
struct Timing {
    double geometry = 0;  //!< time for plants and fields
    double scene = 0;     //!< time for the ray tracer's scene
    double light = 0;

    double total() const { return geometry + scene + light; }

    Timing& operator+=(const Timing& more) {
        geometry += more.geometry;
        scene += more.scene;
        light += more.light;
        return *this;
    }
};

//! The light that a component or a fixed object absorbs [J m-2 day-1].
struct PartReport {
    Estimate leaves;
    Estimate all;  //!< light on leaves and other parts
};

//! A fixed object in a canopy.
struct ObjectReport {
    std::string name;
    bool is_panel = false;
    double area_index = 0;  //!< one-sided area per ground area [m2 m-2]
};

//! The light of one waveband in a canopy.
struct BandReport {
    std::string name;
    double soil_albedo = 0;
    DayReport light;
    //! Light of all sources together by independent randomisation [J m-2 of
    //! ground]; light.day has the means.
    std::vector<Budget> budget_by_randomisation;
    //! Light of light.groups and light.layers [randomisation, group or layer];
    //! empty if groups are faces.
    std::vector<std::vector<double>> groups_by_randomisation,
        layers_by_randomisation;
    //! The light that falls on fixed objects, per area of a side that absorbs
    //! some light: the adaxial, then the abaxial side of each object.
    std::vector<PartLight> objects;
    //! Light of each component, then of each object, if there are several.
    std::vector<PartReport> parts;
    //! Light that leaves of each row absorb, where rows are distinguished [J
    //! m-2 of all ground], as means and by randomisation.
    std::vector<Estimate> rows;
    std::vector<std::vector<double>> rows_by_randomisation;
    //! The light that both sides of each face absorb, if asked for, per
    //! one-sided area of the face [J m-2 day-1]: faces of one plant of each
    //! component, as means over all its copies, then faces of objects. In a
    //! plot that is cut some copies are there only in part.
    std::vector<Estimate> faces;

    //! Returns the light of a component or, with a number above those of
    //! components, of a fixed object.
    PartReport part(std::size_t number) const {
        IDEOTYPE_EXPECT(parts.empty() || number < parts.size());
        return parts.empty() ? PartReport{light.day.leaves, light.day.plants}
                             : parts[number];
    }

    //! Returns the light that leaves of a component absorb at an hour of
    //! LightSeries::hours() [W m-2].
    Estimate leaves_at(std::size_t component, std::size_t hour) const {
        IDEOTYPE_EXPECT(hour < light.steps.size());
        const std::size_t part = objects.size() + component;
        return part < light.parts.size() ? light.parts[part].hours[hour]
                                         : light.steps[hour].budget.leaves;
    }
};

//! The plants of a component in a canopy.
struct ComponentReport {
    std::string name;
    //! One-sided leaf area per ground area, and leaf area plus half the surface
    //! of other organs per ground area [m2 m-2].
    double lai = 0, plant_area_index = 0;
    bool assimilates = false;
    double ground_per_plant = 0;  //!< all ground over all plants [m2]
};

//! The plants of a row, where rows are distinguished.
struct RowReport {
    std::uint32_t component = 0;
    double position = 0;  //!< place of the row along x [m]
    double width = 0;     //!< width of the ground nearest to the row [m]
    double ground = 0;    //!< area of the ground nearest to the row [m2]
    double lai = 0;       //!< one-sided leaf area per area of all ground
    //! Assimilation per area of all ground, if leaves assimilate.
    ComponentAssimilation assimilation{};
};

//! The form of a plant, full-grown and without deviations from its line.
struct PlantForm {
    double height = 0;          //!< height of the highest point [m]
    double top_leaf_angle = 0;  //!< mean of the four highest leaves [deg]
};

//! Leaf area index [m2 m-2].
struct LeafArea {
    double all = 0, assimilating = 0;
};

//! The result of evaluating one canopy.
struct CanopyReport {
    std::vector<BandReport> bands;  //!< reports of the bands, PAR first
    std::vector<ComponentReport> components;
    std::vector<RowReport> rows;  //!< rows, if distinguished
    std::vector<ObjectReport> objects;
    std::optional<AssimilationReport> assimilation;  //!< assimilation, if any
    std::optional<WaterReport> water;  //!< water, if leaves exchange water
    //! Sunlit leaf area in pieces of leaves, from the first hits of beams that
    //! assimilation is computed from.
    std::optional<SunlitReport> hit_by_sun;
    std::optional<LightClassReport> light_classes;  //!< classes, if asked for
    std::optional<PlantForm> form;      //!< form of the plant, if asked for
    std::optional<LineDistance> lines;  //!< distance from lines, if asked for
    std::uint64_t paths = 0;            //!< paths over which light is averaged
    bool is_capped = false;             //!< too few paths for the tolerance
    std::vector<Group> groups;          //!< groups with counted light
    Layers layers;
    int days = 1;    //!< days over which daily figures are averaged
    double lai = 0;  //!< one-sided leaf area over ground [m2 m-2]
    double plant_area_index = 0;  //!< lai and half the surface of other organs
    bool grows = false;           //!< whether plants grow; this is one stage
    bool has_living_organs = false;  //!< see Scene::has_living_organs()
    double dead_area_index = 0;   //!< area of dead leaves per ground [m2 m-2]
    double assimilating_lai = 0;  //!< leaf area index of assimilating leaves
    //! Leaf area index of the field of each randomisation.
    std::vector<LeafArea> leaf_area_by_randomisation;
    double ground_area = 0;  //!< ground of all figures [m2]
    Boundary boundary = Boundary::periodic;
    Timing seconds;  //!< durations, if there was a clock

    const BandReport& par() const {
        IDEOTYPE_EXPECT(!bands.empty());
        return bands.front();
    }
    std::size_t randomisations() const {
        return par().budget_by_randomisation.size();
    }
};

//! Returns the present time [s].
using Clock = std::function<double()>;

//! Evaluates a canopy, always as scene -> fields -> light -> assimilation ->
//! report. At least as many paths are traced as there are sources of light.
//! @throws Error if the numbers of leaves differ, a scene cannot be built, or
//! the energy balance does not close.
//! @param threads threads that share the fields after the first one; results
//! are the same for any number
CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock = {}, int threads = 1);

//! Builds the surfaces of a field, with the field's boundary.
RayScene build_scene(const Device& device, const Field& field);

//! Returns an accuracy with which the light on most faces is known to some 5 %
//! or better, with paths that take about ten seconds at most.
Accuracy face_accuracy(const Accuracy& accuracy, std::size_t faces);

}  // namespace ideotype
