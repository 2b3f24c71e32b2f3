// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ideotype/canopy/water.hpp"
#include "ideotype/physiology/leaf_exchange.hpp"
#include "leaf_places.hpp"

namespace ideotype {

//! The air among the leaves of a canopy over that above it.
struct CanopyAir {
    double warmer = 0;   //!< [K]
    double moister = 0;  //!< vapour pressure [kPa]
};

//! The light besides PAR that leaves of a field absorb.
struct OtherLight {
    const Band& band;
    const std::vector<Tally>& tallies;  //!< with leaf light
};

//! The leaves of a canopy that exchange heat and water.
struct WaterLeaves {
    const Scene& scene;                    //!< with water
    const std::vector<LeafGroup>& leaves;  //!< of each group of plants
    const std::vector<Group>& groups;      //!< of plants
    const std::vector<double>& widths;     //!< of their blades [m]
    double height;                         //!< of the canopy [m]
    std::optional<OtherLight> nir{}, longwave{};
};

//! The wind at the top of a canopy [m s-1], by logarithmic profiles above short
//! grass, where wind is measured, up to 10 m, and from there down to a canopy
//! of displacement height 0.67 h and roughness 0.1 h (Campbell and Norman
//! 1998; Allen et al. 1998, FAO 56, equation 47). Winds below what anemometers
//! notice count as 0.3 m s-1.
//! @param wind [m s-1] at a height [m]
//! @param canopy height h [m]
double wind_at_top(double wind, double height, double canopy);

//! The aerodynamic resistance from a canopy to 10 m above the ground [s m-1],
//! ln((z - d) / z0)^2 / (0.41^2 u), without the effect of stability.
double aerodynamic_resistance(double wind, double height, double canopy);

//! The exchange of leaves with the air in a field, step by step.
class LeafAir {
  public:
    //! A part of the leaves at a place.
    struct Point {
        std::size_t place;
        double ppfd;    //!< absorbed [umol m-2 s-1]
        double cosine;  //!< of the beam on it, see PairLight::Bin; 0: shaded
        double area;    //!< index [m2 m-2]
    };

    //! @param air of each step, in which several fields share it; empty before
    //! the first, which finds it
    LeafAir(const WaterLeaves& leaves,
            std::vector<std::optional<CanopyAir>>& air);

    //! Takes what places have that no step changes.
    void see(const LeafPlaces& places, const ExpectedLight& expectation);

    //! Takes the light of a sun and a sky that steps share; -1: none.
    void meet(int beam, int sky);

    //! The points whose exchange is asked for.
    std::vector<Point>& points() { return points_; }

    //! Finds the exchange of all points in a step.
    void exchange(std::size_t step);

    //! Finds the exchange of all points in a step without light, in which those
    //! of a leaf are taken as alike.
    void exchange_at_night(std::size_t step);

    //! Returns a flux of a point, per area of leaf.
    const Expansion& flux(std::size_t kind, std::size_t point) const {
        return found_[point][kind];
    }

  private:
    struct Place {
        std::uint32_t group = 0;  //!< of plants
        double view = 0;          //!< of the sky, by both faces together
        double wind = 1;          //!< over that at the top
        double nir_of_sun = 0, nir_of_sky = 0;  //!< [J m-2 of leaf]
        double nir_absorptance = 0;
    };
    //! The air of a step above the canopy.
    struct Above {
        LeafSurroundings air;  //!< without light, of a leaf at the top
        double vapour = 0;     //!< pressure [kPa]
        double sky = 0;        //!< longwave radiation [W m-2]
        double nir_of_sun = 0, nir_of_sky = 0, nir_beam = 0;
    };

    //! A leaf in the air of a step.
    struct LeafInAir {
        ThermalLeaf leaf;
        LeafResponse response;   //!< at the temperature of the air above
        double respiration = 0;  //!< at that, in the dark [umol m-2 s-1]
        double width = 0;        //!< of its blade [m]
    };

    Above above(std::size_t step, const Photosynthesis& photosynthesis) const;
    LeafInAir leaf_in(const Above& above, std::uint32_t group) const;
    void exchange_in(std::size_t step, const CanopyAir& air);
    CanopyAir canopy_air(std::size_t step);
    std::vector<std::size_t> join_points();
    std::array<Expansion, leaf_fluxes> of_own_temperature(
        const Point& point, const LeafInAir& leaf, const Above& above,
        LeafSurroundings around);
    std::array<Expansion, leaf_fluxes> of_air_temperature(
        const Point& point, const LeafInAir& leaf,
        const LeafSurroundings& around) const;

    const WaterLeaves leaves_;
    const LeafWater& water_;
    const LightSeries& series_;
    const bool has_canopy_air_;
    std::vector<std::optional<CanopyAir>>& air_;
    const LeafPlaces* places_ = nullptr;
    const ExpectedLight* expectation_ = nullptr;
    std::vector<Place> at_;
    int beam_ = -1, sky_ = -1;
    std::vector<Point> points_;
    std::optional<LeafExchange> last_;  //!< the exchange of the point before
    std::vector<std::array<Expansion, leaf_fluxes>> found_;
};

}  // namespace ideotype
