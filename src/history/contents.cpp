// SPDX-License-Identifier: Apache-2.0
#include "contents.hpp"

#include <algorithm>

namespace ideotype {

namespace {

constexpr std::size_t block_bytes = 1 << 18;

// Exceptions must not pass through C; running out of memory is not foreseen.
herr_t keep_object(hid_t, const char* name, const H5O_info_t* info,
                   void* target) {
    static_cast<std::vector<Object>*>(target)->push_back(
        {name, info->type == H5O_TYPE_DATASET});
    return 0;
}

herr_t keep_name(hid_t, const char* name, const H5A_info_t*, void* target) {
    static_cast<std::vector<std::string>*>(target)->emplace_back(name);
    return 0;
}

Handle space_of(hid_t dataset) {
    return {H5Dget_space(dataset), H5Sclose, "read a shape"};
}

std::vector<hsize_t> sizes_of(hid_t dataset) {
    const Handle space = space_of(dataset);
    const int rank = checked(H5Sget_simple_extent_ndims(space), "read a rank");
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    checked(H5Sget_simple_extent_dims(space, sizes.data(), nullptr),
            "read a shape");
    return sizes;
}

// Selections of one block in the file and in memory.
struct Selection {
    Handle file;
    Handle memory;
};

Selection select(hid_t dataset, const Blocks& blocks, hsize_t first,
                 hsize_t count) {
    const std::string action = "select a block";
    Handle file = space_of(dataset);
    if (blocks.sizes.empty())
        return {std::move(file), {H5Screate(H5S_SCALAR), H5Sclose, action}};
    std::vector<hsize_t> begin(blocks.sizes.size(), 0);
    std::vector<hsize_t> size = blocks.sizes;
    begin[0] = first;
    size[0] = count;
    checked(H5Sselect_hyperslab(file, H5S_SELECT_SET, begin.data(), nullptr,
                                size.data(), nullptr),
            action);
    return {
        std::move(file),
        {H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
         H5Sclose, action}};
}

}  // namespace

std::vector<Object> objects_of(hid_t file) {
    std::vector<Object> objects;
    checked(H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, keep_object, &objects,
                      H5O_INFO_BASIC),
            "list the objects");
    return objects;
}

Handle open_object(hid_t file, const Object& object) {
    return {H5Oopen(file, object.path.c_str(), H5P_DEFAULT), H5Oclose,
            "open " + object.path};
}

std::vector<std::string> attributes_of(hid_t object) {
    std::vector<std::string> names;
    checked(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_name,
                        &names),
            "list the attributes");
    std::erase_if(names, [](const std::string& name) {
        return name == "CLASS" || name == "NAME" || name == "DIMENSION_LIST" ||
               name == "REFERENCE_LIST" || name == "DIMENSION_LABELS";
    });
    return names;
}

StoredValue read_attribute(hid_t object, const std::string& name) {
    const std::string action = "read attribute " + name;
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                           action);
    Handle type(H5Aget_type(attribute), H5Tclose, action);
    std::vector<char> values(H5Tget_size(type));
    checked(H5Aread(attribute, type, values.data()), action);
    return {std::move(type), std::move(values)};
}

Blocks::Blocks(hid_t dataset)
    : type(H5Dget_type(dataset), H5Tclose, "read a type"),
      sizes(sizes_of(dataset)),
      row_bytes(H5Tget_size(type)) {
    for (std::size_t i = 1; i < sizes.size(); ++i) row_bytes *= sizes[i];
    if (!sizes.empty()) rows = sizes[0];
    const std::size_t fitting =
        block_bytes / std::max<std::size_t>(row_bytes, 1);
    rows_per_block =
        std::clamp<hsize_t>(fitting, 1, std::max<hsize_t>(rows, 1));
}

void Blocks::for_each(
    const std::function<void(hsize_t, hsize_t)>& action) const {
    for (hsize_t first = 0; first < rows; first += rows_per_block)
        action(first, std::min(rows_per_block, rows - first));
}

std::vector<char> read_block(hid_t dataset, const Blocks& blocks, hsize_t first,
                             hsize_t count) {
    const auto [file, memory] = select(dataset, blocks, first, count);
    std::vector<char> bytes(count * blocks.row_bytes);
    checked(
        H5Dread(dataset, blocks.type, memory, file, H5P_DEFAULT, bytes.data()),
        "read a block");
    return bytes;
}

}  // namespace ideotype
