# SPDX-License-Identifier: Apache-2.0
"""Published figures of maize canopies that validation.py compares the baseline
with.

Figures that wait until plants grow are left out: means over a season of
growing cover (Kukal and Irmak 2020 have k of .36 for wheat and .48 for sorghum
and soybean), grain yield (Pendleton and others 1968; Winter and Ohlrogge
1973), and dry matter from silking to maturity (Arihara and others 1978). Each
was read in the source that it names. "Abstract" means that no more than the
abstract was read, so that density, rows or hours that it does not tell are
unknown."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Published:
    what: str
    low: float
    high: float
    """The largest value that counts as agreement."""
    told: str
    """The figure as the source gives it."""
    differs: str
    source: str


def near(value: float, share: float = 0.1) -> tuple[float, float]:
    """Returns the range of agreement of a figure without range or error."""
    return (1 - share) * value, (1 + share) * value


def apsim_k(row: float) -> float:
    """Returns the default of APSIM 7.10 by distance of rows [m], linear
    between points."""
    return float(np.interp(row, (0.2, 0.5, 1.0), (0.70, 0.50, 0.40)))


def ceres_k(row: float, density: float) -> float:
    """Returns the value of CERES-Maize by distance of rows [m] and plants per
    area [m-2]."""
    return float(1.5 - 0.768 * (row**2 * density) ** 0.1)


APSIM = "APSIM 7.10, Model/Maize.xml"
CERES = "DSSAT 4.8, MZ_GROSUB.for and MZCER048.ECO"
MADDONNI = "Maddonni and Martínez-Bercovich 2014, doi:10.1155/2014/195012"
KUKAL = (
    "Kukal and Irmak 2020, Agricultural and Forest Meteorology 284, 107887; "
    "abstract"
)
MODEL = (
    "default of a model, fitted to its own fields, means of a growing cover"
)
HYBRID = "leaf area not told, ours 0.63 m2 a plant"
MUCHOW = (
    "Muchow and others 1990, Agronomy Journal 82, 338-343, as documented in the R "
    "package ZeBook"
)
IOWA = (
    "11 plants of fields in Iowa, measured by us in the point clouds of "
    "github.com/baskargroup/ProceduralMaize3D"
)

PUBLISHED = {
    **{
        f"inclination {part}": Published(
            f"inclination of the surface of leaves, {part} [deg]",
            low,
            high,
            f"{mean}, single plants {low} to {high}",
            "theirs are inbred lines and hybrids; roll and twist of ours are "
            "those of these plants",
            IOWA,
        )
        for part, mean, low, high in (
            ("all", 53.6, 45, 62),
            ("lower third", 47.5, 38, 57),
            ("middle third", 53.6, 43, 66),
            ("upper third", 60.7, 51, 73),
        )
    },
    **{
        f"k {row}": Published(
            f"k of all sunlight, rows of {row} m",
            *near(apsim_k(row)),
            f"{apsim_k(row):.2f}",
            MODEL,
            APSIM,
        )
        for row in (0.2, 0.5, 1.0)
    },
    "trend": Published(
        "k of all sunlight in rows of 1.0 m over that of 0.2 m",
        *near(apsim_k(1.0) / apsim_k(0.2)),
        f"{apsim_k(1.0) / apsim_k(0.2):.2f}",
        MODEL,
        APSIM,
    ),
    "k ceres": Published(
        "k of PAR, rows of 0.76 m",
        *near(ceres_k(0.76, 7.5)),
        f"{ceres_k(0.76, 7.5):.2f}",
        MODEL,
        CERES,
    ),
    "k muchow": Published(
        "k of all sunlight, 7 plants m-2, rows of 0.75 m",
        *near(0.4),
        "0.40",
        "a model's, fitted to its own fields; rows not told",
        MUCHOW,
    ),
    "k dense": Published(
        "k, leaf area index 6, noon",
        *near(0.47),
        "0.47",
        "modern hybrids, more erect; leaf area index and hour not told",
        "Ma and others 2014, doi:10.1016/j.eja.2014.04.001; abstract",
    ),
    "transmitted": Published(
        "PAR that reaches the soil, leaf area index 6, noon",
        0.04,
        0.05,
        "0.04 to 0.05",
        "the same",
        "Ma and others 2014; abstract",
    ),
    "wide rows": Published(
        "k in rows of 1.0 m over that of 0.35 m, noon",
        0,
        1,
        "below 1: it falls linearly",
        "density not told",
        "Riahinia and Dehdashti 2008, doi:10.3923/jbs.2008.954.957; abstract",
    ),
    "narrow rows": Published(
        "k in rows of 0.70 m over that of 0.35 m, 8 plants m-2, noon",
        *near(1),
        "1: no effect",
        "6, 8 and 10 plants m-2",
        "Bassu and others 2024, Journal of Agricultural Science; abstract",
    ),
    **{
        f"fipar {density}": Published(
            f"largest fraction intercepted, {density} plants m-2, rows of 0.52 m",
            told - 0.05,
            told + 0.05,
            f"{told:.2f} ± 0.05",
            HYBRID,
            MADDONNI,
        )
        for density, told in ((4.5, 0.80), (6.2, 0.90), (7.3, 0.95))
    },
    "fapar": Published(
        "fAPAR of a closed canopy, leaf area index 5",
        0.88,
        0.96,
        "0.88 to 0.96",
        "theirs are the largest of a season, of maize, soybean, sorghum and wheat",
        KUKAL,
    ),
    "reflected": Published(
        "PAR reflected, noon",
        0.05,
        0.08,
        "0.05 to 0.08",
        "leaves of ours reflect 0.06, those of ADEL 0.09; the abstract calls "
        " it albedo and does not tell the leaf area",
        "thesis, University of Natal 1976, Maize crop growth and development "
        "related to solar radiation; abstract",
    ),
    "tied up": Published(
        "canopy assimilation, leaves tied up, mean of 4.5, 6, 7.5, 9 and 10.5 "
        "plants m-2 [%]",
        *near(17.2),
        "+17.2",
        "theirs is net, a mean of five densities, which are not told; hours "
        "not told",
        "Wang and others 1995, doi:10.1007/BF02913002; abstract",
    ),
    "efficiency": Published(
        "light-use efficiency, clear day [g C MJ-1]",
        1.86,
        2.06,
        "1.96 ± 0.10",
        "abstract does not tell of which PAR; ours is of what leaves absorb, "
        "of incident PAR it is lower still",
        "Suyker and Verma, Gross primary production and ecosystem "
        "respiration of irrigated and rainfed maize-soybean cropping systems "
        "over 8 years; abstract",
    ),
    "clouds": Published(
        "light-use efficiency in the season over that of the clear day",
        1,
        math.inf,
        "above 1: it falls as skies clear",
        "theirs is by hour; the clear day of ours has 30 deg C, the season its "
        "weather",
        "doi:10.2135/cropsci2017.06.0341; abstract",
    ),
    **{
        f"dry matter {name}": Published(
            "dry matter, season, upper limit [g MJ-1 of PAR]",
            *near(value),
            told,
            "in ours roots and growing ears do not respire",
            source,
        )
        for name, source, value, told in (
            ("CERES", CERES, 4.2, "4.2"),
            ("APSIM", APSIM, 1.6 / 0.45, "1.6, if of all sunlight 3.6 of PAR"),
            ("muchow", MUCHOW, 1.6 / 0.45, "1.6, of all sunlight, 3.6 of PAR"),
        )
    },
    "midday": Published(
        "gross assimilation, clear noon in July, leaf area index 6 "
        "[umol m-2 s-1]",
        *near(3.1e3 / 44.01),
        "up to 70",
        "theirs is the largest of its seasons; leaf area not told",
        "Gitelson and others 2006, doi:10.1029/2005JD006017; abstract",
    ),
    "largest day": Published(
        "gross assimilation, clear day in July, leaf area index 6 "
        "[g C m-2 day-1]",
        *near(35),
        "up to 35",
        "theirs is the largest of eight years; leaf area not told",
        "Peng and Gitelson, Remote estimation of gross primary "
        "productivity in soybean and maize based on total crop chlorophyll "
        "content; abstract",
    ),
    "one day": Published(
        "gross assimilation, clear day, 7.5 plants m-2 [g CO2 m-2 day-1]",
        *near(60),
        "about 60",
        "profiles of CO2 on one day; leaf area not told",
        "Photosynthesis under field conditions, IX: vertical distribution of "
        "photosynthesis within a corn crop; abstract",
    ),
}
