// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "run/provenance.hpp"

namespace ideotype {
namespace {

class Provenance : public testing::Test {
  protected:
    //! Returns the reason why a history with this header is not resumed, or "".
    std::string refusal(const HistoryHeader& changed) const {
        try {
            require_resumable(changed, campaign, chosen, "case.h5");
        } catch (const Error& error) {
            EXPECT_EQ(error.exit_code(), ExitCode::refused);
            return error.what();
        }
        return "";
    }

    Campaign campaign = read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml");
    Case chosen = cases(campaign)[0];
    HistoryHeader header = header_of(campaign, chosen, "avx2");
};

TEST_F(Provenance, OfTheSameProgramIsResumed) {
    EXPECT_EQ(refusal(header), "");
}

TEST_F(Provenance, OfAnotherProgramIsRefusedWithBothValues) {
    for (const char* name :
         {"program_version", "compiler", "embree_version", "maths"}) {
        HistoryHeader changed = header;
        changed.text.at(name) = "another";
        const std::string text = refusal(changed);
        EXPECT_NE(text.find(std::string(name) + " was another, is " +
                            header.text.at(name)),
                  std::string::npos)
            << text;
        EXPECT_NE(text.find("--out"), std::string::npos) << text;
    }
}

TEST_F(Provenance, NamesAllDifferencesAtOnce) {
    HistoryHeader changed = header;
    changed.text.at("compiler") = "another";
    changed.text.at("maths") = "another";
    const std::string text = refusal(changed);
    EXPECT_NE(text.find("compiler was"), std::string::npos) << text;
    EXPECT_NE(text.find("maths was"), std::string::npos) << text;
}

TEST_F(Provenance, OfAProgramWithUnknownMathsIsAccepted) {
    header.text.erase("maths");
    EXPECT_EQ(refusal(header), "");
}

}  // namespace
}  // namespace ideotype
