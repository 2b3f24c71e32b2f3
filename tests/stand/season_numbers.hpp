// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "stand/stand.hpp"

namespace ideotype {

//! Returns the outcome of the baseline in the first case.
inline Outcome season_of(const Campaign& campaign) {
    const Case chosen = cases(campaign).at(0);
    return Stand(campaign, chosen)
        .evaluate({campaign.crop.baseline},
                  sampling_of(Task{}, campaign, chosen),
                  Device(Device::supported_isas().back()));
}

//! Returns all numbers of an outcome, by the name of the quantity and the
//! position along its axis.
inline std::map<std::string, double> numbers(const Campaign& campaign) {
    const Outcome outcome = season_of(campaign);
    const QuantitySet measured =
        outcome_schema(campaign, cases(campaign).at(0), campaign.sampling)
            .measured;
    std::map<std::string, double> numbers;
    for (const Quantity& quantity : measured.quantities)
        for (std::size_t i = 0; i < measured.size(quantity); ++i)
            numbers[quantity.name + '_' + std::to_string(i)] =
                outcome.quantities.at(measured.offset(quantity.name) + i).mean;
    return numbers;
}

}  // namespace ideotype
