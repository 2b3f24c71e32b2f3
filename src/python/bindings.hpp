// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

namespace ideotype::python {

//! Turns errors into exceptions of ideotype._errors.
void translate_errors();

void bind_plants(nanobind::module_& module);
void bind_stand(nanobind::module_& module);
void bind_mesh(nanobind::module_& module);
void bind_energy(nanobind::module_& module);
void bind_growth(nanobind::module_& module);
void bind_search(nanobind::module_& module);

}  // namespace ideotype::python
