// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "leaf_lines.hpp"
#include "pair_light.hpp"

namespace ideotype {

//! Fluxes of the leaves of a field that exchange heat and water with the air.
//! At all places, fluxes follow the lines of LeafLines. Deviations from these
//! lines are computed at a few sampled points of each step. Sampling
//! probabilities are proportional to leaf area and light, and each point is
//! weighted by the inverse of its probability, so that sums are unbiased
//! (Horvitz and Thompson 1952, doi:10.1080/01621459.1952.10483446). Each
//! randomisation samples different points, so the spread over randomisations
//! includes the sampling error (interpenetrating samples, Mahalanobis 1946,
//! doi:10.2307/2981330).
class WaterFluxes {
  public:
    //! One flux of all leaves according to their lines.
    struct Flux {
        std::vector<double> mean;   //!< amount on a mean day, by place
        std::vector<double> steps;  //!< flux of all leaves
    };

    //! @param empty empty tallies of each LeafFlux and randomisation
    WaterFluxes(const LitLeaves& lit, const LeafPlaces& places,
                FluxTallies empty);

    //! Sets the indices of the sun and sky sources that the next steps share;
    //! -1: none.
    void meet(int beam, int sky) { air_.meet(beam, sky); }

    //! Adds a step.
    void add(std::size_t step, const StepLight& light) { add(step, &light); }

    //! Adds the exchange of leaves in steps without light.
    void add_nights();

    //! Adds the weights that moments have in a flux, according to its lines, in
    //! the last added step.
    //! @param gross weights of moments in the step's gross assimilation
    void weigh(LeafFlux flux, const StepLight& light, const Weights& gross,
               Weights& all) const;

    //! Adds the deviations of sampled points from their lines.
    void add_drawn_to(FluxTallies& all) const;

    //! Returns the changes of fluxes if stomata close.
    const std::vector<ClosedStomata>& closed() const { return closed_; }

    //! Returns fluxes by LeafFlux. The first is uptake minus gross assimilation
    //! at air temperature.
    const std::vector<Flux>& fluxes() const { return fluxes_; }

  private:
    //! A sampled point.
    struct Sample {
        std::size_t randomisation;
        std::size_t area;  //!< index in areas_
        double times;      //!< 1 / expected number of samples of the area
        LeafAir::Point point;
    };

    //! @param light light in the step; null: a step without light
    void add(std::size_t step, const StepLight* light);
    void find_counts();
    void find_areas(const StepLight* light);
    void find_lines(const StepLight* light);
    void add_lines(std::size_t step, const StepLight* light);
    void add_hot(std::size_t step, const StepLight* light);
    std::vector<LeafLines::Stratum> strata(const StepLight* light) const;
    void close_stomata(std::size_t step, const StepLight* light);
    void prepare_closed();
    void complete_closed();
    void draw(std::size_t step, const StepLight* light);
    void add_drawn(std::size_t step, const StepLight* light,
                   const Sample& sample, const LeafExchange& solved);
    LeafAir::Point point(const StepLight* light, std::size_t area) const;
    void weigh_hot(const StepLight& light, double amount, Weights& all) const;
    bool takes(LeafFlux flux, const StepLight* light) const;
    double amount(const StepLight& light, std::size_t area,
                  const Expansion& at) const;

    const LitLeaves& lit_;
    const SeriesIllumination& light_;
    const LeafPlaces& places_;
    LeafAir& air_;
    std::optional<LeafLines> lines_{};
    std::optional<LeafAir::Batch> batch_{};
    std::vector<Sample> samples_{};  //!< samples of a step
    FluxTallies drawn_;  //!< fluxes of sampled points minus their lines
    std::vector<Flux> fluxes_;
    //! Fraction of each place's area by layer.
    std::vector<std::map<std::size_t, double>> layers_;
    std::vector<ClosedStomata> closed_;  //!< by LeafWater::openings
    std::vector<bool> closes_in_{};      //!< steps in which closed_ is computed
    //! Factors from fluxes in a step to amounts on a mean day.
    std::array<double, leaf_fluxes> amounts_{};
    //! Sums over leaves in a step: sampled points minus their lines.
    std::array<double, leaf_fluxes> drawn_sums_{};
    std::vector<double> counts_;  //!< expected number of samples by step
    //! Starting point of sampling by randomisation.
    std::vector<double> starts_;
    //! Sums over leaves in a step, by place: absorbed light and assimilation.
    std::vector<double> absorbed_, gross_;
    double brightest_ = 0;         //!< largest light at a point [umol m-2 s-1]
    std::vector<double> areas_;    //!< shaded areas of places, followed by bins
    std::vector<double> chances_;  //!< cumulative probabilities
};

}  // namespace ideotype
