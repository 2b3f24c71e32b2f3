#include <cctype>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/os.h>

#include "ideotype/app/canopy.hpp"
#include "ideotype/app/choose_row.hpp"
#include "ideotype/app/verbs.hpp"

namespace ideotype {

namespace {

//! Writes the faces of one plant: one OBJ group per leaf, vertices numbered
//! from `first`.
void write_plant(fmt::ostream& out, const Mesh& mesh, std::size_t first_face,
                 std::size_t faces, const std::string& prefix) {
    std::uint32_t group = UINT32_MAX;
    for (std::size_t f = first_face; f < first_face + faces; ++f) {
        if (mesh.face_group[f] != group) {
            group = mesh.face_group[f];
            out.print("g {}{}\n", prefix, mesh.groups[group].name);
        }
        const auto& v = mesh.faces[f];
        if (v[2] == v[3])
            out.print("f {} {} {}\n", v[0] + 1, v[1] + 1, v[2] + 1);
        else
            out.print("f {} {} {} {}\n", v[0] + 1, v[1] + 1, v[2] + 1,
                      v[3] + 1);
    }
}

void write_obj(const std::string& path, const std::string& title,
               const Mesh& mesh, std::size_t plants) {
    auto out = fmt::output_file(path);
    out.print("# {}\n# metres, z up, y along the rows\n", title);
    for (const Vec3& v : mesh.vertices)
        out.print("v {:.7f} {:.7f} {:.7f}\n", v.x, v.y, v.z);
    const std::size_t faces = mesh.faces.size() / plants;
    for (std::size_t p = 0; p < plants; ++p)
        write_plant(out, mesh, p * faces, faces,
                    plants > 1 ? fmt::format("plant{:03}_", p + 1) : "");
}

void write_csv(const std::string& path, const Genome& genome) {
    auto out = fmt::output_file(path);
    out.print("leaf,length_m,width_m,inclination_deg,azimuth_deg\n");
    const auto traits = to_traits(genome);
    for (std::size_t i = 0; i < traits.size(); ++i)
        out.print("{},{},{},{},{}\n", i + 1, traits[i].length, traits[i].width,
                  traits[i].inclination, traits[i].azimuth);
}

//! The plant's name is that of the file, as far as names allow.
void write_plant_file(const std::string& path, const std::string& title,
                      PlantForm form, const Genome& genome) {
    form.name = std::filesystem::path(path).stem().string().substr(0, 64);
    for (char& c : form.name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    auto out = fmt::output_file(path);
    out.print("# {}\n{}", title, plant_text({form, to_traits(genome)}));
}

}  // namespace

ExitCode export_plant(const ExportOptions& options) {
    const auto [campaign, chosen, task, row, isa] =
        choose_row(options.path, options.row);
    const Genome& genome = row.candidate.genome;
    const std::string title = fmt::format(
        "ideotype {} {} slot {}", chosen.name,
        task.is_final ? "final" : fmt::format("generation {}", task.generation),
        task.slot);
    const auto extension = std::filesystem::path(options.to).extension();
    if (std::filesystem::exists(options.to))
        throw Error(fmt::format("{}: exists already and is not overwritten",
                                options.to),
                    ExitCode::refused);
    if (extension == ".csv") {
        write_csv(options.to, genome);
    } else if (extension == ".toml") {
        write_plant_file(options.to, title, campaign.plant, genome);
    } else if (extension == ".obj") {
        if (options.is_field) {
            const Field field = build_field(
                campaign, chosen, genome, draws_of(task, campaign, chosen), 0);
            write_obj(options.to, title, field.mesh,
                      static_cast<std::size_t>(campaign.field.rows) *
                          static_cast<std::size_t>(campaign.field.plants));
        } else {
            write_obj(options.to, title, build_plant(campaign, genome), 1);
        }
    } else {
        throw Error(fmt::format("{}: unknown format; use a name that ends in "
                                ".obj, .csv or .toml",
                                options.to),
                    ExitCode::usage);
    }
    fmt::print("{}\n", options.to);
    return ExitCode::ok;
}

}  // namespace ideotype
