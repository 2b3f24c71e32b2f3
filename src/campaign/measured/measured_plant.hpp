// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/problems.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Returns whether a file is a table of measured leaves by its name.
bool is_measured(const std::string& path);

//! Reads a table of measured leaves, one leaf per line, into a plant. Measures
//! without a column stay if the numbers of leaves are equal; all other parts of
//! the plant stay. The stalk grows by as much as the highest insertion rises,
//! and organs at a leaf keep their rank counted from the highest leaf.
//! @param is_crop_known false: the plant could not be read
void read_measured_plant(const std::string& text, const std::string& file,
                         bool is_crop_known, Plant& plant,
                         const Problems& problems);

}  // namespace ideotype
