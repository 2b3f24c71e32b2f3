// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "light_report.hpp"
#include "reference_cases.hpp"

namespace ideotype {

namespace {

//! All comparisons in one setup.
struct Deviations {
    std::vector<Comparison> all;
    double balance_error = 0;
    double standard_error = 0;  //!< the largest ratio of our error to its bound

    void add(const SceneResult& result) {
        balance_error = std::max(balance_error, result.balance_error);
        for (const Comparison& c : result.comparisons) {
            standard_error =
                std::max(standard_error, c.ours.standard_error / c.bound);
            all.push_back(c);
        }
    }

    const Comparison& worst() const {
        return *std::max_element(all.begin(), all.end(),
                                 [](const Comparison& a, const Comparison& b) {
                                     return std::abs(a.off()) <
                                            std::abs(b.off());
                                 });
    }

    //! Returns the share of comparisons off by more than so many errors.
    double beyond(double errors) const {
        const auto count = std::count_if(
            all.begin(), all.end(),
            [&](const Comparison& c) { return std::abs(c.off()) > errors; });
        return static_cast<double>(count) / static_cast<double>(all.size());
    }
};

Deviations run(const std::vector<ReferenceScene>& scenes, const Setup& setup,
               int thrift) {
    Deviations deviations;
    for (const ReferenceScene& scene : scenes)
        deviations.add(compare(scene, setup, thrift));
    return deviations;
}

void print_table(const std::vector<Comparison>& comparisons) {
    fmt::print(
        "\n| case | quantity | reference | s.e. | ours | s.e. | off by s.e. | "
        "source |\n|---|---|---|---|---|---|---|---|\n");
    for (const Comparison& c : comparisons)
        fmt::print(
            "| {} | {} | {:.6f} | {:.1e} | {:.6f} | {:.1e} | {:+.1f} | "
            "{} |\n",
            c.name, c.quantity, c.reference.mean, c.reference.standard_error,
            c.ours.mean, c.ours.standard_error, c.off(), c.origin);
}

void print_setup(const std::string& name, const Deviations& d) {
    const Comparison& worst = d.worst();
    fmt::print(
        "| {} | {} | {:.1f} | {:.1f} | {:+.2f} ({} {}) | {:.2f} | {:.0e} "
        "|\n",
        name, d.all.size(), 100 * d.beyond(1), 100 * d.beyond(2), worst.off(),
        worst.name, worst.quantity, d.standard_error, d.balance_error);
    std::fflush(stdout);
}

}  // namespace

void report_references(int thrift) {
    const std::vector<ReferenceScene> scenes = reference_scenes();
    const Deviations usual = run(scenes, setups().front(), thrift);
    const Comparison& worst = usual.worst();
    fmt::print(
        "## References\n\n**{} cases, {} values**; the largest deviation is "
        "{:+.2f} s.e. ({} {}), the largest\nbalance error {:.0e}. Ours must be "
        "within 4 combined s.e., with an s.e. of at most\n2e-4 (1e-6 in "
        "furnace/grey){}. Stands of random leaves (beer, two_stream, turbid)\n"
        "are new ones in each randomisation, so that the s.e. of ours holds "
        "the "
        "accident of\nthe sample; for poisson_horizontal_L3, a single sample, "
        "that of the reference does.\nThe s.e. of two_stream is what the size "
        "of the leaves does to the theory.\n",
        count_cases(scenes), usual.all.size(), worst.off(), worst.name,
        worst.quantity, usual.balance_error,
        thrift > 1
            ? fmt::format(", but here, with {} times fewer paths, {:.0f} "
                          "times that",
                          thrift, std::pow(thrift, .75))
            : "");
    print_table(usual.all);
}

void report_setups(int thrift) {
    const std::vector<ReferenceScene> scenes = reference_scenes();
    fmt::print(
        "\n## Setups\n\nAll values in all ways to set up the engine{}. "
        "Normal deviates would be beyond 1 and\n2 s.e. in 31.7 and 4.6 %; "
        "there "
        "are fewer independent values than rows, since\nparts of a balance and "
        "lights in the same mesh belong together. Last: the largest\ns.e. of "
        "ours over its bound and the largest error of the balance in any\n"
        "randomisation.\n\n| setup | values | % > 1 | % > 2 | largest | s.e. / "
        "bound | balance |\n|---|---|---|---|---|---|---|\n",
        thrift > 1 ? fmt::format(", with {} times fewer paths (bounds times "
                                 "{:.0f})",
                                 thrift, std::pow(thrift, .75))
                   : "");
    for (const Setup& setup : setups())
        print_setup(setup.name, run(scenes, setup, thrift));
}

}  // namespace ideotype
