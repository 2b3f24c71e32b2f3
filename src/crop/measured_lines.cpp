// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/measured_lines.hpp"

#include <algorithm>
#include <charconv>

#include <Eigen/Cholesky>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

//! A leaf by its distance from the leaf at the ear, or from the highest one.
struct RelativeLeaf {
    bool is_from_ear;
    int ranks;
};

std::optional<RelativeLeaf> parse(const std::string& leaf) {
    const bool is_from_ear = leaf.starts_with("ear");
    if (!is_from_ear && !leaf.starts_with("top")) return std::nullopt;
    RelativeLeaf found{is_from_ear, 0};
    if (leaf.size() == 3) return found;
    // std::from_chars takes no plus sign.
    const char* begin = leaf.data() + (leaf[3] == '+' ? 4 : 3);
    const char* end = leaf.data() + leaf.size();
    const auto [rest, error] = std::from_chars(begin, end, found.ranks);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return found;
}

//! Returns the rank of the leaf at the ear, from 1; for plants without an ear,
//! the rank at six tenths of all ranks.
int ear_rank(const Plant& plant) {
    for (const Organ& organ : plant.organs)
        if (organ.name == "ear" && organ.leaf > 0) return organ.leaf;
    return static_cast<int>(plant.leaves.size() * 6 / 10);
}

double value_of(const LineTrait& trait, Plant& plant) {
    const auto measure = find_measure(plant, trait.measure);
    if (!measure || measure->values.empty())
        throw Error("the plant has no " + trait.measure +
                    ", which was measured of lines");
    const auto leaf = parse(trait.leaf);
    if (!measure->is_of_leaves || !leaf) return *measure->values.front();
    const auto last = static_cast<int>(measure->values.size());
    const int rank = (leaf->is_from_ear ? ear_rank(plant) : last) + leaf->ranks;
    return *measure->values[static_cast<std::size_t>(std::clamp(rank, 1, last) -
                                                     1)];
}

Eigen::LLT<Eigen::MatrixXd> factor_of(const MeasuredLines& known) {
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
    return parse(leaf).has_value();
}

bool are_correlations(const MeasuredLines& known) {
    return factor_of(known).info() == Eigen::Success;
}

LineDistance distance(const MeasuredLines& known, const Plant& plant) {
    const auto factor = factor_of(known);
    const auto size = static_cast<Eigen::Index>(known.traits.size());
    Plant measured = plant;
    Eigen::VectorXd values(size), mean(size), deviation(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const LineTrait& trait = known.traits[static_cast<std::size_t>(i)];
        values[i] = value_of(trait, measured);
        mean[i] = trait.mean;
        deviation[i] = trait.deviation;
    }
    const auto from = [&](const Eigen::VectorXd& other) {
        const Eigen::VectorXd apart = (values - other).cwiseQuotient(deviation);
        return factor.matrixL().solve(apart).norm();
    };
    LineDistance found{from(mean)};
    for (std::size_t l = 0; l < known.lines.size(); ++l) {
        const double here = from(Eigen::Map<const Eigen::VectorXd>(
            known.lines[l].values.data(), size));
        if (l > 0 && here >= found.from_line) continue;
        found.from_line = here;
        found.line = l + 1;
    }
    return found;
}

}  // namespace ideotype
