// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "campaign/campaign.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"
#include "search/outcome.hpp"

namespace ideotype {

//! Returns how accurate a task is: finalists are evaluated more finely.
Accuracy accuracy_of(const Task& task, const Campaign& campaign);

//! Returns the random numbers of a task: common to all candidates of a
//! generation; fresh ones for all finalists. Where each row has light of its
//! own, they share the field.
Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen);

//! The accuracy and the random numbers that a plant is evaluated with.
struct Sampling {
    Accuracy accuracy;
    Randomness randomness;
};

//! Returns the sampling of a task.
Sampling sampling_of(const Task& task, const Campaign& campaign,
                     const Case& chosen);

//! The request of an evaluation besides its plant.
struct SamplingRequest {
    std::uint32_t generation = 0;  //!< of the search whose fields it has
    bool is_final = false;         //!< as finalists are evaluated
    //! A seed in the place of the campaign's.
    std::optional<std::uint64_t> seed{};
    //! Relative standard error of the leaves' light, with as few paths as that
    //! takes; not above 0.05.
    std::optional<double> tolerance{};
};

//! Returns the sampling of an evaluation outside of a run. With nothing asked
//! for, it is that of generation 0.
//! @throws Error of wrong usage if the tolerance is impossible.
Sampling sampling_of(const SamplingRequest& request, const Campaign& campaign,
                     const Case& chosen);

}  // namespace ideotype
