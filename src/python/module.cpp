// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype::python {

namespace {

//! Returns a list of (file, line, column, what, key, code).
nb::list to_list(const std::vector<Problem>& problems) {
    nb::list list;
    for (const Problem& problem : problems)
        list.append(nb::make_tuple(problem.where.file, problem.where.line,
                                   problem.where.column, problem.what,
                                   problem.key, name_of(problem.code)));
    return list;
}

//! Makes errors appear in Python as exceptions of ideotype.errors.
void translate_errors() {
    nb::register_exception_translator(
        [](const std::exception_ptr& thrown, void*) {
            const auto errors = [] {
                return nb::module_::import_("ideotype.errors");
            };
            try {
                std::rethrow_exception(thrown);
            } catch (const InputError& error) {
                const nb::object type = errors().attr("InputError");
                const nb::object instance =
                    type(error.what(), to_list(error.problems()));
                PyErr_SetObject(type.ptr(), instance.ptr());
            } catch (const Error& error) {
                PyErr_SetString(errors().attr("Error").ptr(), error.what());
            }
        });
}

}  // namespace

}  // namespace ideotype::python

NB_MODULE(_core, module) {
    using namespace ideotype::python;
    module.doc() =
        "The compiled part of ideotype. Use the names of `ideotype` instead: "
        "these may change.";
    translate_errors();
    module.def("library_version", &ideotype::Device::library_version,
               "Name and version of the ray tracing library.");
    bind_stand(module);
    bind_plants(module);
    bind_mesh(module);
    bind_energy(module);
    bind_growth(module);
    bind_search(module);
}
