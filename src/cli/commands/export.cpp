// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "cli/choose_row.hpp"
#include "cli/commands.hpp"
#include "cli/formats/mesh_files.hpp"
#include "cli/formats/output_file.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/core/text.hpp"
#include "ideotype/crop/measures.hpp"
#include "spec/problems.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

std::vector<Measure<Leaf>> written_measures(const std::vector<Leaf>& leaves) {
    const auto usual = leaf_measures.begin() + usual_leaf_measures;
    std::vector<Measure<Leaf>> written(leaf_measures.begin(), usual);
    std::copy_if(usual, leaf_measures.end(), std::back_inserter(written),
                 [&](const Measure<Leaf>& measure) {
                     return std::ranges::any_of(leaves, [&](const Leaf& leaf) {
                         return leaf.*measure.value != 0;
                     });
                 });
    return written;
}

//! Writes leaf measures with six digits; crop files contain all digits.
void write_csv(const std::string& path, const Plant& plant) {
    const std::vector<Measure<Leaf>> measures = written_measures(plant.leaves);
    OutputFile out(path);
    out.print("leaf");
    for (const Measure<Leaf>& each : measures)
        out.print(",{}_{}", each.name, each.unit);
    int rank = 0;
    for (const Leaf& leaf : plant.leaves) {
        out.print("\n{}", ++rank);
        for (const Measure<Leaf>& each : measures)
            out.print(",{:.6g}", leaf.*each.value);
    }
    out.print("\n");
    out.finish();
}

//! Writes a crop file, in which the plant is named after the file. Characters
//! that names do not allow are replaced.
void write_crop_file(const std::string& path, const std::string& title,
                     const Campaign& campaign, Plant plant,
                     std::size_t component) {
    plant.name = std::filesystem::path(path).stem().string().substr(0, 64);
    for (char& c : plant.name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    OutputFile out(path);
    out.print("# {}\n{}", title, crop_text(campaign, plant, component));
    out.finish();
}

//! Returns comment lines about units and orientation, for users of other ray
//! tracers.
std::vector<std::string> about(const std::string& title, const Case& chosen) {
    return {title, "metres, z up, y along the rows",
            fmt::format("y points {} deg clockwise from north",
                        chosen.spacing.row_direction)};
}

std::string about_ground(const Field& field) {
    const Cell& cell = field.cell;
    if (cell.boundary == Boundary::isolated)
        return fmt::format(
            "an isolated plot; its plants have {:.6f} m2 of ground",
            cell.ground_area);
    return fmt::format("repeats every {:.6f} m in x and {:.6f} m in y",
                       cell.period_x, cell.period_y);
}

//! Returns the PAR absorbed by each face [J m-2 day-1]. The faces are those of
//! the request's components, or of the field that the evaluation of the row
//! draws.
std::vector<Estimate> light_on_faces(CanopyRequest request, std::size_t faces,
                                     std::optional<int> paths,
                                     const std::string& isa) {
    request.details.faces = true;
    request.accuracy = paths ? Accuracy{*paths, request.accuracy.randomisations,
                                        0, request.accuracy.fields}
                             : face_accuracy(request.accuracy, faces);
    return evaluate(request, Device(isa)).par().faces;
}

//! Removes the faces of moving objects except in their pose when the sun is
//! strongest.
//! @param light light on each face; may be empty
void stand_still(Shape& shape, std::vector<Estimate>& light,
                 const std::vector<Source>& sources) {
    std::uint32_t pose = 0;
    double strongest = 0;
    for (const Source& source : sources)
        if (source.direction && source.energy > strongest) {
            strongest = source.energy;
            pose = source.pose;
        }
    Mesh& mesh = shape.mesh;
    std::vector<bool> moves_away;
    for (const std::uint32_t group : mesh.face_group) {
        const std::uint32_t own = mesh.groups[group].pose;
        moves_away.push_back(own != 0 && own != pose);
    }
    const auto thin = [&](auto& values) {
        std::size_t f = 0;
        std::erase_if(values, [&](const auto&) { return moves_away[f++]; });
    };
    thin(mesh.faces);
    thin(mesh.face_group);
    thin(shape.face_plant);
    thin(light);
}

void write_shape(const ExportOptions& options, const ChosenRow& row,
                 const std::string& title, bool is_lit, const Plants& grown,
                 std::size_t component) {
    CanopyRequest request = request_of(
        sampling_of(row.task, row.campaign, row.chosen), row.campaign,
        row.chosen, scene_of(row.campaign, row.chosen), grown);
    const std::vector<Component>& components = request.scene.components;
    const Component& chosen = components.at(component);
    Shape shape{
        about(title, row.chosen), chosen.mesh, {}, chosen.ground_per_plant};
    std::size_t first = 0;
    for (std::size_t i = 0; i < component; ++i)
        first += components[i].mesh.faces.size();
    if (options.is_field) {
        const Field field = draw_field(request.scene, request.randomness);
        shape.about.push_back(about_ground(field));
        shape.mesh = field.mesh;
        shape.face_plant = field.face_plant;
        shape.ground_area = field.cell.ground_area;
        request.scene = as_drawn(std::move(request.scene), field);
        first = 0;
    }
    const std::vector<Source> sources = request.scene.light().light.sources;
    std::vector<Estimate> light;
    if (is_lit) {
        const std::size_t count = shape.mesh.faces.size();
        light =
            light_on_faces(std::move(request), count, options.paths, row.isa);
        light.erase(light.begin(), light.begin() + static_cast<long>(first));
        light.resize(count);
    }
    stand_still(shape, light, sources);
    if (is_lit)
        write_vtp(options.to, shape, light);
    else
        write_obj(options.to, shape);
}

//! Returns a case, or one of its scenarios, in which plants are at the date or
//! thermal time given as an option.
Case as_it_stood(const Campaign& campaign, const Case& chosen,
                 const std::string& at) {
    const std::optional<Date> date = to_date(at);
    const std::optional<double> time = parse_number(at);
    if (!date && !time)
        throw wrong_usage(
            "--at: \"{}\" is neither a date nor a number of deg C d; write for "
            "example 2025-07-15 or 600",
            at);
    Case one = scenarios(chosen).front();
    for (const Case& scenario : scenarios(chosen)) {
        if (!date || campaign.spec.climates.empty()) break;
        const Period& period = climate_of(campaign, scenario).period;
        if (*date >= period.from && *date <= period.to) one = scenario;
    }
    try {
        one.stage = date ? stage_on(campaign, one, *date)
                         : stage_on(campaign, one, *time);
    } catch (const Error& error) {
        throw wrong_usage("--at: {}", error.what());
    }
    return one;
}

std::size_t chosen_component(const Campaign& campaign,
                             const std::string& name) {
    const std::vector<std::string> names = component_names(campaign);
    const auto position = std::ranges::find(names, name);
    if (name.empty()) return 0;
    if (position == names.end())
        throw wrong_usage("--component: there is no '{}'; {}", name,
                          did_you_mean(name, names));
    return static_cast<std::size_t>(position - names.begin());
}

}  // namespace

