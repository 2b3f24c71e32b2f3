// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh_rates.hpp"

namespace ideotype {
namespace {

using Json = nlohmann::json;

std::string data(const std::string& name) {
    return std::string(IDEOTYPE_TEST_DATA) + "/" + name;
}

void set_light(MeshSpec& options, const Json& input, const char* beam,
               const char* sky) {
    if (input.at(beam) > 0) {
        options.sun = {input.at("elevation").get<double>(),
                       input.at("azimuth").get<double>()};
        options.beam_ppfd = input.at(beam).get<double>();
    }
    if (input.at(sky) > 0) {
        options.sky = SkyModel::uniform;
        options.sky_ppfd = input.at(sky).get<double>();
    }
}

//! Expects that a value agrees with its reference within four combined standard
//! errors plus 0.05 % of the reference.
void expect_agreement(Estimate ours, const Json& reference,
                      const std::string& subject) {
    const double mean = reference.at(0), error = reference.at(1);
    EXPECT_NEAR(
        ours.mean, mean,
        4 * std::hypot(ours.standard_error, error) + 5e-4 * std::abs(mean))
        << subject;
}

class MaizeAssimilation : public testing::Test {
  protected:
    MaizeAssimilation() {
        std::ifstream(data("physiology/maize1.json")) >> all_;
        const Json& set2 = all_.at("parameters").at("set2");
        sets_ = {
            table("set1", "amax = 50\nrd = 2\n"),
            table("set2",
                  fmt::format("amax = {}\nrd = {}\n",
                              set2.at("Amax_by_rank_1_lowest_to_10_top").dump(),
                              set2.at("Rd_by_rank").dump()))};
    }

    const Json& maize() const { return all_.at("meshes").at("maize1"); }

    Json all_;
    std::vector<std::string> sets_;
};

TEST_F(MaizeAssimilation, IsThatOfEveryLeafPoint) {
    for (const auto& [name, instant] : maize().at("instants").items())
        for (std::size_t set = 0; set < sets_.size(); ++set) {
            MeshSpec options = mesh("maize1", {.76, .15});
            options.photosynthesis = sets_[set];
            const Json& input = instant.at("input");
            options.optics.leaf = {input.at("rho"), input.at("tau")};
            options.soil_albedo = input.at("soil_albedo");
            set_light(options, input, "beam_horizontal_ppfd",
                      "sky_horizontal_ppfd");
            const Rates computed = rates(options);
            const std::string a = set == 0 ? "A" : "A2";
            expect_agreement(computed.gross, instant.at(a + "_gross"), name);
            expect_agreement(computed.net, instant.at(a + "_net"), name);
            for (const Json& rank : instant.at("per_rank"))
                expect_agreement(
                    computed.groups.at(rank.at("rank").get<std::size_t>() - 1),
                    rank.at(a + "_gross"), name + rank.at("rank").dump());
        }
}

TEST_F(MaizeAssimilation, ExactlyIsThatOfEveryLeafPoint) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.photosynthesis = sets_[0];
    options.soil_albedo = 0;
    options.is_exact = true;
    options.tolerance = 4e-3;
    const Json& instant = maize().at("instants").at("sun30_az90");
    set_light(options, instant.at("input"), "beam_horizontal_ppfd",
              "sky_horizontal_ppfd");
    const Rates computed = rates(options);
    expect_agreement(computed.gross, instant.at("A_gross"), "gross");
    EXPECT_LE(computed.gross.standard_error, 4e-3 * computed.gross.mean);
    for (const Json& rank : instant.at("per_rank"))
        expect_agreement(
            computed.groups.at(rank.at("rank").get<std::size_t>() - 1),
            rank.at("A_gross"), rank.at("rank").dump());
}

//! Tests sun and sky on leaves that scatter most of the light.
class ExactAssimilation : public testing::TestWithParam<Boundary> {};

TEST_P(ExactAssimilation, AgreesWithPieces) {
    MeshSpec options = mesh("maize1", {.76, .15});
    if (GetParam() == Boundary::isolated) {
        options.period.reset();
        options.ground_area = .114;
        options.boundary = Boundary::isolated;
    }
    options.photosynthesis = table("exact", "amax = 50\n");
    options.optics.leaf = {.45, .35};
    options.soil_albedo = .3;
    options.sun = {45, 120};
    options.beam_ppfd = 900;
    options.sky = SkyModel::clear;
    options.sky_ppfd = 400;
    options.tolerance = 2e-3;
    const Estimate usual = rates(options).gross;
    options.is_exact = true;
    options.tolerance = 6e-3;
    const Estimate exact = rates(options).gross;
    // Values computed from pieces are biased by the noise of their light and by
    // the shape of pieces.
    EXPECT_NEAR(usual.mean, exact.mean,
                4 * std::hypot(usual.standard_error, exact.standard_error) +
                    1e-3 * exact.mean);
    EXPECT_LE(exact.standard_error, 6e-3 * exact.mean);
}

INSTANTIATE_TEST_SUITE_P(Boundaries, ExactAssimilation,
                         testing::Values(Boundary::periodic,
                                         Boundary::isolated),
                         [](const auto& test) {
                             return test.param == Boundary::periodic
                                        ? "Periodic"
                                        : "Isolated";
                         });

TEST_F(MaizeAssimilation, OfADayIsTheSumOfItsHours) {
    Estimate sum;
    for (const Json& hour : maize().at("hours")) {
        MeshSpec options = mesh("maize1", {.76, .15});
        options.photosynthesis = sets_[0];
        options.soil_albedo = 0;
        set_light(options, hour.at("input"), "beam_ppfd", "diffuse_ppfd");
        const Estimate gross = scaled(rates(options).gross, 3600e-6);
        sum = {sum.mean + gross.mean,
               std::hypot(sum.standard_error, gross.standard_error)};
    }
    expect_agreement(sum, maize().at("day_ames_0807").at("A_gross_mol"), "day");
}

}  // namespace
}  // namespace ideotype
