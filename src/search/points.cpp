// SPDX-License-Identifier: Apache-2.0
#include "points.hpp"

namespace ideotype {

using Eigen::VectorXd;

VectorXd to_vector(const std::vector<double>& x) {
    return Eigen::Map<const VectorXd>(x.data(),
                                      static_cast<Eigen::Index>(x.size()));
}

VectorXd draw_normal(RandomStream& stream, std::size_t size) {
    VectorXd x(static_cast<Eigen::Index>(size));
    for (Eigen::Index i = 0; i < x.size(); i += 2) {
        const auto [first, second] = stream.normal();
        x[i] = first;
        if (i + 1 < x.size()) x[i + 1] = second;
    }
    return x;
}

}  // namespace ideotype
