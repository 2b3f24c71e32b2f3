// SPDX-License-Identifier: Apache-2.0
// Reads from standard input: the dimension, the population, the number of
// generations, the step size, whether learning rates adapt (0 or 1), the mean,
// and the points of each generation, best first. Prints after each: mean, step
// size, covariance matrix.

#include <cstdio>
#include <iostream>

#include "search/cma.hpp"

namespace {

double number() {
    double x = 0;
    std::cin >> x;
    return x;
}

}  // namespace

int main() {
    const auto dimension = static_cast<Eigen::Index>(number());
    const auto population = static_cast<Eigen::Index>(number());
    const auto generations = static_cast<int>(number());
    const double step_size = number();
    const bool adapts = number() != 0;
    Eigen::VectorXd mean(dimension);
    for (double& x : mean) x = number();
    ideotype::Cma cma(mean, step_size, static_cast<std::size_t>(population),
                      adapts);
    for (int g = 0; g < generations; ++g) {
        Eigen::MatrixXd points(dimension, population);
        for (Eigen::Index i = 0; i < population; ++i)
            for (Eigen::Index k = 0; k < dimension; ++k)
                points(k, i) = number();
        cma.update(points);
        for (const double x : cma.mean()) std::printf("%.17g ", x);
        std::printf("%.17g", cma.step_size());
        for (Eigen::Index i = 0; i < dimension; ++i)
            for (Eigen::Index k = 0; k < dimension; ++k)
                std::printf(" %.17g", cma.covariance()(i, k));
        std::printf("\n");
    }
    return std::cin ? 0 : 1;
}
