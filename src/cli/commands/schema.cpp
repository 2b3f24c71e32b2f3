// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/formats/json_schema.hpp"

namespace ideotype {

ExitCode print_schema(const SchemaOptions& /*options*/) {
    fmt::print("{}", campaign_schema_text());
    return ExitCode::ok;
}

}  // namespace ideotype
