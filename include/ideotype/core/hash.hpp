// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // a type of OpenSSL

namespace ideotype {

//! Returns the SHA-256 of the bytes of a text, as 64 hexadecimal digits.
std::string sha256(std::string_view text);

//! Computes the SHA-256 of bytes that are supplied in parts.
class Sha256 {
  public:
    Sha256();

    void add(std::string_view bytes);

    //! Returns the SHA-256 of all parts, as 64 hexadecimal digits. Call it
    //! once.
    std::string finish();

  private:
    std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

//! Derives a seed from another seed and a name: the first 64 bits of the
//! SHA-256 of both. Different names give independent seeds.
std::uint64_t derive_seed(std::uint64_t seed, std::string_view name);

}  // namespace ideotype
