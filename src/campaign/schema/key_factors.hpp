// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"

namespace ideotype {

//! Reports keys of a sensitivity study that are no numbers of this campaign,
//! ranges that leave those of the keys, and settings that contradict each
//! other. Completes what is known of the keys.
void check_sensitivity(Draft& draft, const Problems& problems);

//! Gives a draft another value of a factor that check_sensitivity() has passed.
void set_key(Draft& draft, const KeyFactor& factor, double value);

}  // namespace ideotype
