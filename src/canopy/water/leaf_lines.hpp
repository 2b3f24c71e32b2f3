// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "leaf_air.hpp"

namespace ideotype {

//! The fluxes of all leaves of a step to first order, and the air that follows
//! from them. Fluxes of a class of leaves are taken as linear, those of gas in
//! assimilation at the temperature of the air, heat and warming in absorbed
//! light, through its mean leaf in the shade and that in the sun, which are
//! solved.
class LeafLines {
  public:
    //! @param air that has seen the leaves
    explicit LeafLines(LeafAir& air) : air_(air), classes_(air.classes()) {}

    //! Forgets all leaves.
    void clear();

    //! Adds some leaf area.
    void add(std::uint32_t group, const LeafAir::Point& point, double area);

    //! Adds the gross assimilation of a place [umol m-2 s-1].
    void add_gross(std::uint32_t group, double gross) {
        of(group).gross += gross;
    }

    //! Finds lines and the air of the step, of which LeafAir is then told.
    //! @param responses of each group; empty: no light
    void settle(const std::vector<LeafResponse>& responses);

    //! Moves the air and the lines by what all leaves lose besides what their
    //! lines tell [W m-2, mmol m-2 s-1].
    void correct(double heat, double water);

    //! Returns a flux of a leaf by its line. Of hot area it is whether the leaf
    //! is hot by the line of its warming.
    double at(LeafFlux flux, std::uint32_t group,
              const LeafAir::Point& point) const;

    //! Returns constant and slope of a flux in assimilation or light.
    std::array<double, 2> line(LeafFlux flux, std::uint32_t group) const {
        const auto k = static_cast<std::size_t>(flux);
        return {of(group).constant[k], of(group).slope[k]};
    }

    //! Tells whether a flux is linear in assimilation, and not in light.
    static bool is_in_gross(LeafFlux flux) {
        return flux != LeafFlux::sensible && flux != LeafFlux::warming &&
               flux != LeafFlux::hot;
    }

    //! Returns what was solved of the mean leaf in the sun, or the other one.
    const LeafExchange& solved(std::uint32_t group, bool is_sunlit) const {
        return of(group).solved[is_sunlit ? 1 : 0];
    }

  private:
    //! Leaves in the shade or in the sun.
    struct Mean {
        double area = 0, ppfd = 0, cosine = 0;
    };
    struct Class {
        Mean means[2]{};             //!< in the shade and in the sun
        double gross = 0;            //!< of all its leaves
        LeafAir::Point points[2]{};  //!< the means
        LeafExchange solved[2]{};
        bool is_used = false;   //!< leaves of it assimilate
        bool is_known = false;  //!< solved in some air of the step
        std::array<double, leaf_fluxes> constant{}, slope{};
    };

    Class& of(std::uint32_t group) { return classes_[air_.class_of(group)]; }
    const Class& of(std::uint32_t group) const {
        return classes_[air_.class_of(group)];
    }
    void find_points(const std::vector<LeafResponse>& responses);
    CanopyAir driven(const CanopyAir& in);
    void find_slopes(const CanopyAir& first);
    void move_air(const CanopyAir& left);
    void draw(Class& leaves);

    LeafAir& air_;
    std::vector<Class> classes_;
    CanopyAir in_{}, driven_{};  //!< of the step, and what leaves drive in it
    //! Slopes of the driven air in that which leaves are in: of its warmth in
    //! warmth and in vapour, and of its vapour in both.
    std::array<double, 4> slopes_{};
};

}  // namespace ideotype
