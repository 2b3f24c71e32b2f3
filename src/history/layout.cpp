// SPDX-License-Identifier: Apache-2.0
#include "layout.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include <hdf5_hl.h>

#include "dataset.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

using Sizes = std::vector<hsize_t>;

Handle create_space(const Sizes& sizes) {
    const std::string action = "create a shape";
    if (sizes.empty()) return {H5Screate(H5S_SCALAR), H5Sclose, action};
    return {
        H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr),
        H5Sclose, action};
}

Handle create_properties(const DatasetForm& form) {
    const std::string action = "create " + form.name;
    Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, action);
    // Without this, files of identical runs would differ in creation times.
    checked(H5Pset_obj_track_times(properties, false), action);
    checked(H5Pset_layout(properties, H5D_CONTIGUOUS), action);
    checked(H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY), action);
    if (form.room == Room::as_needed) {
        checked(H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER), action);
    } else if (form.empty) {
        const Handle native(H5Tget_native_type(form.type, H5T_DIR_ASCEND),
                            H5Tclose, action);
        checked(H5Pset_fill_value(properties, native, form.empty), action);
    }
    return properties;
}

// Creates a dataset with its attributes, without scales.
Handle create_block(hid_t group, const DatasetForm& form, const Sizes& sizes) {
    Handle dataset(
        H5Dcreate2(group, form.name.c_str(), form.type, create_space(sizes),
                   H5P_DEFAULT, create_properties(form), H5P_DEFAULT),
        H5Dclose, "create " + form.name);
    // Attribute names follow the CF conventions; xarray shows them on axes.
    create_attribute(dataset, "units", form.unit);
    create_attribute(dataset, "long_name", form.meaning);
    return dataset;
}

Handle open_scale(hid_t group, const std::string& name) {
    return {H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose,
            "open the axis " + name};
}

std::size_t find_longest(const std::vector<std::string>& texts) {
    std::size_t size = 1;
    for (const std::string& text : texts) size = std::max(size, text.size());
    return size;
}

void fill(hid_t group, const std::string& name,
          const std::vector<std::string>& texts) {
    Dataset dataset(group, name);
    IDEOTYPE_EXPECT(dataset.rows() == texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i)
        dataset.write_text(i, texts[i]);
}

template <class Number>
void fill(hid_t group, const std::string& name,
          const std::vector<Number>& numbers) {
    Dataset(group, name).write(0, numbers);
}

Handle make_type(const std::vector<std::string>& texts) {
    return string_type(find_longest(texts));
}

template <class Number>
Handle make_type(const std::vector<Number>&) {
    const bool is_double = std::is_same_v<Number, double>;
    return {H5Tcopy(is_double ? H5T_IEEE_F64LE : H5T_STD_I64LE), H5Tclose,
            "create a type"};
}

}  // namespace

Handle create_dataset(hid_t group, const DatasetForm& form) {
    IDEOTYPE_EXPECT(!form.name.empty() && form.type >= 0);
    std::vector<Handle> scales;
    Sizes sizes;
    for (const std::string& axis : form.axes) {
        scales.push_back(open_scale(group, axis));
        sizes.push_back(Dataset(group, axis).rows());
    }
    Handle dataset = create_block(group, form, sizes);
    for (unsigned i = 0; i < scales.size(); ++i)
        checked(H5DSattach_scale(dataset, scales[i], i), "attach a scale");
    return dataset;
}

void create_axis(hid_t group, const Axis& axis) {
    std::visit(
        [&](const auto& values) {
            const Handle type = make_type(values);
            const Handle scale = create_block(group,
                                              {.name = axis.name,
                                               .type = type,
                                               .unit = axis.unit,
                                               .meaning = axis.meaning},
                                              {values.size()});
            checked(H5DSset_scale(scale, axis.name.c_str()), "create a scale");
            fill(group, axis.name, values);
        },
        axis.coordinates);
}

void create_texts(hid_t group, DatasetForm form,
                  const std::vector<std::string>& texts) {
    const Handle type = string_type(find_longest(texts));
    form.type = type;
    form.unit = "";
    create_dataset(group, form);
    fill(group, form.name, texts);
}

bool exists(hid_t group, const std::string& name) {
    return checked(H5Lexists(group, name.c_str(), H5P_DEFAULT),
                   "look for " + name) != 0;
}

Axis read_axis(hid_t group, const std::string& name) {
    const Dataset scale(group, name);
    Axis axis{name, scale.text("units"), scale.text("long_name"), {}};
    switch (scale.kind()) {
        case H5T_STRING:
            axis.coordinates = scale.read_text(0, scale.rows());
            break;
        case H5T_INTEGER:
            axis.coordinates = scale.read<std::int64_t>(0, scale.rows());
            break;
        default:
            axis.coordinates = scale.read<double>(0, scale.rows());
    }
    return axis;
}

Handle create_group(hid_t parent, const std::string& name) {
    return {
        H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose, "create " + name};
}

}  // namespace ideotype
