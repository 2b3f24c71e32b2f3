// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ideotype/canopy/water.hpp"
#include "ideotype/core/random.hpp"
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
    Randomness randomness;                 //!< of the light in the field
    std::optional<OtherLight> nir{}, longwave{};
    //! Points whose balance is solved in all steps together, or more.
    double points = 6000;
};

//! The exchange of points of leaves with the air in a field, step by step.
class LeafAir {
  public:
    //! A part of the leaves at a place.
    struct Point {
        std::size_t place = 0;
        double ppfd = 0;  //!< absorbed [umol m-2 s-1]
        double cosine =
            0;  //!< of the beam on it, see PairLight::Bin; 0: shaded
        Expansion
            gross{};  //!< assimilation at the temperature of the air above
    };

    //! The fluxes of a point, per area of leaf.
    using Fluxes = std::array<Expansion, leaf_fluxes>;

    explicit LeafAir(const WaterLeaves& leaves);

    const WaterLeaves& leaves() const { return leaves_; }

    //! Tells whether leaves have a temperature of their own.
    bool warms() const { return water_.has_leaf_temperature; }

    //! Takes what places have that no step changes.
    void see(const LeafPlaces& places, const ExpectedLight& expectation);

    //! Returns the class of a group: leaves of one component whose ranks are
    //! neighbours.
    std::uint32_t class_of(std::uint32_t group) const { return class_[group]; }

    //! Returns how many classes there are.
    std::size_t classes() const { return means_.size(); }

    //! Returns the group with the largest leaf area of a class; none if no
    //! leaves of it assimilate.
    std::optional<std::uint32_t> largest_of(std::uint32_t number) const {
        return means_[number].largest;
    }

    //! Returns a place that has the means of those of a class, in the largest
    //! of its groups.
    std::size_t mean_place(std::uint32_t number) const {
        return places_->count() + number;
    }

    //! Takes the light of a sun and a sky that steps share; -1: none.
    void meet(int beam, int sky);

    //! Begins a step, in the air above the canopy.
    void begin(std::size_t step);

    //! Takes the air among the leaves in the step.
    void set_air(const CanopyAir& air);

    //! Returns how warm a leaf at the top is over which it is hot [K].
    double hot_over_air(std::uint32_t group) const;

    //! Returns the air that leaves drive by the heat and the water that they
    //! lose [W m-2, mmol m-2 s-1]; that above if there is no canopy air.
    //! @param group of some of the leaves
    CanopyAir driven_by(std::uint32_t group, double heat, double water) const;

    //! Returns what is around a point of leaves that have a temperature of
    //! their own.
    LeafSurroundings around(const Point& point) const;

    //! Solves a point.
    //! @param like a point in about the same light and air; null: none
    LeafExchange solve(const Point& point, const LeafExchange* like) const;

    //! Returns the fluxes of a point that was solved.
    Fluxes fluxes_of(const LeafExchange& found, const Point& point) const;

  private:
    struct Place {
        std::uint32_t group = 0;  //!< of plants
        double view = 0;          //!< of the sky, by both faces together
        double wind = 1;          //!< over that at the top
        double nir_of_sun = 0, nir_of_sky = 0;  //!< [J m-2 of leaf]
        double nir_absorptance = 0;
    };
    //! The light and the wind of a step, for all leaves.
    struct Sky {
        double longwave = 0;  //!< [W m-2]
        double wind = 0;      //!< at the top [m s-1]
        double nir_of_sun = 0, nir_of_sky = 0, nir_beam = 0;
    };
    //! The leaves of a group in the air of a step.
    struct Leaf {
        ThermalLeaf leaf;
        LeafSurroundings above;     //!< without light, of a leaf at the top
        double vapour = 0;          //!< pressure there [kPa]
        double respiration = 0;     //!< in the dark [umol m-2 s-1]
        LeafSurroundings within{};  //!< the canopy, at the top
        double black = 0;           //!< radiation of a body as warm [W m-2]
    };

    //! Leaves of a class.
    struct Mean {
        double area = 0;  //!< index
        std::optional<std::uint32_t> largest{};
    };

    void find_classes();
    Leaf leaf_in(std::size_t step, std::uint32_t group) const;
    void take_means(std::initializer_list<double Place::*> parts);

    const WaterLeaves leaves_;
    const LeafWater& water_;
    const LightSeries& series_;
    const LeafPlaces* places_ = nullptr;
    const ExpectedLight* expectation_ = nullptr;
    std::vector<Place> at_;      //!< of places, and then means of classes
    std::vector<double> index_;  //!< leaf area index of groups
    std::vector<std::uint32_t> class_;  //!< of groups
    std::vector<Mean> means_;           //!< of classes
    int beam_ = -1, sky_ = -1;
    Sky light_;
    double resistance_ = 0;  //!< from the canopy to the air above [s m-1]
    std::vector<std::optional<Leaf>> leaf_;  //!< of groups that assimilate
};

}  // namespace ideotype
