// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

namespace {

Key part_of_light(const std::string& name, double& value,
                  const std::string& meaning) {
    return Key(name, &value, meaning).within(0, 1);
}

//! Appends the optics of a surface.
void add_optics(Section& section, Lambertian& par, Lambertian& nir) {
    const std::string sum = "reflectance + transmittance <= 0.99";
    for (const Key& key :
         {part_of_light("reflectance", par.reflectance,
                        "of both sides, in the PAR band"),
          part_of_light("transmittance", par.transmittance, sum),
          part_of_light("nir_reflectance", nir.reflectance,
                        "of both sides, in the near infrared band"),
          part_of_light("nir_transmittance", nir.transmittance, sum)})
        section.keys.push_back(key);
}

Section panel_section(PanelEntry& entry) {
    PanelRows& rows = entry.rows;
    Section section{
        "panel",
        {Key("name", &rows.name, "of the rows, as figures tell them")
             .set(&Key::range, name_range)
             .like("\"panel\""),
         Key("pitch", &rows.pitch,
             "from row to row of panels; goes into the field a whole number "
             "of times; 0: as wide as the field")
             .metres(0, 100),
         Key("height", &rows.height, "of the middle of modules above the soil")
             .metres(0, 50)
             .required("4"),
         Key("width", &rows.width, "of modules, across the row")
             .metres(0.01, 50)
             .required("2"),
         Key("tilt", &rows.tilt, "from level; 90 stands upright")
             .within(0, 90, "deg"),
         Key("azimuth", &rows.azimuth,
             "where the front looks, clockwise from north: parallel to the "
             "rows of plants or at right angles to them")
             .within(0, 360, "deg")
             .required("180"),
         Key("offset", &rows.offset,
             "of the middle of the first row from the edge of the field, which "
             "is halfway between rows of plants")
             .within(0, 100, "m"),
         Key("module_length", &rows.module_length,
             "of a module along the row; 0: one without end")
             .within(0, 100, "m"),
         Key("gap", &rows.gap, "between the modules of a row")
             .within(0, 100, "m"),
         Key("tracks", &rows.tracks,
             "whether modules turn about a level axis after the sun, in the "
             "place of `tilt`"),
         Key("max_angle", &rows.max_angle,
             "largest turn of modules that track, either way from level")
             .within(0, 85, "deg"),
         Key("backtracks", &rows.backtracks,
             "whether modules that track turn back while the sun is low, so "
             "that no row shades another")}};
    add_optics(section, entry.optics, entry.nir_optics);
    return section;
}

Section object_section(ObjectEntry& entry) {
    const auto place = [](const std::string& name, double& value,
                          const std::string& meaning) {
        return Key(name, &value, meaning).within(-1000, 1000, "m");
    };
    const auto numbers = [](const std::string& name,
                            std::vector<double>& values,
                            const std::string& meaning) {
        return Key(name, &values, meaning)
            .set(&Key::count, any_count)
            .set(&Key::type, "list of numbers")
            .set(&Key::initial, "those of the file")
            .set(&Key::is_written, !values.empty())
            .like("[0, 1, 2, 2]");
    };
    Section section{
        "object",
        {Key("name", &entry.name, "of the object, as figures tell it")
             .set(&Key::range, name_range)
             .required("\"post\""),
         Key("obj", &entry.file,
             "Wavefront OBJ file of its surfaces in metres, z up, y along the "
             "rows")
             .set(&Key::is_any_text, true)
             .set(&Key::type, "path")
             .set(&Key::range, "relative to this file")
             .set(&Key::initial, "none")
             .like("\"post.obj\""),
         place("x", entry.x,
               "of its origin from the edge of the field, across "
               "the rows"),
         place("y", entry.y, "the same along the rows"),
         place("z", entry.z, "of its origin above the soil"),
         Key("turn", &entry.turn, "about the vertical, clockwise from above")
             .within(-360, 360, "deg"),
         numbers("vertices", entry.vertices,
                 "coordinates of each vertex, as the program writes them in "
                 "the place of a file")
             .set(&Key::unit, "m"),
         numbers("faces", entry.faces, "four vertices of each face, from 0")}};
    add_optics(section, entry.optics, entry.nir_optics);
    return section;
}

}  // namespace

Table panel_table(Campaign& campaign) {
    Table table =
        list_of_tables<PanelEntry>("panel", panel_section, campaign.panels);
    table.is_optional = true;
    table.most = most_components;
    return table;
}

Table object_table(Campaign& campaign) {
    Table table =
        list_of_tables<ObjectEntry>("object", object_section, campaign.objects);
    table.is_optional = true;
    table.most = most_components;
    return table;
}

}  // namespace ideotype
