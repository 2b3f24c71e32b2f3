// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "leaf_air.hpp"

namespace ideotype {

//! Fluxes of all leaves in a step to first order, and the canopy air that
//! results from these fluxes. Within a class of leaves, fluxes are assumed to
//! be linear. Fluxes of gases are linear in assimilation at air temperature;
//! heat and warming are linear in absorbed light. Each line passes through the
//! mean leaf in the shade and the mean leaf in the sun, for which energy
//! balances are solved.
class LeafLines {
  public:
    //! @param air air for which LeafAir::see() was called
    explicit LeafLines(LeafAir& air)
        : air_(air), batch_(air), classes_(air.classes()) {}

    //! Forgets all leaves.
    void clear() {
        for (Class& each : classes_) each = Class{};
    }

    //! Adds leaf area at some light.
    //! @param ppfd,cosine as in LeafAir::Point
    void add(std::uint32_t group, double ppfd, double cosine, double area);

    //! Adds the gross assimilation of a place [umol m-2 s-1].
    void add_gross(std::uint32_t group, double gross) {
        of(group).gross += gross;
    }

    //! Computes the lines and the canopy air of the step, and passes the air to
    //! LeafAir.
    //! @param responses response of each group; empty: no light
    void settle(const std::vector<LeafResponse>& responses);

    //! Adjusts the air and the lines for the heat and water that all leaves
    //! lose in addition to their lines [W m-2, mmol m-2 s-1].
    void correct(double heat, double water);

    //! Leaves of one component in similar light.
    struct Stratum {
        std::uint32_t number = 0;     //!< class with the most area
        double area = 0;              //!< leaf area index
        double ppfd = 0, cosine = 0;  //!< means, as in LeafAir::Point
    };

    //! Sums of fluxes over leaves, per ground area.
    using Sums = std::array<double, leaf_fluxes>;

    //! Returns the fluxes of leaves in strata with open stomata, then if
    //! stomata close to each opening, in the canopy air that results. Lines and
    //! air remain as they are.
    std::vector<Sums> close_stomata(const std::vector<double>& openings,
                                    const std::vector<Stratum>& strata);

    //! Returns the air that results from the lines minus the air of the step.
    CanopyAir air_left() const {
        return {driven_.warmer - in_.warmer, driven_.moister - in_.moister};
    }

    //! Returns a flux of a leaf from its line, with derivatives in light. For
    //! hot area, returns whether the leaf is hot according to the line of
    //! warming.
    Expansion at(LeafFlux flux, std::uint32_t group,
                 const LeafAir::Point& point) const;

    //! Returns whether any leaf may be hot according to its line.
    //! @param light largest absorbed light of a leaf [umol m-2 s-1]
    bool reaches_heat(double light) const;

    //! Returns the constant and the slope of a flux's line, in assimilation or
    //! light.
    std::array<double, 2> line(LeafFlux flux, std::uint32_t group) const {
        const auto k = static_cast<std::size_t>(flux);
        return {of(group).constant[k], of(group).slope[k]};
    }

    //! Returns whether a flux is linear in assimilation instead of light.
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
        Mean means[2]{};   //!< leaves in shade and in sun
        double gross = 0;  //!< gross assimilation of all leaves of the class
        LeafAir::Point points[2]{};  //!< mean points
        LeafExchange solved[2]{};
        bool is_used = false;   //!< whether any leaf assimilates
        bool is_known = false;  //!< whether the balances of the step are solved
        std::array<double, leaf_fluxes> constant{}, slope{};

        double area() const { return means[0].area + means[1].area; }
    };
    //! A class that represents itself or its component.
    struct Member {
        std::uint32_t number;  //!< number of the class
        double scale;  //!< leaf area that it represents, relative to its own
    };

    Class& of(std::uint32_t group) { return classes_[air_.class_of(group)]; }
    const Class& of(std::uint32_t group) const {
        return classes_[air_.class_of(group)];
    }
    void find_points(const std::vector<LeafResponse>& responses);
    void find_members();
    void drive(const std::vector<Member>& members,
               std::span<const CanopyAir> airs, CanopyAir* driven);
    CanopyAir driven(const CanopyAir& in);
    void guess_air();
    void move_air(const CanopyAir& left);
    void learn_slopes(const CanopyAir& by, const CanopyAir& more);
    std::size_t points_of(const Class& leaves) const;
    void draw(Class& leaves);
    CanopyAir driven_by(std::uint32_t c) const;

    LeafAir& air_;
    LeafAir::Batch batch_;
    std::vector<Class> classes_;
    //! All classes with leaves, and the classes that represent each component.
    std::vector<Member> all_{}, typical_{};
    //! Air in the step, and air that results from leaves.
    CanopyAir in_{}, driven_{};
    //! Derivatives of the resulting air with respect to the air around leaves:
    //! of temperature in temperature and vapour, then of vapour in both.
    std::array<double, 4> slopes_{};
};

}  // namespace ideotype
