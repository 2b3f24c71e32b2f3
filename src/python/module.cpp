// SPDX-License-Identifier: Apache-2.0
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "ideotype/light/device.hpp"

NB_MODULE(_core, module) {
    using namespace ideotype;
    module.doc() =
        "The compiled part of ideotype. Use the names of `ideotype` instead: "
        "these may change.";
    python::translate_errors();
    module.def("library_version", &Device::library_version,
               "Name and version of the ray tracing library.");
    python::bind_stand(module);
    python::bind_plants(module);
    python::bind_mesh(module);
    python::bind_energy(module);
    python::bind_growth(module);
    python::bind_search(module);
}
