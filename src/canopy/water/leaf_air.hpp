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

//! The air among the leaves of a canopy relative to the air above.
struct CanopyAir {
    double warmer = 0;   //!< temperature difference [K]
    double moister = 0;  //!< vapour pressure difference [kPa]
};

//! The light in a band other than PAR that the leaves of a field absorb.
struct OtherLight {
    const Band& band;
    const std::vector<Tally>& tallies;  //!< tallies with leaf light
};

//! The leaves of a canopy that exchange heat and water.
struct WaterLeaves {
    const Scene& scene;                    //!< scene with LeafWater
    const std::vector<LeafGroup>& leaves;  //!< leaves of each group of plants
    const std::vector<Group>& groups;      //!< groups of plants
    double height;                         //!< height of the canopy [m]
    Randomness randomness;                 //!< random numbers of the light
    std::optional<OtherLight> nir{}, longwave{};
    //! Least number of points with a solved balance, in all steps together.
    double points = 3000;
};

//! The exchange of points of leaves with the air in a field, step by step.
class LeafAir {
  public:
    //! A part of the leaves at a place.
    struct Point {
        std::size_t place = 0;
        double ppfd = 0;    //!< absorbed light [umol m-2 s-1]
        double cosine = 0;  //!< cosine of PairLight::Bin; 0: shaded
        Expansion gross{};  //!< assimilation in the air above
    };

    //! The fluxes of a point, per area of leaf.
    using Fluxes = std::array<Expansion, leaf_fluxes>;

    explicit LeafAir(const WaterLeaves& leaves);

    const WaterLeaves& leaves() const { return leaves_; }

    //! Returns whether an energy balance gives the temperature of leaves.
    bool warms() const { return water_.has_leaf_temperature; }

    //! Takes the properties of places that are equal in all steps.
    void see(const LeafPlaces& places, const ExpectedLight& expectation);

    //! Returns the class of a group: a class has leaves of one component with
    //! neighbouring ranks.
    std::uint32_t class_of(std::uint32_t group) const { return class_[group]; }

    static constexpr std::uint32_t classes_per_component = 4;

    //! Returns the number of classes.
    std::size_t classes() const { return means_.size(); }

    //! Returns the group with the largest leaf area of a class; none if no
    //! leaves of the class assimilate.
    std::optional<std::uint32_t> largest_of(std::uint32_t number) const {
        return means_[number].largest;
    }

    //! Returns a place in the largest group of a class that has the means of
    //! the places of the class.
    std::size_t mean_place(std::uint32_t number) const {
        return places_->count() + number;
    }

    //! Takes the light of a sun and a sky that steps share; -1: none.
    void meet(int beam, int sky);

    //! Begins a step, in the air above the canopy.
    void begin(std::size_t step);

    //! Sets the air among the leaves in the step.
    void set_air(const CanopyAir& air);

    //! Returns by how much a leaf is warmer than the air above when it counts
    //! as hot [K].
    double hot_over_air(std::uint32_t group) const {
        return hot_leaf - leaf_[group]->above.temperature;
    }

    //! Returns the canopy air that follows if leaves lose this heat and water
    //! [W m-2, mmol m-2 s-1]; the air above if canopy air has no own state.
    //! @param group group of some of the leaves
    CanopyAir driven_by(std::uint32_t group, double heat, double water) const;

    //! Returns the surroundings of a point of leaves, if warms().
    LeafSurroundings around(const Point& point) const;

    //! Solves the energy balance of a point.
    //! @param like a point in similar light and air to start from; null: none
    LeafExchange solve(const Point& point, const LeafExchange* like) const;

    //! Returns the fluxes of a point that was solved.
    Fluxes fluxes_of(const LeafExchange& found, const Point& point) const;

  private:
    struct Place {
        std::uint32_t group = 0;  //!< group of plants
        double view = 0;          //!< view of the sky, sum of both faces
        double wind = 1;          //!< wind over that at the top
        double width = 0;         //!< width of the blade at the place [m]
        double nir_of_sun = 0, nir_of_sky = 0;  //!< energy [J m-2 of leaf]
        double nir_absorptance = 0;
    };
    //! The light and the wind of a step that all leaves share.
    struct Sky {
        double longwave = 0;  //!< radiation of the sky [W m-2]
        double wind = 0;      //!< wind at the top [m s-1]
        double nir_of_sun = 0, nir_of_sky = 0, nir_beam = 0;
    };
    //! The leaves of a group in the air of a step.
    struct Leaf {
        ThermalLeaf leaf;
        LeafSurroundings above;     //!< surroundings at the top, without light
        double vapour = 0;          //!< vapour pressure above [kPa]
        double respiration = 0;     //!< dark rate [umol m-2 s-1]
        LeafSurroundings within{};  //!< surroundings in canopy air
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
    const ExpectedLight* expectation_ = nullptr;
    std::vector<Place> at_;             //!< places, then means of classes
    std::vector<double> index_;         //!< leaf area index by group
    std::vector<std::uint32_t> class_;  //!< class by group
    std::vector<Mean> means_;           //!< leaves by class
    int beam_ = -1, sky_ = -1;
    Sky light_;
    double resistance_ = 0;  //!< resistance to the air above [s m-1]
    std::vector<std::optional<Leaf>> leaf_;  //!< leaf by group, if assimilating
};

}  // namespace ideotype
