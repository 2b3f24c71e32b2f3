// SPDX-License-Identifier: Apache-2.0
#include "spec/tables.hpp"

namespace ideotype {

template <>
inline constexpr std::array enum_names<DateOrder>{
    EnumName{"year_month_day", DateOrder::year_month_day},
    EnumName{"month_day_year", DateOrder::month_day_year},
    EnumName{"day_month_year", DateOrder::day_month_year}};

namespace {

constexpr Values local_time(const char* range) {
    return {.type = "local time", .range = range, .form = Form::clock};
}

bool grows(const NamedClimate& climate) {
    return climate.value.grows();
}

// Each line declares one key.
// clang-format off
constexpr Key site_keys[] = {
    key<&Site::name>("name", name_text, required("\"ames\""), "name of the site, a part of the names of cases"),
    key<&Site::latitude>("latitude", within(-90, 90, "deg"), required("42.0"), "latitude; north is positive"),
    key<&Site::longitude>("longitude", within(-180, 180, "deg"), required("-93.6"), "longitude; east is positive"),
    key<&Site::utc_offset>("utc_offset", within(-12, 14, "h"), required("-5"), "offset of the local clock from UTC, including summer time"),
    key<&Site::elevation>("elevation", within(-500, 9000, "m"), usual(), "height above sea level"),
    key<&Site::linke_turbidity>("linke_turbidity", within(1, 10), usual(), "Linke turbidity of the clear sky: 2 very clear, 7 hazy"),
    key<&Site::weather>("weather", file_path, none("\"weather/mine.csv\""), "weather file of the site, if a climate has none; \"{year}\" in it is replaced by the year"),
    key<&Site::weight>("weight", within(0, 1e6), usual(), "weight of the site where sites are scenarios").quiet(),
};

constexpr Key day_keys[] = {
    key<&NamedDay::name>("name", name_text, by("month and day", "\"0807\""), "name of the day, a part of the names of cases"),
    key<&NamedDay::value, &DaySpan::dates>("date", words("1950-01-01 .. 2100-12-31"), required("2025-08-07"), "date, or several dates of which the mean day is evaluated").variable(),
    key<&NamedDay::value, &DaySpan::start>("start", local_time("00:00:00 .. 23:59:59"), required("07:00:00"), "first instant, on the local clock"),
    key<&NamedDay::value, &DaySpan::end>("end", local_time("after start, to \"24:00\""), required("20:00:00"), "last instant"),
    key<&NamedDay::value, &DaySpan::step_minutes>("step_minutes", within(1, 720, "min"), usual(), "time between instants; it divides the time from start to end").trades({120, 60, 30, 15}),
};

constexpr Key climate_keys[] = {
    key<&NamedClimate::name>("name", name_text, by("months and days", "\"season\""), "name of the climate, a part of the names of cases"),
    key<&NamedClimate::value, &Climate::file>("file", file_path, none("\"weather/mine.csv\""), "weather file of `ideotype weather`, or any CSV with the columns below; \"{year}\" in it is replaced by the year"),
    key<&NamedClimate::value, &Climate::period, &Period::from>("from", words("1950-01-01 .. 2100-12-31"), required("2011-07-21"), "first day of the period"),
    key<&NamedClimate::value, &Climate::period, &Period::to>("to", words("1950-01-01 .. 2100-12-31"), required("2011-09-20"), "last day of the period"),
    key<&NamedClimate::value, &Climate::emergence>("emergence", words("1950-01-01 .. 2100-12-31"), none("2011-05-15"), "date of emergence; plants then grow and age by [growth] of the crop file until maturity or the end of the period; without it they do not grow").written_if<NamedClimate, grows>().variable(),
    key<&NamedClimate::value, &Climate::years>("years", numbers(1950, 2100, "", "list of integers"), none("[1998, 2005, 2012]"), "years in which the period is repeated, each a climate with the dates of that year; its name ends in the year, or is the year if the table has no name"),
    key<&NamedClimate::value, &Climate::weights>("weights", number_or_list(0, 1e6), by("1", "[0.4, 0.35, 0.25]"), "weight where climates are scenarios: of each year, or one for all").quiet(),
    key<&NamedClimate::value, &Climate::stamp>("stamp", texts("beginning", "middle", "end"), by("\"end\"; \"middle\" without time"), "part of the time step that the time of a row marks"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::time>("time", words("columns of the file"), by("those of `ideotype weather`"), "columns of date and time: one for both, two, or year, month, day, hour and, if there is one, minute"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::date_order>("date_order", any_value, usual(), "order of year, month and day in dates of one column"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::utc_offset>("utc_offset", within(-12, 14, "h"), by("that of the site"), "offset of the file's clock from UTC, if its times have none"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::missing>("missing", any_value, none(), "number that marks missing values, in addition to -99, -999, 9999, NaN and the like"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::global>("global", any_value, none("[\"global\", \"W/m2\"]"), "column and unit: global light on a horizontal plane"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::beam_normal>("beam_normal", any_value, none("[\"beam_normal\", \"W/m2\"]"), "column and unit: direct light on a plane that faces the sun"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::diffuse>("diffuse", any_value, none("[\"diffuse\", \"W/m2\"]"), "column and unit: diffuse light on a horizontal plane"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::diffuse_fraction>("diffuse_fraction", any_value, none("[\"diffuse_fraction\", \"1\"]"), "column and unit: fraction of diffuse in global light"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::ppfd>("ppfd", any_value, none("[\"ppfd\", \"umol/m2/s\"]"), "column and unit: photons from 400 to 700 nm, only compared with the global light"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::temperature>("temperature", any_value, none("[\"temperature\", \"C\"]"), "column and unit: temperature of the air"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::humidity>("humidity", any_value, none("[\"humidity\", \"%\"]"), "column and unit: relative humidity of the air"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::wind>("wind", any_value, none("[\"wind\", \"m/s\"]"), "column and unit: wind speed"),
    key<&NamedClimate::value, &Climate::wind_height>("wind_height", within(0.5, 200, "m"), by("10"), "height of the wind measurement above the ground"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::pressure>("pressure", any_value, none("[\"pressure\", \"kPa\"]"), "column and unit: pressure of the air"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::longwave>("longwave", any_value, none("[\"longwave\", \"W/m2\"]"), "column and unit: longwave radiation of the sky on a horizontal plane"),
    key<&NamedClimate::value, &Climate::columns, &ColumnMap::rain>("rain", any_value, none("[\"rain\", \"mm\"]"), "column and unit: rain of each step, or of each day in one of its rows; empty entries are none"),
    key<&NamedClimate::value, &Climate::co2>("co2", within(50, 5000, "umol mol-1"), by("400"), "mole fraction of CO2 in the air"),
};

constexpr Key weather_keys[] = {
    key<&SiteWeather::site>("site", name_text, required("\"ames\""), "name of the site"),
    key<&SiteWeather::climate>("climate", name_text, required("\"ames\""), "name of the climate"),
    key<&SiteWeather::sha256>("sha256", name_text, required("\"ames\""), "SHA-256 of the file that was read"),
    key<&SiteWeather::utc_offset>("utc_offset", within(-12, 14, "h"), required("-6"), "offset of dates and hours from UTC"),
    key<&SiteWeather::dates>("dates", words("1950-01-01 .. 2100-12-31"), required("[2011-07-21]"), "dates of the period, but for those that the file leaves out"),
    key<&SiteWeather::hours>("hours", unlimited("h"), none("[0, 0]"), "middles of the time steps of a day"),
    key<&SiteWeather::beam, par_band>("beam", unlimited("W m-2"), none("[0, 0]"), "PAR of the sun on a horizontal plane, date by date and hour by hour"),
    key<&SiteWeather::diffuse, par_band>("diffuse", unlimited("W m-2"), none("[0, 0]"), "PAR of the sky"),
    key<&SiteWeather::temperature>("temperature", unlimited("deg C"), none("[0, 0]"), "temperature of the air"),
    key<&SiteWeather::humidity>("humidity", unlimited("1"), none("[0, 0]"), "relative humidity of the air"),
    key<&SiteWeather::beam, nir_band>("nir_beam", unlimited("W m-2"), none("[0, 0]"), "near infrared of the sun on a horizontal plane, if it is followed"),
    key<&SiteWeather::diffuse, nir_band>("nir_diffuse", unlimited("W m-2"), none("[0, 0]"), "near infrared of the sky, if it is followed"),
    key<&SiteWeather::wind>("wind", unlimited("m s-1"), none("[0, 0]"), "speed of the wind, if it is known"),
    key<&SiteWeather::pressure>("pressure", unlimited("kPa"), none("[0, 0]"), "pressure of the air, if it is known"),
    key<&SiteWeather::longwave>("longwave", unlimited("W m-2"), none("[0, 0]"), "longwave radiation of the sky, if it is known"),
    key<&SiteWeather::rain>("rain", unlimited("mm"), none("[0, 0]"), "rain, if it is known"),
};
// clang-format on

}  // namespace

constinit const Description site_table = describe<Site>("site", site_keys);
constinit const Description place_table =
    describe<Site>("site", std::span(site_keys).subspan<1, 3>());
constinit const Description day_table = describe<NamedDay>("day", day_keys);
constinit const Description climate_table =
    describe<NamedClimate>("climate", climate_keys);
constinit const Description weather_table =
    describe<SiteWeather>("weather", weather_keys);

}  // namespace ideotype
