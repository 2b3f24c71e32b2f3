// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <gtest/gtest.h>

#include "search/cma_es/dd_cma.hpp"

namespace ideotype {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd read_matrix(std::istream& file, Eigen::Index rows,
                     Eigen::Index columns) {
    MatrixXd read(rows, columns);
    for (Eigen::Index k = 0; k < columns; ++k)
        for (Eigen::Index i = 0; i < rows; ++i) file >> read(i, k);
    return read;
}

// Expected values: written by tests/search/published_dd_cma.py.
TEST(DdCma, UpdatesAgreeWithAPublishedImplementation) {
    std::ifstream file(std::string(IDEOTYPE_TEST_DATA) + "/dd_cma.txt");
    int cases = 0;
    Eigen::Index n = 0, population = 0;
    for (int generations = 0; file >> n >> population >> generations; ++cases) {
        DdCma search(read_matrix(file, n, 1), VectorXd::Constant(n, 0.2),
                     static_cast<std::size_t>(population));
        for (int g = 0; g < generations; ++g)
            search.update(read_matrix(file, n, population));
        const auto is_near = [](const MatrixXd& ours, const MatrixXd& theirs) {
            return (ours - theirs).cwiseAbs().maxCoeff() <
                   1e-9 * theirs.cwiseAbs().maxCoeff();
        };
        EXPECT_TRUE(is_near(search.mean(), read_matrix(file, n, 1))) << n;
        EXPECT_TRUE(is_near(search.deviations(), read_matrix(file, n, 1))) << n;
        EXPECT_TRUE(is_near(search.correlation(), read_matrix(file, n, n)))
            << n;
    }
    EXPECT_EQ(cases, 3);
}

}  // namespace
}  // namespace ideotype
