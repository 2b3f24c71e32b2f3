// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "leaf_air.hpp"

namespace ideotype {

//! The fluxes of all leaves of a step to first order, and the air that follows
//! from these fluxes. Fluxes of a class of leaves are taken as linear, those of
//! gas in assimilation at the temperature of the air, heat and warming in
//! absorbed light, along the line through the mean leaf in the shade and the
//! mean leaf in the sun, with energy balances that are solved.
class LeafLines {
  public:
    //! @param air air that has seen the leaves
    explicit LeafLines(LeafAir& air) : air_(air), classes_(air.classes()) {}

    //! Forgets all leaves.
    void clear() {
        for (Class& each : classes_) each = Class{};
    }

    //! Adds some leaf area.
    //! @param ppfd,cosine those of LeafAir::Point
    void add(std::uint32_t group, double ppfd, double cosine, double area);

    //! Adds the gross assimilation of a place [umol m-2 s-1].
    void add_gross(std::uint32_t group, double gross) {
        of(group).gross += gross;
    }

    //! Finds the lines and the air of the step, and passes the air to LeafAir.
    //! @param responses response of each group; empty: no light
    void settle(const std::vector<LeafResponse>& responses);

    //! Moves the air and the lines by the amounts that all leaves lose beyond
    //! their lines [W m-2, mmol m-2 s-1].
    void correct(double heat, double water);

    //! Returns the air that follows from the lines less the air of the step.
    CanopyAir air_left() const {
        return {driven_.warmer - in_.warmer, driven_.moister - in_.moister};
    }

    //! Returns a flux of a leaf by its line, with its derivatives in light. For
    //! hot area, the result is whether the leaf is hot by the line of warming.
    Expansion at(LeafFlux flux, std::uint32_t group,
                 const LeafAir::Point& point) const;

    //! Returns whether any leaf may be hot by its line.
    //! @param light most light on a leaf [umol m-2 s-1]
    bool reaches_heat(double light) const;

    //! Returns the constant and the slope of a flux in assimilation or light.
    std::array<double, 2> line(LeafFlux flux, std::uint32_t group) const {
        const auto k = static_cast<std::size_t>(flux);
        return {of(group).constant[k], of(group).slope[k]};
    }

    //! Returns whether a flux is linear in assimilation, not in light.
    static bool is_in_gross(LeafFlux flux) {
        return flux != LeafFlux::sensible && flux != LeafFlux::warming &&
               flux != LeafFlux::hot;
    }

    //! Returns the solution for the mean leaf in the sun or in the shade.
    const LeafExchange& solved(std::uint32_t group, bool is_sunlit) const {
        return of(group).solved[is_sunlit ? 1 : 0];
    }

  private:
    //! Leaves in the shade or in the sun.
    struct Mean {
        double area = 0, ppfd = 0, cosine = 0;
    };
    struct Class {
        Mean means[2]{};             //!< leaves in shade and in sun
        double gross = 0;            //!< assimilation of all leaves
        LeafAir::Point points[2]{};  //!< mean points
        LeafExchange solved[2]{};
        bool is_used = false;   //!< whether any leaf assimilates
        bool is_known = false;  //!< whether solved in the step
        std::array<double, leaf_fluxes> constant{}, slope{};

        double area() const { return means[0].area + means[1].area; }
    };
    //! A class that stands for its component.
    struct Typical {
        std::uint32_t number;  //!< number of the class
        double scale;          //!< leaf area of the component over the class's
    };

    Class& of(std::uint32_t group) { return classes_[air_.class_of(group)]; }
    const Class& of(std::uint32_t group) const {
        return classes_[air_.class_of(group)];
    }
    void find_points(const std::vector<LeafResponse>& responses);
    void find_typical();
    CanopyAir driven_by(std::uint32_t c);
    CanopyAir driven(const CanopyAir& in);
    CanopyAir typically_driven(const CanopyAir& in);
    void guess_air();
    void move_air(const CanopyAir& left);
    void learn_slopes(const CanopyAir& by, const CanopyAir& more);
    void draw(Class& leaves);

    LeafAir& air_;
    std::vector<Class> classes_;
    std::vector<Typical> typical_{};
    CanopyAir in_{}, driven_{};  //!< air in the step, and air that follows
    //! Slopes of the air that leaves drive in the air around leaves: of its
    //! warmth in warmth and in vapour, then of its vapour in both.
    std::array<double, 4> slopes_{};
};

}  // namespace ideotype
