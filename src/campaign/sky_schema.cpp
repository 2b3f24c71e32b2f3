// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "schema.hpp"

namespace ideotype {

namespace {

constexpr auto of_cases = "part of the names of cases";

}  // namespace

Section site_section(Site& site) {
    Section keys{"site"};
    keys.add_name("name", site.name, of_cases).required("\"ames\"");
    keys.add("latitude", site.latitude, {-90, 90, "deg"}, "north is positive")
        .required("42.0");
    keys.add("longitude", site.longitude, {-180, 180, "deg"},
             "east is positive")
        .required("-93.6");
    keys.add("utc_offset", site.utc_offset, {-12, 14, "h"},
             "local clock minus UTC, with summer time")
        .required("-5");
    keys.add("elevation", site.elevation, {-500, 9000, "m"}, "above sea level");
    keys.add("linke_turbidity", site.linke_turbidity, {1, 10},
             "haze of the clear sky: 2 very clear, 7 hazy");
    keys.add_path("weather", site.weather, "\"weather/mine.csv\"",
                  "weather file of the site, if a climate has none");
    return keys;
}

Section day_section(Named<DaySpan>& day) {
    Section keys{"day"};
    DaySpan& span = day.value;
    const auto add_instant =
        [&](const std::string& name, double& value, const std::string& range,
            const std::string& example, const std::string& meaning) {
            keys.add(name, value, meaning).allows(range).required(example);
            keys.keys.back().notation = Notation::clock;
        };
    keys.add_name("name", day.name, of_cases)
        .defaults("month and day, \"0807\"")
        .like("\"0807\"");
    keys.add("date", span.dates,
             "fixes the sun's path; of several dates the mean day counts")
        .allows(date_range)
        .required("2025-08-07");
    add_instant("start", span.start, "00:00:00 .. 23:59:59", "07:00:00",
                "first instant, on the local clock");
    add_instant("end", span.end, "after start, to \"24:00\"", "20:00:00",
                "last instant");
    keys.add("step_minutes", span.step_minutes, {1, 720, "min"},
             "between instants; divides the time from start to end")
        .trades({120, 60, 30, 15});
    return keys;
}

Section climate_section(Named<Climate>& named) {
    Section keys{"climate"};
    Climate& climate = named.value;
    ColumnMap& columns = climate.columns;
    const auto add_column =
        [&](const std::string& name, std::optional<Column>& value,
            const std::string& unit, const std::string& meaning) {
            keys.add(name, value, "column and unit: " + meaning)
                .like(fmt::format("[\"{}\", \"{}\"]", name, unit))
                .defaults("none");
        };
    keys.add_name("name", named.name, of_cases)
        .defaults("months and days, \"0721-0920\"")
        .like("\"season\"");
    keys.add_path("file", climate.file, "\"weather/mine.csv\"",
                  "weather file: what `ideotype weather` writes, or any CSV "
                  "with the columns below");
    keys.add("from", climate.period.from, "first day")
        .allows(date_range)
        .required("2011-07-21");
    keys.add("to", climate.period.to, "last day")
        .allows(date_range)
        .required("2011-09-20");
    keys.add("emergence", climate.emergence,
             "day on which the plants of the crop emerge, which then grow and "
             "age by [growth] of its crop file until they are mature or the "
             "period ends; left out, they stand as they are")
        .allows(date_range)
        .defaults("none")
        .like("2011-05-15")
        .written_if(climate.grows());
    keys.add("stamp", climate.stamp,
             "which part of its time step the time of a row is")
        .one_of({"beginning", "middle", "end"})
        .defaults("\"end\"; \"middle\" without time");
    keys.add("time", columns.time,
             "columns of date and time, or of date, and time, or of year, "
             "month, day, hour and, if there is one, minute")
        .allows("columns of the file")
        .defaults("what `ideotype weather` writes");
    keys.add("date_order", columns.date_order,
             {{"year_month_day", DateOrder::year_month_day},
              {"month_day_year", DateOrder::month_day_year},
              {"day_month_year", DateOrder::day_month_year}},
             "of dates in one text");
    keys.add("utc_offset", columns.utc_offset, {-12, 14, "h"},
             "of the file's clock, if its times have none")
        .defaults("that of the site");
    keys.add("missing", columns.missing,
             "number that stands for what is not known, beside -99, -999, "
             "9999, NaN and the like")
        .defaults("none");
    add_column("global", columns.global, "W/m2", "light on a horizontal plane");
    add_column("beam_normal", columns.beam_normal, "W/m2",
               "light of the sun on a plane that faces it");
    add_column("diffuse", columns.diffuse, "W/m2",
               "light of the sky on a horizontal plane");
    add_column("diffuse_fraction", columns.diffuse_fraction, "1",
               "diffuse over global light");
    add_column("ppfd", columns.ppfd, "umol/m2/s",
               "photons from 400 to 700 nm, which are only compared with the "
               "global light");
    add_column("temperature", columns.temperature, "C", "of the air");
    add_column("humidity", columns.humidity, "%",
               "relative humidity of the air");
    add_column("wind", columns.wind, "m/s", "wind speed");
    keys.add("wind_height", climate.wind_height, {0.5, 200, "m"},
             "of the wind, above the ground")
        .defaults("10");
    add_column("pressure", columns.pressure, "kPa", "of the air");
    add_column("longwave", columns.longwave, "W/m2",
               "longwave radiation of the sky on a horizontal plane");
    keys.add("co2", climate.co2, {50, 5000, "umol mol-1"}, "of the air")
        .defaults("400");
    return keys;
}

Section weather_section(SiteWeather& weather) {
    Section keys{"weather"};
    const auto add_numbers =
        [&](const std::string& name, std::vector<double>& values,
            const std::string& unit, const std::string& meaning) {
            keys.add(name, values, {0, 0, unit}, meaning)
                .defaults("none")
                .like("[0, 0]");
        };
    keys.add_name("site", weather.site, "name of the site")
        .required("\"ames\"");
    keys.add_name("climate", weather.climate, "name of the climate")
        .required("\"ames\"");
    keys.add_name("sha256", weather.sha256, "of the file that was read")
        .required("\"ames\"");
    keys.add("utc_offset", weather.utc_offset, {-12, 14, "h"},
             "of dates and hours")
        .required("-6");
    keys.add("dates", weather.dates,
             "of the period, but for those that the file leaves out")
        .allows(date_range)
        .required("[2011-07-21]");
    add_numbers("hours", weather.hours, "h",
                "middles of the time steps of a day");
    add_numbers("beam", weather.beam, "W m-2",
                "PAR of the sun on a horizontal plane, date by date and hour "
                "by hour");
    add_numbers("diffuse", weather.diffuse, "W m-2", "PAR of the sky");
    add_numbers("temperature", weather.temperature, "deg C", "of the air");
    add_numbers("humidity", weather.humidity, "1",
                "relative humidity of the air");
    add_numbers("nir_beam", weather.nir_beam, "W m-2",
                "near infrared of the sun on a horizontal plane, if it is "
                "followed");
    add_numbers("nir_diffuse", weather.nir_diffuse, "W m-2",
                "near infrared of the sky, if it is followed");
    add_numbers("wind", weather.wind, "m s-1", "speed, if it is known");
    add_numbers("pressure", weather.pressure, "kPa",
                "of the air, if it is known");
    add_numbers("longwave", weather.longwave, "W m-2",
                "longwave radiation of the sky, if it is known");
    return keys;
}

std::vector<Table> climate_file_tables(Campaign& campaign) {
    std::vector<Table> tables;
    for (Section section : {site_section(campaign.sites.front()),
                            climate_section(campaign.climates.front())}) {
        section.keys.front().is_required = false;
        tables.push_back(one_table(section));
        tables.back().is_first_of_list = true;
    }
    return tables;
}

}  // namespace ideotype
