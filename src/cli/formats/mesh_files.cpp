// SPDX-License-Identifier: Apache-2.0
#include "mesh_files.hpp"

#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output_file.hpp"

namespace ideotype {

namespace {

constexpr auto per_face_area = "MJ m-2 day-1";
constexpr double megajoule = 1e6;

std::size_t corners_of(const std::array<std::uint32_t, 4>& face) {
    return face[2] == face[3] ? 3 : 4;
}

template <class Print>
void write_array(OutputFile& out, const std::string& type,
                 const std::string& name, const std::string& more,
                 const Print& print) {
    out.print("<DataArray type=\"{}\" Name=\"{}\"{} format=\"ascii\">\n", type,
              name, more);
    print();
    out.print("\n</DataArray>\n");
}

//! Returns the leaf rank of a name such as "leaf07"; 0 for other organs.
int organ_of(const std::string& name) {
    int rank = 0;
    constexpr std::string_view leaf = "leaf";
    if (name.starts_with(leaf))
        std::from_chars(name.data() + leaf.size(), name.data() + name.size(),
                        rank);
    return rank;
}

//! Writes a text in the form that VTK XML requires: character codes with a
//! final 0.
void write_text(OutputFile& out, const std::string& name,
                const std::string& text) {
    out.print(
        "<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" "
        "format=\"ascii\">\n",
        name);
    for (const char c : text)
        out.print("{} ", static_cast<int>(static_cast<unsigned char>(c)));
    out.print("0\n</Array>\n");
}

void write_cell_data(OutputFile& out, const Shape& shape,
                     const std::vector<Estimate>& light) {
    const std::string absorbed =
        fmt::format("absorbed_par [{}]", per_face_area);
    out.print("<CellData Scalars=\"{}\">\n", absorbed);
    write_array(out, "Float64", absorbed, "", [&] {
        for (const Estimate& x : light) out.print("{} ", x.mean / megajoule);
    });
    write_array(out, "Float64",
                fmt::format("standard_error [{}]", per_face_area), "", [&] {
                    for (const Estimate& x : light)
                        out.print("{} ", x.standard_error / megajoule);
                });
    write_array(out, "Float64", "area [m2]", "", [&] {
        for (const double area : face_areas(shape.mesh)) out.print("{} ", area);
    });
    write_array(out, "Int32", "organ", "", [&] {
        for (const std::uint32_t group : shape.mesh.face_group)
            out.print("{} ", organ_of(shape.mesh.groups[group].name));
    });
    if (!shape.face_plant.empty())
        write_array(out, "Int32", "plant", "", [&] {
            for (const std::uint32_t plant : shape.face_plant)
                out.print("{} ", plant + 1);
        });
    out.print("</CellData>\n");
}

void write_surfaces(OutputFile& out, const Mesh& mesh) {
    out.print("<Points>\n");
    write_array(out, "Float64", "points", " NumberOfComponents=\"3\"", [&] {
        for (const glm::dvec3& v : mesh.vertices)
            out.print("{:.7f} {:.7f} {:.7f}\n", v.x, v.y, v.z);
    });
    out.print("</Points>\n<Polys>\n");
    write_array(out, "Int64", "connectivity", "", [&] {
        for (const auto& face : mesh.faces)
            for (std::size_t i = 0; i < corners_of(face); ++i)
                out.print("{} ", face[i]);
    });
    write_array(out, "Int64", "offsets", "", [&] {
        std::size_t end = 0;
        for (const auto& face : mesh.faces)
            out.print("{} ", end += corners_of(face));
    });
    out.print("</Polys>\n");
}

}  // namespace

void write_obj(const std::string& path, const Shape& shape) {
    const Mesh& mesh = shape.mesh;
    OutputFile out(path);
    for (const std::string& line : shape.about) out.print("# {}\n", line);
    for (const glm::dvec3& v : mesh.vertices)
        out.print("v {:.7f} {:.7f} {:.7f}\n", v.x, v.y, v.z);
    std::string current;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Group& organ = mesh.groups[mesh.face_group[f]];
        std::string group = organ.name;
        if (!shape.face_plant.empty() && !organ.id.is_object())
            group =
                fmt::format("plant{:03}_{}", shape.face_plant[f] + 1, group);
        if (group != current) out.print("g {}\n", current = group);
        out.print("f");
        for (std::size_t i = 0; i < corners_of(mesh.faces[f]); ++i)
            out.print(" {}", mesh.faces[f][i] + 1);
        out.print("\n");
    }
    out.finish();
}

void write_vtp(const std::string& path, const Shape& shape,
               const std::vector<Estimate>& light) {
    OutputFile out(path);
    out.print(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "<PolyData>\n<FieldData>\n");
    write_text(out, "title", fmt::format("{}", fmt::join(shape.about, "\n")));
    write_array(out, "Float64", "ground_area [m2]", " NumberOfTuples=\"1\"",
                [&] { out.print("{}", shape.ground_area); });
    out.print(
        "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" "
        "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
        shape.mesh.vertices.size(), shape.mesh.faces.size());
    write_cell_data(out, shape, light);
    write_surfaces(out, shape.mesh);
    out.print("</Piece>\n</PolyData>\n</VTKFile>\n");
    out.finish();
}

}  // namespace ideotype
