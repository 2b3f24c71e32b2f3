// SPDX-License-Identifier: Apache-2.0
#include "population.hpp"

namespace ideotype {

const char* name_of(Origin origin) {
    switch (origin) {
        case Origin::none:
            return "none";
        case Origin::baseline:
            return "baseline";
        case Origin::random:
            return "random";
        case Origin::elite:
            return "elite";
        case Origin::child:
            return "child";
        case Origin::sample:
            return "sample";
    }
    return "unknown";
}

}  // namespace ideotype
