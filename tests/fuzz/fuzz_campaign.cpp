// SPDX-License-Identifier: Apache-2.0
// Any text is either a campaign or causes an InputError. The resolved form of a
// campaign, read again, must not change.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "campaign/campaign.hpp"
#include "ideotype/core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
    using namespace ideotype;
    const std::string text(data, data + size);
    try {
        const Campaign campaign = parse_campaign(text, "fuzz.toml");
        const Campaign again = parse_campaign(campaign.resolved, "again.toml");
        if (again.resolved != campaign.resolved) std::abort();
    } catch (const InputError&) {
    }
    return 0;
}
