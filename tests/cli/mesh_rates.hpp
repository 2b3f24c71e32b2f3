// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "stand/mesh_study.hpp"
#include "temporary_folder.hpp"

namespace ideotype {

//! Returns the options for a mesh of the reference data.
inline MeshSpec reference(const std::string& name, MeshSpec::Period period) {
    MeshSpec options;
    options.path = std::string(IDEOTYPE_MESHES) + "/" + name + ".obj";
    options.period = period;
    return options;
}

//! Returns the options for a reference mesh with leaves that scatter a tenth of
//! the light.
inline MeshSpec mesh(const std::string& name, MeshSpec::Period period) {
    MeshSpec options = reference(name, period);
    options.optics.leaf = {.05, .05};
    options.tolerance = 3e-4;
    return options;
}

//! Checks that the keys do not contradict each other.
inline void check(const MeshSpec& spec) {
    check_rules(spec, Problems(key_itself));
}

//! Writes a file that contains the given [photosynthesis] table, and returns
//! its path.
inline std::string table(const std::string& name, const std::string& keys) {
    const std::string path = temporary_file(name + ".toml");
    std::ofstream(path) << "[photosynthesis]\n" << keys;
    return path;
}

//! Assimilation of all leaves, and of each group [umol m-2 s-1].
struct Rates {
    Estimate gross, net;
    std::vector<Estimate> groups;
};

inline Rates rates(const MeshSpec& options) {
    const AssimilationReport report = *study(options).canopy.assimilation;
    Rates result{
        scaled(report.gross.sum, 1e6), scaled(report.gross.sum, 1e6), {}};
    result.net.mean -= 1e6 * sum_of(report.losses).in_light;
    for (const Estimate& group : report.gross.groups)
        result.groups.push_back(scaled(group, 1e6));
    return result;
}

}  // namespace ideotype
