// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Sections of README.md, on standard output.

//! Writes the largest deviation from known values for each stand, in the usual
//! setup.
//! @param thrift see compare()
void report_references(int thrift);

//! Writes reference_values.md: every known value against ours.
//! @param thrift see compare()
void report_values(int thrift);

//! Writes the deviations in all setups of the engine.
//! @param thrift see compare()
void report_setups(int thrift);

//! Writes expectation, balance error and result of every extreme case.
void report_extremes();

//! Writes the ratio of the spread of many estimates to their standard errors.
void report_honesty();

//! Writes a comparison of depth buffers with rays.
void report_first_hits();

//! Writes the standard error of the baseline at Ames against paths.
//! @param campaigns folder of the campaign files
void report_convergence(const std::string& campaigns);

}  // namespace ideotype
