#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ideotype {

//! SHA-256 of the bytes of a text, as 64 hexadecimal digits.
std::string sha256(std::string_view text);

//! A seed that is a function of another seed and a name: the first 64 bits of
//! SHA-256 of both. Different names give independent seeds.
std::uint64_t derive_seed(std::uint64_t seed, std::string_view name);

}  // namespace ideotype
