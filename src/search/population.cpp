// SPDX-License-Identifier: Apache-2.0
#include "population.hpp"

#include <array>

namespace ideotype {

const char* name_of(Origin origin) {
    constexpr std::array names{"none",  "baseline", "random",
                               "elite", "child",    "sample"};
    const auto number = static_cast<std::size_t>(origin);
    return number < names.size() ? names[number] : "unknown";
}

}  // namespace ideotype
