// SPDX-License-Identifier: Apache-2.0
#include "json.hpp"

namespace ideotype {

Json to_json(Estimate x) {
    return {{"mean", x.mean}, {"standard_error", x.standard_error}};
}

std::string to_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ideotype
