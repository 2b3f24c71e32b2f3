// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/field.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

//! Returns a stream of random numbers that only this component uses.
RandomStream stream_of(const Randomness& randomness, Purpose purpose,
                       std::uint32_t component) {
    constexpr std::uint32_t apart = 1u << 24;
    return {randomness.seed, purpose, randomness.generation,
            randomness.first_randomisation + component * apart};
}

template <class Item>
void shuffle(std::vector<Item>& items, RandomStream& stream) {
    IDEOTYPE_EXPECT(!items.empty());
    for (std::size_t i = items.size() - 1; i > 0; --i)
        std::swap(items[i],
                  items[stream.below(static_cast<std::uint32_t>(i + 1))]);
}

//! Returns a fraction of a count, rounded at random without bias.
std::size_t number_of(double fraction, std::size_t count,
                      RandomStream& stream) {
    return static_cast<std::size_t>(fraction * static_cast<double>(count) +
                                    stream.uniform());
}

//! Turns planes of leaves towards the widest gap between plants. The plane of a
//! plant that is not rotated is across the row.
std::vector<double> towards_gap(std::vector<double> turns,
                                const Component& component) {
    if (component.turn == 0) return turns;
    const double gap = component.is_gap_along_row ? 90 : 0;
    for (double& turn : turns)
        turn -= component.turn * std::remainder(turn - gap, 180);
    return turns;
}

}  // namespace

std::vector<double> draw_plant_azimuths(const Component& component,
                                        const Randomness& randomness,
                                        std::uint32_t number) {
    IDEOTYPE_EXPECT(component.plants() > 0 && component.jitter >= 0);
    RandomStream stream = stream_of(randomness, Purpose::jitter, number);
    std::vector<double> turns(component.plants());
    const auto across = component.variation.across_row;
    if (!across) {
        for (double& turn : turns)
            turn = stream.uniform(-component.jitter, component.jitter);
        return towards_gap(std::move(turns), component);
    }
    // Both ranges are divided into equal parts with one plant in each part.
    const std::size_t crossing =
        std::min(number_of(*across, turns.size(), stream), turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const bool is_across = i < crossing;
        const auto parts =
            static_cast<double>(is_across ? crossing : turns.size() - crossing);
        const auto part = static_cast<double>(is_across ? i : i - crossing);
        turns[i] =
            (is_across ? 0 : 90) - 45 + 90 * (part + stream.uniform()) / parts;
    }
    shuffle(turns, stream);
    return towards_gap(std::move(turns), component);
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

//! Removes faces with centres outside the kept ground.
void cut_border(Field& field) {
    const auto [x, y, width, depth] = *field.cell.kept;
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
}

enum class Emergence { usual, late, none };

//! Selects at random the positions without a plant and those with a late plant.
//! Their numbers differ from the specified fractions by less than one plant and
//! are unbiased.
std::vector<Emergence> draw_emergence(const Component& component,
                                      RandomStream& stream) {
    const std::size_t count = component.plants();
    const std::size_t missing = std::min(
        number_of(component.variation.missing, count, stream), count - 1);
    const std::size_t late = std::min(
        number_of(component.variation.late, count, stream), count - missing);
    std::vector<Emergence> places(count, Emergence::usual);
    std::fill_n(places.begin(), missing, Emergence::none);
    std::fill_n(places.begin() + static_cast<std::ptrdiff_t>(missing), late,
                Emergence::late);
    shuffle(places, stream);
    return places;
}

//! Generates the plants of a component by position; missing plants have no
//! faces.
//! @param line mesh of a plant that does not deviate from its line
std::vector<Mesh> draw_plants(const Component& component, const Mesh& line,
                              const Randomness& randomness,
                              std::uint32_t number) {
    IDEOTYPE_EXPECT(component.plant.has_value());
    const PlantVariation& variation = component.variation;
    RandomStream stream = stream_of(randomness, Purpose::variation, number);
    const std::vector<Emergence> places = draw_emergence(component, stream);
    // Plants of the second half deviate opposite to those of the first half, so
    // effects that are linear in the deviations cancel.
    std::vector<RandomStream> pairs;
    std::vector<Mesh> plants(places.size());
    for (std::size_t p = 0; p < places.size(); ++p) {
        const Emergence emergence = places[p];
        const std::size_t half = (places.size() + 1) / 2;
        if (p < half) pairs.push_back(stream);
        Plant one = p < half ? deviating(*component.plant, variation, stream)
                             : deviating(*component.plant, variation,
                                         pairs[p - half], -1);
        if (emergence == Emergence::none) continue;
        if (emergence == Emergence::late)
            one = scaled(std::move(one), late_size);
        plants[p] = build_plant(one, component.tessellation);
        if (plants[p].faces.size() != line.faces.size())
            throw Error(
                "the plants of a field have different numbers of faces, but "
                "all have to be built from plants with the same leaves");
        plants[p].face_group = line.face_group;
    }
    return plants;
}

//! @param first_group first group of the plant's component
void add_plant(Field& field, const Mesh& plant, const Place& place, double turn,
               std::uint32_t first_group, std::uint32_t number) {
    IDEOTYPE_EXPECT(plant.face_group.size() == plant.faces.size());
    const double sine = std::sin(turn * degree);
    const double cosine = std::cos(turn * degree);
    Mesh& mesh = field.mesh;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::dvec3& v : plant.vertices)
        mesh.vertices.push_back({place.x + v.x * cosine + v.y * sine,
                                 place.y + v.y * cosine - v.x * sine, v.z});
    for (const auto& face : plant.faces)
        mesh.faces.push_back({first + face[0], first + face[1], first + face[2],
                              first + face[3]});
    for (const std::uint32_t group : plant.face_group)
        mesh.face_group.push_back(first_group + group);
    field.face_plant.insert(field.face_plant.end(), plant.faces.size(), number);
}

