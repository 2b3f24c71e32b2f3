// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "layout.hpp"
#include "search/population.hpp"

namespace ideotype {

namespace {

template <class Value>
Handle make_enumeration(
    hid_t base, std::initializer_list<std::pair<const char*, Value>> members) {
    Handle type(H5Tenum_create(base), H5Tclose, "create an enumeration");
    for (const auto& [name, value] : members)
        checked(H5Tenum_insert(type, name, &value), "fill an enumeration");
    return type;
}

// Adds the name of a dataset to a list. No exception may pass through C code,
// but only a lack of memory could cause one here.
herr_t keep_dataset(hid_t, const char* name, const H5O_info_t* info,
                    void* target) {
    if (info->type == H5O_TYPE_DATASET)
        static_cast<std::vector<std::string>*>(target)->emplace_back(name);
    return 0;
}

herr_t keep_name(hid_t, const char* name, const H5A_info_t*, void* target) {
    static_cast<std::vector<std::string>*>(target)->emplace_back(name);
    return 0;
}

}  // namespace

Handle string_type(std::size_t size) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a string type");
    // HDF5 has no strings of length zero.
    checked(H5Tset_size(type, size == 0 ? 1 : size), "size a string type");
    checked(H5Tset_cset(type, H5T_CSET_UTF8), "encode a string type");
    checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "pad a string type");
    return type;
}

Handle status_type() {
    return make_enumeration<Status>(H5T_STD_U8LE,
                                    {{"empty", Status::empty},
                                     {"proposed", Status::proposed},
                                     {"done", Status::done},
                                     {"failed", Status::failed}});
}

Handle origin_type() {
    return make_enumeration<Origin>(H5T_STD_U8LE,
                                    {{"none", Origin::none},
                                     {"baseline", Origin::baseline},
                                     {"random", Origin::random},
                                     {"elite", Origin::elite},
                                     {"child", Origin::child},
                                     {"sample", Origin::sample}});
}

Handle bool_type() {
    return make_enumeration<std::int8_t>(
        H5T_STD_I8LE, {{"FALSE", std::int8_t{0}}, {"TRUE", std::int8_t{1}}});
}

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text) {
    create_attribute(object, name, string_type(text.size()), text.c_str());
}

void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value) {
    IDEOTYPE_EXPECT(!name.empty() && value != nullptr);
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create " + name);
    const Handle attribute(
        H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose, "create " + name);
    checked(H5Awrite(attribute, type, value), "write " + name);
}

std::vector<std::string> list_attributes(hid_t object) {
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

Attribute::Attribute(hid_t object, const std::string& name) {
    const std::string action = "read attribute " + name;
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                           action);
    type = Handle(H5Aget_type(attribute), H5Tclose, action);
    bytes.resize(H5Tget_size(type));
    checked(H5Aread(attribute, type, bytes.data()), action);
}

std::string text_attribute(hid_t object, const std::string& name) {
    if (checked(H5Aexists(object, name.c_str()), "find attribute " + name) == 0)
        return "";
    const auto [type, bytes] = Attribute(object, name);
    if (H5Tget_class(type) != H5T_STRING) return "";
    return {bytes.begin(), std::find(bytes.begin(), bytes.end(), '\0')};
}

std::vector<std::string> list_datasets(hid_t location) {
    std::vector<std::string> paths;
    checked(H5Ovisit2(location, H5_INDEX_NAME, H5_ITER_INC, keep_dataset,
                      &paths, H5O_INFO_BASIC),
            "list the datasets");
    return paths;
}

}  // namespace ideotype
