// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! The smallest and the largest permitted value.
struct Range {
    double lower = 0;
    double upper = 0;
};

}  // namespace ideotype
