// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/map.h>
#include <nanobind/stl/variant.h>

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

//! The arrays of a Dataset of xarray, each with its name, dimensions, unit,
//! meaning and numbers; numbers with standard errors are pairs.
class Arrays {
  public:
    using Names = std::vector<std::string>;

    explicit Arrays(const MeshSpec& spec) {
        if (spec.has_day()) {
            unit_ = "MJ m-2 day-1";
            scale_ = 1e-6;
        } else {
            // A single light is that of one second [mol].
            unit_ = spec.has_ppfd() ? "umol m-2 s-1" : "1";
            carbon_unit_ = "umol m-2 s-1";
            moles_ = 1e6;
        }
    }

    void add(const std::string& name, const Names& along,
             const std::string& unit, std::vector<Estimate> values,
             double scale = 1, const std::string& meaning = "") {
        for (Estimate& each : values) each = scaled(each, scale);
        all_.append(nb::make_tuple(name, along, unit,
                                   meaning.empty() ? name : meaning,
                                   to_array(values)));
    }
    void add_light(const std::string& name, const Names& along,
                   const std::vector<Estimate>& values) {
        add(name, along, unit_, values, scale_);
    }
    void add_incident(const Names& along, std::vector<double> values) {
        for (double& each : values) each *= scale_;
        add_exact("incident", along, unit_, values);
    }
    void add_exact(const std::string& name, const Names& along,
                   const std::string& unit, const std::vector<double>& values) {
        all_.append(nb::make_tuple(name, along, unit, name,
                                   to_array(values, {values.size()})));
    }
    //! Adds assimilation, given in mol, without and with its losses in light.
    void add_carbon(const Names& along, const std::vector<Estimate>& gross,
                    const std::vector<Estimate>& net) {
        add("gross_assimilation", along, carbon_unit_, gross);
        add("net_assimilation", along, carbon_unit_, net);
    }
    //! Returns moles in the unit of carbon.
    double moles() const { return moles_; }

    const nb::list& all() const { return all_; }

  private:
    nb::list all_;
    std::string unit_, carbon_unit_ = "mol m-2 day-1";
    double scale_ = 1, moles_ = 1;
};

//! Adds the light and the numbers of a mesh.
void add_mesh(const CanopyReport& canopy, bool is_day,
              const std::vector<Estimate>& faces, Arrays& arrays) {
    const DayReport& light = canopy.par().light;
    if (canopy.boundary == Boundary::isolated)
        arrays.add_light("entered", {}, {light.day.entered});
    arrays.add_light("leaves", {}, {light.day.leaves});
    arrays.add_light("stalks", {}, {light.day.organs});
    arrays.add_light("soil", {}, {light.day.soil});
    arrays.add_light("reflected", {}, {light.day.reflected});
    arrays.add_light("absorbed", {"group"}, light.groups);
    arrays.add_light("absorbed_by_layer", {"layer"}, light.layers);
    // Light by face is per one-sided area of the face.
    if (!faces.empty()) arrays.add_light("absorbed_by_face", {"face"}, faces);
    for (const auto& [quantity, estimate] : measure_numbers(canopy)) {
        const bool is_rate = quantity.unit != "1" && quantity.unit != "m2 m-2";
        if (is_day || !is_rate)
            arrays.add(quantity.name, {}, quantity.unit, {estimate}, 1,
                       quantity.meaning);
    }
    arrays.add_incident({}, {light.day.incident});
    if (!canopy.assimilation) return;
    const Estimate gross =
        scaled(canopy.assimilation->gross.sum, arrays.moles());
    const double loss =
        arrays.moles() * sum_of(canopy.assimilation->losses).in_light;
    arrays.add_carbon({}, {gross}, {{gross.mean - loss, gross.standard_error}});
}

//! Adds the light and the assimilation of a scene file by band and component.
void add_scene(const CanopyReport& canopy, Arrays& arrays) {
    std::vector<Estimate> soil, reflected, components, groups, gross, net;
    std::vector<double> incident, lai;
    for (const BandReport& band : canopy.bands) {
        incident.push_back(band.light.day.incident);
        soil.push_back(band.light.day.soil);
        reflected.push_back(band.light.day.reflected);
        for (std::size_t c = 0; c < canopy.components.size(); ++c)
            components.push_back(band.part(c).all);
        groups.insert(groups.end(), band.light.groups.begin(),
                      band.light.groups.end());
    }
    for (const ComponentReport& each : canopy.components)
        lai.push_back(each.lai);
    arrays.add_light("soil", {"band"}, soil);
    arrays.add_light("reflected", {"band"}, reflected);
    arrays.add_light("absorbed_by_component", {"band", "component"},
                     components);
    arrays.add_light("absorbed", {"band", "group"}, groups);
    arrays.add_incident({"band"}, incident);
    arrays.add_exact("lai", {"component"}, "m2 m-2", lai);
    if (!canopy.assimilation) return;
    for (const ComponentAssimilation& each :
         by_component(*canopy.assimilation, canopy.groups, lai.size())) {
        gross.push_back(scaled(each.gross, arrays.moles()));
        net.push_back(scaled(
            {each.gross.mean - each.loss.in_light, each.gross.standard_error},
            arrays.moles()));
    }
    arrays.add_carbon({"component"}, gross, net);
}

//! Returns the parts of a Dataset: arrays, coordinates and attributes.
nb::tuple parts_of(const MeshReport& report, const MeshSpec& spec,
                   const std::vector<Estimate>& faces) {
    const CanopyReport& canopy = report.canopy;
    Arrays arrays(spec);
    nb::dict coordinates, about;
    about["paths"] = canopy.paths;
    about["ground_area"] = canopy.ground_area;
    about["is_tolerance_met"] = !canopy.is_capped;
    about["warnings"] = report.warnings;
    coordinates["group"] = names_of(canopy.groups);
    if (spec.scene.empty()) {
        add_mesh(canopy, spec.has_day(), faces, arrays);
        std::vector<double> middles;
        for (std::size_t i = 0; i < canopy.par().light.layers.size(); ++i)
            middles.push_back(canopy.layers.thickness *
                              (static_cast<double>(i) + 0.5));
        coordinates["layer"] = middles;
        about["balance_error"] = canopy.par().light.balance_error;
    } else {
        add_scene(canopy, arrays);
        coordinates["band"] = names_of(canopy.bands);
        coordinates["component"] = names_of(canopy.components);
    }
    return nb::make_tuple(arrays.all(), coordinates, about);
}

//! Returns the argument of a key: a surface has a pair of both fractions.
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
