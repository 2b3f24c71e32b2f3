// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "extremes.hpp"

namespace ideotype {

//! Expects agreement with a reference within four combined standard errors, and
//! a standard error of ours below a bound.
void expect_agreement(Estimate ours, Estimate reference, double bound,
                      const std::string& what);

//! Traces light, and expects finite fractions with a balance that closes to
//! rounding.
Fractions closing(const Mesh& mesh, GroundPeriod period, const Optics& optics,
                  const Illumination& light, Accuracy accuracy = {256, 4});

//! Returns the letters and digits of the name of a case, as a test name.
std::string test_name(std::string name);

}  // namespace ideotype
