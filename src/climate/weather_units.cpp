// SPDX-License-Identifier: Apache-2.0
#include "weather_units.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

enum class Per { itself, second, photon };

struct Unit {
    Kind kind;
    std::string_view name;
    Scale scale;
    Per per = Per::itself;
};

constexpr std::array units{
    Unit{Kind::light, "W/m2", {}},
    Unit{Kind::light, "kW/m2", {1e3}},
    Unit{Kind::light, "Wh/m2", {3600}, Per::second},
    Unit{Kind::light, "kWh/m2", {3.6e6}, Per::second},
    Unit{Kind::light, "kJ/m2", {1e3}, Per::second},
    Unit{Kind::light, "MJ/m2", {1e6}, Per::second},
    Unit{Kind::light, "umol/m2/s", {1}, Per::photon},
    Unit{Kind::fraction, "1", {}},
    Unit{Kind::fraction, "%", {0.01}},
    Unit{Kind::temperature, "C", {}},
    Unit{Kind::temperature, "K", {1, -273.15}},
    Unit{Kind::temperature, "F", {5 / 9.0, -160 / 9.0}},
};

//! One of several ways to write a unit.
std::string plain(std::string_view unit) {
    std::string text(unit);
    const auto replace = [&](std::string_view what, std::string_view by) {
        for (std::size_t at; (at = text.find(what)) != text.npos;)
            text.replace(at, what.size(), by);
    };
    replace("\xC2\xB5", "u");  // micro sign
    replace("\xCE\xBC", "u");  // Greek mu
    replace("\xC2\xB2", "2");  // superscript two
    replace("\xC2\xB0", "");   // degree sign
    replace("^", "");
    replace(" m-2 s-1", "/m2/s");
    replace(" m-2", "/m2");
    replace(" ", "");
    replace("W-hr", "Wh");
    replace("MJ/hr", "MJ/m2");  // NASA POWER for agriculture, per m2
    return text;
}

}  // namespace

std::optional<Scale> scale_of(Kind kind, std::string_view unit, double seconds,
                              double par_fraction) {
    const std::string name = plain(unit);
    const auto* const found =
        std::find_if(units.begin(), units.end(), [&](const Unit& each) {
            return each.kind == kind && each.name == name;
        });
    if (found == units.end()) return std::nullopt;
    Scale scale = found->scale;
    if (found->per == Per::second) scale.factor /= seconds;
    if (found->per == Per::photon)
        scale.factor /= mol_per_mj_par * par_fraction;
    return scale;
}

std::string units_of(Kind kind) {
    std::string names;
    for (const Unit& each : units)
        if (each.kind == kind)
            names += fmt::format("{}{}", names.empty() ? "" : ", ", each.name);
    return names;
}

}  // namespace ideotype
