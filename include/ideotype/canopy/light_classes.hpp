// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! The number of classes of absorbed PPFD: 0 to 50, 50 to 100, then classes of
//! width 100 up to 2000, and one above 2000 [umol m-2 s-1].
inline constexpr std::size_t ppfd_classes = 22;

//! Returns the PPFD at which a class begins; the last class is unbounded.
inline double class_begin(std::size_t number) {
    IDEOTYPE_EXPECT(number < ppfd_classes);
    return number < 2 ? 50. * static_cast<double>(number)
                      : 100. * static_cast<double>(number - 1);
}

//! Returns the class of an absorbed PPFD.
inline std::size_t class_of(double ppfd) {
    if (!(ppfd >= 50)) return 0;
    return std::min(1 + static_cast<std::size_t>(ppfd / 100), ppfd_classes - 1);
}

//! Leaf area in each class of absorbed PPFD [m2 m-2 of ground].
struct LightClasses {
    std::vector<double> sunlit, shaded;

    explicit LightClasses(std::size_t classes)
        : sunlit(classes), shaded(classes) {}
};

//! Computes the leaf area in each class of absorbed light in one field, by
//! randomisation, as a mean over the time with any light. The sum over all
//! classes is the leaf area index. Diffuse light is computed as in
//! assimilate(): as a mean over identical plants. Leaves that absorb nothing
//! count as shaded.
//! @param tallies tallies with leaf light
//! @param lit field with the scene of pieces.mesh
std::vector<LightClasses> leaf_area_by_light(const std::vector<Tally>& tallies,
                                             const Pieces& pieces,
                                             const LitLeaves& lit);

//! Estimates of leaf area in each class of absorbed light [m2 m-2].
struct LightClassReport {
    std::vector<Estimate> sunlit, shaded;
};

//! Reports the leaf area in each class from all randomisations.
LightClassReport report(const std::vector<LightClasses>& randomisations);

}  // namespace ideotype
