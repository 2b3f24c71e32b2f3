// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <fmt/format.h>

#include "comparison.hpp"
#include "output_file.hpp"
#include "run/progress.hpp"

namespace ideotype {

namespace {

//! The figures of each profile, by its name.
std::map<std::string, std::vector<std::size_t>> profiles(
    const Comparison& all) {
    std::map<std::string, std::vector<std::size_t>> found;
    const std::vector<Figure>& figures = all.figures();
    for (std::size_t f = 0; f < figures.size(); ++f)
        if (figures[f].is_of_profile())
            found[figures[f].quantity.name].push_back(f);
    return found;
}

//! Where a figure of a profile is: the rank of a leaf, or the height of the
//! middle of a layer [m].
double coordinate(const Comparison& all, const Figure& figure) {
    const auto place = static_cast<double>(figure.place);
    return figure.quantity.axes.front() == "leaf"
               ? place + 1
               : all.layers.thickness * (place + 0.5);
}

//! Adds matrices of means and standard errors of figures, with lists of them if
//! they are of a profile.
//! @param take Comparison::value or Comparison::difference
template <class Take>
void add_matrices(Json& json, const Comparison& all,
                  const std::vector<std::size_t>& figures, bool is_list,
                  Take take) {
    for (const auto& [name, member] :
         {std::pair{"mean", &Estimate::mean},
          {"standard_error", &Estimate::standard_error}})
        for (std::size_t p = 0; p < all.plants.size(); ++p) {
            Json row = Json::array();
            for (std::size_t c = 0; c < all.cases.size(); ++c) {
                Json list = Json::array();
                for (const std::size_t f : figures) {
                    const std::optional<Estimate> x = (all.*take)(p, c, f);
                    list.push_back(x ? Json((*x).*member) : Json());
                }
                row.push_back(is_list ? list : list.front());
            }
            json[name].push_back(std::move(row));
        }
}

//! Adds values and differences.
void add_figures(Json& json, const Comparison& all,
                 const std::vector<std::size_t>& figures, bool is_list) {
    add_matrices(json, all, figures, is_list, &Comparison::value);
    add_matrices(json["difference"], all, figures, is_list,
                 &Comparison::difference);
}

//! A text as an entry of CSV.
std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string csv_numbers(const std::optional<Estimate>& x) {
    return x ? fmt::format("{},{}", x->mean, x->standard_error) : ",";
}

std::string title(const Quantity& quantity) {
    return title_of(quantity.name, quantity.unit);
}

//! Also relative to the first plant, if both are more than zero as they are
//! printed; each with its standard error.
std::string difference_text(const Comparison& all, std::size_t p, std::size_t c,
                            std::size_t f) {
    const std::optional<Estimate> x = all.difference(p, c, f);
    if (!x) return "-";
    const std::string text = format(*x);
    const std::optional<Estimate> gain = all.relative_gain(p, c, f);
    if (!gain || text == "0" || format(*all.value(0, c, f)) == "0") return text;
    const std::string percent = gain->standard_error > 0
                                    ? format(*gain)
                                    : fmt::format("{:.2f}", gain->mean);
    return fmt::format("{} ({}{} %)", text, gain->mean > 0 ? "+" : "", percent);
}

std::string value_text(const Comparison& all, std::size_t p, std::size_t c,
                       std::size_t f) {
    const std::optional<Estimate> x = all.value(p, c, f);
    return x ? format(*x) : "-";
}

void print_number(const Comparison& all, std::size_t c, std::size_t f) {
    for (std::size_t p = 0; p < all.plants.size(); ++p)
        fmt::print(
            "  {:<36} {:>24}{}\n", all.plants[p].name, value_text(all, p, c, f),
            p == 0 ? ""
                   : fmt::format(" {:>44}", difference_text(all, p, c, f)));
}

}  // namespace

Json to_json(const Comparison& all) {
    const std::vector<Figure>& figures = all.figures();
    const Quantity& objective = figures.front().quantity;
    Json json{{"objective", objective.name},
              {"unit", objective.unit},
              {"seed", all.under.seed}};
    for (const ComparedPlant& plant : all.plants)
        json["plants"].push_back(plant.name);
    for (const ComparedCase& each : all.cases)
        json["cases"].push_back(each.name);
    add_figures(json, all, {0}, false);
    for (const auto& row : all.outcomes) {
        Json of_plant = Json::array();
        for (const Outcome& outcome : row)
            of_plant.push_back(std::vector(
                outcome.randomisations.begin(),
                outcome.randomisations.begin() +
                    static_cast<std::ptrdiff_t>(outcome.randomisations.size() /
                                                outcome.objectives.size())));
        // Common to all plants of a case: differences are paired.
        json["by_randomisation"].push_back(of_plant);
    }
    for (std::size_t f = 0; f < figures.size(); ++f) {
        const Quantity& quantity = figures[f].quantity;
        if (figures[f].is_of_profile()) continue;
        Json& one = json["quantities"][quantity.name];
        one["unit"] = quantity.unit;
        add_figures(one, all, {f}, false);
    }
    for (const auto& [name, places] : profiles(all)) {
        const Quantity& quantity = figures[places.front()].quantity;
        const std::string& axis = quantity.axes.front();
        Json& one = json["profiles"][name];
        one["unit"] = quantity.unit;
        one["axis"] = axis;
        one["axis_unit"] = axis == "layer" ? "m" : "1";
        for (const std::size_t f : places)
            one["coordinates"].push_back(coordinate(all, figures[f]));
        add_figures(one, all, places, true);
    }
    return json;
}

void write_csv(const std::string& path, const Comparison& all) {
    OutputFile out(path);
    out.print(
        "plant,case,quantity,unit,leaf,layer_m,mean,standard_error,"
        "difference,difference_standard_error\n");
    for (std::size_t p = 0; p < all.plants.size(); ++p)
        for (std::size_t c = 0; c < all.cases.size(); ++c)
            for (std::size_t f = 0; f < all.plants[p].figures.size(); ++f) {
                const Figure& figure = all.plants[p].figures[f];
                std::string place = ",";
                if (figure.is_of_profile()) {
                    const std::string at =
                        fmt::format("{}", coordinate(all, figure));
                    const bool is_leaf = figure.quantity.axes.front() == "leaf";
                    place.insert(is_leaf ? 0 : place.size(), at);
                }
                out.print("{},{},{},{},{},{},{}\n",
                          csv_text(all.plants[p].name), all.cases[c].name,
                          figure.quantity.name, csv_text(figure.quantity.unit),
                          place, csv_numbers(all.value(p, c, f)),
                          csv_numbers(all.difference(p, c, f)));
            }
    out.finish();
}

void print(const Comparison& all) {
    const std::vector<Figure>& figures = all.figures();
    const bool has_differences = all.plants.size() > 1;
    fmt::print(
        "{} of each plant in each case{}\n", title(figures.front().quantity),
        has_differences ? ", and how much more than " + all.plants.front().name
                        : "");
    for (std::size_t c = 0; c < all.cases.size(); ++c) {
        fmt::print("\n{}\n", all.cases[c].name);
        print_number(all, c, 0);
    }
    fmt::print("\nErrors are standard errors.{}\n",
               has_differences ? " Plants of a case share their random "
                                 "numbers: those of\ndifferences are paired."
                               : "");
    for (std::size_t c = 0; c < all.cases.size(); ++c) {
        fmt::print("\n== {} ==\n", all.cases[c].name);
        for (std::size_t f = 1; f < figures.size(); ++f) {
            if (figures[f].is_of_profile()) continue;
            fmt::print("\n{}\n", title(figures[f].quantity));
            print_number(all, c, f);
        }
    }
}

}  // namespace ideotype
