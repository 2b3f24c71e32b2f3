// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/light_classes.hpp"
#include "ideotype/canopy/request.hpp"
#include "ideotype/canopy/season.hpp"
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
    Estimate all;  //!< light on all parts, leaves included
};

//! A fixed object in a canopy.
struct ObjectReport {
    std::string name;
    bool is_panel = false;
    double area_index = 0;  //!< one-sided area per ground area [m2 m-2]
};

//! The light in a canopy in one waveband.
struct BandReport {
    std::string name;
    double soil_albedo = 0;
    DayReport light;
    //! Budget of all light sources together, by independent randomisation [J
    //! m-2 of ground]; light.day contains the means.
    std::vector<Budget> budget_by_randomisation;
    //! The values of light.groups and light.layers by randomisation:
    //! [randomisation, group or layer]. Empty if groups are faces.
    std::vector<std::vector<double>> groups_by_randomisation,
        layers_by_randomisation;
    //! The light incident on fixed objects per area of each side: the adaxial,
    //! then the abaxial side of each object. It is computed from absorbed light
    //! and is 0 for sides that absorb none.
    std::vector<PartLight> objects;
    //! Light absorbed by each component, then by each object, if there are
    //! several.
    std::vector<PartReport> parts;
    //! Light absorbed by the leaves of each row, where rows are distinguished
    //! [J m-2 of all ground]: means, and values by randomisation.
    std::vector<Estimate> rows;
    std::vector<std::vector<double>> rows_by_randomisation;
    //! Light absorbed by both sides of each face per one-sided area of the
    //! face, if requested [J m-2 day-1]. First the faces of one plant of each
    //! component, averaged over all its copies, then the faces of objects. At
    //! the edge of a plot only parts of some copies remain.
    std::vector<Estimate> faces;

    //! Returns the light absorbed by a component. Numbers above those of the
    //! components select fixed objects.
    PartReport part(std::size_t number) const {
        IDEOTYPE_EXPECT(parts.empty() || number < parts.size());
        return parts.empty() ? PartReport{light.day.leaves, light.day.plants}
                             : parts[number];
    }

    //! Returns the light absorbed by the leaves of a component at an hour of
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
    double ground_per_plant = 0;  //!< total ground area per plant [m2]
};

//! The plants of a row, where rows are distinguished.
struct RowReport {
    std::uint32_t component = 0;
    double position = 0;  //!< x coordinate of the row [m]
    double width = 0;     //!< width of the ground nearest to the row [m]
    double ground = 0;    //!< area of the ground nearest to the row [m2]
    double lai = 0;       //!< one-sided leaf area per area of all ground
    //! Assimilation per area of all ground, if leaves assimilate.
    ComponentAssimilation assimilation{};
};

//! The shape of a full-grown plant that does not deviate from its line.
struct PlantForm {
    double height = 0;          //!< height of the plant's highest point [m]
    double top_leaf_angle = 0;  //!< mean angle of the four highest leaves [deg]
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
    //! Parts of the stage in the season's soil and grain, if there are any.
    std::optional<SeasonWater> season_water;
    std::optional<SeasonGrain> season_grain;
    std::optional<SeasonPrices> season_prices;
    //! Sunlit leaf area by piece of leaf, from the same first hits of beams as
    //! assimilation.
    std::optional<SunlitReport> hit_by_sun;
    std::optional<LightClassReport> light_classes;  //!< classes, if asked for
    std::optional<PlantForm> form;      //!< form of the plant, if asked for
    std::optional<LineDistance> lines;  //!< distance from lines, if asked for
    std::uint64_t paths = 0;  //!< number of paths over which light is averaged
    //! The path limit was reached before the tolerance.
    bool is_capped = false;
    std::vector<Group> groups;  //!< groups of the mesh with tallied light
    Layers layers;
    int days = 1;    //!< days over which daily figures are averaged
    double lai = 0;  //!< one-sided leaf area over ground [m2 m-2]
    double plant_area_index = 0;  //!< lai plus half the surface of other organs
    bool grows = false;  //!< whether plants grow; the report is for one stage
    bool has_living_organs = false;  //!< see Scene::has_living_organs()
    double dead_area_index = 0;   //!< area of dead leaves per ground [m2 m-2]
    double assimilating_lai = 0;  //!< leaf area index of assimilating leaves
    //! Leaf area index of the field of each randomisation.
    std::vector<LeafArea> leaf_area_by_randomisation;
    double ground_area = 0;  //!< ground area of all figures [m2]
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

//! Evaluates a canopy, always in the order scene, fields, light, assimilation,
//! report. At least one path is traced per light source.
//! @throws Error if the numbers of leaves differ, a scene cannot be built, or
//! the energy balance does not close.
//! @param threads threads that share the fields after the first one; results
//! are the same for any number
CanopyReport evaluate(const CanopyRequest& request, const Device& device,
                      const Clock& clock = {}, int threads = 1);

//! Finds the work that the tolerance of a request requires, by trials in its
//! first field. Requests for other plants that get this work are traced with
//! the same paths, so that more noise of the light cancels between the plants
//! than with separate trials.
//! @throws Error like evaluate()
LightWork find_work(const CanopyRequest& request, const Device& device);

//! A canopy after its light and fluxes have been computed, and before they are
//! reported: stomata may still close under stress.
class LitCanopy {
  public:
    //! Computes light and fluxes as evaluate() does.
    LitCanopy(CanopyRequest request, const Device& device,
              const Clock& clock = {}, int threads = 1);
    //! Computes canopies that differ in the photosynthesis of leaves alone.
    //! Their light is traced once; results are those of each canopy, bit for
    //! bit.
    //! @param requests requests with the same plants, light, accuracy and
    //! random numbers; at least one
    static std::vector<LitCanopy> sharing_light(
        std::vector<CanopyRequest> requests, const Device& device,
        const Clock& clock = {}, int threads = 1);

    LitCanopy(LitCanopy&&) noexcept;
    ~LitCanopy();

    const Scene& scene() const;
    const CanopyFluxes& fluxes() const;

    //! Returns PAR and near infrared on the soil over those above the canopy,
    //! where they are traced [randomisation][date of LightSeries::dates()]. It
    //! includes light that is reflected several times.
    std::vector<std::vector<double>> light_on_soil() const;

    //! Closes stomata, which must be open, see close_stomata().
    //! @param closures by step
    void close_stomata(const std::vector<Closure>& closures);

    CanopyReport report() const;

  private:
    struct Parts;
    explicit LitCanopy(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

//! Builds the surfaces of a field, with the field's boundary.
RayScene build_scene(const Device& device, const Field& field,
                     BoxTree tree = BoxTree::by_area);

//! Returns an accuracy that determines the light on most faces to about 5 % or
//! better. Tracing its paths takes about ten seconds at most.
Accuracy face_accuracy(const Accuracy& accuracy, std::size_t faces);

}  // namespace ideotype
