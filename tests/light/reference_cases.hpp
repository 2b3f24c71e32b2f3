// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference.hpp"
#include "setups.hpp"

namespace ideotype {

//! A known value under one light in a scene, as a fraction of the incident
//! light. The name is "leaves", "soil", "reflected" or a group of the mesh.
struct KnownValue {
    std::string quantity;
    Estimate value;
};

//! One case: a light and the known values under it.
struct ReferenceCase {
    std::string name;  //!< unique name
    Source light;
    std::vector<KnownValue> known;
};

//! A stand with known values. Groups can be distinguished only under a single
//! light.
struct ReferenceScene {
    std::string origin;  //!< origin of the known values
    //! The stand; for random stands, one realisation.
    std::function<Mesh(std::uint32_t realisation)> mesh;
    //! Random stands have a new realisation in each randomisation, so that our
    //! standard error includes the sampling of leaves.
    enum class Kind { fixed, random } kind;
    GroundPeriod period{};
    Optics optics;
    std::vector<ReferenceCase> cases;
    Accuracy accuracy;    //!< accuracy by which standard errors meet the bound
    double bound = 2e-4;  //!< bound of our standard error
};

//! Returns the scenes of all exact and trusted references.
std::vector<ReferenceScene> reference_scenes();

//! Returns the number of cases.
std::size_t count_cases(const std::vector<ReferenceScene>& scenes);

//! A known value and ours.
struct Comparison {
    std::string name;
    std::string quantity;
    std::string origin;
    Estimate reference;
    Estimate ours;
    double bound = 0;  //!< bound of our standard error

    //! Returns the difference of both values in combined standard errors.
    double off() const;
};

struct SceneResult {
    std::vector<Comparison> comparisons;
    double balance_error = 0;
};

//! Traces a scene in one setup and compares all known values.
//! @param thrift the factor, a power of two, by which the number of paths is
//! smaller than the number that meets the bound. The bound is larger by this
//! factor to the power 3/4, as for errors of nets.
SceneResult compare(const ReferenceScene& scene, const Setup& setup,
                    int thrift = 1);

}  // namespace ideotype
