// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Sections of README.md, each written to standard output as it is found.

//! Every known value against ours in the usual setup.
//! @param thrift see compare()
void report_references(int thrift);

//! The deviations in all ways to set up the engine.
//! @param thrift see compare()
void report_setups(int thrift);

//! Every extreme: expectation, balance error, result.
void report_extremes();

//! The spread of many estimates over the error that each reports.
void report_honesty();

//! Depth buffers against rays.
void report_first_hits();

//! The standard error of the baseline at Ames against paths.
//! @param campaigns folder of the campaign files
void report_convergence(const std::string& campaigns);

}  // namespace ideotype
