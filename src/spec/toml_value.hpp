// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! A value of any type, as TOML on one line.
struct TomlValue {
    std::string text;

    bool operator==(const TomlValue&) const = default;
};

}  // namespace ideotype
