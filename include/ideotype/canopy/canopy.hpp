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
    double geometry = 0;  //!< plant and fields
    double scene = 0;     //!< what the ray tracer builds of them
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
    Estimate all;  //!< leaves and all else
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
    //! All sources together by independent randomisation [J m-2 of ground]:
    //! light.day has their means.
    std::vector<Budget> budget_by_randomisation;
    //! The light of light.groups and light.layers [randomisation, group or
    //! layer]; none if groups are faces.
    std::vector<std::vector<double>> groups_by_randomisation,
        layers_by_randomisation;
    //! The light that falls on fixed objects, per area of a side that absorbs
    //! some: of each object the adaxial side, then the abaxial one.
    std::vector<PartLight> objects;
    //! Parts for each component, then each fixed object, if there are several.
    std::vector<PartReport> parts;
    //! Light that leaves of each row absorb, where rows are told apart
    //! [J m-2 of all ground], and the same by randomisation.
    std::vector<Estimate> rows;
    std::vector<std::vector<double>> rows_by_randomisation;
    //! If asked for, by face of the mesh of one plant of each component and of
    //! objects: what both sides absorb, for the one-sided area of the face
    //! [J m-2 day-1]. That of a plant is a mean over all its copies; in a plot
    //! that is cut some are only there in part.
    std::vector<Estimate> faces;

    //! Returns the light of a component or, in the numbers behind, of a fixed
    //! object.
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
    //! Per ground area: one-sided leaf area, and that and half the surface of
    //! other organs [m2 m-2].
    double lai = 0, plant_area_index = 0;
    bool assimilates = false;
    double ground_per_plant = 0;  //!< all ground over the plants [m2]
};

//! The plants of a row, where rows are told apart.
struct RowReport {
    std::uint32_t component = 0;
    double position = 0;  //!< along x [m]
    double width = 0;     //!< width of the ground that is nearest to it [m]
    double ground = 0;    //!< area of that [m2]
    double lai = 0;       //!< one-sided leaf area per area of all ground
    //! If leaves assimilate, per area of all ground.
    ComponentAssimilation assimilation{};
};

//! The form of a plant, full-grown and without deviations from its line.
struct PlantForm {
    double height = 0;          //!< of its highest point [m]
    double top_leaf_angle = 0;  //!< of the four highest leaves, a mean [deg]
};

//! The result of evaluating one canopy.
struct CanopyReport {
    std::vector<BandReport> bands;  //!< PAR first
    std::vector<ComponentReport> components;
    std::vector<RowReport> rows;  //!< if they are told apart
    std::vector<ObjectReport> objects;
    std::optional<AssimilationReport> assimilation;  //!< if leaves assimilate
    std::optional<WaterReport> water;  //!< if they exchange heat and water
    //! Sunlit leaf area by the first hits that assimilation is made of, in
    //! pieces of leaves.
    std::optional<SunlitReport> hit_by_sun;
    std::optional<LightClassReport> light_classes;  //!< if asked for as well
    std::optional<PlantForm> form;                  //!< if asked for
    std::optional<LineDistance> lines;              //!< if asked for
    std::uint64_t paths = 0;    //!< that the light is the mean of
    bool is_capped = false;     //!< more would be needed to meet the tolerance
    std::vector<Group> groups;  //!< that light was counted for
    Layers layers;
    int days = 1;                 //!< that daily figures are the mean of
    double lai = 0;               //!< one-sided leaf area over ground [m2 m-2]
    double plant_area_index = 0;  //!< with half the surface of other organs
    bool grows = false;           //!< plants grow; this is one stage
    double dead_area_index = 0;   //!< of leaves, per ground area [m2 m-2]
    double assimilating_lai = 0;  //!< leaf area index of leaves that assimilate
    double ground_area = 0;       //!< that all figures refer to [m2]
    Boundary boundary = Boundary::periodic;
    Timing seconds;  //!< if there was a clock

    const BandReport& par() const {
        IDEOTYPE_EXPECT(!bands.empty());
        return bands.front();
    }
    std::size_t randomisations() const {
        return par().budget_by_randomisation.size();
    }
};

//! Tells a time [s].
using Clock = std::function<double()>;

//! Evaluates a canopy, the one way in which it is done: scene -> fields ->
//! light -> assimilation -> report. At least as many paths are traced as there
//! are sources of light.
//! @throws Error if the numbers of leaves differ, a scene cannot be built, or
//! the energy balance does not close.
CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock = {});

//! Builds the surfaces of a field, as its boundary says.
RayScene build_scene(const Device& device, const Field& field);

//! Returns an accuracy with which the light on most faces is known to some 5 %
//! or better, but with no more paths than take about ten seconds.
Accuracy face_accuracy(const Accuracy& accuracy, std::size_t faces);

}  // namespace ideotype
