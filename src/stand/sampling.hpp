// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "campaign/campaign.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"
#include "search/outcome.hpp"

namespace ideotype {

//! Returns the accuracy of a task: finalists are evaluated more accurately.
Accuracy accuracy_of(const Task& task, const Campaign& campaign);

//! Returns the random numbers of a task: common to all candidates of a
//! generation; fresh numbers for all finalists. If each row has light of its
//! own, rows share only the field.
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
    std::uint32_t generation = 0;  //!< number in the search, for its fields
    bool is_final = false;  //!< whether to be as accurate as for finalists
    //! A seed that replaces the campaign's seed.
    std::optional<std::uint64_t> seed{};
    //! Relative standard error of the leaves' light, at most 0.05, reached with
    //! as few paths as possible.
    std::optional<double> tolerance{};
};

//! Returns the sampling of an evaluation outside of a run. An empty request
//! gives the sampling of generation 0.
//! @throws Error of wrong usage if the tolerance is impossible.
Sampling sampling_of(const SamplingRequest& request, const Campaign& campaign,
                     const Case& chosen);

}  // namespace ideotype
