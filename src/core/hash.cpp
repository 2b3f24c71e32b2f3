#include "ideotype/core/hash.hpp"

#include <array>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

std::array<unsigned char, 32> digest(std::string_view text) {
    std::array<unsigned char, 32> bytes{};
    if (EVP_Digest(text.data(), text.size(), bytes.data(), nullptr,
                   EVP_sha256(), nullptr) != 1)
        throw Error("SHA-256 is not available in the OpenSSL library");
    return bytes;
}

}  // namespace

std::string sha256(std::string_view text) {
    std::string hex;
    for (const unsigned char byte : digest(text))
        hex += fmt::format("{:02x}", byte);
    return hex;
}

std::uint64_t derive_seed(std::uint64_t seed, std::string_view name) {
    const auto bytes = digest(fmt::format("{}/{}", seed, name));
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < 8; ++i) result = result << 8 | bytes[i];
    return result;
}

}  // namespace ideotype
