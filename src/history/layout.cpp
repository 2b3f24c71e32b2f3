#include "layout.hpp"

#include <algorithm>

#include <hdf5_hl.h>

#include "types.hpp"

namespace ideotype {

namespace {

Handle create_space(const DatasetForm& form) {
    const std::string action = "create " + form.name;
    if (form.sizes.empty()) return {H5Screate(H5S_SCALAR), H5Sclose, action};
    return {H5Screate_simple(static_cast<int>(form.sizes.size()),
                             form.sizes.data(), nullptr),
            H5Sclose, action};
}

Handle create_properties(const DatasetForm& form) {
    const std::string action = "create " + form.name;
    Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, action);
    // Times would make two equal runs give different files.
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

}  // namespace

Handle create_dataset(hid_t parent, const DatasetForm& form) {
    const Handle space = create_space(form);
    const Handle properties = create_properties(form);
    Handle dataset(H5Dcreate2(parent, form.name.c_str(), form.type, space,
                              H5P_DEFAULT, properties, H5P_DEFAULT),
                   H5Dclose, "create " + form.name);
    create_attribute(dataset, "unit", form.unit);
    return dataset;
}

Handle create_texts(hid_t parent, const std::string& name,
                    const std::vector<std::string>& texts) {
    std::size_t size = 1;
    for (const std::string& text : texts) size = std::max(size, text.size());
    const Handle type = string_type(size);
    Handle dataset = create_dataset(
        parent,
        {.name = name, .type = type, .sizes = {texts.size()}, .unit = ""});
    std::string bytes;
    for (const std::string& text : texts) {
        bytes += text;
        bytes.append(size - text.size(), '\0');
    }
    if (!texts.empty())
        checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                         bytes.data()),
                "write " + name);
    return dataset;
}

void create_text(hid_t parent, const std::string& name,
                 const std::string& text) {
    const Handle type = string_type(text.size());
    const Handle dataset = create_dataset(
        parent, {.name = name, .type = type, .sizes = {}, .unit = ""});
    checked(
        H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()),
        "write " + name);
}

Handle create_group(hid_t parent, const std::string& name) {
    return {
        H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose, "create " + name};
}

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text) {
    create_attribute(object, name, string_type(text.size()), text.c_str());
}

void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create " + name);
    const Handle attribute(
        H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose, "create " + name);
    checked(H5Awrite(attribute, type, value), "write " + name);
}

void label_dimension(hid_t dataset, unsigned dimension,
                     const std::string& label) {
    checked(H5DSset_label(dataset, dimension, label.c_str()),
            "label a dimension " + label);
}

void attach_scale(hid_t dataset, unsigned dimension, hid_t scale) {
    if (checked(H5DSis_scale(scale), "find a scale") == 0)
        checked(H5DSset_scale(scale, nullptr), "create a scale");
    checked(H5DSattach_scale(dataset, scale, dimension), "attach a scale");
}

}  // namespace ideotype
