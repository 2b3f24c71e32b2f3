// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/hash.hpp"

#include <array>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

void require(int result) {
    if (result != 1)
        throw Error(
            "the OpenSSL library has no SHA-256; install one that has it");
}

}  // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Sha256::add(std::string_view bytes) {
    IDEOTYPE_EXPECT(context_ != nullptr);
    require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::finish() {
    IDEOTYPE_EXPECT(context_ != nullptr);
    std::array<unsigned char, 32> bytes{};
    require(EVP_DigestFinal_ex(context_.get(), bytes.data(), nullptr));
    context_.reset();
    std::string hex;
    for (const unsigned char byte : bytes) hex += fmt::format("{:02x}", byte);
    return hex;
}

std::string sha256(std::string_view text) {
    Sha256 sum;
    sum.add(text);
    return sum.finish();
}

std::uint64_t derive_seed(std::uint64_t seed, std::string_view name) {
    const std::string hex = sha256(fmt::format("{}/{}", seed, name));
    return std::stoull(hex.substr(0, 16), nullptr, 16);
}

}  // namespace ideotype
