// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "campaign/campaign.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"
#include "search/outcome.hpp"

namespace ideotype {

//! Returns the accuracy of a task: finalists are evaluated more accurately.
//! @throws Error of wrong usage if the tolerance of the task is impossible.
Accuracy accuracy_of(const Task& task, const Campaign& campaign);

//! Returns the random numbers of a task: common to all candidates of a
//! generation; fresh numbers for all finalists. If each row has light of its
//! own, rows share only the field, or nothing with several fields, since their
//! differences are part of standard errors then.
Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen);

//! The accuracy and the random numbers that a plant is evaluated with.
struct Sampling {
    Accuracy accuracy;
    Randomness randomness;
};

//! Returns the sampling of a task. An empty task gives that of generation 0.
//! @throws Error as accuracy_of()
Sampling sampling_of(const Task& task, const Campaign& campaign,
                     const Case& chosen);

}  // namespace ideotype
