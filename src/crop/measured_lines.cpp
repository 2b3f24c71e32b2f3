// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/measured_lines.hpp"

#include <algorithm>
#include <charconv>

#include <Eigen/Cholesky>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

//! A leaf given by its rank relative to the ear leaf or to the highest leaf.
struct RelativeLeaf {
    bool is_from_ear;
    int ranks;
};

std::optional<RelativeLeaf> parse_leaf(const std::string& leaf) {
    const bool is_from_ear = leaf.starts_with("ear");
    if (!is_from_ear && !leaf.starts_with("top")) return std::nullopt;
    RelativeLeaf relative{is_from_ear, 0};
    if (leaf.size() == 3) return relative;
    // std::from_chars does not accept a plus sign.
    const char* begin = leaf.data() + (leaf[3] == '+' ? 4 : 3);
    const char* end = leaf.data() + leaf.size();
    const auto [rest, error] = std::from_chars(begin, end, relative.ranks);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return relative;
}

//! Returns the rank of the ear leaf, counted from 1. In plants without an ear,
//! it is the rank at 60 % of the number of leaves.
int ear_rank(const Plant& plant) {
    for (const Organ& organ : plant.organs)
        if (organ.name == "ear" && organ.leaf > 0) return organ.leaf;
    return static_cast<int>(plant.leaves.size() * 6 / 10);
}

double measure_trait(const LineTrait& trait, Plant& plant) {
    const auto measure = find_measure(plant, trait.measure);
    if (!measure || measure->values.empty())
        throw Error("the plant has no " + trait.measure +
                    ", which was measured on lines");
    const auto leaf = parse_leaf(trait.leaf);
    if (!measure->is_of_leaves || !leaf) return *measure->values.front();
    const auto last = static_cast<int>(measure->values.size());
    const int rank = (leaf->is_from_ear ? ear_rank(plant) : last) + leaf->ranks;
    return *measure->values[static_cast<std::size_t>(std::clamp(rank, 1, last) -
                                                     1)];
}

//! Returns the Cholesky factor of the correlation matrix.
Eigen::LLT<Eigen::MatrixXd> factorize(const MeasuredLines& known) {
    const auto size = static_cast<Eigen::Index>(known.traits.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
    std::size_t next = 0;
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = i + 1; j < size; ++j)
            matrix(i, j) = matrix(j, i) = known.correlations.at(next++);
    return matrix.llt();
}

}  // namespace

bool names_leaf(const std::string& leaf) {
    return parse_leaf(leaf).has_value();
}

bool are_correlations(const MeasuredLines& known) {
    return factorize(known).info() == Eigen::Success;
}

LineDistance distance(const MeasuredLines& known, const Plant& plant) {
    const auto factor = factorize(known);
    const auto size = static_cast<Eigen::Index>(known.traits.size());
    Plant measured = plant;
    Eigen::VectorXd values(size), mean(size), deviation(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const LineTrait& trait = known.traits[static_cast<std::size_t>(i)];
        values[i] = measure_trait(trait, measured);
        mean[i] = trait.mean;
        deviation[i] = trait.deviation;
    }
    const auto mahalanobis = [&](const Eigen::VectorXd& other) {
        const Eigen::VectorXd apart = (values - other).cwiseQuotient(deviation);
        return factor.matrixL().solve(apart).norm();
    };
    LineDistance result{mahalanobis(mean)};
    for (std::size_t l = 0; l < known.lines.size(); ++l) {
        const double to_line = mahalanobis(Eigen::Map<const Eigen::VectorXd>(
            known.lines[l].values.data(), size));
        if (l > 0 && to_line >= result.from_line) continue;
        result.from_line = to_line;
        result.line = l + 1;
    }
    return result;
}

}  // namespace ideotype
