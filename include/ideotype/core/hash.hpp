// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // of OpenSSL

namespace ideotype {

//! SHA-256 of the bytes of a text, as 64 hexadecimal digits.
std::string sha256(std::string_view text);

//! SHA-256 of bytes that come in parts.
class Sha256 {
  public:
    Sha256();

    void add(std::string_view bytes);

    //! As 64 hexadecimal digits. Once.
    std::string finish();

  private:
    std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

//! A seed that is a function of another seed and a name: the first 64 bits of
//! SHA-256 of both. Different names give independent seeds.
std::uint64_t derive_seed(std::uint64_t seed, std::string_view name);

}  // namespace ideotype
