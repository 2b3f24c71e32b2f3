// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/maths.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include "ideotype/core/hash.hpp"

namespace ideotype {

namespace {

// Enough that variants which differ in one result of a thousand show.
constexpr int samples = 20000;

//! All results at one place of the unit interval, each function over the
//! arguments that the program gives it.
void add_results(std::vector<double>& results, double u) {
    const double angle = 20 * u - 10;
    const double unit = 2 * u - 1;
    const double positive = 1e-6 + 1000 * u * u * u;
    for (const double result :
         {std::sin(angle), std::cos(angle), std::tan(unit), std::asin(unit),
          std::acos(unit), std::atan2(unit, 0.3), std::exp(60 * u - 50),
          std::cosh(5 * unit), std::log(positive), std::log2(positive),
          std::log10(positive), std::pow(positive, 3 * unit),
          std::hypot(unit, 0.7)})
        results.push_back(result);
}

std::string measure_fingerprint() {
    std::vector<double> results;
    for (int i = 0; i < samples; ++i) add_results(results, (i + 0.5) / samples);
    return sha256({reinterpret_cast<const char*>(results.data()),
                   results.size() * sizeof(double)})
        .substr(0, 16);
}

}  // namespace

const std::string& maths_fingerprint() {
    static const std::string fingerprint = measure_fingerprint();
    return fingerprint;
}

}  // namespace ideotype
