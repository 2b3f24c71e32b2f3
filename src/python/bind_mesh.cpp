// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/map.h>
#include <nanobind/stl/variant.h>

#include "bindings.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/mapped.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "ideotype/crop/polygon.hpp"
#include "stand/mesh_study.hpp"

namespace ideotype::python {

namespace {

//! A mesh with faces made by dividing polygons.
struct Divided {
    Mesh mesh;
    std::vector<std::size_t> polygon;  //!< polygon of each face
    std::size_t polygons = 0;
};

//! Divides polygons into faces, as for OBJ files.
//! @param corners vertices of all polygons, one polygon after another
//! @param counts number of corners of each polygon
Divided divide(const Input<double, 2>& vertices,
               const Input<std::uint32_t, 1>& corners,
               const Input<std::uint32_t, 1>& counts,
               const Input<std::uint32_t, 1>& group,
               const std::vector<std::string>& names) {
    Divided result;
    Mesh& mesh = result.mesh;
    for (std::size_t i = 0; i < vertices.shape(0); ++i)
        mesh.vertices.push_back(
            {vertices(i, 0), vertices(i, 1), vertices(i, 2)});
    const std::uint32_t* next = corners.data();
    for (std::size_t p = 0; p < counts.size(); ++p) {
        const std::vector<std::uint32_t> polygon(next, next + counts(p));
        next += counts(p);
        for (const auto& face : split_polygon(mesh.vertices, polygon).faces) {
            mesh.faces.push_back(face);
            mesh.face_group.push_back(group(p));
            result.polygon.push_back(p);
        }
    }
    result.polygons = counts.size();
    for (const std::string& name : names)
        mesh.groups.push_back(parse_group_name(name));
    if (mesh.faces.empty()) throw Error("no face has an area");
    return result;
}

//! Returns the light absorbed by each polygon per one-sided area; 0 for
//! polygons without area.
std::vector<Estimate> by_polygon(const Divided& divided,
                                 const std::vector<double>& areas,
                                 const std::vector<Estimate>& faces) {
    if (faces.empty()) return {};
    std::vector<Estimate> estimates(divided.polygons);
    std::vector<double> area(divided.polygons);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Estimate& polygon = estimates[divided.polygon[f]];
        polygon.mean += faces[f].mean * areas[f];
        // Add standard errors as if they were fully correlated, which is an
        // upper bound.
        polygon.standard_error += faces[f].standard_error * areas[f];
        area[divided.polygon[f]] += areas[f];
    }
    for (std::size_t p = 0; p < estimates.size(); ++p)
        if (area[p] > 0) estimates[p] = scaled(estimates[p], 1 / area[p]);
    return estimates;
}

//! A unit of results, and the factor by which values are converted to it.
struct Unit {
    const char* name;
    double scale = 1;
};

Unit unit_of_light(const MeshSpec& spec) {
    if (spec.has_day()) return {"MJ m-2 day-1", 1 / joule_per_megajoule};
    return {spec.has_ppfd() ? "umol m-2 s-1" : "1"};
}

//! The parts of an xarray Dataset: coordinates and arrays. An array has a name,
//! dimensions, unit, meaning and values; values with standard errors are pairs.
struct Dataset {
    nb::list arrays;
    nb::dict coordinates;

