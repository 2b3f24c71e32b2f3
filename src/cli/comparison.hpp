// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "ideotype/canopy/scene.hpp"
#include "json.hpp"
#include "search/outcome.hpp"
#include "stand/stand.hpp"
#include "verbs.hpp"

namespace ideotype {

//! One figure of a plant: a single number, or one place of a profile by leaf or
//! by layer of height.
struct Figure {
    Quantity quantity;
    std::size_t place = 0;  //!< along its axis, from 0

    bool is_of_profile() const { return !quantity.axes.empty(); }
};

//! A plant and what is measured of it. Plants with more leaves have more
//! figures; those that two plants have are the same, in the same order.
struct ComparedPlant {
    std::string name;
    Plants plants;  //!< of a crop file one
    std::vector<Figure> figures;
};

//! A case, or one of its scenarios, without its replicates, which have the same
//! light.
struct ComparedCase {
    Case chosen;
    std::string name;
    Scene scene;
};

//! Plants in the light of cases.
struct Comparison {
    Campaign under;
    std::optional<double> tolerance;  //!< relative standard error
    std::vector<ComparedPlant> plants;
    std::vector<ComparedCase> cases;
    Layers layers;  //!< up to the highest leaf of any plant
    //! Outcomes by plant, then by case. Each figure is an objective, so that
    //! all have values by randomisation.
    std::vector<std::vector<Outcome>> outcomes;

    std::size_t size() const { return plants.size() * cases.size(); }

    //! Returns the figures of the plant with the most leaves.
    const std::vector<Figure>& figures() const;

    //! Nothing if the plant has no such leaf.
    std::optional<Estimate> value(std::size_t plant, std::size_t chosen,
                                  std::size_t figure) const;

    //! By how much it exceeds that of the first plant; the standard error is
    //! one of pairs of randomisations.
    std::optional<Estimate> difference(std::size_t plant, std::size_t chosen,
                                       std::size_t figure) const;

    //! Returns the difference relative to the first plant [%], or nothing if
    //! that has zero.
    std::optional<Estimate> relative_gain(std::size_t plant, std::size_t chosen,
                                          std::size_t figure) const;
};

//! Matrices with a row per plant and a column per case: of the first objective
//! `mean`, `standard_error`, `difference` and `by_randomisation`, the same of
//! all single numbers in `quantities`, and lists of them in `profiles`; null
//! where a plant has no such leaf.
Json to_json(const Comparison& comparison);

//! A line per plant, case and figure.
//! @throws Error if the file cannot be written.
void write_csv(const std::string& path, const Comparison& comparison);

//! Tables of single numbers: the first objective in all cases, then the others.
void print(const Comparison& comparison);

}  // namespace ideotype
