// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign/schema/keys.hpp"
#include "campaign/schema/schema.hpp"
#include "ideotype/core/contract.hpp"
#include "sample_campaign.hpp"

namespace ideotype {

namespace {

//! Calls a function with each key that the program reads; its value is the
//! default.
void for_each_key(
    const std::function<void(const std::string&, const Key&)>& use) {
    Draft draft;
    const auto use_section = [&](const Section& section) {
        for (const Key& key : section.keys) use(section.name, key);
    };
    const auto use_table = [&](const Table& table) {
        if (table.resize) table.resize(1);
        use_section(table.section(0));
    };
    // One trait stands for all traits.
    draft.traits.resize(1);
    draft.traits[0].trait.name = "TRAIT";
    draft.traits[0].sets = {};
    draft.rule.clear();
    draft.own_bounds = {draft.traits[0].trait.range};
    draft.campaign.constraints.traits = {{"TRAIT"}};
    use_section(top_section(draft.campaign));
    for (const Table& table : campaign_tables(draft)) {
        use_table(table);
        for (const Table& child : table.children) use_table(child);
    }
    use_section(plant_file_section(draft.campaign.crop.baseline));
    for (const Table& table : plant_tables(draft)) use_table(table);
}

//! Returns whether the default of a key is told in words, because it depends on
//! other keys.
bool is_in_words(const std::string& initial) {
    return initial.find("; ") != initial.npos ||
           initial.find(" if ") != initial.npos ||
           (std::isalpha(static_cast<unsigned char>(initial.front())) != 0 &&
            initial != "true" && initial != "false");
}

//! Returns the sample with all keys that a climate may have, in place of a day.
std::string with_climate(const std::string& more) {
    std::string text = sample_text("", more);
    const std::size_t begin = text.find("[[day]]");
    text.replace(begin, text.find("[[spacing]]") - begin,
                 "weather = \"own.csv\"\n"
                 "[[climate]]\nname = \"dry\"\nfile = \"a.csv\"\n"
                 "from = 2025-08-07\nto = 2025-08-07\nstamp = \"end\"\n"
                 "time = [\"t\"]\nutc_offset = -6\nmissing = -1\n"
                 "global = [\"g\", \"W/m2\"]\n"
                 "beam_normal = [\"b\", \"W/m2\"]\n"
                 "diffuse = [\"d\", \"W/m2\"]\n"
                 "diffuse_fraction = [\"f\", \"1\"]\n"
                 "temperature = [\"t\", \"C\"]\n"
                 "humidity = [\"h\", \"%\"]\nwind = [\"w\", \"m/s\"]\n"
                 "wind_height = 2\npressure = [\"p\", \"kPa\"]\n"
                 "longwave = [\"l\", \"W/m2\"]\nco2 = 420\n");
    return text +
           "[[weather]]\nsite = \"Ames\"\nclimate = \"dry\"\n"
           "sha256 = \"0\"\nutc_offset = -6\ndates = 2025-08-07\n"
           "hours = [12]\nbeam = [100]\ndiffuse = [50]\n"
           "temperature = [20]\nhumidity = [0.5]\n"
           "nir_beam = [110]\nnir_diffuse = [60]\n"
           "wind = [2]\npressure = [99]\nlongwave = [350]\n";
}

}  // namespace

TEST(Documentation, DeclaresTheKeysThatAreReadAndNoOthers) {
    std::vector<std::string> read, declared;
    for_each_key([&](const std::string& section, const Key& key) {
        read.push_back(section + '.' + key.name);
    });
    for (const KeyInfo& key : campaign_keys())
        declared.push_back(key.section + '.' + key.name);
    EXPECT_EQ(read, declared);
}

TEST(Documentation, TellsTheDefaults) {
    int compared = 0;
    for_each_key([&](const std::string& section, const Key& key) {
        const std::string& initial = key_info(section, key.name).initial;
        const std::string text = toml_text(key);
        if (key.is_required || is_in_words(initial) || text.empty() ||
            (text == "[]" && key.count == any_count))
            return;
        EXPECT_EQ(text, initial) << section << '.' << key.name;
        ++compared;
    });
    EXPECT_GT(compared, 150);
}

TEST(Documentation, IsNeededForEachKey) {
    EXPECT_THROW(key_info("site", "height"), Error);
    int number = 0;
    EXPECT_THROW(Section("site", {{"height", &number}}), Error);
#ifdef IDEOTYPE_CONTRACTS
    // Latitudes are decimal numbers.
    EXPECT_THROW(Section("site", {{"latitude", &number}}), ContractError);
    Section site("site", {});
    EXPECT_THROW(site["latitude"], ContractError);
#endif
}

TEST(Documentation, EveryKeySaysWhatItMeans) {
    EXPECT_GT(campaign_keys().size(), 60u);
    for (const KeyInfo& key : campaign_keys()) {
        EXPECT_NE(key.type, "") << key.section << '.' << key.name;
        EXPECT_NE(key.range, "") << key.section << '.' << key.name;
        EXPECT_NE(key.initial, "") << key.section << '.' << key.name;
        EXPECT_NE(key.meaning, "") << key.section << '.' << key.name;
    }
}

TEST(Documentation, ResolvedTextHasExactlyTheDeclaredKeys) {
    // Bounds given by name and constraints without limits have no table; a
    // trait does only one thing; the plant has a table of its own.
    const std::set<std::string> left_out{"plant.bounds", "constraints.TRAIT"};
    const std::set<std::string> of_plant{"stalk", "sheath", "petiole",
                                         "blade", "growth", "leaf",
                                         "organ", "trait",  "bounds"};
    std::set<std::string> declared;
    for (const KeyInfo& key : campaign_keys()) {
        if (left_out.contains(key.section) || key.name == "baseline" ||
            key.name == "lines" || key.name == "scales" || key.name == "shifts")
            continue;
        std::string section = key.section + '.';
        if (section == "top.") section = "";
        if (section == "crop file.") section = "plant.baseline.";
        if (of_plant.contains(key.section))
            section = "plant.baseline." + section;
        declared.insert(section + key.name);
    }
    std::set<std::string> written;
    const std::string organ =
        "[[plant.baseline.organ]]\nname = \"ear\"\nlength = 0.2\n"
        "base_diameter = 0.05\n";
    // Models of leaves have keys of their own.
    const std::string hyperbola =
        "[photosynthesis]\nphi = 0.05\ntheta = 0.8\namax = 40\nrd = 1\n";
    // A rate in full light is given in place of amax.
    const std::string rate = "[photosynthesis]\nrate_2000 = 40\n";
    const std::string collatz =
        "[photosynthesis]\nmodel = \"collatz\"\nvmax = 30\nalpha = 0.06\n"
        "beta = 0.9\nk = 0.6\n";
    const std::string sensitivity =
        "[[sensitivity.keys]]\n"
        "key = \"field.jitter\"\nrange = [0, 20]\n";
    const std::string variation =
        "[light]\nfields = 4\n[field.variation]\nlength = 0.1\nacross_row = "
        "0.7\n"
        "[feasibility]\nlimit = 3\ncorrelations = "
        "[0.5]\n[[feasibility.trait]]\n"
        "measure = \"leaf.length\"\nleaf = \"top\"\nmean = 1\n"
        "deviation = 1\n[[feasibility.trait]]\n"
        "measure = \"stalk.height\"\nmean = 1\ndeviation = 1\n"
        "[[feasibility.line]]\nname = \"B73\"\nvalues = [1, 2]\n";
    const auto lines_of = [](const Campaign& campaign) {
        return differences(campaign.resolved, "", cases(campaign).front());
    };
    std::string twisted =
        sample_text("", organ + hyperbola + sensitivity + variation);
    const std::string leaf = "[[plant.baseline.leaf]]\n";
    twisted.insert(
        twisted.find(leaf) + leaf.size(),
        "roll = 9\ntwist = 9\nmidrib = [[0, 0], [1, 2]]\n"
        "petiole_length = 0.1\npetiole_angle = 9\ninternode = 0.2\n");
    twisted +=
        "[plant.baseline.blade]\nleaflets = 3\nleaflet_divergence = 80\n"
        "[plant.baseline.growth]\nageing = [1, 0.5]\n"
        "maintenance = [1, 0.3]\nroot_share = 0.2\n"
        "ear_maintenance = 0.01\n";
    const std::string plant = "[plant]\n";
    twisted.insert(twisted.find(plant) + plant.size(), "stage = 1.5\n");
    auto lines = lines_of(parse_campaign(twisted, "sample.toml"));
    for (const std::string& line :
         lines_of(parse_campaign(sample_text("", rate), "sample.toml")))
        lines.push_back(line);
    // A campaign has days or climates, one scenario or several, and one
    // objective or a front of them.
    const std::string text =
        with_climate(organ + collatz +
                     "[objective]\nminimise = \"lai\"\nover = \"site\"\n"
                     "[search]\noptimizer = \"nsga2\"\nreference = [5, 7]\n"
                     "[water]\nslope = 2\nintercept = 0.02\n");
    for (const std::string& line :
         lines_of(parse_campaign(text, "sample.toml")))
        lines.push_back(line);
    // Components have crops of their own.
    const std::string mixed =
        "[photosynthesis]\nmodel = \"farquhar\"\nvcmax = 90\njmax = 160\n"
        "tpu = 11\ng1 = 4\n"
        "[search]\noptimizer = \"atlas\"\n"
        "[[search.keys]]\nkey = \"panel.height\"\nrange = [3, 5]\n"
        "[[search.axes]]\nquantity = \"lai\"\nrange = [2, 6]\n"
        "[field]\nrow_pattern = [1, 3]\n[objective]\nweights = [1, 1, 2]\n"
        "[[component]]\nname = \"weed\"\nrows = [2]\nplants = 3\njitter = 5\n"
        "variation = { length = 0.1 }\n"
        "crop = \"crops/sorghum.toml\"\n"
        "[[component]]\nname = \"other\"\nmixed = 2\nfree = [\"width\"]\n"
        "bounds = \"biological\"\n"
        "crop = \"crops/sorghum.toml\"\n"
        "[[panel]]\npitch = 3.048\nheight = 4\nwidth = 2\nazimuth = 180\n"
        "[[object]]\nname = \"post\"\nobj = \"post.obj\"\n"
        "vertices = [0, 0, 0, 1, 0, 0, 1, 0, 1]\nfaces = [0, 1, 2, 2]\n"
        "[[band]]\nname = \"nir\"\n";
    for (const std::string& line : lines_of(read_campaign_text(
             sample_text("", mixed), IDEOTYPE_CAMPAIGNS "/mixed.toml")))
        lines.push_back(line);
    const std::string ratio =
        "[objective]\nsole = [1, 2]\nsole_errors = [0.1, 0.1]\n"
        "[[component]]\nname = \"weed\"\nrows = [2]\n"
        "crop = \"crops/sorghum.toml\"\n";
    for (const std::string& line : lines_of(read_campaign_text(
             sample_text("", ratio), IDEOTYPE_CAMPAIGNS "/ratio.toml")))
        lines.push_back(line);
    // Plants grow in a climate, and have living stalks, sheaths and organs.
    std::string grown =
        read_campaign(IDEOTYPE_CAMPAIGNS "/growing_season.toml").source;
    const std::string temperature = "temperature = [\"temp_c\", \"C\"]\n";
    for (auto at = grown.find(temperature); at != grown.npos;
         at = grown.find(temperature, at + temperature.size()))
        grown.insert(at += temperature.size(),
                     "ppfd = [\"ppfd_umol\", \"umol/m2/s\"]\n");
    grown +=
        "[[component]]\nname = \"relay\"\nrows = [2]\nlater = 20\n"
        "crop = \"crops/maize_hybrid.toml\"\n";
    for (const std::string& line : lines_of(
             read_campaign_text(grown, IDEOTYPE_CAMPAIGNS "/growing.toml")))
        if (!line.starts_with("plant.baseline.") ||
            line.starts_with("plant.baseline.s") ||
            line.starts_with("plant.baseline.organ"))
            lines.push_back(line);
    for (const std::string& line : lines) {
        std::string name = line.substr(0, line.find(' '));
        for (const std::string key : {"component.crop", "component.variation"})
            if (name.starts_with(key)) name = key;
        const std::size_t index = name.find('[');
        if (index != std::string::npos) name.erase(index, 3);
        written.insert(name);
    }
    // The number of replicates is no part of a case.
    declared.erase("replicates");
    // Distances between plants follow from the number of plants.
    declared.erase("spacing.density");
    // A search begins at the baseline, unless it is given a plant.
    declared.erase("search.start");
    std::vector<std::string> missing;
    std::set_symmetric_difference(written.begin(), written.end(),
                                  declared.begin(), declared.end(),
                                  std::back_inserter(missing));
    EXPECT_THAT(missing, testing::IsEmpty());
}

}  // namespace ideotype
