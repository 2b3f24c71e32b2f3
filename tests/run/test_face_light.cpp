// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "stand/stand.hpp"

namespace ideotype {
namespace {

class FaceLight : public ::testing::Test {
  protected:
    FaceLight() {
        stand_in({3, 3, chosen.spacing, campaign.spec.field.jitter});
        request.accuracy = {512, 4};
        request.randomness = {5, 2};
    }

    std::vector<Estimate> of_faces() const {
        CanopyRequest by_face = request;
        by_face.details.faces = true;
        return evaluate(by_face, device).par().faces;
    }

    void stand_in(const FieldForm& form) {
        set_places(request.scene.components[0], form);
        request.scene.cell = cell_of(form);
    }

    //! Returns the light absorbed by faces of leaves, or by all other faces,
    //! per area of ground [J m-2 day-1].
    static double sum(const Mesh& mesh, const std::vector<Estimate>& light,
                      double ground_area, bool is_leaf) {
        const std::vector<double> areas = face_areas(mesh);
        EXPECT_EQ(light.size(), areas.size());
        double energy = 0;
        for (std::size_t f = 0; f < areas.size(); ++f)
            if ((mesh.groups[mesh.face_group[f]].id.is_leaf()) == is_leaf)
                energy += light[f].mean * areas[f];
        return energy / ground_area;
    }

    //! Expects that the light on the faces of a mesh sums to the total of the
    //! evaluation.
    void expect_totals(const Mesh& mesh, const std::vector<Estimate>& light,
                       double ground_area) const {
        const BudgetEstimate whole = evaluate(request, device).par().light.day;
        EXPECT_NEAR(sum(mesh, light, ground_area, true) / whole.leaves.mean, 1,
                    1e-12);
        EXPECT_NEAR(sum(mesh, light, ground_area, false) / whole.organs.mean, 1,
                    1e-12);
    }

    //! Expects that the light on all faces of the requested field sums to the
    //! total of its evaluation.
    void expect_totals_of_field() {
        const Field ready = draw_field(request.scene, request.randomness);
        const Scene drawn = as_drawn(request.scene, ready);
        const Scene plants = std::exchange(request.scene, drawn);
        const std::vector<Estimate> light = of_faces();
        request.scene = plants;
        expect_totals(ready.mesh, light, ready.cell.ground_area);
    }

    const Campaign campaign =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml");
    const Case chosen = cases(campaign)[0];
    const double ground = chosen.spacing.row * chosen.spacing.plant;
    CanopyRequest request =
        request_of(sampling_of(Task{}, campaign, chosen), campaign, chosen,
                   scene_of(campaign, chosen), {campaign.crop.baseline});
    const Mesh plant =
        build_plant(campaign.crop.baseline, campaign.spec.plant.tessellation);
    const Device device{Device::supported_isas().back()};
};

TEST_F(FaceLight, FacesOfAPlantSumToItsEvaluation) {
    for (const int fields : {1, request.accuracy.randomisations}) {
        request.accuracy.fields = fields;
        expect_totals(plant, of_faces(), ground);
    }
}

TEST_F(FaceLight, FacesOfAFieldSumToItsEvaluation) {
    expect_totals_of_field();
}

TEST_F(FaceLight, FacesOfAnIsolatedPlotSumToItsEvaluation) {
    stand_in({.rows = 3,
              .plants = 3,
              .spacing = chosen.spacing,
              .jitter = campaign.spec.field.jitter,
              .boundary = Boundary::isolated,
              .border_rows = 1});
    expect_totals_of_field();
    // A face that exists in only one field counts with its light in this field.
    EXPECT_NEAR(sum(plant, of_faces(), ground, true) /
                    evaluate(request, device).par().light.day.leaves.mean,
                1, .2);
}

TEST_F(FaceLight, StandardErrorsOfFacesAreUnbiasedAndSmall) {
    request.scene.components[0].jitter = 0;
    request.accuracy = face_accuracy({16, 16}, plant.faces.size());
    const std::vector<Estimate> one = of_faces();
    request.randomness.seed = 6;
    const std::vector<Estimate> other = of_faces();
    double squares = 0, relative = 0, count = 0;
    for (std::size_t f = 0; f < plant.faces.size(); ++f) {
        const Estimate &a = one[f], &b = other[f];
        const double error = std::hypot(a.standard_error, b.standard_error);
        // Only small parts of the tops of sheaths are visible.
        if (!(error > 0) || !(a.mean > 0)) continue;
        squares += std::pow((a.mean - b.mean) / error, 2);
        relative += a.standard_error / a.mean;
        ++count;
    }
    EXPECT_GT(count, .95 * static_cast<double>(plant.faces.size()));
    // The expected ratio is about 1.1, because each error has 15 degrees of
    // freedom.
    EXPECT_NEAR(squares / count, 1.1, .4);
    EXPECT_LT(relative / count, .1);
}

}  // namespace
}  // namespace ideotype
