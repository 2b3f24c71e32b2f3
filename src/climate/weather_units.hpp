// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ideotype {

//! What a column tells.
enum class Kind { light, fraction, temperature };

//! From the number in a file to ours: factor times it, plus offset.
struct Scale {
    double factor = 1;
    double offset = 0;
};

//! Light becomes all solar radiation [W m-2], fractions 1, temperature deg C;
//! nothing if there is no such unit.
//! @param seconds of a time step
//! @param par_fraction PAR over all solar radiation
std::optional<Scale> scale_of(Kind kind, std::string_view unit, double seconds,
                              double par_fraction);

//! The units that there are, for messages.
std::string units_of(Kind kind);

}  // namespace ideotype
