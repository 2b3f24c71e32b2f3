// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/host.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sched.h>
#include <unistd.h>

namespace ideotype {

std::string host_name() {
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

int available_cores() {
    cpu_set_t set;
    int cores = 1;
    if (sched_getaffinity(0, sizeof set, &set) == 0) cores = CPU_COUNT(&set);
    // "max 100000" without a quota
    std::ifstream file("/sys/fs/cgroup/cpu.max");
    double quota = 0, period = 0;
    if (file >> quota >> period && quota > 0 && period > 0)
        cores = std::min(cores, static_cast<int>(std::ceil(quota / period)));
    return std::max(cores, 1);
}

}  // namespace ideotype
