// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "history/history.hpp"
#include "ideotype/core/text.hpp"
#include "verbs.hpp"

namespace ideotype {

ExitCode verify(const std::vector<std::string>& paths) {
    ExitCode worst = ExitCode::ok;
    for (const std::string& path : paths) try {
            const Verified found = verify_file(path);
            fmt::print(
                "{}: header, {} generations and {} finalists have their "
                "checksums\n",
                path, found.generations, found.finalists);
        } catch (const Error& error) {
            // One that is damaged must not hide the others.
            fmt::print(stderr, "{}\n", printable_lines(error.what()));
            worst = std::max(worst, error.exit_code());
        }
    return worst;
}

}  // namespace ideotype
