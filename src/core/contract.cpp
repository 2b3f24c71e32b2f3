// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/contract.hpp"

#include <fmt/format.h>

namespace ideotype {

void fail_contract(const char* kind, const char* condition, const char* file,
                   int line) {
    throw ContractError(fmt::format(
        "{}:{}: a {} of the program does not hold: {}; please report this",
        file, line, kind, condition));
}

}  // namespace ideotype
