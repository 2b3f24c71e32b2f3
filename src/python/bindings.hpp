// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype::python {

namespace nb = nanobind;

//! A contiguous read-only array.
template <class Number, int dimensions>
using Input = nb::ndarray<const Number, nb::ndim<dimensions>, nb::c_contig,
                          nb::device::cpu>;

template <class Number>
using Output = nb::ndarray<nb::numpy, Number>;

//! Returns a numpy array with a copy of numbers.
template <class Number>
Output<Number> to_array(const std::vector<Number>& numbers,
                        std::initializer_list<std::size_t> shape) {
    auto owned = std::make_unique<std::vector<Number>>(numbers);
    Number* data = owned->data();
    nb::capsule owner(owned.release(), [](void* pointer) noexcept {
        delete static_cast<std::vector<Number>*>(pointer);
    });
    return Output<Number>(data, shape, owner);
}

//! Returns means and standard errors as an array [estimate, 2].
inline Output<double> to_array(const std::vector<Estimate>& estimates) {
    std::vector<double> numbers;
    for (const Estimate& x : estimates) {
        numbers.push_back(x.mean);
        numbers.push_back(x.standard_error);
    }
    return to_array(numbers, {estimates.size(), 2});
}

inline std::vector<double> to_vector(const Input<double, 1>& array) {
    return {array.data(), array.data() + array.size()};
}

inline std::vector<std::string> names_of(const auto& entries) {
    std::vector<std::string> names;
    for (const auto& each : entries) names.push_back(each.name);
    return names;
}

//! Returns the vertices [n, 3] in m, the faces [m, 4], the group index of each
//! face, the name of each group, and the leaf rank of each group, from 1 (0:
//! not a leaf).
inline nb::tuple mesh_tuple(const Mesh& mesh) {
    std::vector<double> vertices;
    for (const glm::dvec3& x : mesh.vertices)
        vertices.insert(vertices.end(), {x.x, x.y, x.z});
    std::vector<std::uint32_t> faces;
    for (const auto& face : mesh.faces)
        faces.insert(faces.end(), face.begin(), face.end());
    std::vector<std::uint32_t> ranks;
    for (const Group& group : mesh.groups)
        ranks.push_back(group.id.is_leaf() ? group.id.rank : 0);
    return nb::make_tuple(to_array(vertices, {mesh.vertices.size(), 3}),
                          to_array(faces, {mesh.faces.size(), 4}),
                          to_array(mesh.face_group, {mesh.face_group.size()}),
                          names_of(mesh.groups), ranks);
}

void bind_plants(nb::module_& module);
void bind_stand(nb::module_& module);
void bind_mesh(nb::module_& module);
void bind_energy(nb::module_& module);
void bind_growth(nb::module_& module);
void bind_search(nb::module_& module);

}  // namespace ideotype::python
