// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/season_days.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/physiology/soil_water.hpp"

namespace ideotype {

//! A day in the soil of a season [mm].
struct SeasonState {
    SeasonDay day{};
    double root_depth = 0;               //!< [m]
    double potential_transpiration = 0;  //!< with open stomata
    double potential_evaporation = 0;    //!< of wet soil below the canopy
    double irrigation = 0;
    SoilFluxes fluxes{};
    SoilWater water{};      //!< in the evening
    double soil_water = 0;  //!< in the evening, water that roots can take up
    double available = 0;   //!< largest soil_water
    Closure closure = 0;    //!< of the stomata of all leaves
};

//! What replaces the program's soil on a day.
struct DayControl {
    std::optional<double> stress{};  //!< transpiration over potential, 0 to 1
    std::optional<double> irrigation{};  //!< [mm]
};

//! Decides about a day, whose fluxes are not known yet; the water is that of
//! the morning.
using ControlDay = std::function<DayControl(const SeasonState&)>;

//! The soil and the grain of growing plants in one scenario. Each stage has
//! computed its fluxes with open stomata and with some others. The days then
//! run in order: the balance of FAO-56 states how much of the potential
//! transpiration the soil supplies, and stomata close until leaves transpire
//! that much, see Closure.
class Season {
  public:
    //! @param scenario a scenario that contains its stages
    Season(const Campaign& campaign, const Case& scenario);

    //! Returns whether soil dries or grain fills.
    bool is_any() const { return !days_.empty(); }

    //! Runs the days of the means over randomisations.
    //! @param stages canopies at all stages, with open stomata
    std::vector<SeasonState> run(const std::vector<LitCanopy>& stages,
                                 const ControlDay& control) const;

    //! The days of the mean over randomisations, and of each randomisation.
    struct Soils {
        std::vector<SeasonState> mean;
        std::vector<std::vector<SeasonState>> by_randomisation;
    };

    //! Closes stomata as the soil dries, in all randomisations as in their
    //! mean. Returns nothing without soil.
    Soils dry(std::vector<LitCanopy>& stages) const;

    //! Adds the season's soil and grain to the reports of its stages.
    //! @param soils result of dry()
    void add_to(const Soils& soils, const std::vector<LitCanopy>& stages,
                std::vector<CanopyReport>& reports) const;

  private:
    struct StageDays;
    std::vector<StageDays> days_of(const std::vector<LitCanopy>& stages) const;
    void add_demand(const std::vector<LitCanopy>& stages,
                    std::vector<StageDays>& days) const;
    std::vector<SeasonState> run(const std::vector<StageDays>& stages,
                                 std::size_t randomisation,
                                 const ControlDay& control) const;
    double irrigate(const SeasonState& state, double& by_depletion) const;
    void add_water(const Soils& soils, const std::vector<StageDays>& stages,
                   std::vector<CanopyReport>& reports) const;
    void add_grain(const std::vector<StageDays>& stages, double stalk,
                   std::vector<CanopyReport>& reports) const;

    const Campaign& campaign_;
    std::vector<SeasonDay> days_{};
    std::optional<Soil> soil_{};
    bool has_grain_;
};

}  // namespace ideotype