    void add(const std::string& name, const std::vector<ResultAxis>& along,
             const std::string& unit, const Output<double>& numbers,
             const std::string& meaning = "") {
        std::vector<std::string> names;
        for (const ResultAxis& axis : along) {
            names.emplace_back(axis.name);
            if (!axis.labels.empty()) coordinates[axis.name] = axis.labels;
        }
        arrays.append(nb::make_tuple(
            name, names, unit, meaning.empty() ? name : meaning, numbers));
    }
    void add(const std::vector<LightResult>& results, const Unit& unit) {
        for (const LightResult& result : results)
            if (result.array)
                add(result.array, result.along, unit.name,
                    to_array(mapped(result.values, [&](const Estimate& x) {
                        return scaled(x, unit.scale);
                    })));
    }
    void add_exact(const std::string& name,
                   const std::vector<ResultAxis>& along,
                   const std::string& unit, const std::vector<double>& values) {
        add(name, along, unit, to_array(values, {values.size()}));
    }
};

//! Returns the arrays, coordinates and attributes of a Dataset. With a scene
//! file, arrays are split by waveband and component.
nb::tuple parts_of(const MeshReport& report, const MeshSpec& spec,
                   const std::vector<Estimate>& faces) {
    const CanopyReport& canopy = report.canopy;
    const DayReport& light = canopy.par().light;
    const Unit unit = unit_of_light(spec);
    const Span span = span_of(spec);
    const bool is_scene = !spec.scene.empty();
    Dataset dataset;
    nb::dict about;
    about["paths"] = canopy.paths;
    about["ground_area"] = canopy.ground_area;
    about["is_tolerance_met"] = !canopy.is_capped;
    about["warnings"] = report.warnings;
    if (is_scene) {
        dataset.add(band_results(canopy), unit);
        dataset.add_exact("incident", {{"band"}}, unit.name,
                          mapped(canopy.bands, [&](const BandReport& band) {
                              return unit.scale * band.light.day.incident;
                          }));
        dataset.add_exact("lai", {{"component"}}, "m2 m-2",
                          mapped(canopy.components, &ComponentReport::lai));
    } else {
        dataset.add(budget_results(light.day, canopy), unit);
        dataset.add(part_results(canopy), unit);
        // Light by face is given per one-sided area of the face.
        if (!faces.empty())
            dataset.add({{"", "absorbed_by_face", {{"face"}}, faces}}, unit);
        for (const auto& [quantity, estimate] : numbers_of(canopy, span))
            dataset.add(quantity.name, {}, quantity.unit,
                        to_array(std::vector{estimate}), quantity.meaning);
        dataset.add_exact("incident", {}, unit.name,
                          {unit.scale * light.day.incident});
        std::vector<double> middles;
        for (std::size_t i = 0; i < light.layers.size(); ++i)
            middles.push_back(canopy.layers.thickness *
                              (static_cast<double>(i) + 0.5));
        dataset.coordinates["layer"] = middles;
        about["balance_error"] = light.balance_error;
    }
    if (canopy.assimilation)
        dataset.add(
            carbon_results(
                canopy, is_scene ? CarbonOf::components : CarbonOf::all, span),
            {carbon_unit(span)});
    return nb::make_tuple(dataset.arrays, dataset.coordinates, about);
}

//! Returns the Python argument for a key. The two fractions of a surface are
//! passed as a pair in one argument.
std::string argument_of_key(const std::string& key) {
    for (const std::string surface : {"leaf", "stalk", "sheath"})
        if (key.starts_with(surface + '_'))
            return surface + (key.ends_with("reflectance") ? "[0]" : "[1]");
    return key == "date" ? "day" : key;
}

}  // namespace

void bind_mesh(nb::module_& module) {
    module.def("evaluate_mesh", [](const Input<double, 2>& vertices,
                                   const Input<std::uint32_t, 1>& corners,
                                   const Input<std::uint32_t, 1>& counts,
                                   const Input<std::uint32_t, 1>& group,
                                   const std::vector<std::string>& names,
                                   const GivenKeys& given, bool by_face) {
        MeshSpec spec = read_mesh_spec(given, argument_of_key);
        spec.is_by_face = by_face;
        MeshReport report;
        std::vector<Estimate> faces;
        {
            const nb::gil_scoped_release released;
            Divided divided = divide(vertices, corners, counts, group, names);
            const std::vector<double> areas = face_areas(divided.mesh);
            report = study(std::move(divided.mesh), spec, argument_of_key);
            faces = by_polygon(divided, areas, report.canopy.par().faces);
        }
        return parts_of(report, spec, faces);
    });
}

}  // namespace ideotype::python
