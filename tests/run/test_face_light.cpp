#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/canopy/face_light.hpp"
#include "ideotype/run/evaluator.hpp"

namespace ideotype {
namespace {

class FaceLightTest : public ::testing::Test {
  protected:
    FaceLightTest() { model.field.rows = model.field.plants = 3; }

    Draws few(Draws::Fields fields) const { return {5, 2, {512, 4}, fields}; }

    CanopyReport evaluation(const Draws& draws) const {
        return study(model, device, campaign.baseline, draws, Detail::history);
    }

    //! What the faces of a tissue absorb, for each area of ground
    //! [J m-2 day-1].
    static double sum(const Mesh& mesh, const FaceLight& light, Tissue tissue) {
        const std::vector<double> areas = face_areas(mesh);
        EXPECT_EQ(light.absorbed.size(), areas.size());
        double energy = 0;
        for (std::size_t f = 0; f < areas.size(); ++f)
            if (mesh.groups[mesh.face_group[f]].tissue == tissue)
                energy += light.absorbed[f].mean * areas[f];
        return energy / light.ground_area;
    }

    static void expect_totals(const Mesh& mesh, const FaceLight& light,
                              const CanopyReport& report) {
        const BudgetEstimate& whole = report.light.day;
        EXPECT_NEAR(sum(mesh, light, Tissue::leaf) / whole.leaves.mean, 1,
                    1e-12);
        EXPECT_NEAR(sum(mesh, light, Tissue::stalk) / whole.stalks.mean, 1,
                    1e-12);
    }

    Campaign campaign =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml");
    CanopyModel model = canopy_model(campaign, cases(campaign)[0]);
    const Device device{Device::supported_isas().back()};
    const Mesh plant = build_plant(model, campaign.baseline);
};

TEST_F(FaceLightTest, FacesOfAPlantSumToItsEvaluation) {
    for (const auto fields : {Draws::Fields::one, Draws::Fields::each})
        expect_totals(plant, light_on_plant(model, device, plant, few(fields)),
                      evaluation(few(fields)));
}

TEST_F(FaceLightTest, FacesOfAFieldSumToItsEvaluation) {
    const Draws draws = few(Draws::Fields::one);
    const Field field = build_field(model, plant, draws, 0);
    expect_totals(field.mesh, light_on_field(model, device, field, draws),
                  evaluation(draws));
}

TEST_F(FaceLightTest, FacesOfACutPlotSumToItsEvaluation) {
    model.field.boundary = Boundary::isolated;
    model.field.border_rows = 1;
    const Draws draws = few(Draws::Fields::one);
    const Field field = build_field(model, plant, draws, 0);
    expect_totals(field.mesh, light_on_field(model, device, field, draws),
                  evaluation(draws));
    // A face that is there in one field only counts by what is there of it.
    const FaceLight light = light_on_plant(model, device, plant, draws);
    EXPECT_NEAR(sum(plant, light, Tissue::leaf) /
                    evaluation(draws).light.day.leaves.mean,
                1, .2);
}

TEST_F(FaceLightTest, StandardErrorsOfFacesAreHonestAndSmall) {
    model.field.jitter = 0;
    Draws draws{5, 2, face_sampling({16, 16}, plant.faces.size())};
    const FaceLight one = light_on_plant(model, device, plant, draws);
    draws.seed = 6;
    const FaceLight other = light_on_plant(model, device, plant, draws);
    double squares = 0, relative = 0, count = 0;
    for (std::size_t f = 0; f < plant.faces.size(); ++f) {
        const Estimate &a = one.absorbed[f], &b = other.absorbed[f];
        const double error = std::hypot(a.standard_error, b.standard_error);
        if (!(error > 0)) continue;
        squares += std::pow((a.mean - b.mean) / error, 2);
        relative += a.standard_error / a.mean;
        ++count;
    }
    EXPECT_GT(count, .95 * static_cast<double>(plant.faces.size()));
    // With 15 degrees of freedom for each error it is about 1.1.
    EXPECT_NEAR(squares / count, 1.1, .4);
    EXPECT_LT(relative / count, .1);
}

}  // namespace
}  // namespace ideotype
