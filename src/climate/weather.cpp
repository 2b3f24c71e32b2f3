#include "ideotype/climate/weather.hpp"

namespace ideotype {

namespace {

double sum_over(const Weather& weather, double Irradiance::*component) {
    double sum = 0;
    for (const WeatherStep& step : weather.steps)
        sum += step.light.par.*component * step.light.seconds;
    return sum;
}

}  // namespace

int Weather::days() const {
    int count = 0;
    const Date* last = nullptr;
    for (const WeatherStep& step : steps) {
        if (!last || step.date.day != last->day ||
            step.date.month != last->month || step.date.year != last->year)
            ++count;
        last = &step.date;
    }
    return count;
}

double Weather::beam() const {
    return sum_over(*this, &Irradiance::beam);
}

double Weather::diffuse() const {
    return sum_over(*this, &Irradiance::diffuse);
}

}  // namespace ideotype
