// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/field.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

//! Puts a list into a random order.
template <class Item>
void shuffle(std::vector<Item>& items, RandomStream& stream) {
    for (std::size_t i = items.size() - 1; i > 0; --i)
        std::swap(items[i],
                  items[stream.below(static_cast<std::uint32_t>(i + 1))]);
}

//! As many as this fraction of so many is on average, within one.
std::size_t number_of(double fraction, std::size_t count,
                      RandomStream& stream) {
    return static_cast<std::size_t>(fraction * static_cast<double>(count) +
                                    stream.uniform());
}

}  // namespace

std::vector<double> draw_plant_azimuths(const FieldForm& form,
                                        const Randomness& randomness) {
    RandomStream stream(randomness.seed, Purpose::jitter, randomness.generation,
                        randomness.first_randomisation);
    std::vector<double> turns(form.count());
    const auto across = form.variation.across_row;
    if (!across) {
        for (double& turn : turns)
            turn = stream.uniform(-form.jitter, form.jitter);
        return turns;
    }
    // One turn in each of equal parts of both ranges.
    const std::size_t number =
        std::min(number_of(*across, turns.size(), stream), turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const bool is_across = i < number;
        const auto parts =
            static_cast<double>(is_across ? number : turns.size() - number);
        const auto part = static_cast<double>(is_across ? i : i - number);
        turns[i] =
            (is_across ? 0 : 90) - 45 + 90 * (part + stream.uniform()) / parts;
    }
    shuffle(turns, stream);
    return turns;
}

namespace {

void drop_unused_vertices(Mesh& mesh) {
    constexpr std::uint32_t unused = UINT32_MAX;
    std::vector<std::uint32_t> place(mesh.vertices.size(), unused);
    for (const auto& face : mesh.faces)
        for (const std::uint32_t v : face) place[v] = v;
    std::uint32_t kept = 0;
    for (std::uint32_t v = 0; v < place.size(); ++v) {
        if (place[v] == unused) continue;
        mesh.vertices[kept] = mesh.vertices[v];
        place[v] = kept++;
    }
    mesh.vertices.resize(kept);
    for (auto& face : mesh.faces)
        for (std::uint32_t& v : face) v = place[v];
}

//! Keeps the faces whose centre is above the ground of the inner plants.
void remove_border(Field& field, const FieldForm& form) {
    const double x = form.border_rows * form.spacing.row;
    const double y = form.border_rows * form.spacing.plant;
    const double width = field.period_x - 2 * x;
    const double depth = field.period_y - 2 * y;
    if (form.rows <= 2 * form.border_rows ||
        form.plants <= 2 * form.border_rows)
        throw Error(
            fmt::format("nothing is left of a plot of {} x {} plants "
                        "with {} cut away on each side",
                        form.rows, form.plants, form.border_rows));
    Mesh& mesh = field.mesh;
    std::size_t kept = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        glm::dvec3 centre(0);
        for (const std::uint32_t v : mesh.faces[f])
            centre += mesh.vertices[v] / 4.;
        if (centre.x < x || centre.x > x + width || centre.y < y ||
            centre.y > y + depth)
            continue;
        mesh.faces[kept] = mesh.faces[f];
        mesh.face_group[kept] = mesh.face_group[f];
        field.face_plant[kept++] = field.face_plant[f];
    }
    mesh.faces.resize(kept);
    mesh.face_group.resize(kept);
    field.face_plant.resize(kept);
    drop_unused_vertices(mesh);
    field.ground_area = width * depth;
}

}  // namespace

