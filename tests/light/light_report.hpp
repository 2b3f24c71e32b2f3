// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Sections of README.md; each is written to standard output when it is found.

//! Writes every known value against ours in the usual setup.
//! @param thrift see compare()
void report_references(int thrift);

//! Writes the deviations in all setups of the engine.
//! @param thrift see compare()
void report_setups(int thrift);

//! Writes expectation, balance error and result of every extreme case.
void report_extremes();

//! Writes the spread of many estimates over the error that each reports.
void report_honesty();

//! Writes how depth buffers compare with rays.
void report_first_hits();

//! Writes the standard error of the baseline at Ames against paths.
//! @param campaigns folder of the campaign files
void report_convergence(const std::string& campaigns);

}  // namespace ideotype
