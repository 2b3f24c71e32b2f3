// SPDX-License-Identifier: Apache-2.0
#include "types.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "search/population.hpp"

namespace ideotype {

namespace {

template <class Value>
Handle enumeration(
    hid_t base, std::initializer_list<std::pair<const char*, Value>> members) {
    Handle type(H5Tenum_create(base), H5Tclose, "create an enumeration");
    for (const auto& [name, value] : members)
        checked(H5Tenum_insert(type, name, &value), "fill an enumeration");
    return type;
}

}  // namespace

Handle string_type(std::size_t size) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a string type");
    // HDF5 has no strings of no bytes.
    checked(H5Tset_size(type, size == 0 ? 1 : size), "size a string type");
    checked(H5Tset_cset(type, H5T_CSET_UTF8), "encode a string type");
    checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "pad a string type");
    return type;
}

Handle status_type() {
    return enumeration<Status>(H5T_STD_U8LE, {{"empty", Status::empty},
                                              {"proposed", Status::proposed},
                                              {"done", Status::done},
                                              {"failed", Status::failed}});
}

Handle origin_type() {
    return enumeration<Origin>(H5T_STD_U8LE, {{"none", Origin::none},
                                              {"baseline", Origin::baseline},
                                              {"random", Origin::random},
                                              {"elite", Origin::elite},
                                              {"child", Origin::child},
                                              {"sample", Origin::sample}});
}

Handle bool_type() {
    return enumeration<std::int8_t>(
        H5T_STD_I8LE, {{"FALSE", std::int8_t{0}}, {"TRUE", std::int8_t{1}}});
}

}  // namespace ideotype
