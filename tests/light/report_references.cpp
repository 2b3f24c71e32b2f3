// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

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

    //! Returns the share of comparisons that deviate by more than the given
    //! number of standard errors.
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

//! Prints a row for each value.
void print_values(const std::vector<Comparison>& comparisons) {
    fmt::print(
        "| case | quantity | reference | s.e. | ours | s.e. | off by s.e. | "
        "source |\n|---|---|---|---|---|---|---|---|\n");
    for (const Comparison& c : comparisons)
        fmt::print(
            "| {} | {} | {:.6f} | {:.1e} | {:.6f} | {:.1e} | {:+.1f} | "
            "{} |\n",
            c.name, c.quantity, c.reference.mean, c.reference.standard_error,
            c.ours.mean, c.ours.standard_error, c.off(), c.origin);
}

//! Returns the stand of a case, the part of the name before the first slash.
std::string get_stand(const Comparison& c) {
    return c.name.substr(0, c.name.find('/'));
}

//! Prints a row for each stand, in the order in which stands first occur.
void print_stands(const std::vector<Comparison>& comparisons) {
    fmt::print(
        "| stand | cases | values | largest deviation [s.e.] | source |\n"
        "|---|---|---|---|---|\n");
    std::set<std::string> printed;
    for (const Comparison& first : comparisons) {
        const std::string stand = get_stand(first);
        if (!printed.insert(stand).second) continue;
        Deviations deviations;
        std::set<std::string> cases;
        for (const Comparison& c : comparisons)
            if (get_stand(c) == stand) {
                deviations.all.push_back(c);
                cases.insert(c.name);
            }
        const Comparison& worst = deviations.worst();
        fmt::print("| {} | {} | {} | {:+.1f} ({} {}) | {} |\n", stand,
                   cases.size(), deviations.all.size(), worst.off(), worst.name,
                   worst.quantity, first.origin);
    }
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
        "{:+.2f} combined s.e. ({} {}),\nthe largest error of the energy "
        "balance {:.0e}.{} [All values](reference_values.md).\n\n",
        count_cases(scenes), usual.all.size(), worst.off(), worst.name,
        worst.quantity, usual.balance_error,
        thrift > 1
            ? fmt::format(" With {} times fewer paths, bounds are {:.0f} "
                          "times as large.",
                          thrift, std::pow(thrift, .75))
            : "");
    print_stands(usual.all);
}

void report_values(int thrift) {
    const std::vector<ReferenceScene> scenes = reference_scenes();
    fmt::print(
        "# Reference values\n\n{} cases. Light is a fraction of the light on "
        "horizontal ground; s.e. is the standard\nerror. [How far the light "
        "can be trusted](README.md) has the summary.\n\n",
        count_cases(scenes));
    print_values(run(scenes, setups().front(), thrift).all);
}

void report_setups(int thrift) {
    const std::vector<ReferenceScene> scenes = reference_scenes();
    fmt::print(
        "\n## Setups\n\nDo instruction sets, triangles, shifts or turns change "
        "results? The shares beyond 1 and 2 s.e. are alike in all\nsetups. "
        "Of independent normal deviates 31.7 and 4.6 % are beyond; values of "
        "one mesh are not independent.\n{}\n\n| setup | values | % > 1 | % > 2 "
        "| largest | largest s.e. / bound | energy balance |\n"
        "|---|---|---|---|---|---|---|\n",
        thrift > 1
            ? fmt::format("Each setup has {} times fewer paths than the "
                          "references, and bounds {:.0f} times as large.",
                          thrift, std::pow(thrift, .75))
            : "Each setup has as many paths as the references.");
    for (const Setup& setup : setups())
        print_setup(setup.name, run(scenes, setup, thrift));
}

}  // namespace ideotype
