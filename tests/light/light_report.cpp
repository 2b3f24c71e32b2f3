// SPDX-License-Identifier: Apache-2.0
// Writes the evidence of this folder:
//     light_report > tests/light/README.md
//     light_report values > tests/light/reference_values.md
// With names of sections it writes only these; `quick` takes 16 times fewer
// paths for references, `thorough` as many for all setups as for references.
#include "light_report.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

constexpr const char* title = R"(# How far the light can be trusted

Every known value of light agrees with the program within 4 combined standard errors: exact solutions, theory, and
an independent tracer in double precision. Light is a fraction of the light on horizontal ground; s.e. is the standard
error.

)";

constexpr const char* method = R"(
## How obtained

`build/dev/tests/light/light_report > tests/light/README.md` writes this page, and
`light_report values > tests/light/reference_values.md` all reference values; nothing is typed by hand.

| stand | content |
|---|---|
| maize1 | maize plants; PAR or black leaves |
| poisson_spherical_L3, poisson_horizontal_L3 | leaves at random positions, leaf area index 3 |
| beer | random black leaves of four angle distributions |
| two_stream | random horizontal leaves |
| turbid | small random leaves, a turbid medium |
| sheets1, sheets5 | closed horizontal sheets |
| furnace | one maize plant that scatters all or nearly all light, over white soil: irradiance is 1 on all faces |

* Each value must be within 4 combined s.e., with an s.e. of at most 2e-4 (1e-6 in furnace/grey).
* Stands of beer, two_stream and turbid are redrawn in each randomisation, so that the s.e. includes the sampling of
  leaves. poisson_horizontal_L3 is a single sample: there the s.e. of the reference includes it.
* The s.e. of two_stream is the effect of leaf size on the theory.
* Tests repeat all of it with fewer paths: `ctest --preset dev -R "Reference|Extreme"`.
)";

void write(const std::vector<std::string>& words) {
    const auto is_asked = [&](const std::string& word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    const bool is_quick = is_asked("quick");
    const bool is_thorough = is_asked("thorough");
    const bool is_whole = words.size() == (is_quick || is_thorough ? 1 : 0);
    if (is_asked("values")) ideotype::report_values(is_quick ? 16 : 1);
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
    if (is_whole) std::fputs(method, stdout);
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
