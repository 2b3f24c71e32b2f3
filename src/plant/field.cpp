#include "ideotype/plant/field.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

std::vector<double> draw_turns(const FieldForm& form, std::uint64_t seed,
                               std::uint32_t generation, std::uint32_t draw) {
    RandomStream stream(seed, Purpose::jitter, generation, draw);
    std::vector<double> turns(static_cast<std::size_t>(form.rows) *
                              static_cast<std::size_t>(form.plants));
    for (double& turn : turns) turn = stream.uniform(-form.jitter, form.jitter);
    return turns;
}

Field build_field(const Mesh& plant, const FieldForm& form,
                  const std::vector<double>& turns) {
    const auto count = static_cast<std::size_t>(form.rows) *
                       static_cast<std::size_t>(form.plants);
    if (turns.size() != count)
        throw Error(
            fmt::format("a field of {} plants needs as many turns, not {}",
                        count, turns.size()));
    Field field;
    field.period_x = form.rows * form.spacing.row;
    field.period_y = form.plants * form.spacing.plant;
    field.row_direction = form.row_direction;
    Mesh& mesh = field.mesh;
    mesh.groups = plant.groups;
    mesh.vertices.reserve(count * plant.vertices.size());
    mesh.faces.reserve(count * plant.faces.size());
    mesh.face_group.reserve(count * plant.faces.size());
    for (std::size_t p = 0; p < count; ++p) {
        const auto plants = static_cast<std::size_t>(form.plants);
        const double x =
            (static_cast<double>(p / plants) + 0.5) * form.spacing.row;
        const double y =
            (static_cast<double>(p % plants) + 0.5) * form.spacing.plant;
        const double sine = std::sin(turns[p] * degree);
        const double cosine = std::cos(turns[p] * degree);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vec3& v : plant.vertices)
            mesh.vertices.push_back({x + v.x * cosine + v.y * sine,
                                     y + v.y * cosine - v.x * sine, v.z});
        for (const auto& face : plant.faces)
            mesh.faces.push_back({first + face[0], first + face[1],
                                  first + face[2], first + face[3]});
        mesh.face_group.insert(mesh.face_group.end(), plant.face_group.begin(),
                               plant.face_group.end());
    }
    return field;
}

}  // namespace ideotype
