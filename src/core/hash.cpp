// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/hash.hpp"

#include <array>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

using Digest = std::array<unsigned char, 32>;

void require(int result) {
    if (result != 1)
        throw Error("SHA-256 is not available in the OpenSSL library");
}

Digest digest(std::string_view text) {
    Digest bytes{};
    require(EVP_Digest(text.data(), text.size(), bytes.data(), nullptr,
                       EVP_sha256(), nullptr));
    return bytes;
}

std::string hexadecimal(const Digest& bytes) {
    std::string hex;
    for (const unsigned char byte : bytes) hex += fmt::format("{:02x}", byte);
    return hex;
}

}  // namespace

std::string sha256(std::string_view text) {
    return hexadecimal(digest(text));
}

struct Sha256::Context {
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> its{
        EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
    require(EVP_DigestInit_ex(context_->its.get(), EVP_sha256(), nullptr));
}

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
    require(EVP_DigestUpdate(context_->its.get(), bytes.data(), bytes.size()));
}

std::string Sha256::finish() {
    Digest bytes{};
    require(EVP_DigestFinal_ex(context_->its.get(), bytes.data(), nullptr));
    return hexadecimal(bytes);
}

std::uint64_t derive_seed(std::uint64_t seed, std::string_view name) {
    const auto bytes = digest(fmt::format("{}/{}", seed, name));
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < 8; ++i) result = result << 8 | bytes[i];
    return result;
}

}  // namespace ideotype
