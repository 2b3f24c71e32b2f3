// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/obj_reader.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/file.hpp"
#include "ideotype/crop/plant.hpp"
#include "ideotype/crop/polygon.hpp"
#include "obj_statements.hpp"

namespace ideotype {

std::uint32_t leaf_rank(std::string_view name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    constexpr std::string_view leaf = "leaf";
    constexpr std::size_t most_digits = 4;
    if (digits == name.size() || name.size() - digits > most_digits ||
        !name.substr(0, digits).ends_with(leaf))
        return 0;
    return static_cast<std::uint32_t>(
        std::stoul(std::string(name.substr(digits))));
}

namespace {

PlantMaterial parse_material(std::string_view name) {
    constexpr std::string_view plant = "plant";
    if (name.starts_with(plant)) {
        const std::size_t end =
            name.find_first_not_of("0123456789", plant.size());
        if (end == plant.size() || end == name.npos || name[end] != '_')
            return PlantMaterial::leaf;
        name.remove_prefix(end + 1);
    }
    if (name.starts_with("stalk")) return PlantMaterial::stalk;
    return name.starts_with("sheath") ? PlantMaterial::sheath
                                      : PlantMaterial::leaf;
}

}  // namespace

Group parse_group_name(const std::string& name) {
    const auto material = static_cast<std::uint32_t>(parse_material(name));
    return {name, {0, material, leaf_rank(name)}, material};
}

namespace {

//! Builds a mesh from the statements that the library reports.
class ObjBuilder {
  public:
    ObjBuilder(const std::string& file, const ObjStatements& statements)
        : file_(file), statements_(statements) {
        polygons_.reserve(statements.face_lines.size());
        result_.mesh.vertices.reserve(statements.vertex_lines.size());
    }

    //! Returns functions for the library, with this builder as `self`.
    static tinyobj::callback_t callbacks() {
        tinyobj::callback_t calls;
        calls.vertex_cb = [](void* self, double x, double y, double z, double) {
            cast(self).add_vertex({x, y, z});
        };
        calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            cast(self).add_polygon(corners, count);
        };
        calls.group_cb = [](void* self, const char** names, int count) {
            cast(self).begin_group(
                fmt::format("{}", fmt::join(names, names + count, " ")));
        };
        calls.object_cb = [](void* self, const char* name) {
            cast(self).begin_group(name);
        };
        return calls;
    }

    ObjMesh finish() {
        result_.mesh.faces.reserve(polygons_.size());
        result_.mesh.face_group.reserve(polygons_.size());
        for (const Polygon& polygon : polygons_) add_faces(polygon);
        if (result_.mesh.faces.empty())
            throw InputError(
                {{{file_},
                  "",
                  ProblemCode::data,
                  polygons_.empty()
                      ? "there are no faces (lines that begin with f); add some"
                      : "no face has an area (the corners of each are on a "
                        "line); export the mesh again"}});
        warn(without_area_, "faces without area are left out");
        warn(crossing_,
             "polygons cross themselves; parts of them may count twice");
        warn(statements_.unknown, "lines are not understood and left out");
        return std::move(result_);
    }

  private:
    //! A polygon. Its corners are a range of one list for all polygons, since
    //! files may contain millions of them.
    struct Polygon {
        std::size_t first;  //!< index of the first corner in corners_
        std::uint32_t count;
        std::uint32_t group;
        int line;
    };

    static ObjBuilder& cast(void* self) {
        return *static_cast<ObjBuilder*>(self);
    }

    void add_vertex(const glm::dvec3& v) {
        std::vector<glm::dvec3>& vertices = result_.mesh.vertices;
        for (const double x : {v.x, v.y, v.z})
            if (!(std::abs(x) <= largest_obj_coordinate))
                fail(statements_.vertex_lines[vertices.size()],
                     fmt::format("the coordinate {:.6g} is not within {:.0g} m "
                                 "of the origin (the unit is the metre); scale "
                                 "the mesh",
                                 x, largest_obj_coordinate));
        vertices.push_back(v);
    }

