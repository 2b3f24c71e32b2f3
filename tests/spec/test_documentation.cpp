// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/file.hpp"
#include "spec/documents.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

TEST(Documentation, OfKeysMatchesTheirDeclarations) {
    const std::string page = IDEOTYPE_CAMPAIGNS "/../docs/campaign_files.md";
    const std::string text = read_file(page, most_input_bytes).text;
    const std::string fresh = with_key_tables(text);
    if (std::getenv("IDEOTYPE_WRITE_GOLDEN")) std::ofstream(page) << fresh;
    EXPECT_TRUE(text == fresh)
        << page
        << " differs from the tables of src/spec/tables; run this test with "
           "IDEOTYPE_WRITE_GOLDEN=1";
}

TEST(Documentation, NeedsEachTableOnce) {
    EXPECT_THROW(with_key_tables("no tables"), Error);
    EXPECT_THROW(with_key_tables("<!-- keys: sight -->\n<!-- end of keys -->"),
                 Error);
}

TEST(Documentation, EveryKeyHasAMeaning) {
    std::size_t keys = 0;
    for (const Documented& table : documented_tables())
        for (const Key& key : table.description->keys()) {
            EXPECT_STRNE(key.meaning, "") << table.section << '.' << key.name;
            EXPECT_NE(default_of(table.section, key), "")
                << table.section << '.' << key.name;
            ++keys;
        }
    EXPECT_GT(keys, 300u);
}

TEST(Keys, AreFoundByTheirNames) {
    ASSERT_TRUE(find_key("site", "latitude"));
    EXPECT_EQ(find_key("site", "latitude")->values.upper, 90);
    EXPECT_TRUE(find_key("optics.nir", "leaf_reflectance"));
    EXPECT_TRUE(find_key("leaf", "length"));
    EXPECT_FALSE(find_key("site", "height"));
    EXPECT_FALSE(find_key("height", "latitude"));
}

TEST(Keys, OfASpecWithDefaultsAreWrittenOnce) {
    Spec spec;
    spec.name = "usual";
    const std::string text = resolved_text(spec);
    EXPECT_NE(text.find("\n[field]\nrows = 4\n"), std::string::npos);
    EXPECT_EQ(text.find("[water]"), std::string::npos);
    EXPECT_EQ(text.find("[sensitivity]"), std::string::npos);
    spec.water.emplace();
    EXPECT_NE(resolved_text(spec).find("[water]"), std::string::npos);
}

}  // namespace ideotype
