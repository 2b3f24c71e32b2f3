// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "ideotype/crop/polygon.hpp"
#include "stand/mesh_study.hpp"

namespace ideotype::python {

namespace {

//! A mesh made of polygons.
struct Divided {
    Mesh mesh;
    std::vector<std::size_t> polygon;  //!< polygon of each face
    std::size_t polygons = 0;
};

//! Divides polygons into faces as in OBJ files.
//! @param corners vertices of all polygons, with a number of corners for each
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
        const std::vector<std::uint32_t> own(next, next + counts(p));
        next += counts(p);
        for (const auto& face : split_polygon(mesh.vertices, own).faces) {
            mesh.faces.push_back(face);
            mesh.face_group.push_back(group(p));
            result.polygon.push_back(p);
        }
    }
    result.polygons = counts.size();
    for (const std::string& name : names)
        mesh.groups.push_back(group_of_name(name));
    if (mesh.faces.empty()) throw Error("no face has an area");
    return result;
}

//! Returns the light of each polygon per one-sided area: 0 if it has none.
std::vector<Estimate> by_polygon(const Divided& divided,
                                 const std::vector<double>& areas,
                                 const std::vector<Estimate>& faces) {
    if (faces.empty()) return {};
    std::vector<Estimate> all(divided.polygons);
    std::vector<double> area(divided.polygons);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Estimate& polygon = all[divided.polygon[f]];
        polygon.mean += faces[f].mean * areas[f];
        // Errors are added as if fully correlated, which can only overestimate
        // them.
        polygon.standard_error += faces[f].standard_error * areas[f];
        area[divided.polygon[f]] += areas[f];
    }
    for (std::size_t p = 0; p < all.size(); ++p)
        if (area[p] > 0) all[p] = scaled(all[p], 1 / area[p]);
    return all;
}

nb::tuple to_tuple(const Estimate& x) {
    return nb::make_tuple(x.mean, x.standard_error);
}

nb::dict to_dict(const CanopyReport& canopy, bool is_day,
                 const std::vector<Estimate>& faces) {
    const BudgetEstimate& day = canopy.par().light.day;
    nb::dict dict;
    dict["incident"] = day.incident;
    nb::dict budget;
    if (canopy.boundary == Boundary::isolated)
        budget["entered"] = to_tuple(day.entered);
    budget["leaves"] = to_tuple(day.leaves);
    budget["stalks"] = to_tuple(day.organs);
    budget["soil"] = to_tuple(day.soil);
    budget["reflected"] = to_tuple(day.reflected);
    dict["budget"] = budget;
    dict["groups"] = names_of(canopy.groups);
    dict["absorbed_by_group"] = to_array(canopy.par().light.groups);
    dict["absorbed_by_layer"] = to_array(canopy.par().light.layers);
    dict["layer_thickness"] = canopy.layers.thickness;
    dict["absorbed_by_face"] = to_array(faces);
    nb::list numbers;
    for (const auto& [quantity, estimate] : measure_numbers(canopy)) {
        const bool is_rate = quantity.unit != "1" && quantity.unit != "m2 m-2";
        if (is_day || !is_rate)
            numbers.append(nb::make_tuple(quantity.name, quantity.unit,
                                          quantity.meaning, estimate.mean,
                                          estimate.standard_error));
    }
    dict["numbers"] = numbers;
    if (canopy.assimilation) {
        const AssimilationReport& all = *canopy.assimilation;
        dict["gross_assimilation"] = to_tuple(all.gross.sum);
        dict["net_loss"] = sum_of(all.losses).in_light;
    }
    dict["balance_error"] = canopy.par().light.balance_error;
    return dict;
}

nb::dict to_scene_dict(const CanopyReport& canopy) {
    nb::dict dict;
    nb::list bands;
    for (const BandReport& band : canopy.bands) {
        std::vector<Estimate> components;
        for (std::size_t c = 0; c < canopy.components.size(); ++c)
            components.push_back(band.part(c).all);
        nb::dict one;
        one["name"] = band.name;
        one["incident"] = band.light.day.incident;
        one["soil"] = to_tuple(band.light.day.soil);
        one["reflected"] = to_tuple(band.light.day.reflected);
        one["absorbed_by_component"] = to_array(components);
        one["absorbed"] = to_array(band.light.groups);
        bands.append(one);
    }
    dict["bands"] = bands;
    std::vector<double> lai;
    for (const ComponentReport& each : canopy.components)
        lai.push_back(each.lai);
    dict["components"] = names_of(canopy.components);
    dict["lai"] = lai;
    dict["groups"] = names_of(canopy.groups);
    if (canopy.assimilation) {
        std::vector<Estimate> gross;
        std::vector<double> lost;
        for (const ComponentAssimilation& each :
             by_component(*canopy.assimilation, canopy.groups, lai.size())) {
            gross.push_back(each.gross);
            lost.push_back(each.loss.in_light);
        }
        dict["gross_assimilation"] = to_array(gross);
        dict["respired"] = lost;
    }
    return dict;
}

}  // namespace

void bind_mesh(nb::module_& module) {
    module.def("evaluate_mesh", [](const Input<double, 2>& vertices,
                                   const Input<std::uint32_t, 1>& corners,
                                   const Input<std::uint32_t, 1>& counts,
                                   const Input<std::uint32_t, 1>& group,
                                   const std::vector<std::string>& names,
                                   std::vector<std::string> arguments,
                                   bool by_face) {
        MeshOptions options = read_mesh_options(std::move(arguments));
        options.is_by_face = by_face;
        MeshReport report;
        std::vector<Estimate> faces;
        {
            const nb::gil_scoped_release released;
            Divided divided = divide(vertices, corners, counts, group, names);
            const std::vector<double> areas = face_areas(divided.mesh);
            report = study(std::move(divided.mesh), options);
            faces = by_polygon(divided, areas, report.canopy.par().faces);
        }
        const bool is_day = has_day(options);
        nb::dict found = options.scene.empty()
                             ? to_dict(report.canopy, is_day, faces)
                             : to_scene_dict(report.canopy);
        found["ground_area"] = report.canopy.ground_area;
        found["paths"] = report.canopy.paths;
        found["is_capped"] = report.canopy.is_capped;
        found["warnings"] = report.warnings;
        found["is_day"] = is_day;
        return found;
    });
}

}  // namespace ideotype::python
