// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "handle.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

//! The group /sensitivity, of histories that have it: what is known of each
//! quantity once the case is finished, NaN before.
class SensitivityTable {
  public:
    static constexpr const char* group = "sensitivity";

    static void create(hid_t file, const SensitivityForm& form);

    //! Of a file that has the group; none of others.
    static std::optional<SensitivityForm> read_form(hid_t file);

    static void write(hid_t file, const SensitivityForm& form,
                      const std::vector<QuantitySensitivity>& quantities);
    static std::vector<QuantitySensitivity> read(hid_t file,
                                                 const SensitivityForm& form);
};

}  // namespace ideotype