Field build_field(std::span<const Mesh> plants, const FieldForm& form,
                  const std::vector<double>& turns) {
    const std::size_t count = form.count();
    if (turns.size() != count)
        throw Error(
            fmt::format("a field of {} plants needs as many turns, not {}",
                        count, turns.size()));
    Field field;
    field.boundary = form.boundary;
    field.period_x = form.rows * form.spacing.row;
    field.period_y = form.plants * form.spacing.plant;
    field.ground_area = field.period_x * field.period_y;
    Mesh& mesh = field.mesh;
    mesh.groups = plants.front().groups;
    mesh.vertices.reserve(count * plants.front().vertices.size());
    mesh.faces.reserve(count * plants.front().faces.size());
    mesh.face_group.reserve(count * plants.front().faces.size());
    field.face_plant.reserve(count * plants.front().faces.size());
    std::uint32_t present = 0;
    for (std::size_t p = 0; p < count; ++p) {
        const Mesh& plant = plants.size() == 1 ? plants.front() : plants[p];
        if (plant.faces.empty()) continue;
        const auto per_row = static_cast<std::size_t>(form.plants);
        const std::size_t row = p / per_row;
        const std::size_t place = p % per_row;
        const double x = (static_cast<double>(row) + 0.5) * form.spacing.row;
        const double y =
            (static_cast<double>(place) + 0.5) * form.spacing.plant;
        const double sine = std::sin(turns[p] * degree);
        const double cosine = std::cos(turns[p] * degree);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::dvec3& v : plant.vertices)
            mesh.vertices.push_back({x + v.x * cosine + v.y * sine,
                                     y + v.y * cosine - v.x * sine, v.z});
        for (const auto& face : plant.faces)
            mesh.faces.push_back({first + face[0], first + face[1],
                                  first + face[2], first + face[3]});
        mesh.face_group.insert(mesh.face_group.end(), plant.face_group.begin(),
                               plant.face_group.end());
        field.face_plant.insert(field.face_plant.end(), plant.faces.size(),
                                present++);
    }
    if (form.border_rows > 0) remove_border(field, form);
    return field;
}

Field build_field(const Mesh& plant, const FieldForm& form,
                  const std::vector<double>& turns) {
    return build_field(std::span(&plant, 1), form, turns);
}

Field draw_field(const Mesh& plant, const FieldForm& form,
                 const Randomness& randomness) {
    return build_field(plant, form, draw_plant_azimuths(form, randomness));
}

namespace {

enum class Emergence { usual, late, none };

//! A fraction of the places of a field is without a plant, and another one has
//! a late plant. The numbers of both differ from these fractions by less than
//! one, and are right on average.
std::vector<Emergence> draw_emergence(const FieldForm& form,
                                      RandomStream& stream) {
    const std::size_t missing =
        std::min(number_of(form.variation.missing, form.count(), stream),
                 form.count() - 1);
    const std::size_t late =
        std::min(number_of(form.variation.late, form.count(), stream),
                 form.count() - missing);
    std::vector<Emergence> places(form.count(), Emergence::usual);
    std::fill_n(places.begin(), missing, Emergence::none);
    std::fill_n(places.begin() + static_cast<std::ptrdiff_t>(missing), late,
                Emergence::late);
    shuffle(places, stream);
    return places;
}

}  // namespace

Field draw_field(const Plant& plant, const Mesh& mesh,
                 const Tessellation& tessellation, const FieldForm& form,
                 const Randomness& randomness) {
    const PlantVariation& variation = form.variation;
    if (!variation.is_any()) return draw_field(mesh, form, randomness);
    RandomStream stream(randomness.seed, Purpose::variation,
                        randomness.generation, randomness.first_randomisation);
    const std::vector<Emergence> places = draw_emergence(form, stream);
    // Plants of the second half deviate as those of the first half, but to the
    // other side: what is linear in deviations has no noise then.
    std::vector<RandomStream> pairs;
    std::vector<Mesh> plants;
    plants.reserve(form.count());
    for (std::size_t p = 0; p < places.size(); ++p) {
        const Emergence emergence = places[p];
        const std::size_t half = (places.size() + 1) / 2;
        if (p < half) pairs.push_back(stream);
        Plant one = p < half ? deviating(plant, variation, stream)
                             : deviating(plant, variation, pairs[p - half], -1);
        plants.emplace_back();
        Mesh& built = plants.back();
        if (emergence != Emergence::none) {
            if (emergence == Emergence::late)
                one = scaled(std::move(one), variation.late_size);
            built = build_plant(one, tessellation);
            if (built.faces.size() != mesh.faces.size())
                throw Error("a plant has other faces than its line");
            built.face_group = mesh.face_group;
        }
        built.groups = mesh.groups;
    }
    return build_field(plants, form, draw_plant_azimuths(form, randomness));
}

}  // namespace ideotype
