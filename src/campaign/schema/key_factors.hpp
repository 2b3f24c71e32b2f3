// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"

namespace ideotype {

//! Reports keys of a sensitivity study that are not numbers of this campaign,
//! ranges that exceed those of their keys, and contradicting settings.
//! Completes the values and units of the keys.
void check_sensitivity(Draft& draft, const Problems& problems);

//! Sets a factor that check_sensitivity() has accepted to another value.
void set_key(Draft& draft, const KeyFactor& factor, double value);

}  // namespace ideotype