ExitCode export_plant(const ExportOptions& options) {
    if (options.is_generations) return export_generations(options);
    ChosenRow row = choose_row(options.path, options.row);
    const auto& [campaign, chosen, task, found, keys, schema, isa] = row;
    const std::size_t component = chosen_component(campaign, options.component);
    const Plants plants = grow(campaign, found.candidate.genome);
    std::string title = fmt::format(
        "ideotype {} {} slot {}", chosen.name,
        task.is_final ? "final" : fmt::format("generation {}", task.generation),
        task.slot);
    if (!keys.empty()) title += fmt::format(", {}", fmt::join(keys, ", "));
    const auto extension = std::filesystem::path(options.to).extension();
    if (extension != ".csv" && extension != ".obj" && extension != ".vtp" &&
        extension != ".toml")
        throw wrong_usage(
            "{}: the format is unknown; use a name that ends in .obj, .vtp, "
            ".csv or .toml",
            options.to);
    if (!options.at.empty()) {
        if (extension == ".csv" || extension == ".toml")
            throw wrong_usage(
                "--at: {} files describe full-grown plants only; write a .obj "
                "or .vtp file, or leave --at out",
                extension.string());
        row.chosen = as_it_stood(campaign, chosen, options.at);
        title += fmt::format(", {} ({:.0f} deg C d)",
                             to_string(*row.chosen.stage->date),
                             row.chosen.stage->at);
    }
    if (extension == ".csv" || extension == ".toml")
        require_crop(campaign, component);
    require_new(options.to);
    if (!keys.empty() && (extension == ".csv" || extension == ".toml"))
        fmt::print(stderr,
                   "ideotype: warning: {}: the search also varied keys of the "
                   "campaign, which a plant file cannot state; evaluate this "
                   "plant with --set {}\n",
                   options.to, fmt::join(keys, " --set "));
    if (extension == ".csv")
        write_csv(options.to, plants[component]);
    else if (extension == ".toml")
        write_crop_file(options.to, title, campaign, plants[component],
                        component);
    else
        write_shape(options, row, title, extension == ".vtp", plants,
                    component);
    fmt::print("{}\n", options.to);
    return ExitCode::ok;
}

}  // namespace ideotype
