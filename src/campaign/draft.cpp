#include "draft.hpp"

#include <algorithm>

namespace ideotype {

namespace {

// The same for every leaf, as in the study arXiv:2512.06064; the range of the
// insertion angle is our estimate.
constexpr LeafBounds paper{{0.40, 1.10}, {0.05, 0.14}, {10, 80}};

// How far breeding may move a leaf from a living plant's; our estimate.
constexpr double biological_change = 0.35;

Range around(double value) {
    return {(1 - biological_change) * value, (1 + biological_change) * value};
}

Range intersection(Range a, Range b) {
    return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace

Draft::Draft() {
    // What `fidelity` recommends; the field and the time step are so anyway.
    campaign.sampling = {16384, 16, 0.008};
    campaign.trait_sets = {{"all", {}}};
    campaign.optics = {{0.05, 0.05}, {0.31, 0.12}, 0.10};
    // A least-squares fit of a maize width profile with a maximum of 1 and an
    // area of 0.7455 length x width.
    campaign.plant.blade.width_controls = {0.28,     0.885870, 0.895017,
                                           1.149943, 0.379696, 0.0};
}

LeafBounds leaf_bounds(const BoundsEntry& bounds, const LeafTraits& traits) {
    if (bounds.rule.empty()) return bounds.table;
    if (bounds.rule == "biological")
        return {intersection(around(traits.length), paper.length),
                around(traits.width), paper.insertion_angle};
    return paper;
}

}  // namespace ideotype
