// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reference.hpp"

namespace ideotype {

inline constexpr GroundPeriod own_cell{0.76, 0.15};
inline const Optics par = leaf_optics(.05, .05, .1);
inline const Optics black = leaf_optics(0, 0, 0);

//! Collects what one extreme case shows.
class Findings {
  public:
    //! Traces, and requires that all figures are finite fractions and that
    //! the balance closes to rounding.
    Fractions closing(const Mesh& mesh, GroundPeriod period,
                      const Optics& optics, const Illumination& light,
                      Accuracy accuracy = {256, 4});

    //! As above, for fractions that come from elsewhere.
    void require_closed(const Fractions& fractions);

    //! Notes a condition that must hold.
    void require(bool holds, const std::string& what);

    //! Requires ours within four combined standard errors of a reference, and
    //! ours to have a standard error below a bound.
    void require_agreement(Estimate ours, Estimate reference, double bound,
                           const std::string& what);

    //! Notes in words what came out.
    void say(const std::string& words);

    const std::vector<std::string>& failures() const { return failures_; }
    //! Returns the number of balances that were looked at.
    int traces() const { return traces_; }
    //! Largest in any randomisation of any trace.
    double balance_error() const { return balance_error_; }
    //! Returns what was said, or how far agreements were off.
    std::string result() const;

  private:
    double balance_error_ = 0;
    int traces_ = 0;
    double most_off_ = 0;
    int agreements_ = 0;
    std::string said_;
    std::vector<std::string> failures_;
};

//! Something at the limits of what can be asked for.
struct ExtremeCase {
    std::string name;  //!< unique
    std::string expectation;
    void (*run)(Findings&);
};

std::vector<ExtremeCase> extreme_suns_and_fields();
std::vector<ExtremeCase> extreme_surfaces();
std::vector<ExtremeCase> extreme_days_and_paths();

//! Returns all extreme cases.
std::vector<ExtremeCase> extreme_cases();

//! One group of leaves, still without faces.
Mesh leaves_only();

//! A parallelogram from a corner along two edges.
void add_leaf(Mesh& mesh, glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v);

//! Returns a plant of two leaves, the upper one across the row.
Mesh two_leaves(double length, double width, double insertion_angle);

}  // namespace ideotype
