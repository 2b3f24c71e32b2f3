// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/text.hpp"

namespace ideotype {

std::string first_bytes(const std::string& text, std::size_t size) {
    if (text.size() <= size) return text;
    const auto continues = [&](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
    };
    std::size_t end = size;
    while (end > 0 && continues(end)) --end;
    return text.substr(0, end);
}

}  // namespace ideotype
