// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign/cases.hpp"
#include "campaign/entries.hpp"
#include "sample_campaign.hpp"

namespace ideotype {
namespace {

using testing::ElementsAre;

const std::string keys = R"(
[search]
keys = [
    { key = "spacing.density", range = [5, 12] },
    { key = "field.rows", range = [1, 6] },
    { key = "field.boundary", values = ["isolated", "periodic"] },
    { key = "field.jitter", values = [20, 0, 10] },
    { key = "day.date", values = [2025-08-07, 2025-06-21] },
]
)";

TEST(VariedKeys, NumbersAndDatesAreInOrderAndOtherValuesAreChoices) {
    const Campaign campaign = sample("", keys);
    GeneSpace genes = search_genes(campaign, cases(campaign).front());
    genes.erase(genes.begin(), genes.end() - 5);
    std::vector<GeneKind> kinds;
    for (const Gene& gene : genes) kinds.push_back(gene.kind);
    EXPECT_THAT(kinds,
                ElementsAre(GeneKind::real, GeneKind::integer, GeneKind::choice,
                            GeneKind::integer, GeneKind::integer));
    EXPECT_EQ(genes[1].lower, 1);
    EXPECT_EQ(genes[1].upper, 6);
    EXPECT_EQ(genes[2].upper, 1);
    EXPECT_THAT(genes[2].values, ElementsAre("\"isolated\"", "\"periodic\""));
    EXPECT_THAT(genes[3].values, ElementsAre("0", "10", "20"));
    EXPECT_THAT(genes[4].values, ElementsAre("2025-06-21", "2025-08-07"));
    std::vector<double> numbers;
    for (const KeyFactor& factor : campaign.varied.keys)
        numbers.push_back(factor.number);
    EXPECT_NEAR(numbers[0], 1 / (0.762 * 0.1524), 1e-9);
    EXPECT_THAT(std::vector(numbers.begin() + 1, numbers.end()),
                ElementsAre(4, 1, 1, 1));
}

TEST(VariedKeys, GenesSetTheValuesOfTheCampaign) {
    const Campaign campaign = sample("", keys);
    Genome genome = baseline_genome(campaign);
    const std::size_t plant = genome.size();
    genome.insert(genome.end(), {8, 3, 0, 2, 0});
    const Spec& spec = at_keys(campaign, genome).spec;
    EXPECT_EQ(genome.size(), plant);
    EXPECT_EQ(spec.spacings[0].value.plant, 1 / (8 * 0.762));
    EXPECT_EQ(spec.field.rows, 3);
    EXPECT_EQ(spec.field.boundary, Boundary::isolated);
    EXPECT_EQ(spec.field.jitter, 20);
    EXPECT_EQ(spec.days[0].value.dates.front(), (Date{2025, 6, 21}));
}

TEST(VariedKeys, VariedRowsKeepTheVariedDensity) {
    const Campaign campaign = sample("", R"(
[search]
keys = [
    { key = "spacing.density", range = [5, 12] },
    { key = "spacing.row", range = [0.5, 1] },
]
)");
    Genome genome = baseline_genome(campaign);
    genome.insert(genome.end(), {8, 0.5});
    const Campaign varied = at_keys(campaign, genome);
    EXPECT_EQ(varied.spec.spacings[0].value.plant, 0.25);
}

TEST(VariedKeys, ResolvedTextsHaveTheSameGenes) {
    for (const char* place : {"plant = 0.1524", "density = 7.3"}) {
        const Campaign first = parse_campaign(
            replaced(sample_text("", keys), "plant = 0.1524", place), "first");
        const Campaign again = parse_campaign(first.resolved, "again");
        EXPECT_EQ(again.resolved, first.resolved);
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(again.varied.keys[i].number, first.varied.keys[i].number);
            EXPECT_EQ(again.varied.keys[i].values, first.varied.keys[i].values);
        }
    }
}

TEST(VariedKeys, ScenariosShareADateButKeepTheirYears) {
    const Campaign campaign = read_campaign(
        IDEOTYPE_CAMPAIGNS "/growing_season.toml",
        {"search.keys=[{key=\"climate.emergence\", values=[2011-06-01, "
         "2011-05-15]}]"});
    EXPECT_EQ(campaign.varied.keys[0].number, 0);
    Genome genome = baseline_genome(campaign);
    genome.push_back(1);
    const Campaign varied = at_keys(campaign, genome);
    ASSERT_EQ(varied.spec.climates.size(), 2u);
    EXPECT_EQ(varied.spec.climates[0].value.emergence, (Date{2011, 6, 1}));
    EXPECT_EQ(varied.spec.climates[1].value.emergence, (Date{2012, 6, 1}));
}

TEST(VariedKeys, AGivenDensityIsTheNumberOfItsGene) {
    const Campaign campaign = parse_campaign(
        replaced(sample_text("", keys), "plant = 0.1524", "density = 7.3"),
        "sample");
    EXPECT_EQ(campaign.varied.keys[0].number, 7.3);
}

}  // namespace
}  // namespace ideotype
