// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "leaf_lines.hpp"
#include "step_light.hpp"

namespace ideotype {

//! Fluxes of the leaves of a field that exchange heat and water. All places
//! have those of LeafLines; what differs from them is known at few points of
//! each step, which are drawn with chances in proportion to leaf area and
//! light. Each counts for as many as its chance is small, so that sums have no
//! bias (Horvitz and Thompson 1952, doi:10.1080/01621459.1952.10483446).
//! Each randomisation draws points of its own, so that the spread over
//! randomisations holds the error of the draw (interpenetrating samples,
//! Mahalanobis 1946, doi:10.2307/2981330).
class WaterFluxes {
  public:
    //! One flux by lines.
    struct Flux {
        std::vector<double> mean;   //!< of places, on a mean day
        std::vector<double> size;   //!< sums of its amounts, by place
        std::vector<double> steps;  //!< of all leaves
    };

    //! @param empty tallies of each LeafFlux and randomisation
    WaterFluxes(const LitLeaves& lit, const LeafPlaces& places,
                const ExpectedLight& expectation, FluxTallies empty);

    //! Takes the light of a sun and a sky that steps share; -1: none.
    void meet(int beam, int sky) { air_.meet(beam, sky); }

    //! Adds a step.
    void add(std::size_t step, const StepLight& light) { add(step, &light); }

    //! Adds what leaves exchange in steps without light.
    void add_nights();

    //! Adds what drawn points differ from their lines.
    void add_drawn_to(FluxTallies& all) const;

    //! Returns fluxes by LeafFlux. The first is what assimilation differs from
    //! that at the temperature of the air.
    const std::vector<Flux>& fluxes() const { return fluxes_; }

  private:
    //! @param light null: none
    void add(std::size_t step, const StepLight* light);
    void find_areas(const StepLight* light);
    void find_lines(const StepLight* light);
    void add_lines(std::size_t step, const StepLight* light);
    void add_hot(std::size_t step, const StepLight* light);
    void draw(std::size_t step, const StepLight* light);
    void add_drawn(std::size_t step, const StepLight* light,
                   std::size_t randomisation, std::size_t area, double times);
    LeafAir::Point point(const StepLight* light, std::size_t area) const;
    bool takes(LeafFlux flux, const StepLight* light) const;
    double amount(const StepLight& light, std::size_t area,
                  const Expansion& at) const;

    const LitLeaves& lit_;
    const SeriesIllumination& light_;
    const LeafPlaces& places_;
    LeafAir& air_;
    std::optional<LeafLines> lines_{};
    FluxTallies drawn_;  //!< what drawn points differ from their lines
    std::vector<Flux> fluxes_;
    std::array<double, leaf_fluxes> amounts_{};  //!< of a step, on a mean day
    //! Differences of drawn points from lines in a step, of all leaves.
    std::array<double, leaf_fluxes> drawn_sums_{};
    std::vector<double> starts_;   //!< of the draws of randomisations
    std::vector<double> areas_;    //!< of places in the shade, and of bins
    std::vector<double> chances_;  //!< of those, summed up
};

}  // namespace ideotype
