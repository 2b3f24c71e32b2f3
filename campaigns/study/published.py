# SPDX-License-Identifier: Apache-2.0
"""Published figures of maize canopies that validation.py compares the baseline with.

Each was read in the source that it names. "Abstract": no more than that was read, so
that density, rows or hours that it does not tell are unknown."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Published:
    what: str
    low: float
    high: float
    """What counts as agreement."""
    told: str
    """The figure as the source has it."""
    differs: str
    source: str


def near(value: float, share: float = 0.1) -> tuple[float, float]:
    """Where no range or error is told."""
    return (1 - share) * value, (1 + share) * value


def apsim_k(row: float) -> float:
    """Default of APSIM 7.10 by distance of rows [m], linear between points."""
    return float(np.interp(row, (0.2, 0.5, 1.0), (0.70, 0.50, 0.40)))


def ceres_k(row: float, density: float) -> float:
    """Of CERES-Maize by distance of rows [m] and plants per area [m-2]."""
    return float(1.5 - 0.768 * (row**2 * density) ** 0.1)


APSIM = "APSIM 7.10, Model/Maize.xml"
CERES = "DSSAT 4.8, MZ_GROSUB.for and MZCER048.ECO"
MADDONNI = "Maddonni and Martínez-Bercovich 2014, doi:10.1155/2014/195012"
KUKAL = (
    "Kukal and Irmak 2020, Agricultural and Forest Meteorology 284, 107887; "
    "abstract"
)
MODEL = (
    "default of a model, fitted to its own fields; of green leaves, ours of all "
    "organs"
)
HYBRID = (
    "leaf area not told, and a hybrid has more than the baseline's 0.40 m2"
)
YIELD = "theirs is grain yield, ours a clear day's assimilation"

PUBLISHED = {
    **{
        f"k {row}": Published(
            f"k, rows of {row} m",
            *near(apsim_k(row)),
            f"{apsim_k(row):.2f}",
            MODEL,
            APSIM,
        )
        for row in (0.2, 0.5, 1.0)
    },
    "trend": Published(
        "k in rows of 1.0 m over that of 0.2 m",
        *near(apsim_k(1.0) / apsim_k(0.2)),
        f"{apsim_k(1.0) / apsim_k(0.2):.2f}",
        MODEL,
        APSIM,
    ),
    "k ceres": Published(
        "k, rows of 0.76 m",
        *near(ceres_k(0.76, 7.5)),
        f"{ceres_k(0.76, 7.5):.2f}",
        MODEL,
        CERES,
    ),
    "k crops": Published(
        "k, rows of 0.76 m",
        0.36,
        0.48,
        "0.36 to 0.48",
        "theirs is the range of maize and three other crops, means of a season",
        KUKAL,
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
        "theirs is the largest of a season, of maize and three other crops",
        KUKAL,
    ),
    "reflected": Published(
        "PAR reflected, noon",
        0.05,
        0.08,
        "0.05 to 0.08",
        "leaves of the baseline reflect 0.05, those of ADEL 0.09; the abstract "
        "calls it albedo and does not tell the leaf area",
        "thesis, University of Natal 1976, Maize crop growth and development "
        "related to solar radiation; abstract",
    ),
    **{
        f"tied up {density}": Published(
            "canopy assimilation, leaves tied up [%], leaf area index "
            f"{density * 0.399:.1f}",
            *near(17.2),
            "+17.2",
            "theirs is net, a mean of five densities; these and hours not told",
            "Wang and others 1995, doi:10.1007/BF02913002; abstract",
        )
        for density in (9, 16)
    },
    "sign": Published(
        "leaf area index from which an erect top pays",
        3,
        5,
        "3 to 5",
        YIELD,
        "Winter and Ohlrogge 1973, Agronomy Journal 65, 395-397; abstract",
    ),
    "erect 0.5": Published(
        "erect top, 9 plants m-2, rows of 0.5 m [%]",
        0,
        math.inf,
        "above 0",
        "theirs is dry matter from silking to maturity",
        "Arihara and others 1978, Japanese Journal of Crop Science 47, "
        "536-540; abstract",
    ),
    "erect 1.5": Published(
        "erect top, 9 plants m-2, rows of 1.5 m [%]",
        -math.inf,
        0,
        "below 0",
        "theirs is dry matter from silking to maturity",
        "Arihara and others 1978; abstract",
    ),
    "lg2": Published(
        "leaves at 15 deg instead of 45, 5.9 plants m-2, rows of 0.51 m [%]",
        *near(40),
        "+40",
        f"gene lg2, angles not told; {YIELD}",
        "Pendleton and others 1968, Field investigations of the relationships "
        "of leaf angle in corn to grain yield and apparent photosynthesis; "
        "abstract",
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
        f"dry matter {source[:5]}": Published(
            "dry matter, season, upper limit [g MJ-1 of PAR]",
            *near(value),
            told,
            "in ours stalks, ears and roots do not respire",
            source,
        )
        for source, value, told in (
            (CERES, 4.2, "4.2"),
            (APSIM, 1.6 / 0.45, "1.6, if of all sunlight 3.6 of PAR"),
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
