// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Smallest and largest value.
struct Range {
    double lower = 0;
    double upper = 0;
};

}  // namespace ideotype
