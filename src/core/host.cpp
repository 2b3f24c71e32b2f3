// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/host.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sched.h>
#include <unistd.h>
#include <vector>

#include "ideotype/core/hash.hpp"

namespace ideotype {

namespace {

// Number of arguments. It is large enough to distinguish two variants of a
// function if one in a thousand of their results differs.
constexpr int samples = 20000;

//! Appends the result of each mathematical function. A number `u` from 0 to 1
//! is mapped to arguments that are typical of the program.
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

std::string host_name() {
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

int available_cores() {
    cpu_set_t set;
    int cores = 1;
    if (sched_getaffinity(0, sizeof set, &set) == 0) cores = CPU_COUNT(&set);
    // The file contains "max 100000" without a quota.
    std::ifstream file("/sys/fs/cgroup/cpu.max");
    double quota = 0, period = 0;
    if (file >> quota >> period && quota > 0 && period > 0)
        cores = std::min(cores, static_cast<int>(std::ceil(quota / period)));
    return std::max(cores, 1);
}

const std::string& maths_fingerprint() {
    static const std::string fingerprint = measure_fingerprint();
    return fingerprint;
}

}  // namespace ideotype
