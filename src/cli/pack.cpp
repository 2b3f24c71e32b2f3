// SPDX-License-Identifier: Apache-2.0
#include "ideotype/history/pack.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/cli/verbs.hpp"

namespace ideotype {

ExitCode pack(const std::vector<std::string>& paths) {
    ExitCode worst = ExitCode::ok;
    for (const std::string& path : paths) try {
            const auto [before, after] = pack_file(path);
            const auto mebibytes = [](std::uintmax_t bytes) {
                return static_cast<double>(bytes) / (1 << 20);
            };
            if (before == after)
                fmt::print("{}: is packed already, {:.2f} MiB\n", path,
                           mebibytes(after));
            else
                fmt::print("{}: {:.2f} MiB, packed {:.2f} MiB\n", path,
                           mebibytes(before), mebibytes(after));
        } catch (const Error& error) {
            // One that is not finished must not keep the others waiting.
            fmt::print(stderr, "ideotype: {}\n", error.what());
            worst = std::max(worst, error.exit_code());
        }
    return worst;
}

}  // namespace ideotype
