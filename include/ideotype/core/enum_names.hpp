// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ideotype {

//! A value of an enumeration with its name in files.
template <class Enum>
struct EnumName {
    const char* name;
    Enum value;
};

template <class Enum>
EnumName(const char*, Enum) -> EnumName<Enum>;

//! The names of the values of an enumeration, specialised as a std::array of
//! EnumName for each enumeration that appears in files.
template <class Enum>
inline constexpr std::nullptr_t enum_names = nullptr;

//! Returns the name of a value of an enumeration; "" if it is unnamed.
template <class Enum>
constexpr const char* name_of(Enum value) {
    for (const auto& entry : enum_names<Enum>)
        if (entry.value == value) return entry.name;
    return "";
}

//! Returns the value of an enumeration with a name, if there is one.
template <class Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
    for (const auto& entry : enum_names<Enum>)
        if (entry.name == name) return entry.value;
    return std::nullopt;
}

}  // namespace ideotype
