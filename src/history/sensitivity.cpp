// SPDX-License-Identifier: Apache-2.0
#include "sensitivity.hpp"

#include <cstdint>
#include <limits>

#include "checksum.hpp"
#include "columns.hpp"
#include "dataset.hpp"
#include "layout.hpp"
#include "types.hpp"

namespace ideotype {

namespace {

struct Statistic {
    const char* name;
    const char* meaning;
    double QuantitySensitivity::*member;
};

constexpr Statistic statistics[] = {
    {"mean", "of all rows of complete samples", &QuantitySensitivity::mean},
    {"standard_deviation", "of the quantity without that of noise",
     &QuantitySensitivity::standard_deviation},
    {"noise_standard_deviation", "of noise, by the rows' standard errors",
     &QuantitySensitivity::noise},
};

constexpr const char* unit_path = "/sensitivity/unit";
constexpr const char* error_suffix = "_standard_error";

//! The datasets of an index and of its standard error.
constexpr std::pair<const char*, double Estimate::*> index_parts[] = {
    {"", &Estimate::mean}, {error_suffix, &Estimate::standard_error}};

std::string path(const std::string& name) {
    return std::string(SensitivityTable::group) + "/" + name;
}

Axis names(const std::string& name, const std::string& meaning,
           const std::vector<std::string>& texts) {
    return {name, "", meaning, texts};
}

}  // namespace

void SensitivityTable::create(hid_t file, const SensitivityForm& form) {
    const Handle at = create_group(file, group);
    create_axis(at, names("quantity", "objectives, and all single numbers",
                          form.quantities));
    create_axis(
        at, names("factor", "a gene, or what its genes are of", form.factors));
    create_texts(at,
                 {.name = "unit", .axes = {"quantity"}, .meaning = "of values"},
                 form.units);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Statistic& each : statistics)
        create_dataset(at, {.name = each.name,
                            .type = H5T_IEEE_F64LE,
                            .axes = {"quantity"},
                            .unit = unit_path,
                            .meaning = each.meaning,
                            .empty = &nan});
    create_dataset(at, {.name = "samples",
                        .type = H5T_STD_I64LE,
                        .axes = {"quantity"},
                        .meaning = "that are complete"});
    for (const SensitivityIndex& index : sensitivity_indices(form.method))
        for (const auto& [suffix, member] : index_parts)
            create_dataset(at, {.name = index.name + suffix,
                                .type = H5T_IEEE_F64LE,
                                .axes = {"quantity", "factor"},
                                .unit = index.is_relative ? "1" : unit_path,
                                .meaning = index.meaning,
                                .empty = &nan});
    const Handle type = string_type(checksum_size);
    create_dataset(at, {.name = "checksum",
                        .type = type,
                        .axes = {"quantity"},
                        .unit = "",
                        .meaning = "SHA-256 of the row"});
}

std::optional<SensitivityForm> SensitivityTable::read_form(hid_t file) {
    if (!exists(file, group)) return std::nullopt;
    const auto texts = [&](const std::string& name) {
        const Dataset dataset(file, path(name));
        return dataset.read_text(0, dataset.rows());
    };
    const bool is_sobol = exists(file, path("first"));
    return SensitivityForm{
        is_sobol ? SensitivityMethod::sobol : SensitivityMethod::morris,
        texts("factor"), texts("quantity"), texts("unit")};
}

void SensitivityTable::write(
    hid_t file, const SensitivityForm& form,
    const std::vector<QuantitySensitivity>& quantities) {
    const auto indices = sensitivity_indices(form.method);
    for (std::size_t row = 0; row < quantities.size(); ++row) {
        const QuantitySensitivity& one = quantities[row];
        for (const Statistic& each : statistics)
            Dataset(file, path(each.name)).write_one(row, one.*each.member);
        Dataset(file, path("samples"))
            .write_one(row, static_cast<std::int64_t>(one.samples));
        for (std::size_t i = 0; i < indices.size(); ++i)
            for (const auto& [suffix, member] : index_parts) {
                std::vector<double> values;
                for (const Estimate& each : one.indices[i])
                    values.push_back(each.*member);
                Dataset(file, path(indices[i].name + suffix))
                    .write(row, values);
            }
        Dataset(file, path("checksum"))
            .write_text(row, sensitivity_checksum(file, row));
    }
}

std::vector<QuantitySensitivity> SensitivityTable::read(
    hid_t file, const SensitivityForm& form) {
    std::vector<QuantitySensitivity> quantities(form.quantities.size());
    const auto indices = sensitivity_indices(form.method);
    for (std::size_t row = 0; row < quantities.size(); ++row) {
        QuantitySensitivity& one = quantities[row];
        for (const Statistic& each : statistics)
            one.*each.member =
                Dataset(file, path(each.name)).read<double>(row, 1)[0];
        one.samples = static_cast<std::size_t>(
            Dataset(file, path("samples")).read<std::int64_t>(row, 1)[0]);
        for (const SensitivityIndex& index : indices) {
            std::vector<Estimate> estimates(form.factors.size());
            for (const auto& [suffix, member] : index_parts) {
                const auto values = Dataset(file, path(index.name + suffix))
                                        .read<double>(row, 1);
                for (std::size_t k = 0; k < values.size(); ++k)
                    estimates[k].*member = values[k];
            }
            one.indices.push_back(std::move(estimates));
        }
    }
    return quantities;
}

}  // namespace ideotype