void reserve(Field& field, const Scene& scene) {
    std::size_t vertices = 0, faces = 0;
    for (const Component& each : scene.components) {
        vertices += each.plants() * each.mesh.vertices.size();
        faces += each.plants() * each.mesh.faces.size();
    }
    field.mesh.vertices.reserve(vertices);
    field.mesh.faces.reserve(faces);
    field.mesh.face_group.reserve(faces);
    field.face_plant.reserve(faces);
}

}  // namespace

namespace {

//! Shifts the plants of a component at random from their lattice positions.
void deviate(std::vector<Place>& places, const PlantVariation& variation,
             RandomStream stream) {
    if (!(variation.position > 0 || variation.position_across > 0)) return;
    for (Place& place : places) {
        const auto [along, across] = stream.normal();
        place.x += variation.position_across * cut_deviation(across);
        place.y += variation.position * cut_deviation(along);
    }
}

}  // namespace

std::vector<std::vector<Place>> draw_places(const Scene& scene,
                                            const Randomness& randomness) {
    std::vector<std::vector<Place>> all;
    std::vector<Place> shared;  // remaining positions of the mixture
    for (const Component& each : scene.components) {
        if (each.mixed > 0 && shared.empty()) {
            shared = each.places;
            RandomStream stream = stream_of(randomness, Purpose::mixture, 0);
            shuffle(shared, stream);
        }
        IDEOTYPE_EXPECT(each.mixed <= shared.size());
        all.push_back(each.mixed > 0 ? std::vector<Place>{} : each.places);
        for (std::size_t i = 0; i < each.mixed; ++i) {
            all.back().push_back(shared.back());
            shared.pop_back();
        }
        const auto number = static_cast<std::uint32_t>(all.size() - 1);
        deviate(all.back(), each.variation,
                stream_of(randomness, Purpose::position, number));
    }
    return all;
}

Field draw_field(const Scene& scene, const Randomness& randomness,
                 std::span<const Mesh> lines) {
    const std::vector<std::vector<Place>> places =
        draw_places(scene, randomness);
    Field field;
    field.cell = scene.cell;
    field.mesh.groups = groups_of(scene, lines);
    reserve(field, scene);
    std::uint32_t present = 0, first_group = 0, number = 0;
    for (const Component& component : scene.components) {
        const Mesh& line = lines.empty() ? component.mesh : lines[number];
        field.first_plant.push_back(present);
        const std::vector<double> turns =
            draw_plant_azimuths(component, randomness, number);
        std::vector<Mesh> plants;
        if (component.variation.is_any())
            plants = draw_plants(component, line, randomness, number);
        for (std::size_t p = 0; p < places[number].size(); ++p) {
            const Mesh& plant = plants.empty() ? line : plants[p];
            if (plant.faces.empty()) continue;
            add_plant(field, plant, places[number][p], turns[p], first_group,
                      present++);
            field.plant_row.push_back(places[number][p].row);
        }
        first_group += static_cast<std::uint32_t>(line.groups.size());
        ++number;
    }
    field.first_plant.push_back(present);
    for (const FixedObject& object : scene.objects) {
        add_plant(field, object.mesh, {}, 0, first_group, present);
        first_group += static_cast<std::uint32_t>(object.mesh.groups.size());
    }
    if (field.cell.kept) cut_border(field);
    IDEOTYPE_ENSURE(field.mesh.face_group.size() == field.mesh.faces.size());
    IDEOTYPE_ENSURE(field.face_plant.size() == field.mesh.faces.size());
    IDEOTYPE_ENSURE(field.plant_row.size() == present);
    return field;
}

Scene as_drawn(Scene scene, const Field& field) {
    IDEOTYPE_EXPECT(field.first_plant.size() == scene.components.size() + 1);
    std::uint32_t first_group = 0;
    for (std::uint32_t c = 0; c < scene.components.size(); ++c) {
        Component& component = scene.components[c];
        Mesh mesh;
        mesh.groups = std::move(component.mesh.groups);
        mesh.vertices = field.mesh.vertices;
        for (std::size_t f = 0; f < field.mesh.faces.size(); ++f) {
            if (field.face_plant[f] < field.first_plant[c] ||
                field.face_plant[f] >= field.first_plant[c + 1])
                continue;
            mesh.faces.push_back(field.mesh.faces[f]);
            mesh.face_group.push_back(field.mesh.face_group[f] - first_group);
        }
        first_group += static_cast<std::uint32_t>(mesh.groups.size());
        drop_unused_vertices(mesh);
        component = {.name = component.name, .mesh = std::move(mesh)};
    }
    scene.cell.kept.reset();
    scene.cell.row_ground.clear();
    return scene;
}

}  // namespace ideotype
