// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/problems.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Returns whether a file is a table of measured leaves, by its name.
bool is_measured(const std::string& path);

//! Reads a table of measured leaves, a line each, into a plant, whose other
//! measures stay: of as many leaves those that have no column too. The stalk
//! becomes as much longer as the highest insertion is higher, and organs at a
//! leaf keep its rank from the highest one.
//! @param is_crop_known false: the plant could not be read
void read_measured_plant(const std::string& text, const std::string& file,
                         bool is_crop_known, Plant& plant,
                         const Problems& problems);

}  // namespace ideotype
