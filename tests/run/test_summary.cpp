// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <gtest/gtest.h>

#include "run/provenance.hpp"
#include "run/summary.hpp"
#include "stand/stand.hpp"

namespace ideotype {
namespace {

namespace fs = std::filesystem;

//! A history with only a final evaluation.
class Summary : public testing::Test {
  protected:
    ~Summary() override { fs::remove(path_); }

    //! Returns the summary for the given light absorbed by baseline and best
    //! plant [MJ m-2 day-1] and their leaf area indices; NaN: the evaluation
    //! failed.
    std::string of(Estimate baseline, double baseline_lai, Estimate best,
                   double best_lai) {
        fs::remove(path_);
        History history = History::create(
            path_.string(), header_of(campaign_, cases(campaign_)[0], "avx2"));
        const Genome genome = baseline_numbers(campaign_.crop);
        history.propose_final(
            {{genome, Origin::baseline, {}}, {genome, Origin::elite, {}}});
        record(history, 0, baseline, baseline_lai);
        record(history, 1, best, best_lai);
        history.finish("generations");
        return to_text(result_of(history), "a.h5", "finished") +
               left_to_gain(history, campaign_);
    }

  private:
    static void record(History& history, std::uint32_t slot, Estimate absorbed,
                       double lai) {
        const OutcomeSchema& schema = history.header().schema;
        Outcome outcome = unknown_outcome(history.header().final_schema());
        outcome.status = Status::done;
        outcome.objectives = {absorbed};
        outcome.violation = 0;
        outcome.quantities.assign(schema.measured.size(), {0, 0});
        outcome.quantities[schema.measured.offset("lai")].mean = lai;
        history.record_final(slot, std::isnan(absorbed.mean)
                                       ? failed_outcome(schema, "no leaves")
                                       : outcome);
    }

  protected:
    Campaign campaign_ = read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml");
    fs::path path_ = fs::temp_directory_path() /
                     ("ideotype_summary_" + std::to_string(getpid()) + ".h5");
};

TEST_F(Summary, PrintsLeafAreaWithTheGain) {
    const std::string text = of({10, 0.03}, 2.5, {11, 0.04}, 5);
    EXPECT_NE(text.find(", gain 1.000 ± 0.098 MJ m-2 day-1 = 10.0 ± "
                        "1.0 %, LAI 5.00 (baseline 2.50)"),
              std::string::npos)
        << text;
}

TEST_F(Summary, WarnsAboutTooManyLeaves) {
    EXPECT_EQ(of({10, 0.03}, 3.4, {11, 0.04}, 8).find("leaf area index"),
              std::string::npos);
    const std::string text = of({10, 0.03}, 3.4, {11, 0.04}, 8.5);
    EXPECT_NE(
        text.find("; this plant has a leaf area index of 8.50, and fields "
                  "hardly ever have more than 8; limit "),
        std::string::npos)
        << text;
}

TEST_F(Summary, CountsFinalistsThatFailed) {
    EXPECT_EQ(of({10, 0.03}, 2.5, {std::nan(""), 0}, 5),
              "a.h5: finished (reached stop.generations), 0 of 480 plants in 0 "
              "generations, 1 of 2 finalists failed (no leaves)");
}

TEST_F(Summary, NeverDividesByZero) {
    const std::string text = of({0, 0}, 0, {0, 0}, 0);
    EXPECT_NE(text.find(", gain 0 MJ m-2 day-1, LAI 0.00 (baseline 0.00)"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("inf\n"), std::string::npos) << text;
}

TEST_F(Summary, SeveralScenariosHaveNoCommonCeiling) {
    const std::string alone = of({9, 0.01}, 3, {10, 0.01}, 4);
    EXPECT_NE(alone.find("\nat most "), std::string::npos);
    campaign_.spec.objective.over = {"site"};
    const std::string text = of({9, 0.01}, 3, {10, 0.01}, 4);
    EXPECT_NE(text.find("gain "), std::string::npos);
    EXPECT_EQ(text.find("\nat most "), std::string::npos);
}

}  // namespace
}  // namespace ideotype
