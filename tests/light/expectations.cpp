// SPDX-License-Identifier: Apache-2.0
#include "expectations.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace ideotype {

namespace {

void expect_none(const Findings& findings) {
    for (const std::string& failure : findings.failures())
        ADD_FAILURE() << failure;
}

}  // namespace

void expect_agreement(Estimate ours, Estimate reference, double bound,
                      const std::string& what) {
    Findings findings;
    findings.require_agreement(ours, reference, bound, what);
    expect_none(findings);
}

Fractions closing(const Mesh& mesh, GroundPeriod period, const Optics& optics,
                  const Illumination& light, Accuracy accuracy) {
    Findings findings;
    const Fractions fractions =
        findings.closing(mesh, period, optics, light, accuracy);
    expect_none(findings);
    return fractions;
}

std::string test_name(std::string name) {
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
}

}  // namespace ideotype
