// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace ideotype {

struct MeshOptions;

//! Declares the mesh and the options of `light`.
void declare_light(CLI::App& verb, MeshOptions& options);

}  // namespace ideotype