    void add_polygon(const tinyobj::index_t* corners, int count) {
        const Polygon polygon{corners_.size(),
                              static_cast<std::uint32_t>(count), group(),
                              statements_.face_lines[polygons_.size()]};
        for (int i = 0; i < count; ++i) {
            const long long index = corners[i].vertex_index;
            if (index == 0)
                fail(polygon.line,
                     "a corner is vertex 0 (vertices are counted from 1); "
                     "correct it");
            // A negative index counts back from the last vertex so far.
            const auto vertices =
                static_cast<long long>(result_.mesh.vertices.size());
            corners_.push_back(
                static_cast<int>(index > 0 ? index - 1 : vertices + index));
        }
        polygons_.push_back(polygon);
    }

    void begin_group(std::string name) {
        name_ = name.empty() ? "unnamed" : std::move(name);
    }

    //! Returns the index of the current group. The group is created when its
    //! first face is read.
    std::uint32_t group() {
        std::vector<Group>& groups = result_.mesh.groups;
        const auto [entry, is_new] = group_index_.try_emplace(
            name_, static_cast<std::uint32_t>(groups.size()));
        if (is_new) groups.push_back(parse_group_name(name_));
        return entry->second;
    }

    void add_faces(const Polygon& polygon) {
        Mesh& mesh = result_.mesh;
        const auto count = static_cast<long long>(mesh.vertices.size());
        Corners corners;
        for (std::uint32_t i = 0; i < polygon.count; ++i) {
            const long long corner = corners_[polygon.first + i];
            if (corner < 0 || corner >= count)
                fail(polygon.line,
                     corner < 0
                         ? "a corner lies before the first vertex; correct it"
                         : fmt::format("a corner is vertex {}, but there are "
                                       "only {}; correct it",
                                       corner + 1, count));
            corners.push_back(static_cast<std::uint32_t>(corner));
        }
        const SplitPolygon split =
            split_polygon(mesh.vertices, std::move(corners));
        if (split.kind == PolygonKind::intricate)
            fail(polygon.line,
                 fmt::format("a polygon of {} corners is too intricate to be "
                             "split; give it as triangles",
                             polygon.count));
        if (split.kind == PolygonKind::without_area)
            without_area_.add(polygon.line);
        if (split.kind == PolygonKind::crossing) crossing_.add(polygon.line);
        mesh.faces.insert(mesh.faces.end(), split.faces.begin(),
                          split.faces.end());
        mesh.face_group.insert(mesh.face_group.end(), split.faces.size(),
                               polygon.group);
    }

    void warn(const Occurrences& occurrences, const char* text) {
        if (occurrences.count > 0)
            result_.warnings.push_back(
                fmt::format("{} {} (the first in line {})", occurrences.count,
                            text, occurrences.first_line));
    }

    [[noreturn]] void fail(int line, std::string text) const {
        throw InputError(
            {{{file_, line, 1}, "", ProblemCode::data, std::move(text)}});
    }

    const std::string& file_;
    const ObjStatements& statements_;
    ObjMesh result_;
    std::vector<int> corners_;  //!< vertices from 0, not yet checked
    std::vector<Polygon> polygons_;
    std::string name_ = "unnamed";
    std::map<std::string, std::uint32_t> group_index_;
    Occurrences without_area_;
    Occurrences crossing_;
};

}  // namespace

ObjMesh parse_obj(std::string text, const std::string& file) {
    ObjStatements statements = pick_statements(text, file);
    // Release the text of a large mesh as soon as possible.
    text = {};
    ObjBuilder builder(file, statements);
    {
        std::istringstream stream(std::move(statements.text));
        std::string warning, error;
        if (!tinyobj::LoadObjWithCallback(stream, ObjBuilder::callbacks(),
                                          &builder, nullptr, &warning, &error))
            throw InputError({{{file}, "", ProblemCode::data, error}});
    }
    return builder.finish();
}

ObjMesh read_obj(const std::string& path) {
    FileText file = read_file(path, most_data_bytes);
    if (!file.is_there)
        throw Error(fmt::format("{}; name an OBJ file", file.refusal(path)));
    return parse_obj(std::move(file.text), path);
}

}  // namespace ideotype
