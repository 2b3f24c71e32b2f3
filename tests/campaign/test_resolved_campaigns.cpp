// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "campaign/campaign.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

constexpr const char* golden = IDEOTYPE_TEST_DATA "/golden/resolved.txt";

//! SHA-256 digests of the resolved texts of campaigns, by file name.
using Digests = std::map<std::string, std::string>;

//! Returns the digests of all campaigns in the folder. Its subfolders contain
//! crops, plants and weather.
Digests found_digests() {
    Digests digests;
    for (const auto& entry : fs::directory_iterator(IDEOTYPE_CAMPAIGNS))
        if (entry.path().extension() == ".toml")
            digests[entry.path().filename().string()] =
                read_campaign(entry.path().string()).sha256;
    return digests;
}

Digests golden_digests() {
    Digests expected;
    std::ifstream file(golden);
    for (std::string name, digest; file >> name >> digest;)
        expected[name] = digest;
    return expected;
}

void write(const Digests& digests) {
    std::ofstream file(golden);
    for (const auto& [name, digest] : digests)
        file << name << ' ' << digest << '\n';
}

}  // namespace

// Histories store the resolved text, and a run resumes only if the text is
// unchanged.
TEST(ResolvedCampaign, TextsOfAllCampaignsHaveTheSameBits) {
    const Digests digests = found_digests();
    if (std::getenv("IDEOTYPE_WRITE_GOLDEN")) write(digests);
    Digests expected = golden_digests();
    EXPECT_GT(digests.size(), 10u);
    for (const auto& [name, digest] : digests) {
        EXPECT_EQ(digest, expected[name])
            << "campaigns/" << name << " has another resolved text than "
            << "tests/data/golden/resolved.txt states; after a change that is "
               "meant to change it, write the file by IDEOTYPE_WRITE_GOLDEN=1 "
               "test_campaign --gtest_filter=ResolvedCampaign.Texts*, and "
               "explain the change in the commit";
        expected.erase(name);
    }
    for (const auto& [name, digest] : expected)
        ADD_FAILURE() << "there is no campaigns/" << name
                      << "; remove its line from "
                         "tests/data/golden/resolved.txt";
}

}  // namespace ideotype
