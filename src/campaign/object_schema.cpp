// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

namespace {

//! Adds the optics of a surface in both bands.
void add_optics(Section& keys, Lambertian& par, Lambertian& nir) {
    const std::string sum = "reflectance + transmittance <= 0.99";
    keys.add("reflectance", par.reflectance, {0, 1},
             "of both sides, in the PAR band");
    keys.add("transmittance", par.transmittance, {0, 1}, sum);
    keys.add("nir_reflectance", nir.reflectance, {0, 1},
             "of both sides, in the near infrared band");
    keys.add("nir_transmittance", nir.transmittance, {0, 1}, sum);
}

Section panel_section(PanelEntry& entry) {
    Section keys{"panel"};
    PanelRows& rows = entry.rows;
    keys.add_name("name", rows.name, "of the rows, as figures tell them")
        .like("\"panel\"");
    keys.add("pitch", rows.pitch, {0, 100},
             "from row to row of panels; goes into the field a whole number of "
             "times; 0: as wide as the field")
        .in_metres();
    keys.add("height", rows.height, {0, 50},
             "of the middle of modules above the soil")
        .in_metres()
        .required("4");
    keys.add("width", rows.width, {0.01, 50}, "of modules, across the row")
        .in_metres()
        .required("2");
    keys.add("tilt", rows.tilt, {0, 90, "deg"},
             "from level; 90 stands upright");
    keys.add("azimuth", rows.azimuth, {0, 360, "deg"},
             "where the front looks, clockwise from north: parallel to the "
             "rows of plants or at right angles to them")
        .required("180");
    keys.add("offset", rows.offset, {0, 100, "m"},
             "of the middle of the first row from the edge of the field, which "
             "is halfway between rows of plants");
    keys.add("module_length", rows.module_length, {0, 100, "m"},
             "of a module along the row; 0: one without end");
    keys.add("gap", rows.gap, {0, 100, "m"}, "between the modules of a row");
    keys.add("tracks", rows.tracks,
             "whether modules turn about a level axis after the sun, in the "
             "place of `tilt`");
    keys.add("max_angle", rows.max_angle, {0, 85, "deg"},
             "largest turn of modules that track, either way from level");
    keys.add("backtracks", rows.backtracks,
             "whether modules that track turn back while the sun is low, so "
             "that no row shades another");
    add_optics(keys, entry.optics, entry.nir_optics);
    return keys;
}

Section object_section(ObjectEntry& entry) {
    Section keys{"object"};
    keys.add_name("name", entry.name, "of the object, as figures tell it")
        .required("\"post\"");
    keys.add_path("obj", entry.file, "\"post.obj\"",
                  "Wavefront OBJ file of its surfaces in metres, z up, y along "
                  "the rows");
    keys.add("x", entry.x, {-1000, 1000, "m"},
             "of its origin from the edge of the field, across the rows");
    keys.add("y", entry.y, {-1000, 1000, "m"}, "the same along the rows");
    keys.add("z", entry.z, {-1000, 1000, "m"}, "of its origin above the soil");
    keys.add("turn", entry.turn, {-360, 360, "deg"},
             "about the vertical, clockwise from above");
    keys.add("vertices", entry.vertices, {0, 0, "m"},
             "coordinates of each vertex, as the program writes them in the "
             "place of a file")
        .optional_list("list of numbers", "those of the file", "[0, 1, 2, 2]");
    keys.add("faces", entry.faces, "four vertices of each face, from 0")
        .optional_list("list of numbers", "those of the file", "[0, 1, 2, 2]");
    add_optics(keys, entry.optics, entry.nir_optics);
    return keys;
}

}  // namespace

std::vector<Table> object_tables(Campaign& campaign) {
    return {
        list_of_tables<PanelEntry>("panel", panel_section, campaign.panels)
            .optional()
            .at_most(most_components),
        list_of_tables<ObjectEntry>("object", object_section, campaign.objects)
            .optional()
            .at_most(most_components)};
}

}  // namespace ideotype
