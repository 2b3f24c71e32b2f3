// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

Section site_section(Site& site) {
    return {"site",
            {{"name", &site.name},
             {"latitude", &site.latitude},
             {"longitude", &site.longitude},
             {"utc_offset", &site.utc_offset},
             {"elevation", &site.elevation},
             {"linke_turbidity", &site.linke_turbidity},
             {"weather", &site.weather}}};
}

Section day_section(Named<DaySpan>& day) {
    DaySpan& span = day.value;
    Section section("day", {{"name", &day.name},
                            {"date", &span.dates},
                            {"start", &span.start},
                            {"end", &span.end},
                            {"step_minutes", &span.step_minutes}});
    section["step_minutes"].trades({120, 60, 30, 15});
    return section;
}

Section climate_section(Named<Climate>& named) {
    Climate& climate = named.value;
    ColumnMap& columns = climate.columns;
    using enum DateOrder;
    Section section(
        "climate",
        {{"name", &named.name},
         {"file", &climate.file},
         {"from", &climate.period.from},
         {"to", &climate.period.to},
         {"emergence", &climate.emergence},
         {"stamp", &climate.stamp},
         {"time", &columns.time},
         {"date_order",
          choice(columns.date_order, {{"year_month_day", year_month_day},
                                      {"month_day_year", month_day_year},
                                      {"day_month_year", day_month_year}})},
         {"utc_offset", &columns.utc_offset},
         {"missing", &columns.missing},
         {"global", &columns.global},
         {"beam_normal", &columns.beam_normal},
         {"diffuse", &columns.diffuse},
         {"diffuse_fraction", &columns.diffuse_fraction},
         {"ppfd", &columns.ppfd},
         {"temperature", &columns.temperature},
         {"humidity", &columns.humidity},
         {"wind", &columns.wind},
         {"wind_height", &climate.wind_height},
         {"pressure", &columns.pressure},
         {"longwave", &columns.longwave},
         {"co2", &climate.co2}});
    section["emergence"].written_if(climate.grows());
    return section;
}

Section weather_section(SiteWeather& weather) {
    Section section("weather", {{"site", &weather.site},
                                {"climate", &weather.climate},
                                {"sha256", &weather.sha256},
                                {"utc_offset", &weather.utc_offset},
                                {"dates", &weather.dates},
                                {"hours", &weather.hours},
                                {"beam", &weather.beam[0]},
                                {"diffuse", &weather.diffuse[0]},
                                {"temperature", &weather.temperature},
                                {"humidity", &weather.humidity}});
    for (std::size_t b = 1; b < wavebands.size(); ++b) {
        section.add(wavebands[b].prefix + "beam", &weather.beam[b]);
        section.add(wavebands[b].prefix + "diffuse", &weather.diffuse[b]);
    }
    section.add("wind", &weather.wind);
    section.add("pressure", &weather.pressure);
    section.add("longwave", &weather.longwave);
    return section;
}

std::vector<Table> climate_file_tables(Campaign& campaign) {
    std::vector<Table> tables;
    for (Section section : {site_section(campaign.sites.front()),
                            climate_section(campaign.climates.front())}) {
        section["name"].is_required = false;
        tables.push_back(one_table(section));
        tables.back().is_first_of_list = true;
    }
    return tables;
}

namespace {

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
    return {list_of_tables("panel", panel_section, campaign.panels)
                .optional()
                .at_most(most_components),
            list_of_tables("object", object_section, campaign.objects)
                .optional()
                .at_most(most_components)};
}

}  // namespace ideotype
