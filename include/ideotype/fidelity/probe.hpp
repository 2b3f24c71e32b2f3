// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/fidelity/parameters.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

//! What one field costs [s of the processor], and one path on average of all
//! draws' paths; and how many paths were traced in a field.
struct Cost {
    double geometry = 0;
    double scene = 0;
    double path = 0;
    double paths = 0;
};

//! How an estimate scatters, as standard deviations: from field to field, and
//! from one randomisation of the paths to another in the same field.
struct Scatter {
    Estimate field;
    Estimate path;
};

//! Two plants that are compared, as selection does.
using Rivals = std::array<Genome, 2>;

//! The baseline, and a plant as far from it as candidates are from each
//! other: every free gene is moved by a tenth of its range.
Rivals rivals(const Campaign& campaign, const Case& chosen);

//! What is estimated of two plants, in the unit of the campaign's objective:
//! that of the first, and how much more the second has.
enum class Goal { value, difference };

//! Time of the processor that this process has used [s]; unlike that of a
//! clock it does not count what others do on a shared machine.
double processor_seconds();

//! Middle of the values; 0 if there are none.
double median(std::vector<double> x);

//! Evaluates two plants under a variant, in one random field after another.
//! The n-th draws of all probes share their random numbers, and both plants
//! always do.
class Probe {
  public:
    //! The device must outlive the probe.
    Probe(const Variant& variant, std::size_t case_index, const Device& device,
          const Rivals& rivals);

    //! Makes the next draw: a field with some randomisations.
    void draw();

    std::size_t draws() const { return means_[0].size(); }

    //! By draw, mean of the randomisations.
    const std::vector<double>& means(Goal goal) const {
        return means_[index(goal)];
    }

    Scatter scatter(Goal goal) const;

    //! The median over draws: what else the machine does disturbs some.
    Cost cost() const;

    //! Of all draws together [s].
    double seconds() const { return seconds_; }

  private:
    static std::size_t index(Goal goal) { return goal == Goal::value ? 0 : 1; }
    //! The objective by randomisation.
    std::vector<double> evaluate(const Genome& genome, std::uint32_t draw);
    void append(Goal goal, const std::vector<double>& values);

    std::string objective_;
    CanopyRequest request_;
    Crop crop_;
    const Device& device_;
    Rivals rivals_;
    std::array<std::vector<double>, 2> means_;
    std::array<std::vector<double>, 2> variances_;  //!< within draws
    std::vector<double> geometry_, scene_, path_, paths_traced_;
    double seconds_ = 0;
};

}  // namespace ideotype
