// SPDX-License-Identifier: Apache-2.0
#include "plan.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Least number of randomisations in a field for assimilate().
constexpr int fewest_in_field = 4;

//! Tells whether fields of a scene may differ from each other.
bool are_drawn(const Scene& scene) {
    return std::any_of(
        scene.components.begin(), scene.components.end(),
        [](const Component& each) { return each.plant || each.jitter > 0; });
}

}  // namespace

Plan::Plan(const CanopyRequest& request)
    : accuracy(request.accuracy), randomness_(request.randomness) {
    IDEOTYPE_EXPECT(accuracy.paths > 0 && accuracy.randomisations > 0);
    IDEOTYPE_EXPECT(accuracy.tolerance >= 0);
    if (are_drawn(request.scene))
        fields = std::clamp(accuracy.fields, 1, accuracy.randomisations);
    accuracy.randomisations /= fields;
    accuracy.tolerance *= std::sqrt(fields);
    if (request.scene.assimilates() && !request.details.exact &&
        accuracy.randomisations < fewest_in_field) {
        accuracy.paths =
            accuracy.paths * accuracy.randomisations / fewest_in_field;
        accuracy.randomisations = fewest_in_field;
    }
    is_one_of_many = fields > 1 && accuracy.randomisations > 1;
}

Randomness Plan::of_plants(int field) const {
    if (!randomness_.has_common_fields) return of_field(field, 1);
    return {randomness_.seed, 0, static_cast<std::uint32_t>(field)};
}

Randomness Plan::of_light(int field) const {
    return of_field(field, is_one_of_many ? accuracy.randomisations : 1);
}

Randomness Plan::of_field(int field, int times) const {
    IDEOTYPE_EXPECT(field >= 0 && field < fields);
    Randomness numbers = randomness_;
    numbers.first_randomisation =
        (numbers.first_randomisation + static_cast<std::uint32_t>(field)) *
        static_cast<std::uint32_t>(times);
    return numbers;
}

}  // namespace ideotype
