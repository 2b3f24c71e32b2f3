// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/light/device.hpp"
#include "light/one_band.hpp"
#include "two_leaves.hpp"

namespace ideotype {

//! Whether all randomisations share one field, or each has its own.
enum class Fields { one, each };

//! A test of plants of two leaves, with a request for their evaluation.
class TwoLeaves : public ::testing::Test {
  protected:
    CanopyReport evaluated(Fields fields = Fields::one) {
        request.accuracy.fields =
            fields == Fields::each ? request.accuracy.randomisations : 1;
        return evaluate(request, device);
    }

    const Device device{Device::supported_isas().back()};
    CanopyRequest request = two_leaves({512, 8});
};

//! A test of plants of two leaves with random azimuths in one field.
class FieldOfTwoLeaves : public ::testing::Test {
  protected:
    explicit FieldOfTwoLeaves(double erect = 0)
        : request(two_leaves({}, erect)) {
        Component& component = request.scene.components[0];
        component.jitter = 45;
        component.photosynthesis.emplace();
        const Pieces plant = cut_leaves(component.mesh);
        Field field = draw_field(request.scene, {1}, {&plant.mesh, 1});
        pieces = pieces_of_field({&plant, 1}, field);
        field.mesh = pieces.mesh;
        scene.emplace(build_scene(device, field));
        std::vector<double> index(plant.uncut_groups);
        for (std::size_t v = 0; v < pieces.count; ++v)
            index[pieces.group[v]] += pieces.area[v] / field.cell.ground_area;
        leaves = leaf_groups(request.scene, component.mesh.groups, index);
    }

    std::vector<Tally> light(const Band& band, const Accuracy& accuracy,
                             std::uint64_t seed) const {
        return simulate(*scene, pieces.mesh.groups, band.optics,
                        band.light.light, accuracy, {seed}, {}, pieces.count);
    }

    LitLeaves lit() const {
        return {*scene,
                pieces.mesh.groups,
                request.scene.bands.front(),
                request.scene.photons,
                leaves,
                layers};
    }

    const Device device{Device::supported_isas().back()};
    const Layers layers;
    CanopyRequest request;
    Pieces pieces;
    std::optional<RayScene> scene;
    std::vector<LeafGroup> leaves;
};

}  // namespace ideotype
