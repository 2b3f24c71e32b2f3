// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "ideotype/core/hash.hpp"

namespace ideotype {

// Expected values: the examples published in FIPS 180-4.
TEST(Sha256, HashOfPartsIsTheHashOfTheWhole) {
    Sha256 sum;
    for (const char* part : {"", "abcdbcdecdefdefgefghfghi", "ghijhijkijkljklm",
                             "klmnlmnomnopnopq"})
        sum.add(part);
    EXPECT_EQ(
        sum.finish(),
        sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"));
}

TEST(Sha256, HashAgreesWithPublishedExamples) {
    EXPECT_EQ(
        sha256(""),
        "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(
        sha256("abc"),
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(
        sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(
        sha256(std::string(1'000'000, 'a')),
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, NullBytesAreHashed) {
    EXPECT_NE(sha256(std::string("a\0b", 3)), sha256("a"));
}

TEST(DeriveSeed, SeedIsTheStartOfTheHashOfSeedAndName) {
    EXPECT_EQ(sha256("42/ames").substr(0, 16), [] {
        char hex[17];
        std::snprintf(hex, sizeof hex, "%016llx",
                      static_cast<unsigned long long>(derive_seed(42, "ames")));
        return std::string(hex);
    }());
}

TEST(DeriveSeed, SeedsDifferForAllSeedsAndNames) {
    std::set<std::uint64_t> seeds;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        for (const char* name : {"", "ames", "ames ", "Ames", "1"})
            seeds.insert(derive_seed(seed, name));
    EXPECT_EQ(seeds.size(), 500u);
}

}  // namespace ideotype
