// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ideotype/canopy/water.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/physiology/leaf_exchange.hpp"
#include "leaf_places.hpp"

namespace ideotype {

//! The state of the air within the canopy relative to the air above.
struct CanopyAir {
    double warmer = 0;   //!< temperature difference [K]
    double moister = 0;  //!< vapour pressure difference [kPa]
};

//! The light absorbed by the leaves of a field in a band other than PAR.
struct OtherLight {
    const Band& band;
    const std::vector<Tally>& tallies;  //!< tallies with leaf light
};

//! The leaves of a canopy that exchange heat and water with the air.
struct WaterLeaves {
    const Scene& scene;                    //!< scene with LeafWater
    const std::vector<LeafGroup>& leaves;  //!< leaves of each group of plants
    const std::vector<Group>& groups;      //!< groups of plants
    double height;                         //!< height of the canopy [m]
    Randomness randomness;                 //!< random numbers of the light
    std::optional<OtherLight> nir{}, longwave{};
    //! Smallest number of points at which the energy balance is solved, summed
    //! over steps.
    double points = 3000;
};

//! The exchange between points on leaves and the air in a field, step by step.
class LeafAir {
  public:
    //! A part of the leaves at a place, in light or in shade.
    struct Point {
        std::size_t place = 0;
        double ppfd = 0;    //!< absorbed light [umol m-2 s-1]
        double cosine = 0;  //!< cosine of PairLight::Bins; 0: in the shade
        Expansion gross{};  //!< gross assimilation in the air above
    };

    //! The fluxes at a point, per leaf area.
    using Fluxes = std::array<Expansion, leaf_fluxes>;

    explicit LeafAir(const WaterLeaves& leaves);

    const WaterLeaves& leaves() const { return leaves_; }

    //! Returns whether leaf temperature follows from an energy balance.
    bool warms() const { return water_.has_leaf_temperature; }

    //! Returns whether leaves warm and moisten the air within the canopy.
    bool has_canopy_air() const { return warms() && water_.has_canopy_air; }

    //! Sets the properties of places that are equal in all steps.
    void see(const LeafPlaces& places);

    //! Returns the class of a group. A class contains leaves of one component
    //! with neighbouring ranks.
    std::uint32_t class_of(std::uint32_t group) const { return class_[group]; }

    static constexpr std::uint32_t classes_per_component = 4;

    //! Returns the number of classes.
    std::size_t classes() const { return means_.size(); }

    //! Returns the group with the largest leaf area in a class; none if no
    //! leaves of the class assimilate.
    std::optional<std::uint32_t> largest_of(std::uint32_t number) const {
        return means_[number].largest;
    }

    //! Returns an additional place that represents a class. It belongs to the
    //! largest group of the class, and its properties are means over the class.
    std::size_t mean_place(std::uint32_t number) const {
        return places_->count() + number;
    }

    //! Sets the indices of the sun and sky sources that the next steps share;
    //! -1: none.
    void meet(int beam, int sky);

    //! Begins a step, with leaves in the air above the canopy.
    void begin(std::size_t step);

    //! Sets the state of the air within the canopy in this step.
    void set_air(const CanopyAir& air);

    //! Closes stomata to an opening relative to that of the step.
    void close_stomata(double opening);

    //! Returns the excess of leaf temperature over the air above at which a
    //! leaf counts as hot [K].
    double hot_over_air(std::uint32_t group) const {
        return hot_leaf - leaf_[group]->above.temperature;
    }

    //! Returns the state of the canopy air if leaves lose the given heat and
    //! water [W m-2, mmol m-2 s-1]. Without separate canopy air, returns that
    //! of the air above.
    //! @param group group of some of the leaves
    CanopyAir driven_by(std::uint32_t group, double heat, double water) const;

    //! Returns the surroundings of a point on a leaf, if warms().
    LeafSurroundings around(const Point& point) const;

    //! Points to be solved together. Each is in the air at the time when it is
    //! added.
    class Batch {
      public:
        explicit Batch(const LeafAir& air) : air_(air) {}

        void clear();

        //! @param like solution for a point in similar light and air, used as
        //! the starting point; null: none
        void add(const Point& point, const LeafExchange* like);

        //! Solves the energy balances of all points.
        //! @return the solutions in the order of the points, until the next
        //! call
        std::span<const LeafExchange> solve();

      private:
        const LeafAir& air_;
        std::vector<ThermalPoint> points_;
        std::vector<LeafExchange> solved_;
    };

    //! Returns the fluxes at a point from its solution.
    Fluxes fluxes_of(const LeafExchange& found, const Point& point) const;

  private:
    struct Place {
        std::uint32_t group = 0;  //!< group of plants
        double view = 0;          //!< sky view factor, summed over both faces
        double wind = 1;   //!< wind speed relative to the top of the canopy
        double width = 0;  //!< width of the blade at this place [m]
        double nir_of_sun = 0, nir_of_sky = 0;  //!< energy [J m-2 of leaf]
        double nir_absorptance = 0;
    };
    //! The light and the wind of a step, common to all leaves.
    struct Sky {
        double longwave = 0;  //!< radiation of the sky [W m-2]
        double wind = 0;      //!< wind at the top of the canopy [m s-1]
        double nir_of_sun = 0, nir_of_sky = 0, nir_beam = 0;
    };
    //! The leaves of a group and their air in a step.
    struct Leaf {
        ThermalLeaf leaf;
        //! Surroundings at the top of the canopy, without light.
        LeafSurroundings above;
        double vapour = 0;          //!< vapour pressure above the canopy [kPa]
        double respiration = 0;     //!< dark respiration [umol m-2 s-1]
        LeafSurroundings within{};  //!< surroundings in the canopy air
        double black = 0;           //!< black body radiation [W m-2]
    };

    //! The leaves of a class.
    struct Mean {
        double area = 0;  //!< leaf area index
        std::optional<std::uint32_t> largest{};
    };

    void find_classes();
    Leaf leaf_in(std::size_t step, std::uint32_t group) const;
    void take_means(std::initializer_list<double Place::*> parts);

    const WaterLeaves leaves_;
    const LeafWater& water_;
    const LightSeries& series_;
    const LeafPlaces* places_ = nullptr;
    std::vector<Place> at_;  //!< places, followed by the mean places of classes
    std::vector<double> index_;         //!< leaf area index by group
    std::vector<std::uint32_t> class_;  //!< class by group
    std::vector<Mean> means_;           //!< mean leaves by class
    int beam_ = -1, sky_ = -1;
    std::size_t step_ = 0;
    Sky light_;
    double resistance_ = 0;  //!< resistance to the air above [s m-1]
    //! Leaf by group, if it assimilates.
    std::vector<std::optional<Leaf>> leaf_;
};

}  // namespace ideotype
