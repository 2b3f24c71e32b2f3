// SPDX-License-Identifier: Apache-2.0
#include "new_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/campaign/keys.hpp"
#include "ideotype/climate/daylight.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! Full hours around the light of a day, on the local clock.
struct Hours {
    int start = 0, end = 24;
};

Hours hours_of_light(const Site& site, const Date& date) {
    const Daylight day = daylight(site, date);
    if (!day.sunrise && !(day.elevation > 0))
        throw Error(fmt::format("the sun does not rise on {} at a latitude of "
                                "{} deg; choose another date",
                                to_string(date), site.latitude),
                    ExitCode::usage);
    if (!day.sunrise || !day.sunset) return {};
    return {std::max(0, static_cast<int>(std::floor(*day.sunrise))),
            std::min(24, static_cast<int>(std::ceil(*day.sunset)))};
}

std::string clock(int hour) {
    // TOML's days end before 24:00.
    return hour < 24 ? fmt::format("{:02}:00:00", hour) : "\"24:00\"";
}

std::string quoted(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '"' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return '"' + escaped + '"';
}

//! Writes keys with what their declarations say of them.
class Writer {
  public:
    std::string text;

    void table(const std::string& heading, const std::string& about) {
        text += fmt::format("\n# {}\n{}\n", about, heading);
        section_ = heading;
        std::erase_if(section_, [](char c) { return c == '[' || c == ']'; });
    }

    //! @param value as TOML; "": the default
    //! @param note in the place of the key's meaning
    void key(const std::string& name, const std::string& value = "",
             const std::string& note = "") {
        const auto found =
            std::find_if(keys_.begin(), keys_.end(), [&](const KeyInfo& each) {
                return each.section == section_ && each.name == name;
            });
        const std::string unit =
            found->unit == "-" ? "" : fmt::format(" [{}]", found->unit);
        comment(fmt::format("{} = {}", name,
                            value.empty() ? found->initial : value),
                (note.empty() ? found->meaning : note) + unit);
    }

    void comment(const std::string& line, const std::string& words) {
        text += fmt::format("{:<27} # {}\n", line, words);
    }

  private:
    std::vector<KeyInfo> keys_ = campaign_keys();
    std::string section_ = "top";
};

//! Bounds of the bred traits that the baseline is beyond.
std::string wider_bounds(const Crop& crop) {
    constexpr double step = 100;  // to be read easily
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    const std::vector<double> baseline = baseline_numbers(crop);
    std::string text;
    for (std::size_t t = 0; t < crop.traits.size(); ++t) {
        const Trait& trait = crop.traits[t];
        Range range = trait.range;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (numbers[i].trait != t) continue;
            if (baseline[i] < range.lower)
                range.lower = std::floor(baseline[i] * step) / step;
            if (baseline[i] > range.upper)
                range.upper = std::ceil(baseline[i] * step) / step;
        }
        const bool is_wider =
            range.lower < trait.range.lower || range.upper > trait.range.upper;
        if (trait.is_bred && is_wider)
            text +=
                fmt::format("{} = [{}, {}]  # of the crop: {} .. {} [{}]\n",
                            trait.name, range.lower, range.upper,
                            trait.range.lower, trait.range.upper, trait.unit);
    }
    return text;
}

}  // namespace

std::string text_of(const NewCampaign& campaign) {
    const auto& [name, site, date, row, plant, plant_file, crop, objective] =
        campaign;
    const auto number = [](double x) { return fmt::format("{}", x); };
    const Hours hours = hours_of_light(site, date);
    Writer out;
    out.text =
        "# A campaign of ideotype, a whole study in one file:\n"
        "#     ideotype check FILE               what is wrong, size and cost\n"
        "#     ideotype run FILE --ranks auto    on all cores of this machine\n"
        "# Other keys have defaults: see campaigns/README.md.\n\n";
    out.key("name", quoted(name));
    out.key("seed");
    out.key("replicates", "3",
            "searches of each case, apart but for their seeds: how far they "
            "differ is how sure a gain is");
    out.table("[[site]]", "The place and its clear sky.");
    out.key("name", quoted(site.name));
    out.key("latitude", number(site.latitude));
    out.key("longitude", number(site.longitude));
    out.key("utc_offset", number(site.utc_offset),
            "local clock minus UTC; summer time is one more");
    out.key("elevation");
    out.key("linke_turbidity");
    out.table("[[day]]",
              "A clear day, from sunrise to sunset. [[climate]] in its place "
              "takes measured weather.");
    out.key("date", to_string(date));
    out.key("start", clock(hours.start));
    out.key("end", clock(hours.end));
    out.key("step_minutes");
    out.table("[[spacing]]", "How far plants are apart.");
    out.key("row", number(row));
    out.key("plant", number(plant));
    out.key("row_direction");
    out.table("[field]", "Plants that repeat without end.");
    out.key("rows");
    out.key("plants");
    out.key("boundary", "", "\"isolated\" is a plot alone");
    out.key("jitter");
    out.table("[plant]", "The plant that breeding begins with.");
    out.key("baseline", quoted(plant_file), "crop file, from this folder");
    const bool is_breedable = std::ranges::count(crop.rules, "breedable") > 0;
    if (is_breedable) {
        out.key("bounds", quoted("breedable"),
                "what a breeder could select: sizes and angles that change "
                "smoothly from leaf to leaf; \"traits\" frees each leaf");
    } else if (const std::string bounds = wider_bounds(crop); bounds.empty()) {
        out.key("bounds", "", "how far traits may move: as the crop file says");
    } else {
        out.text +=
            "\n# How far traits may move: as the crop file says, but wide "
            "enough for the baseline.\n[plant.bounds]\n" +
            bounds;
    }
    out.table("[optics]", "Parts of the light, in the PAR band.");
    for (const char* each :
         {"leaf_reflectance", "leaf_transmittance", "stalk_reflectance",
          "stalk_transmittance", "sheath_reflectance", "sheath_transmittance",
          "soil_albedo", "par_fraction"})
        out.key(each);
    out.table("[light]", "How accurate an evaluation is.");
    out.key("tolerance", "0.008",
            "relative standard error of the light that leaves absorb");
    out.key("paths", "", "light paths per randomisation, at most");
    out.key("randomisations");
    out.key("sky", "", "diffuse light; \"overcast\" and \"clear\" are others");
    out.table("[objective]", "What plants are bred for.");
    out.key("maximise", quoted(objective),
            "\"net_assimilation\", \"absorbed_par\" are others");
    out.table("[search]", "How plants are proposed.");
    out.key("optimizer", "", "\"cma_es\", \"nsga2\", \"random\" are others");
    out.key("population", "100");
    out.table("[stop]", "The first rule that holds ends a case.");
    out.key("generations");
    out.key("no_gain", "",
            "generations without a gain; 0: off, else 5 or more");
    out.table("[final]",
              "The best are evaluated again, with fresh random "
              "numbers.");
    for (const char* each : {"candidates", "paths", "randomisations"})
        out.key(each);
    return out.text;
}

}  // namespace ideotype
