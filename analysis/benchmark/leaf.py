# SPDX-License-Identifier: Apache-2.0
"""Leaf models of the benchmark in plain Python, from the published equations.

This module shares no code with the program. It is the second method for cases
of photosynthesis and of leaf energy, and specifies these cases exactly for
other programs."""

from __future__ import annotations

from collections.abc import Mapping
from math import exp, sqrt
from typing import Any

from scipy.optimize import brentq

R = 8.314462618e-3  # kJ mol-1 K-1


def smaller_root(curvature: float, a: float, b: float) -> float:
    """Returns the smaller root x of q x^2 - (a + b) x + a b = 0."""
    if curvature == 0:
        return a * b / (a + b)
    return (a + b - sqrt((a + b) ** 2 - 4 * curvature * a * b)) / (
        2 * curvature
    )


def hyperbola(light: float, leaf: Mapping[str, float]) -> float:
    """Returns gross assimilation [umol m-2 s-1] at the given absorbed light
    (Thornley 1976)."""
    return smaller_root(leaf["theta"], leaf["phi"] * light, leaf["amax"])


def collatz(
    light: float, t: float, ci: float, leaf: Mapping[str, float]
) -> float:
    """Returns gross assimilation of a C4 leaf (Collatz et al. 1992)."""
    q10 = 2 ** ((t - 25) / 10)
    capacity = (
        leaf["vmax"]
        * q10
        / ((1 + exp(0.3 * (3 - t))) * (1 + exp(0.3 * (t - 37.5))))
    )
    inner = smaller_root(leaf["theta"], leaf["alpha"] * light, capacity)
    return smaller_root(leaf["beta"], inner, leaf["k"] * q10 * ci)


def collatz_respiration(t: float, leaf: Mapping[str, float]) -> float:
    return leaf["rd"] * 2 ** ((t - 25) / 10) / (1 + exp(1.3 * (t - 55)))


def farquhar(
    light: float, t: float, ci: float, leaf: Mapping[str, float]
) -> float:
    """Returns gross assimilation of a C3 leaf (Farquhar et al. 1980), with the
    constants of Bernacchi et al. 2001 and 2003 and 210 mmol mol-1 of
    oxygen."""
    k = t + 273.15

    def arrhenius(c: float, energy: float) -> float:
        return exp(c - energy / (R * k))

    def rise(energy: float) -> float:
        return exp(energy / R * (1 / 298.15 - 1 / k))

    def falls(kelvin: float) -> float:
        return 1 + exp((0.65 - 201.8 / kelvin) / R)

    star = arrhenius(19.02, 37.83)
    km = arrhenius(38.05, 79.43) * (1 + 210 / arrhenius(20.30, 36.38))
    above = ci - star
    rubisco = leaf["vcmax"] * rise(65.33) * above / (ci + km)
    triose = 3 * leaf["tpu"] * rise(53.1) * falls(298.15) / falls(k)
    theta = leaf["theta"] + 0.018 * (t - 25) - 0.00037 * (t * t - 625)
    electrons = smaller_root(
        theta,
        0.5 * (0.352 + 0.022 * t - 0.00034 * t * t) * light,
        leaf["jmax"] * rise(43.5),
    )
    transport = electrons * above / (4.5 * ci + 10.5 * star)
    return smaller_root(
        leaf["beta"], smaller_root(leaf["beta"], rubisco, triose), transport
    )


def gross(light: float, leaf: Mapping[str, Any]) -> float:
    """Returns gross assimilation by the table `photosynthesis` of a case."""
    if leaf["model"] == "hyperbola":
        return hyperbola(light, leaf)
    model = {"collatz": collatz, "farquhar": farquhar}[leaf["model"]]
    return model(light, leaf["temperature"], leaf["ci"], leaf)


def saturated(t: float) -> float:
    """Returns the saturation vapour pressure over water [kPa] (Tetens
    1930)."""
    return 0.61078 * exp(17.27 * t / (t + 237.3))


def energy_balance(case: Mapping[str, Any]) -> dict[str, float]:
    """Returns temperature [deg C] and fluxes of a C4 leaf with stomata after
    Medlyn, by nested bisection: the inner one finds the assimilation that
    agrees with the stomata at a leaf temperature, the outer one the
    temperature at which the energy is balanced.

    The case states the radiation absorbed by both faces together and the air,
    as in README.md. It must have a single solution, without dew."""
    ta, pressure, width = case["air"], case["pressure"], case["width"]
    vapour = case["rh"] * saturated(ta)
    absorbed = case["ppfd"] / 4.57 + case["nir"] + case["longwave"]
    latent_heat = 0.0180153 * (2.501e6 - 2361 * ta)
    d = 0.72 * width
    molar = pressure / (R * (ta + 273.15))

    def heat(t: float) -> float:
        """Returns the conductance of one face for heat [mol m-2 s-1]."""
        forced = 1.4 * 0.135 * sqrt(case["wind"] / d)
        free = 0.05 * (abs(t - ta) / d) ** 0.25
        still = 2.15e-5 * molar / d
        return (forced**3 + free**3 + still**3) ** (1 / 3)

    def stomata(t: float) -> tuple[float, float, float]:
        """Returns net assimilation, stomatal conductance and ci at a leaf
        temperature."""
        gb = 2 * 1.09 * heat(t)
        loss = collatz_respiration(t, case)

        def of(gs: float) -> tuple[float, float]:
            resistance = 1.37 / gb + 1.6 / gs

            def excess(ci: float) -> float:
                a = collatz(case["ppfd"], t, ci, case) - loss
                return ci - (case["co2"] - a * resistance)

            most = case["co2"] + loss * resistance + 1
            ci = brentq(excess, 0, most, xtol=1e-12)
            return (case["co2"] - ci) / resistance, ci

        def opening(gs: float) -> float:
            a, _ = of(gs)
            surface = (gs * saturated(t) + gb * vapour) / (gs + gb)
            deficit = max(saturated(t) - surface, 0.05)
            cs = case["co2"] - 1.37 * a / gb
            wanted = case["g0"]
            if a > 0:
                wanted += 1.6 * (1 + case["g1"] / sqrt(deficit)) * a / cs
            return wanted - gs

        gs = brentq(opening, case["g0"] / 2, 20, xtol=1e-13)
        a, ci = of(gs)
        return a, gs, ci

    def fluxes(t: float) -> tuple[float, float, float]:
        _, gs, _ = stomata(t)
        gb = 2 * 1.09 * heat(t)
        g = gs * gb / (gs + gb)
        latent = latent_heat * g * (saturated(t) - vapour) / pressure
        sensible = 2 * 29.3 * heat(t) * (t - ta)
        radiation = (
            absorbed
            - 2 * case["emissivity"] * 5.670374419e-8 * (t + 273.15) ** 4
        )
        return radiation, sensible, latent

    def left(t: float) -> float:
        radiation, sensible, latent = fluxes(t)
        return radiation - sensible - latent

    t = brentq(left, ta - 8, ta + 25, xtol=1e-11)
    net, gs, ci = stomata(t)
    _, sensible, latent = fluxes(t)
    return {
        "leaf": t,
        "net": net,
        "gs": gs,
        "ci": ci,
        "transpiration": 1e3 * latent / latent_heat,
        "latent": latent,
        "sensible": sensible,
    }
