// SPDX-License-Identifier: Apache-2.0
#include "campaign/weather_reader.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "ideotype/climate/weather.hpp"
#include "ideotype/core/file.hpp"
#include "ideotype/core/hash.hpp"
#include "spec/files.hpp"

namespace ideotype {

namespace {

//! Reports problems of a climate that prevent its weather from being read;
//! returns whether there are none.
bool check_climate(const Climate& climate, const Problems& problems) {
    const auto& [from, to] = climate.period;
    const ColumnMap& columns = climate.columns;
    problems.rule({"to", "from"}, to < from,
                  "climate.to is {} (before the first day, {}); give a later "
                  "one",
                  to_string(to), to_string(from));
    if (!problems.usable({"file", "stamp", "from", "to", "missing",
                          "utc_offset", "time", "date_order"}))
        return false;
    for (const auto& [key, column] :
         {std::pair("global", &columns.global),
          std::pair("beam_normal", &columns.beam_normal),
          std::pair("diffuse", &columns.diffuse),
          std::pair("diffuse_fraction", &columns.diffuse_fraction),
          std::pair("ppfd", &columns.ppfd),
          std::pair("temperature", &columns.temperature),
          std::pair("humidity", &columns.humidity),
          std::pair("wind", &columns.wind),
          std::pair("pressure", &columns.pressure),
          std::pair("longwave", &columns.longwave),
          std::pair("rain", &columns.rain)}) {
        if (!problems.usable({key})) return false;
        if (!*column || !columns.time.empty()) continue;
        problems.add(key, ProblemCode::missing,
                     "climate has the column \"{}\" but no 'time' (a file that "
                     "`ideotype weather` wrote needs neither); name the "
                     "columns of the time too",
                     (*column)->name);
        return false;
    }
    return true;
}

WeatherRequest request_of(const std::string& file, const Site& site,
                          const Climate& climate, double par_fraction) {
    WeatherRequest request{file, site, climate.period, climate.columns,
                           par_fraction};
    if (climate.stamp == "beginning") request.columns.stamp = Stamp::beginning;
    if (climate.stamp == "middle") request.columns.stamp = Stamp::middle;
    if (climate.stamp == "end") request.columns.stamp = Stamp::end;
    return request;
}

SiteWeather to_site_weather(const LightSeries& series,
                            const ByBand<bool>& follows) {
    SiteWeather result;
    result.utc_offset = series.utc_offset;
    result.dates = series.dates();
    for (const TimeStep& step : series.steps) {
        if (step.date == result.dates[0]) result.hours.push_back(step.hour);
        if (step.temperature) result.temperature.push_back(*step.temperature);
        if (step.humidity) result.humidity.push_back(*step.humidity);
        if (step.wind) result.wind.push_back(*step.wind);
        if (step.pressure) result.pressure.push_back(*step.pressure);
        if (step.longwave) result.longwave.push_back(*step.longwave);
        if (step.rain) result.rain.push_back(*step.rain);
        for (std::size_t b = 0; b < follows.size(); ++b) {
            if (!follows[b]) continue;
            result.beam[b].push_back((step.*wavebands[b].light).beam);
            result.diffuse[b].push_back((step.*wavebands[b].light).diffuse);
        }
    }
    return result;
}

//! Reports impossible values in the weather included in a campaign.
void check_weather(const SiteWeather& weather, const Problems& problems) {
    const auto& hours = weather.hours;
    const auto check = [&](const std::string& name,
                           const std::vector<double>& values, bool is_fine,
                           const std::string& expected) {
        problems.rule({name}, !is_fine,
                      "weather.{} has {} values (expected: {}); use the text "
                      "that the program has written, unchanged",
                      name, values.size(), expected);
    };
    check("hours", hours,
          !hours.empty() && std::ranges::is_sorted(hours) &&
              hours.front() >= 0 && hours.back() < 24,
          "from 0 to 24, in order");
    const std::size_t steps = weather.dates.size() * hours.size();
    const auto of_steps = [&](const std::string& name,
                              const std::vector<double>& values,
                              std::size_t fewest, double least) {
        check(name, values,
              (values.size() == steps || values.size() == fewest) &&
                  std::ranges::all_of(values,
                                      [&](double x) { return x >= least; }),
              fmt::format("one of each hour of each date, {} or more", least));
    };
    of_steps("temperature", weather.temperature, 0, -273);
    of_steps("humidity", weather.humidity, 0, 0);
    of_steps("wind", weather.wind, 0, 0);
    of_steps("pressure", weather.pressure, 0, 1);
    of_steps("longwave", weather.longwave, 0, 0);
    of_steps("rain", weather.rain, 0, 0);
    for (std::size_t b = 0; b < wavebands.size(); ++b) {
        // PAR is required. In other wavebands, beam and diffuse light must be
        // given together.
        const auto &beam = weather.beam[b], &diffuse = weather.diffuse[b];
        const bool is_none = b > 0 && beam.empty() && diffuse.empty();
        of_steps(wavebands[b].prefix + "beam", beam, is_none ? 0 : steps, 0);
        of_steps(wavebands[b].prefix + "diffuse", diffuse, is_none ? 0 : steps,
                 0);
    }
}

//! Returns the path of the weather file of a year.
std::string in_year(std::string path, int year) {
    constexpr std::string_view mark = "{year}";
    for (auto at = path.find(mark); at != std::string::npos;
         at = path.find(mark))
        path.replace(at, mark.size(), std::to_string(year));
    return path;
}

//! A weather file, with its table as soon as it is parsed.
struct SharedFile {
    FileText text;
    std::string sha256{};
    std::optional<WeatherFile> table{};
};

struct WeathersReader {
    const std::string& campaign_file;
    TextSource source;
    Spec& spec;
    const Problems& problems;
    std::set<std::string> reported{};
    //! Files by path, site and table of the climate: years may share one.
    std::map<std::tuple<std::string, std::string, std::size_t>, SharedFile>
        files{};

