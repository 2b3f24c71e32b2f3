// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Sections of README.md, on standard output.

//! Writes the largest deviation from known values for each stand, in the
//! standard setup.
//! @param thrift see compare()
void report_references(int thrift);

//! Writes reference_values.md: every known value with our value.
//! @param thrift see compare()
void report_values(int thrift);

//! Writes the deviations in all setups of the engine.
//! @param thrift see compare()
void report_setups(int thrift);

//! Writes for each extreme case the expectation, the balance error and the
//! result.
void report_extremes();

//! Writes the ratio between the spread of many estimates and their standard
//! errors.
void report_honesty();

//! Writes the comparison of depth buffers with rays.
void report_first_hits();

//! Writes the standard error for the baseline at Ames by number of paths.
//! @param campaigns folder of the campaign files
void report_convergence(const std::string& campaigns);

}  // namespace ideotype
