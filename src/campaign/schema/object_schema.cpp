// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

namespace {

//! Adds the optics of a surface in each waveband.
void add_optics(Section& section, ByBand<Lambertian>& optics) {
    for (std::size_t b = 0; b < wavebands.size(); ++b) {
        const std::string& prefix = wavebands[b].prefix;
        section.add(prefix + "reflectance", &optics[b].reflectance);
        section.add(prefix + "transmittance", &optics[b].transmittance);
    }
}

Section panel_section(PanelEntry& entry) {
    PanelRows& rows = entry.rows;
    Section section("panel", {{"name", &rows.name},
                              {"pitch", &rows.pitch},
                              {"height", &rows.height},
                              {"width", &rows.width},
                              {"tilt", &rows.tilt},
                              {"azimuth", &rows.azimuth},
                              {"offset", &rows.offset},
                              {"module_length", &rows.module_length},
                              {"gap", &rows.gap},
                              {"tracks", &rows.tracks},
                              {"max_angle", &rows.max_angle},
                              {"backtracks", &rows.backtracks}});
    for (const char* key : {"pitch", "height", "width"})
        section[key].in_metres();
    add_optics(section, entry.optics);
    return section;
}

Section object_section(ObjectEntry& entry) {
    Section section("object", {{"name", &entry.name},
                               {"obj", &entry.file},
                               {"x", &entry.x},
                               {"y", &entry.y},
                               {"z", &entry.z},
                               {"turn", &entry.turn},
                               {"vertices", &entry.vertices},
                               {"faces", &entry.faces}});
    for (const char* key : {"vertices", "faces"}) section[key].optional_list();
    add_optics(section, entry.optics);
    return section;
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
