// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/request.hpp"
#include "ideotype/core/error.hpp"
#include "light_results.hpp"
#include "spec/mesh_spec.hpp"

namespace ideotype {

//! The result of tracing light in a mesh. A single source is normalised to unit
//! irradiance on level ground.
struct MeshReport {
    CanopyReport canopy;
    std::vector<std::string> warnings;
};

inline Span span_of(const MeshSpec& spec) {
    return spec.has_day() ? Span::day : Span::single;
}

//! The largest number of paths traced to meet a tolerance.
inline constexpr std::uint64_t most_tolerance_paths = std::uint64_t{1} << 28;

//! Reads the mesh and traces light with reproducible random numbers.
//! @throws Error, also for wrong usage.
MeshReport study(const MeshSpec& spec, KeyNaming naming = key_itself);

//! Traces light in a mesh in memory; MeshSpec::path is ignored.
MeshReport study(Mesh mesh, const MeshSpec& spec,
                 KeyNaming naming = key_itself);

//! Checks keys for consistency.
//! @throws Error for wrong usage: missing, contradictory or impossible keys.
void check_rules(const MeshSpec& spec, const Problems& problems);

//! Checks whether light can be traced in copies of a mesh in a cell.
//! @param sun sun position, if it is fixed
//! @return warnings about problems that do not prevent tracing
//! @throws Error if light cannot be traced.
std::vector<std::string> check_mesh(const Mesh& mesh, double plants,
                                    const Cell& cell,
                                    const std::optional<MeshSpec::Sun>& sun,
                                    const Problems& problems);

}  // namespace ideotype
