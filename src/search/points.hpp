// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "ideotype/core/random.hpp"

namespace ideotype {

//! Copies numbers to a vector.
Eigen::VectorXd to_vector(const std::vector<double>& x);

//! Draws independent standard normal numbers.
Eigen::VectorXd draw_normal(RandomStream& stream, std::size_t size);

}  // namespace ideotype