    void read() {
        for (std::size_t i = 0; i < spec.weathers.size(); ++i)
            check_weather(spec.weathers[i], problems.in("weather", i));
        std::vector<SiteWeather> weathers;
        for (const NamedClimate& named : spec.climates) {
            const auto& [name, climate] = named;
            const Problems of_climate = problems.in("climate", climate.table);
            if (!check_climate(climate, of_climate)) continue;
            for (std::size_t s = 0; s < spec.sites.size(); ++s)
                if (!has(spec.sites[s].name, name))
                    read(spec.sites[s], named, problems.in("site", s),
                         of_climate, weathers);
        }
        for (SiteWeather& each : weathers)
            spec.weathers.push_back(std::move(each));
    }

    bool has(const std::string& site, const std::string& climate) const {
        return std::ranges::any_of(spec.weathers, [&](const SiteWeather& each) {
            return each.site == site && each.climate == climate;
        });
    }

    void read(const Site& site, const Named<Climate>& named,
              const Problems& of_site, const Problems& of_climate,
              std::vector<SiteWeather>& weathers) {
        const auto& [name, climate] = named;
        if (source != TextSource::file)
            return of_climate.add(
                "file", ProblemCode::missing,
                "climate \"{}\" has no [[weather]] of site \"{}\" (resolved "
                "campaigns include it); use the campaign file",
                name, site.name);
        if (!of_site.usable({"name", "weather", "latitude", "longitude",
                             "utc_offset", "elevation"}) ||
            !problems.usable({"optics.par_fraction"}))
            return;
        if (climate.file.empty() && site.weather.empty())
            return of_climate.add(
                "file", ProblemCode::missing,
                "climate \"{}\" has no file (and site \"{}\" no weather); add "
                "file = \"weather/mine.csv\" here, or weather = ... there",
                name, site.name);
        if (!climate.file.empty() && !site.weather.empty())
            return of_site.add("weather", ProblemCode::contradiction,
                               "site \"{}\" has a weather file (and climate "
                               "\"{}\" has one for all sites); remove one",
                               site.name, name);
        const bool is_of_site = climate.file.empty();
        const Problems& of_file = is_of_site ? of_site : of_climate;
        const std::string key = is_of_site ? "weather" : "file";
        const std::string path = path_from(
            campaign_file, in_year(is_of_site ? site.weather : climate.file,
                                   climate.period.from.year));
        const auto [found, is_first] =
            files.try_emplace({path, site.name, climate.table});
        SharedFile& file = found->second;
        if (is_first) {
            file.text = read_file(path, most_data_bytes);
            file.sha256 = sha256(file.text.text);
        }
        if (!file.text.is_there)
            return of_file.add(key, ProblemCode::file,
                               "{}; give a path relative to this file",
                               file.text.refusal(path));
        problems.open(path);
        try {
            if (!file.table)
                file.table.emplace(
                    file.text.text,
                    request_of(path, site, climate, spec.par_fraction));
            const Weather weather = file.table->parse(climate.period);
            for (const Problem& warning : weather.warnings)
                if (is_new(warning))
                    problems.warn(of_file.named_by(key, warning));
            weathers.push_back(
                to_site_weather(weather.series, spec.plant.crop.follows));
            weathers.back().site = site.name;
            weathers.back().climate = name;
            weathers.back().sha256 = file.sha256;
        } catch (const InputError& error) {
            // If several sites share a file, report its problems only once.
            for (const Problem& problem : error.problems())
                if (is_new(problem))
                    problems.add(of_file.named_by(key, problem));
        }
    }

    bool is_new(const Problem& problem) {
        return reported.insert(to_string(problem)).second;
    }
};

}  // namespace

void read_weathers(const std::string& file, TextSource source, Spec& spec,
                   const Problems& problems) {
    WeathersReader{file, source, spec, problems}.read();
}

}  // namespace ideotype
