// SPDX-License-Identifier: Apache-2.0
// Any bytes are either a finite mesh or cause an InputError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/obj_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
    using namespace ideotype;
    const std::string text(data, data + size);
    try {
        const Mesh mesh = parse_obj(text, "fuzz.obj").mesh;
        if (mesh.faces.empty() || mesh.face_group.size() != mesh.faces.size())
            std::abort();
        for (const auto& face : mesh.faces)
            for (const std::uint32_t vertex : face)
                if (vertex >= mesh.vertices.size()) std::abort();
        for (const std::uint32_t group : mesh.face_group)
            if (group >= mesh.groups.size()) std::abort();
        if (!std::isfinite(plant_area(mesh).leaves)) std::abort();
    } catch (const InputError&) {
    }
    return 0;
}
