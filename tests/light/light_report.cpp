// SPDX-License-Identifier: Apache-2.0
// Writes README.md of this folder: light_report > tests/light/README.md. With
// names of sections it writes only these; `quick` takes 16 times fewer paths
// for the table of references, `thorough` takes as many for all setups as for
// that table.
#include "light_report.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

constexpr const char* title = R"(# How far the light can be trusted

Written by `build/dev/tests/light/light_report > tests/light/README.md`; nothing
here is typed by hand. Light is in fractions of what falls on horizontal ground,
s.e. is standard error.

)";

void write(const std::vector<std::string>& words) {
    const auto is_asked = [&](const std::string& word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    const bool is_quick = is_asked("quick");
    const bool is_thorough = is_asked("thorough");
    const bool is_whole = words.size() == (is_quick || is_thorough ? 1 : 0);
    if (is_whole) std::fputs(title, stdout);
    if (is_whole || is_asked("references"))
        ideotype::report_references(is_quick ? 16 : 1);
    if (is_whole || is_asked("setups"))
        ideotype::report_setups(is_thorough ? 1 : 16);
    if (is_whole || is_asked("extremes")) ideotype::report_extremes();
    if (is_whole || is_asked("first_hits")) ideotype::report_first_hits();
    if (is_whole || is_asked("honesty")) ideotype::report_honesty();
    if (is_whole || is_asked("convergence"))
        ideotype::report_convergence(IDEOTYPE_CAMPAIGNS);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        write({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "light_report: %s\n", error.what());
        return 1;
    }
}
