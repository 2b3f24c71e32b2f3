// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "columns.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Formats names and axes of quantities in the order of a schema: "lai
// absorbed_by_leaf[leaf]". In a truncated file this text may be left while the
// references to scales are lost.
std::string format_quantities(const std::vector<Quantity>& quantities) {
    const auto text = [](const Quantity& quantity) {
        return quantity.axes.empty()
                   ? quantity.name
                   : fmt::format("{}[{}]", quantity.name,
                                 fmt::join(quantity.axes, ","));
    };
    return fmt::format("{}", fmt::join(mapped(quantities, text), " "));
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::istringstream stream(text);
    std::vector<std::string> parts;
    for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(part);
    return parts;
}

Quantity read_quantity(hid_t group, const std::string& text) {
    const std::size_t bracket = std::min(text.find('['), text.size());
    const std::string name = text.substr(0, bracket);
    const Dataset dataset(group, name);
    Quantity quantity{name, dataset.text("units"), dataset.text("long_name")};
    if (bracket < text.size())
        quantity.axes =
            split(text.substr(bracket + 1, text.size() - bracket - 2), ',');
    if (!exists(group, name + error_suffix))
        quantity.certainty = Certainty::exact;
    return quantity;
}

}  // namespace

std::vector<DatasetForm> number_forms(const OutcomeSchema& schema,
                                      const std::string& rows) {
    std::vector<DatasetForm> forms;
    const auto add = [&](const std::string& name,
                         const std::vector<std::string>& axes,
                         const std::string& unit, const std::string& meaning) {
        forms.push_back({.name = name,
                         .type = H5T_IEEE_F64LE,
                         .axes = axes,
                         .unit = unit,
                         .meaning = meaning,
                         .empty = &nan});
        forms.back().axes.insert(forms.back().axes.begin(), rows);
    };
    const std::string unit = "/objectives/unit";
    add("objectives", {"objective"}, unit, "values of the objectives");
    add("objectives_standard_error", {"objective"}, unit,
        "standard error of the mean over randomisations");
    add("objectives_by_randomisation", {"objective", "randomisation"}, unit,
        "objectives in independent randomisations, shared by the rows of a "
        "generation");
    add("violation", {}, "1",
        "sum of the violations of constraints, relative to their limits");
    for (const Quantity& quantity : schema.measured.quantities) {
        add(quantity.name, quantity.axes, quantity.unit, quantity.meaning);
        if (quantity.certainty == Certainty::estimated)
            add(quantity.name + error_suffix, quantity.axes, quantity.unit,
                "standard error of: " + quantity.meaning);
    }
    return forms;
}

std::vector<std::vector<double*>> collect_numbers(const OutcomeSchema& schema,
                                                  Outcome& outcome) {
    IDEOTYPE_EXPECT(has_form(schema, outcome));
    std::vector<std::vector<double*>> columns;
    const auto add = [&](std::span<Estimate> estimates,
                         double Estimate::*member) {
        columns.emplace_back();
        for (Estimate& x : estimates) columns.back().push_back(&(x.*member));
    };
    add(outcome.objectives, &Estimate::mean);
    add(outcome.objectives, &Estimate::standard_error);
    columns.emplace_back();
    for (double& x : outcome.randomisations) columns.back().push_back(&x);
    columns.push_back({&outcome.violation});
    std::span<Estimate> rest(outcome.quantities);
    for (const Quantity& quantity : schema.measured.quantities) {
        const auto estimates = rest.first(schema.measured.size(quantity));
        rest = rest.subspan(estimates.size());
        add(estimates, &Estimate::mean);
        if (quantity.certainty == Certainty::estimated)
            add(estimates, &Estimate::standard_error);
        else
            for (Estimate& x : estimates) x.standard_error = 0;
    }
    IDEOTYPE_ENSURE(rest.empty());
    return columns;
}

void write_measured(hid_t group, const QuantitySet& measured) {
    create_attribute(group, "quantities",
                     format_quantities(measured.quantities));
    for (const Axis& axis : measured.axes) create_axis(group, axis);
}

QuantitySet read_measured(hid_t group) {
    QuantitySet measured;
    auto& [axes, quantities] = measured;
    for (const std::string& quantity_text :
         split(text_attribute(group, "quantities"), ' '))
        quantities.push_back(read_quantity(group, quantity_text));
    for (const Quantity& quantity : quantities)
        for (const std::string& axis : quantity.axes)
            if (std::none_of(axes.begin(), axes.end(), [&](const Axis& known) {
                    return known.name == axis;
                }))
                axes.push_back(read_axis(group, axis));
    return measured;
}

}  // namespace ideotype
