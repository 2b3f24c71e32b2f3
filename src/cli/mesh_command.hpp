// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace ideotype {

struct MeshOptions;

//! Adds the options of `evaluate --mesh` to a verb. They need --mesh.
void add_mesh_options(CLI::App& verb, MeshOptions& options);

}  // namespace ideotype
