// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <string>
#include <tuple>

#include "declaration.hpp"
#include "ideotype/core/units.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

using Rows = std::vector<Randomised>;

//! Returns the light absorbed by leaves of each row in each band [MJ m-2 day-1
//! of all ground].
std::vector<Rows> light_of_rows(const CanopyReport& report) {
    return mapped(report.bands, [](const BandReport& band) {
        return randomised(band.rows, band.rows_by_randomisation,
                          1 / joule_per_megajoule);
    });
}

//! Returns the assimilation of each row minus a loss [mol m-2 day-1 of all
//! ground].
Rows assimilation_of_rows(const CanopyReport& report, Loss loss) {
    Rows rows;
    for (std::size_t row = 0; row < report.rows.size(); ++row) {
        const ComponentAssimilation& all = report.rows[row].assimilation;
        rows.push_back(lowered(
            loss == Loss::none ? all.gross : all.uptake,
            mapped(flux_before(*report.assimilation, loss).tallies,
                   [&](const FluxTally& tally) { return tally.rows[row]; }),
            all.loss, all.loss_by_randomisation, loss));
        rows.back().estimate = estimate(rows.back().by_randomisation);
    }
    return rows;
}

Rows lai_of_rows(const CanopyReport& report) {
    return mapped(report.rows, [&](const RowReport& row) {
        return certain(report, row.lai);
    });
}

//! Converts row values per area of all ground to values per area of the row's
//! ground.
Rows on_own_ground(const CanopyReport& report, Rows rows) {
    for (std::size_t row = 0; row < rows.size(); ++row)
        rows[row] = scaled(std::move(rows[row]),
                           report.ground_area / report.rows[row].ground);
    return rows;
}

//! Sums row values, per area of all ground, over the rows of each component,
//! and converts the sums to values per area of the ground of these rows.
Rows on_own_strip(const CanopyReport& report, Rows rows) {
    Rows strips;
    for (std::size_t c = 0; c < report.components.size(); ++c) {
        double ground = 0;
        std::vector<double> sums(rows.front().by_randomisation.size());
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (report.rows[row].component != c) continue;
            ground += report.rows[row].ground;
            for (std::size_t r = 0; r < sums.size(); ++r)
                sums[r] += rows[row].by_randomisation[r];
        }
        strips.push_back(
            scaled(known_to(0, std::move(sums)), report.ground_area / ground));
    }
    return strips;
}

//! Extracts row values per area of all ground, either for each band of an axis
//! or once.
using Take = std::function<std::vector<Rows>(const CanopyReport&)>;

Rows places_first(const std::vector<Rows>& bands) {
    Rows all;
    for (std::size_t place = 0; place < bands.front().size(); ++place)
        for (const Rows& band : bands) all.push_back(band[place]);
    return all;
}

//! Extracts row values per ground area of each row, or per ground area of the
//! strip of a component.
TakeProfile of_ground(const Take& take, Rows (*of)(const CanopyReport&, Rows)) {
    return [take, of](const CanopyReport& report) {
        std::vector<Rows> bands = take(report);
        for (Rows& rows : bands) rows = of(report, std::move(rows));
        return places_first(bands);
    };
}

//! Declares a quantity by row and by strip.
void add_figure(std::vector<Declaration>& all, const Quantity& figure,
                MeanOver mean_over, const Take& take,
                bool assimilates = false) {
    const auto declare =
        [&](const std::string& name, const std::string& meaning,
            const std::string& axis, const auto& of, bool has_strips) {
            Quantity one = figure;
            one.name += name;
            one.meaning += meaning;
            one.axes.insert(one.axes.begin(), axis);
            all.push_back({std::move(one), mean_over, of_ground(take, of),
                           [=](const Scope& scope) {
                               return scope.has_rows &&
                                      (!assimilates || scope.assimilates) &&
                                      (!has_strips || scope.components > 1);
                           }});
        };
    declare("_by_row", " per ground that is nearest to the row", "field_row",
            on_own_ground, false);
    declare("_of_strip", " per ground that is nearest to rows of the component",
            "component", on_own_strip, true);
}

}  // namespace

std::vector<Declaration> row_quantities() {
    using Report = CanopyReport;
    std::vector<Declaration> all;
    for (const auto& [name, meaning, take] :
         {std::tuple{"row_position", "place of the row across the field",
                     &RowReport::position},
          std::tuple{"row_width", "width of the ground nearest to the row",
                     &RowReport::width}})
        all.push_back({exact(by({"field_row"}, {name, "m", meaning})),
                       MeanOver::time,
                       [member = take](const Report& r) {
                           return mapped(r.rows, [&](const RowReport& row) {
                               return Estimate{row.*member, 0};
                           });
                       },
                       [](const Scope& scope) { return scope.has_rows; }});
    add_figure(
        all, exact({"lai", "m2 m-2", "one-sided leaf area"}), MeanOver::time,
        [](const Report& r) { return std::vector<Rows>{lai_of_rows(r)}; });
    add_figure(
        all,
        by({"band"}, {"absorbed_light", daily, "light that leaves absorb"}),
        MeanOver::nothing, light_of_rows);
    const auto add_assimilation = [&](const char* name, const char* meaning,
                                      Loss loss) {
        add_figure(
            all, {name, rate, meaning}, MeanOver::nothing,
            [loss](const Report& r) {
                return std::vector<Rows>{assimilation_of_rows(r, loss)};
            },
            true);
    };
    add_assimilation("gross_assimilation", "CO2 that leaves take up",
                     Loss::none);
    add_assimilation("net_assimilation",
                     "gross assimilation less the respiration of leaves "
                     "while there is light",
                     Loss::in_light);
    add_assimilation("carbon_balance",
                     "gross assimilation less the respiration of leaves by day "
                     "and night and the carbon that builds them",
                     Loss::all);
    return all;
}

}  // namespace ideotype
