// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "sample_campaign.hpp"

namespace ideotype {
namespace {

const std::string sorghum =
    "[[component]]\nname = \"sorghum\"\ncrop = \"crops/sorghum.toml\"\n";

Campaign mixed(const std::string& more) {
    return read_campaign_text(sample_text("", more),
                              IDEOTYPE_CAMPAIGNS "/mixed.toml");
}

std::string problems_of(const std::string& more) {
    try {
        mixed(more);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Components, HaveTheirCropAndAreFoundAgainInAResolvedCampaign) {
    const Campaign campaign =
        mixed(sorghum +
              "rows = [2]\n[[band]]\nname = \"nir\"\n"
              "[objective]\nmaximise = \"net_assimilation\"\n");
    ASSERT_EQ(campaign.components.size(), 1u);
    const ComponentEntry& one = campaign.components.front();
    EXPECT_EQ(one.name, "sorghum");
    EXPECT_EQ(one.standing.rows, std::vector<int>{1});
    EXPECT_EQ(one.crop.baseline.leaves.size(), 16u);
    EXPECT_TRUE(one.photosynthesis);
    EXPECT_TRUE(campaign.follows[nir_band]);
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    const std::string nir =
        "[component.crop.optics.nir]\nleaf_reflectance = 0.";
    EXPECT_NE(problem_of(replaced(campaign.resolved, nir + "4", nir + "9"))
                  .find("optics.nir.leaf_transmittance is 0.43"),
              std::string::npos);
}

TEST(Components, DoNotChangeCampaignsWithoutThem) {
    const std::string resolved = mixed("").resolved;
    for (const char* word :
         {"component", "nir", "[[band]]", "band =", "weights"})
        EXPECT_EQ(resolved.find(word), std::string::npos) << word;
}

TEST(Components, NeedSeparateRowsAndNames) {
    const std::string taken =
        sorghum + "rows = [2]\n" + sorghum + "rows = [2]\n";
    EXPECT_NE(problems_of(taken).find("which another component has"),
              std::string::npos);
    EXPECT_NE(problems_of(taken).find("already used"), std::string::npos);
    EXPECT_NE(problems_of(sorghum + "rows = [1.5]\n")
                  .find("which the field does not have"),
              std::string::npos);
    EXPECT_NE(problems_of(sorghum + "rows = [1, 2, 3, 4, 5, 6]\n")
                  .find("leaves no position"),
              std::string::npos);
    EXPECT_NE(problems_of(sorghum).find("stands nowhere"), std::string::npos);
}

TEST(Components, StandInRowsOrAmongPlantsOfTheMainCrop) {
    const Campaign campaign =
        mixed(sorghum +
              "mixed = 5\njitter = 90\n[[component]]\nname = \"other\"\n"
              "crop = \"crops/maize.toml\"\nrows = [1]\nplants = 3\n");
    const Standing& among = campaign.components[0].standing;
    EXPECT_EQ(among.mixed, 5);
    EXPECT_EQ(among.jitter, 90);
    EXPECT_EQ(campaign.components[1].standing.plants, 3);
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    for (const auto& [more, problem] :
         {std::pair{"mixed = 2\nrows = [1]\n", "stands in two ways"},
          std::pair{"mixed = 2\nplants = 3\n", "is for components in rows"},
          std::pair{"mixed = 9999\n", "leaves no position"}})
        EXPECT_NE(problems_of(sorghum + more).find(problem), std::string::npos)
            << more;
}

TEST(Components, CountInObjectivesByTheirWeights) {
    const std::string rows = sorghum + "rows = [2]\n";
    const std::string net = "[objective]\nmaximise = \"net_assimilation\"\n";
    const Campaign campaign = mixed(rows + net + "weights = [1, 0.5]\n");
    EXPECT_EQ(campaign.spec.objective.weights, (std::vector<double>{1, 0.5}));
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    for (const auto& [text, problem] :
         {std::pair{rows + net + "weights = [1]\n", "there are 2 components"},
          std::pair{net + "weights = [1, 1]\n", "it distinguishes components"},
          std::pair{net + "weights = [2]\n", "it distinguishes components"},
          std::pair{rows + net + "weights = [0, 0]\n", "are all 0"},
          std::pair{
              rows + "[objective]\nmaximise = \"fapar\"\n"
                     "weights = [1, 1]\n",
              "fapar is not a sum over components, which could be weighted"},
          std::pair{std::string("[objective]\nmaximise = \"invasion\"\n"),
                    "compares two components, and there are not two"}})
        EXPECT_NE(problems_of(text).find(problem), std::string::npos) << text;
}

TEST(Components, MayBeOptimisedWithinDifferentBounds) {
    const std::string bred =
        sorghum + "rows = [2]\nfree = [\"width\", \"insertion_angle\"]\n";
    const Campaign campaign =
        mixed(bred + "[component.bounds]\nwidth = [0.01, 0.2]\n");
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    const Case chosen = cases(campaign).front();
    const GeneSpace genes = gene_space(campaign, chosen);
    const Genome baseline = baseline_genome(campaign);
    ASSERT_EQ(genes.size(), baseline.size());
    EXPECT_EQ(genes.size(), count_genes(campaign));
    EXPECT_EQ(genes.size(),
              gene_space(mixed(sorghum + "rows = [2]\n"), chosen).size() +
                  campaign.components[0].bounds.size());
    std::size_t widths = 0;
    for (const Gene& gene : genes) {
        const bool is_own = gene.name.starts_with("sorghum.");
        if (!is_own) continue;
        EXPECT_EQ(gene.is_free, gene.trait == "sorghum.width" ||
                                    gene.trait == "sorghum.insertion_angle")
            << gene.name;
        if (gene.trait != "sorghum.width") continue;
        ++widths;
        EXPECT_EQ(gene.lower, 0.01);
        EXPECT_EQ(gene.upper, 0.2);
    }
    EXPECT_EQ(widths, 16u);
    for (const auto& [more, problem] :
         {std::pair{bred + "bounds = \"paper\"\n", "component.bounds"},
          std::pair{sorghum + "rows = [2]\nfree = [\"widht\"]\n",
                    "did you mean 'width'"},
          std::pair{bred + "[objective]\n"
                           "maximise = \"sorgum.net_assimilation\"\n",
                    "did you mean 'sorghum.net_assimilation'"},
          std::pair{bred + "[objective]\n"
                           "maximise = \"sorghum.net_assimilation\"\n"
                           "weights = [1, 1]\n",
                    "is a quantity of one component"}})
        EXPECT_NE(problems_of(more).find(problem), std::string::npos)
            << more << problems_of(more);
}

TEST(Components, ReportBaselinesOutsideTheirBounds) {
    const Campaign campaign =
        mixed(sorghum +
              "rows = [2]\nfree = [\"width\"]\n"
              "[component.bounds]\nwidth = [0.15, 0.2]\n");
    ASSERT_FALSE(campaign.outside_bounds.empty());
    EXPECT_NE(campaign.outside_bounds.front().what.find("component.free"),
              std::string::npos);
    EXPECT_NE(campaign.outside_bounds.back().what.find(
                  "write in [component.bounds]:\nwidth = ["),
              std::string::npos);
}

TEST(Components, HaveALandEquivalentRatioFromSoleYields) {
    const std::string rows = sorghum + "rows = [2]\n";
    const std::string net = "[objective]\nmaximise = \"net_assimilation\"\n";
    const Campaign campaign =
        mixed(rows + net + "sole = [0.5, 4]\nsole_errors = [0.1, 0]\n");
    EXPECT_EQ(component_weights(campaign), (std::vector<double>{2, 0.25}));
    EXPECT_EQ(unit_of(campaign, "net_assimilation"), "1");
    EXPECT_EQ(unit_of(campaign, "gross_assimilation"), "mol m-2 day-1");
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    for (const auto& [text, problem] :
         {std::pair{rows + net + "sole = [1]\n", "there are 2 components"},
          std::pair{net + "sole = [1]\n", "it distinguishes components"},
          std::pair{rows + net + "sole_errors = [1, 1]\n",
                    "give both, or neither"},
          std::pair{rows + net + "sole = [1, 1]\nweights = [1, 1]\n",
                    "remove one of them"},
          std::pair{rows + net + "minimise = \"lai\"\nsole = [1, 1]\n",
                    "ask for one objective"},
          std::pair{rows + "[objective]\nmaximise = \"fapar\"\n"
                           "sole = [1, 1]\n",
                    "fapar is not a sum over components, which could be "
                    "weighted; remove objective.sole"}})
        EXPECT_NE(problems_of(text).find(problem), std::string::npos) << text;
}

TEST(Components, HaveTheVariationOfTheFieldUnlessTheyStateAnother) {
    const std::string field = "[field.variation]\nlength = 0.1\n";
    const auto with_variation = [&](const std::string& own) {
        return mixed(sorghum + "rows = [2]\n" + own + field);
    };
    EXPECT_FALSE(with_variation("").components[0].standing.variation);
    EXPECT_FALSE(with_variation("variation = {}\n")
                     .components[0]
                     .standing.variation->is_any());
    const Campaign campaign =
        with_variation("variation = { azimuth = [10, 20] }\n");
    const PlantVariation& variation =
        *campaign.components[0].standing.variation;
    EXPECT_EQ(variation.length, 0);
    EXPECT_EQ(variation.azimuth, (std::vector<double>{10, 20}));
    EXPECT_EQ(campaign.spec.field.variation.length, 0.1);
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    for (const auto& [text, problem] :
         {std::pair{"variation = 3\n", "expected: one table"},
          std::pair{"variation = { lenth = 0.1 }\n", "unknown key 'lenth'"},
          std::pair{"variation = { length = 0.9 }\n", "length is 0.9"}})
        EXPECT_NE(problems_of(sorghum + "rows = [2]\n" + text).find(problem),
                  std::string::npos)
            << problems_of(sorghum + "rows = [2]\n" + text);
}

TEST(Rows, RepeatTheirDistances) {
    const Campaign campaign = mixed("[field]\nrow_pattern = [1, 3]\n");
    EXPECT_EQ(campaign.spec.field.row_pattern, (std::vector<double>{1, 3}));
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    EXPECT_NE(problems_of("[field]\nrow_pattern = [1, 3, 2]\n")
                  .find("use a multiple of 3 rows"),
              std::string::npos);
    EXPECT_NE(problems_of("[field]\nrow_pattern = [1, 3]\n"
                          "boundary = \"isolated\"\n")
                  .find("for fields that repeat"),
              std::string::npos);
}

TEST(Bands, OfNearInfraredMustBeDeclaredBeforeUse) {
    for (const char* more : {"[objective]\nmaximise = \"absorbed_nir\"\n",
                             "[light]\nband = \"nir\"\n"})
        EXPECT_NE(problems_of(more).find("[[band]]"), std::string::npos)
            << more;
    EXPECT_NE(problems_of("[[band]]\nname = \"nir\"\n"
                          "[optics.nir]\nleaf_reflectance = 0.9\n")
                  .find("nir.leaf_transmittance"),
              std::string::npos);
}

}  // namespace
}  // namespace ideotype
