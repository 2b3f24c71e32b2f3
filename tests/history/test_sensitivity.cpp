// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/history/verify.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

HistoryHeader header_with(SensitivityMethod method) {
    HistoryHeader header = sample_header();
    header.sensitivity = {{method,
                           {"length", "azimuth"},
                           {"absorbed_par", "lai"},
                           {"MJ m-2 day-1", "m2 m-2"}}};
    return header;
}

std::vector<QuantitySensitivity> sample_findings(SensitivityMethod method) {
    std::vector<QuantitySensitivity> found;
    double x = 0;
    for (std::size_t quantity = 0; quantity < 2; ++quantity) {
        QuantitySensitivity one{x + 1, x + 2, x + 3, quantity, {}};
        for (std::size_t i = 0; i < sensitivity_indices(method).size(); ++i)
            one.indices.push_back({{++x, ++x}, {++x, ++x}});
        found.push_back(one);
    }
    return found;
}

class Sensitivity : public testing::TestWithParam<SensitivityMethod> {
  protected:
    Folder folder;
    const std::string path = folder / "case.h5";
};

TEST_P(Sensitivity, IsNotKnownBeforeItIsRecordedAndReadsTheSameAfter) {
    const auto expected = sample_findings(GetParam());
    {
        History history = History::create(path, header_with(GetParam()));
        for (const QuantitySensitivity& each : history.sensitivity())
            EXPECT_TRUE(std::isnan(each.indices.at(1).at(1).mean));
        history.record_sensitivity(expected);
        history.finish("generations");
    }
    verify_file(path);
    const History history = History::read(path);
    const SensitivityForm form = history.header().sensitivity.value();
    EXPECT_EQ(form.method, GetParam());
    EXPECT_EQ(form.factors, (std::vector<std::string>{"length", "azimuth"}));
    EXPECT_EQ(form.units.at(1), "m2 m-2");
    const auto found = history.sensitivity();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].mean, expected[i].mean);
        EXPECT_EQ(found[i].standard_deviation, expected[i].standard_deviation);
        EXPECT_EQ(found[i].noise, expected[i].noise);
        EXPECT_EQ(found[i].samples, expected[i].samples);
        ASSERT_EQ(found[i].indices.size(), expected[i].indices.size());
        for (std::size_t k = 0; k < found[i].indices.size(); ++k)
            for (std::size_t f = 0; f < 2; ++f) {
                const Estimate &is = found[i].indices[k][f],
                               &was = expected[i].indices[k][f];
                EXPECT_EQ(is.mean, was.mean);
                EXPECT_EQ(is.standard_error, was.standard_error);
            }
    }
}

//! A kill may come between any two writes.
TEST_P(Sensitivity, MayBeRecordedAgainUntilTheCaseIsFinished) {
    const auto expected = sample_findings(GetParam());
    {
        History history = History::create(path, header_with(GetParam()));
        history.record_sensitivity({expected[1], expected[0]});
    }
    History history = History::resume(path);
    history.record_sensitivity(expected);
    history.finish("generations");
    EXPECT_EQ(history.sensitivity()[1].samples, expected[1].samples);
    EXPECT_EQ(History::read(path).finished(), "generations");
}

TEST_P(Sensitivity, ThatWasNeverRecordedIsDamageOfAFinishedCase) {
    History::create(path, header_with(GetParam())).finish("generations");
    try {
        verify_file(path);
        FAIL() << "verified";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("sensitivity of absorbed_par"),
                  std::string::npos)
            << error.what();
    }
}

TEST(SensitivityOfASearch, DoesNotExist) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    EXPECT_FALSE(History::create(path, sample_header()).header().sensitivity);
}

INSTANTIATE_TEST_SUITE_P(Methods, Sensitivity,
                         testing::Values(SensitivityMethod::sobol,
                                         SensitivityMethod::morris));

}  // namespace
}  // namespace ideotype
