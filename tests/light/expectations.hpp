// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "extremes.hpp"

namespace ideotype {

//! Expects our value within four combined standard errors of a reference, and
//! our standard error below a bound.
void expect_agreement(Estimate ours, Estimate reference, double bound,
                      const std::string& what);

//! Traces and expects finite fractions that close the balance to rounding.
Fractions closing(const Mesh& mesh, GroundPeriod period, const Optics& optics,
                  const Illumination& light, Accuracy accuracy = {256, 4});

//! Returns the letters and digits of a case's name, for a test's name.
std::string test_name(std::string name);

}  // namespace ideotype
