#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/core/mesh.hpp"
#include "ideotype/crop/plant.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/report.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! All that an evaluation needs to know besides a plant's traits and random
//! numbers: what the plant is made of, how it stands, and what lights it.
struct CanopyModel {
    PlantForm plant;
    Tessellation tessellation;
    FieldForm field;
    DayIllumination light;  //!< in the axes of the field
    Optics optics;
    Layers layers;  //!< in which the light that leaves absorb is counted
};

//! Which random numbers an estimate uses, and how many.
struct Draws {
    std::uint64_t seed = 0;
    std::uint32_t generation = 0;
    Accuracy sampling;
    //! One field for all randomisations makes candidates comparable at least
    //! cost; a new one for each makes the standard error include the jitter.
    enum class Fields { one, each } fields = Fields::one;
};

//! traits -> plant, lowest leaf first.
Mesh build_plant(const CanopyModel& model,
                 const std::vector<LeafTraits>& traits);

//! plant -> field, with the turns of one draw.
Field build_field(const CanopyModel& model, const Mesh& plant,
                  const Draws& draws, std::uint32_t draw);

//! The surfaces of a field, as its boundary says.
Scene build_scene(const Device& device, const Field& field);

//! Visits the fields of an estimate one by one, each with the part of the
//! sampling that falls to it and its random numbers.
void for_each_field(const CanopyModel& model, const Mesh& plant,
                    const Draws& draws,
                    const std::function<void(const Field&, const Accuracy&,
                                             const Randomness&)>& visit);

//! What light does in one canopy.
struct CanopyReport {
    DayReport light;
    //! What all leaves absorb, by independent randomisation
    //! [J m-2 of ground]: light.day.leaves is its mean.
    std::vector<double> leaves_by_randomisation;
    std::uint64_t paths = 0;    //!< that the light is the mean of
    bool is_capped = false;     //!< more would be needed to meet the tolerance
    std::vector<Group> groups;  //!< that light was counted for
    Layers layers;
    double lai = 0;          //!< one-sided leaf area over ground [m2 m-2]
    double ground_area = 0;  //!< that all figures refer to [m2]
    Boundary boundary = Boundary::periodic;
};

//! Enough points to know a sunlit fraction to some 0.2 %.
Accuracy sunlit_sampling(const Accuracy& sampling);

//! The sunlit leaf area costs more rays and changes no fitness: histories go
//! without it.
enum class Detail { history, full };

//! traits -> plant -> fields -> light -> report.
//! @throws Error if the numbers of leaves differ, or the energy balance does
//! not close.
CanopyReport study(const CanopyModel& model, const Device& device,
                   const std::vector<LeafTraits>& traits, const Draws& draws,
                   Detail detail);

}  // namespace ideotype
