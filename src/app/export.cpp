#include <filesystem>

#include <fmt/format.h>
#include <fmt/os.h>

#include "ideotype/app/canopy.hpp"
#include "ideotype/app/choose_row.hpp"
#include "ideotype/app/verbs.hpp"

namespace ideotype {

namespace {

//! One group per organ, "leaf01", or with plants of the faces given,
//! "plant001_leaf01".
void write_obj(const std::string& path, const std::string& title,
               const Mesh& mesh,
               const std::vector<std::uint32_t>& face_plant = {}) {
    auto out = fmt::output_file(path);
    out.print("# {}\n# metres, z up, y along the rows\n", title);
    for (const Vec3& v : mesh.vertices)
        out.print("v {:.7f} {:.7f} {:.7f}\n", v.x, v.y, v.z);
    std::string current;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        std::string group = mesh.groups[mesh.face_group[f]].name;
        if (!face_plant.empty())
            group = fmt::format("plant{:03}_{}", face_plant[f] + 1, group);
        if (group != current) out.print("g {}\n", current = group);
        const auto& v = mesh.faces[f];
        if (v[2] == v[3])
            out.print("f {} {} {}\n", v[0] + 1, v[1] + 1, v[2] + 1);
        else
            out.print("f {} {} {} {}\n", v[0] + 1, v[1] + 1, v[2] + 1,
                      v[3] + 1);
    }
}

void write_csv(const std::string& path, const Genome& genome) {
    auto out = fmt::output_file(path);
    out.print("leaf,length_m,width_m,inclination_deg,azimuth_deg\n");
    const auto traits = to_traits(genome);
    for (std::size_t i = 0; i < traits.size(); ++i)
        out.print("{},{},{},{},{}\n", i + 1, traits[i].length, traits[i].width,
                  traits[i].inclination, traits[i].azimuth);
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
    } else if (extension == ".obj") {
        if (options.is_field) {
            const Field field = build_field(
                campaign, chosen, genome, draws_of(task, campaign, chosen), 0);
            write_obj(options.to, title, field.mesh, field.face_plant);
        } else {
            write_obj(options.to, title, build_plant(campaign, genome));
        }
    } else {
        throw Error(fmt::format("{}: unknown format; use a name that ends in "
                                ".obj or .csv",
                                options.to),
                    ExitCode::usage);
    }
    fmt::print("{}\n", options.to);
    return ExitCode::ok;
}

}  // namespace ideotype
