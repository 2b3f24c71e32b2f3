// SPDX-License-Identifier: Apache-2.0
#include "weather_reader.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "ideotype/climate/weather.hpp"
#include "ideotype/core/file.hpp"
#include "ideotype/core/hash.hpp"

namespace ideotype {

namespace {

//! Reports what cannot be read by; returns whether there is nothing.
bool check_climate(Climate& climate, Problems& problems) {
    const Period& period = climate.period;
    ColumnMap& columns = climate.columns;
    if (!problems.usable({&climate.file, &climate.stamp, &period.from,
                          &period.to, &columns.missing, &columns.utc_offset,
                          &columns.time, &columns.date_order}))
        return false;
    if (period.to < period.from) {
        problems.add(
            &period.to,
            fmt::format(
                "climate.to is {} (before the first day, {}); give a later one",
                to_string(period.to), to_string(period.from)));
        return false;
    }
    for (std::optional<Column>* column :
         {&columns.global, &columns.beam_normal, &columns.diffuse,
          &columns.diffuse_fraction, &columns.ppfd, &columns.temperature,
          &columns.humidity, &columns.wind, &columns.pressure,
          &columns.longwave}) {
        if (!problems.usable({column})) return false;
        if (!*column || !columns.time.empty()) continue;
        problems.add(
            column,
            fmt::format("climate has the column \"{}\" but no 'time' (a "
                        "file that `ideotype weather` wrote needs "
                        "neither); name the columns of the time too",
                        (*column)->name));
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

SiteWeather to_site_weather(const LightSeries& series, bool has_nir) {
    SiteWeather result;
    result.utc_offset = series.utc_offset;
    result.dates = series.dates();
    for (const TimeStep& step : series.steps) {
        if (step.date == result.dates[0]) result.hours.push_back(step.hour);
        result.beam.push_back(step.par.beam);
        result.diffuse.push_back(step.par.diffuse);
        if (step.temperature) result.temperature.push_back(*step.temperature);
        if (step.humidity) result.humidity.push_back(*step.humidity);
        if (step.wind) result.wind.push_back(*step.wind);
        if (step.pressure) result.pressure.push_back(*step.pressure);
        if (step.longwave) result.longwave.push_back(*step.longwave);
        if (!has_nir) continue;
        result.nir_beam.push_back(step.nir.beam);
        result.nir_diffuse.push_back(step.nir.diffuse);
    }
    return result;
}

//! Reports what a campaign has of its weather and cannot be.
void check_weather(const SiteWeather& weather, Problems& problems) {
    const auto& hours = weather.hours;
    const auto check = [&](const std::string& name,
                           const std::vector<double>& values, bool is_fine,
                           const std::string& expected) {
        if (problems.usable({&values}) && !is_fine)
            problems.add(&values,
                         fmt::format("weather.{} has {} values (expected: {}); "
                                     "take what the program has written",
                                     name, values.size(), expected));
    };
    check("hours", hours,
          !hours.empty() && std::is_sorted(hours.begin(), hours.end()) &&
              hours.front() >= 0 && hours.back() < 24,
          "from 0 to 24, in order");
    const std::size_t steps = weather.dates.size() * hours.size();
    const auto of_steps = [&](const std::string& name,
                              const std::vector<double>& values,
                              std::size_t fewest, double least) {
        check(name, values,
              (values.size() == steps || values.size() == fewest) &&
                  std::all_of(values.begin(), values.end(),
                              [&](double x) { return x >= least; }),
              fmt::format("one of each hour of each date, {} or more", least));
    };
    of_steps("beam", weather.beam, steps, 0);
    of_steps("diffuse", weather.diffuse, steps, 0);
    of_steps("temperature", weather.temperature, 0, -273);
    of_steps("humidity", weather.humidity, 0, 0);
    of_steps("wind", weather.wind, 0, 0);
    of_steps("pressure", weather.pressure, 0, 1);
    of_steps("longwave", weather.longwave, 0, 0);
    // There are both or neither.
    of_steps("nir_beam", weather.nir_beam,
             weather.nir_diffuse.empty() ? 0 : steps, 0);
    of_steps("nir_diffuse", weather.nir_diffuse,
             weather.nir_beam.empty() ? 0 : steps, 0);
}

class WeathersReader {
  public:
    WeathersReader(const std::string& campaign_file, PlantSource source,
                   Draft& draft, Problems& problems)
        : campaign_file_(campaign_file),
          source_(source),
          campaign_(draft.campaign),
          problems_(problems) {}

    void read() {
        for (const SiteWeather& weather : campaign_.weathers)
            check_weather(weather, problems_);
        std::vector<SiteWeather> found;
        for (auto& [name, climate] : campaign_.climates) {
            if (!check_climate(climate, problems_)) continue;
            for (const Site& site : campaign_.sites)
                if (!has(site.name, name)) read(site, name, climate, found);
        }
        for (SiteWeather& each : found)
            campaign_.weathers.push_back(std::move(each));
    }

  private:
    bool has(const std::string& site, const std::string& climate) const {
        return std::any_of(campaign_.weathers.begin(), campaign_.weathers.end(),
                           [&](const SiteWeather& weather) {
                               return weather.site == site &&
                                      weather.climate == climate;
                           });
    }

    void read(const Site& site, const std::string& name, Climate& climate,
              std::vector<SiteWeather>& found) {
        if (source_ == PlantSource::table)
            return problems_.add(
                &climate.file,
                fmt::format("climate \"{}\" has no [[weather]] of site \"{}\" "
                            "(resolved campaigns have it in them); use the "
                            "campaign file",
                            name, site.name));
        if (!problems_.usable({&site.name, &site.weather, &site.latitude,
                               &site.longitude, &site.utc_offset,
                               &site.elevation, &campaign_.par_fraction}))
            return;
        if (climate.file.empty() && site.weather.empty())
            return problems_.add(
                &climate.file,
                fmt::format("climate \"{}\" has no file (and site \"{}\" no "
                            "weather); add file = \"weather/mine.csv\" here, "
                            "or weather = ... there",
                            name, site.name));
        if (!climate.file.empty() && !site.weather.empty())
            return problems_.add(
                &site.weather,
                fmt::format("site \"{}\" has weather of its own (climate "
                            "\"{}\" has a file for all sites); remove one",
                            site.name, name));
        const std::string& own =
            climate.file.empty() ? site.weather : climate.file;
        const std::string path = path_from(campaign_file_, own);
        const FileText file = read_file(path, most_data_bytes);
        if (!file.is_there)
            return problems_.add(
                climate.file.empty() ? &site.weather : &climate.file,
                file.refusal(path) + "; give a path relative to this file");
        problems_.open(path);
        try {
            const Weather weather = parse_weather(
                file.text,
                request_of(path, site, climate, campaign_.par_fraction));
            for (const Problem& warning : weather.warnings)
                if (is_new(warning)) problems_.warn(warning);
            found.push_back(to_site_weather(weather.series, campaign_.has_nir));
            found.back().site = site.name;
            found.back().climate = name;
            found.back().sha256 = sha256(file.text);
        } catch (const InputError& error) {
            // Sites may share a file.
            for (const Problem& problem : error.problems())
                if (is_new(problem)) problems_.add(problem.where, problem.what);
        }
    }

    bool is_new(const Problem& problem) {
        return told_.insert(to_string(problem)).second;
    }

    const std::string& campaign_file_;
    PlantSource source_;
    Campaign& campaign_;
    Problems& problems_;
    std::set<std::string> told_;
};

}  // namespace

void read_weathers(const std::string& file, PlantSource source, Draft& draft,
                   Problems& problems) {
    WeathersReader(file, source, draft, problems).read();
}

}  // namespace ideotype
