// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "campaign/campaign.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

//! The light on young leaves as the cue of plasticity (Cue::light). Each leaf
//! responds to the light that the young leaves of its plants absorb at the last
//! stage before the leaf is full-grown. This light is expressed as a density:
//! that of a stand of the same crop alone, in rows at a fixed distance, in
//! which young leaves of the baseline absorb the same. Density, rows, panels,
//! gaps and neighbours thus act through one cause.
//!
//! With L the PAR that young leaves absorb per leaf area over the PAR above the
//! stand, ln(L) is taken as linear in ln(D) between stands at 2/3 and 3/2 of
//! the reference density, and beyond up to three times the reference. At stages
//! at which L of the denser stand is less than 2 % smaller there is no
//! competition yet, and leaves are as at the reference.
class LightCue {
  public:
    //! @param cases evaluated_cases() of a case, which must outlive this object
    //! as must the campaign
    LightCue(const Campaign& campaign, const std::vector<Case>& cases);

    //! Returns whether plants of any component respond to light.
    bool is_any() const { return !components_.empty(); }

    //! Traces the light of the stands with which light is compared. Must be
    //! called once before responses are computed.
    //! @param lights for each case the first one with the same light; empty:
    //! all differ
    void prepare(const Device& device,
                 const std::vector<std::size_t>& lights = {});

    //! The densities that correspond to the light on leaves, by component and
    //! leaf.
    class Response {
      public:
        explicit Response(const LightCue& cue) : cue_(cue) {}

        //! Sets the plants of a request to those that have responded to the
        //! light of earlier stages.
        //! @param plants plants at the reference density
        //! @param number number of the case
        void set_plants(std::size_t number, const Plants& plants, Scene& scene);

        //! Takes the light on young leaves from the report of a case. Cases are
        //! taken in order.
        void observe(std::size_t number, const Scene& scene,
                     const CanopyReport& report);

      private:
        const LightCue& cue_;
        std::map<std::size_t, std::vector<double>> densities_{};
    };

  private:
    //! ln(L) in the two stands with which light is compared; none if no leaf is
    //! young.
    using Comparison = std::optional<std::array<double, 2>>;

    const Campaign& campaign_;
    const std::vector<Case>& cases_;
    std::vector<std::size_t> components_;  //!< components that respond to light
    //! [case, component of components_].
    std::vector<std::vector<Comparison>> comparisons_{};
};

}  // namespace ideotype
