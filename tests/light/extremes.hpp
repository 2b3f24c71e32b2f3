// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reference.hpp"

namespace ideotype {

inline constexpr GroundPeriod own_cell{0.76, 0.15};
inline const Optics par = leaf_optics(.05, .05, .1);
inline const Optics black = leaf_optics(0, 0, 0);

//! Collects the results of one extreme case.
class Findings {
  public:
    //! Traces light, and requires that all fractions are finite and that the
    //! balance closes to rounding.
    Fractions closing(const Mesh& mesh, GroundPeriod period,
                      const Optics& optics, const Illumination& light,
                      Accuracy accuracy = {256, 4});

    //! Requires the same as closing() for fractions that are already computed.
    void require_closed(const Fractions& fractions);

    //! Records a failure unless a condition holds.
    void require(bool holds, const std::string& what);

    //! Requires agreement with a reference within four combined standard
    //! errors, and a standard error of ours below a bound.
    void require_agreement(Estimate ours, Estimate reference, double bound,
                           const std::string& what);

    //! Records a result in words.
    void say(const std::string& words);

    const std::vector<std::string>& failures() const { return failures_; }
    //! Returns the number of balances that were checked.
    int traces() const { return traces_; }
    //! Returns the largest balance error in any randomisation of any trace.
    double balance_error() const { return balance_error_; }
    //! Returns the recorded words, or the deviation from references.
    std::string result() const;

  private:
    double balance_error_ = 0;
    int traces_ = 0;
    double most_off_ = 0;
    int agreements_ = 0;
    std::string said_;
    std::vector<std::string> failures_;
};

//! An extreme case of valid input.
struct ExtremeCase {
    std::string name;  //!< unique name
    std::string expectation;
    void (*run)(Findings&);
};

std::vector<ExtremeCase> extreme_suns_and_fields();
std::vector<ExtremeCase> extreme_surfaces();
std::vector<ExtremeCase> extreme_days_and_paths();

std::vector<ExtremeCase> extreme_cases();

//! Returns a mesh that has one group of leaves and no faces.
Mesh leaves_only();

//! Adds the parallelogram spanned by two edges at a corner.
void add_leaf(Mesh& mesh, glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v);

//! Returns a plant of two leaves; the upper leaf points across the row.
Mesh two_leaves(double length, double width, double insertion_angle);

}  // namespace ideotype
