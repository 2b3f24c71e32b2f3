# SPDX-License-Identifier: Apache-2.0
"""Answers in three sentences which plant is best, and tabulates the leaves of
this plant beside the leaves of the baseline."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ..common.labels import unit_label, words
from ..errors import Error
from ..figures.comparison import known_cases
from ..history.bounds import bounds_in_words
from ..history.case import Case
from ..history.coordinates import short_names
from ..history.file import HistoryError
from ..history.interval import ENOUGH, ONE_SEED
from ..history.results import evaluations_of
from .blocks import Answer, Block, Note, Table
from .organ_split import Split, in_words

_COSTS = ("leaf_nitrogen", "nitrogen", "water_use")
"""Quantities besides leaf area that are costs of a plant, if a campaign
measures them."""

_MEASURES = (
    ("length", "length [cm]", 100, 1),
    ("width", "width [cm]", 100, 1),
    ("insertion_angle", "angle [°]", 1, 0),
    ("curvature", "bend [°]", 1, 0),
    ("azimuth", "points to [°]", 1, 0),
    ("insertion_height", "base at [cm]", 100, 0),
)
"""Measures of leaves: name, title, factor and digits."""


def answer(
    cases: Sequence[Case], splits: Mapping[str, Split | Note] = {}
) -> Answer:
    """States which plant is best and how certain the gain is, the split of the
    gain if splits by the names of cases are given, the costs of the plant, and
    the limits of the search.

    Raises HistoryError if nothing is evaluated yet."""
    known = known_cases(cases)
    tell = _of_one if len(known) == 1 else _of_many
    better, cost = tell(known)
    better += in_words([splits.get(case.name) for case in known])
    return Answer(
        (
            ("How much better, and how sure?", better),
            ("At what cost?", cost),
            ("What was not searched?", " ".join(_not_searched(known))),
        )
    )


def _of_one(known: Sequence[Case]) -> tuple[str, str]:
    (case,) = known
    goal = case.best.row.goals[0]
    unit = "" if goal.unit == "1" else f" {unit_label(goal.unit)}"
    gain = case.relative_gain()
    searches = len(case.pairs)
    which = "The best plant"
    if searches > 1:
        place = [h for h, _ in case.known].index(case.best_history) + 1
        which = f"The best plant, of search {place} of {searches},"
    provisional = "" if case.is_final else "Provisional: "
    better = (
        f"{provisional}{which} has {case.best.objective.interval_text()}{unit} "
        f"of {words(goal.name)}, the baseline "
        f"{case.baseline.objective.interval_text()}. "
    )
    gains = [pair.gain.mean for pair in case.pairs]
    better += (
        f"The {searches} searches gained {min(gains):.1f} to {max(gains):.1f} %, "
        f"{gain.number()} % on average."
        if searches > 1
        else f"The gain is {gain.number()} % ({ONE_SEED})."
    )
    return better, " ".join(_costs(case))


def _costs(case: Case) -> Iterator[str]:
    try:
        was, now = (
            case.best_pair.baseline.estimate("lai").mean,
            case.best.estimate("lai").mean,
        )
    except HistoryError:
        yield "The history does not tell its leaf area."
    else:
        change = 100 * (now / was - 1)
        yield (
            f"Its leaf area index is {now:.2f} instead of {was:.2f} "
            f"({_signed(change)} %)."
        )
    told = []
    for name in _COSTS:
        if name in case.best.row.quantities:
            gain = case.best_pair.gain_in(name)
            told.append(f"{words(name)} changes by {_signed(gain.mean)} %")
    if told:
        yield f"Its {'; '.join(told)}."
    else:
        yield "What it needs of nitrogen and water is not evaluated."


def _of_many(known: Sequence[Case]) -> tuple[str, str]:
    names = short_names(known)
    gains = {case.name: case.relative_gain() for case in known}
    order = sorted(known, key=lambda case: gains[case.name].mean)
    least, most = (gains[case.name] for case in (order[0], order[-1]))
    sure = sum(x.is_sure for x in gains.values())
    goals = {case.best.row.goals[0].name for case in known}
    what = words(goals.pop()) if len(goals) == 1 else "their objective"
    counts = {len(case.pairs) for case in known}
    noted = f" ({ONE_SEED})" if 1 in counts else ""
    better = (
        f"In {len(known)} cases the bred plants have from {least.number()} % "
        f"({names[order[0].name]}) to {most.number()} % more "
        f"({names[order[-1].name]}) {what} than the baseline; in {sure} of them "
        f"the interval of the gain is on one side of 0{noted}."
    )
    try:
        ratios = [
            100
            * (
                c.best.estimate("lai").mean / c.baseline.estimate("lai").mean
                - 1
            )
            for c in known
        ]
        cost = (
            f"Their leaf area differs from the baseline's by "
            f"{_signed(min(ratios))} to {_signed(max(ratios))} %, "
            f"{_signed(float(np.median(ratios)))} % in the median case."
        )
    except HistoryError:
        cost = "The histories do not tell leaf areas."
    if not any(x in known[0].best.row.quantities for x in _COSTS):
        cost += " What plants need of nitrogen and water is not evaluated."
    return better, cost


def _signed(value: float) -> str:
    return f"{value:+.1f}".replace("-", "\N{MINUS SIGN}")


def _not_searched(known: Sequence[Case]) -> Iterator[str]:
    first = known[0]
    genes = first.genes
    free = {t for t, is_free in zip(genes.traits, genes.is_free) if is_free}
    kept = [t for t in dict.fromkeys(genes.traits) if t not in free]
    kept = [
        _plain(t) for t in kept if _plain(t) not in {_plain(x) for x in free}
    ]
    if kept:
        names = _listed(list(dict.fromkeys(kept)))
        stay = "stays" if len({*kept}) == 1 else "stay"
        yield f"{names[:1].upper()}{names[1:]} {stay} as in the baseline."
    if len(known) == 1:
        site, day, spacing = _place(first)
        keys = [
            f"{name} = {value:.4g} {unit}"
            for name, unit, value in zip(
                genes.names, genes.units, first.best.row.genome[0]
            )
            if "." in name
        ]
        place = f"{site}, {day} and {spacing} alone"
        if keys:
            place = f"{site} and {day} alone, with {_listed(keys)} of its own"
        yield f"The plant is bred for {place}."
    if at_bounds := bounds_in_words(known):
        yield f"{at_bounds[:1].upper()}{at_bounds[1:]}."
    bounds = first.resolved.get("plant", {}).get("bounds")
    within = f'the bounds "{bounds}"' if isinstance(bounds, str) else "bounds"
    counts = [evaluations_of(h) for c in known for h in c.histories]
    yield (
        f"Nothing outside {within} was tried, and no search evaluated more than "
        f"{max(counts)} plants. The optimum may be better than the plants that "
        "were found: the upper end of a gain's interval reaches to where it was "
        f"after {ENOUGH} evaluations in a case in which it is known"
        f"{', and may be too low here' if max(counts) < ENOUGH else ''}."
    )


def _place(case: Case) -> tuple[str, str, str]:
    """Returns words for site, time and spacing."""
    has = case.attributes
    site = f"the site {has.get('site', '?')}"
    day = f"the time {has.get('day', '?')}"
    spacing = f"the spacing {has.get('spacing', '?')}"
    if {"row_spacing", "plant_spacing"} <= {*has}:
        row, plant = (float(has[f"{x}_spacing"]) for x in ("row", "plant"))
        spacing = f"rows {row:.4g} m and plants {plant:.4g} m apart"
    return site, day, spacing


def _plain(trait: str) -> str:
    return words(trait.removesuffix("_profile").removesuffix("_deviation"))


def _listed(words_of: Sequence[str]) -> str:
    *others, last = words_of
    return f"{', '.join(others)} and {last}" if others else last


def _shown(measure: str, value: float) -> float:
    """Returns a measure as it is printed: azimuths are below 360."""
    return round(value) % 360 if measure == "azimuth" else value


def leaf_table(case: Case) -> Block:
    """Returns the leaves of the best plant, the highest first, with the leaves
    of the baseline in brackets; or the reason why leaves are not known."""
    try:
        from ..stand.stand import Stand

        stand = Stand.from_history(case.best_history.path, same_isa=False)
        best, baseline = (
            stand.leaves(plant.row.genome[0])
            for plant in (case.best, case.baseline)
        )
    except Error as reason:
        return Note(f"The leaves of the best plant are not told: {reason}.")
    shown = [each for each in _MEASURES if each[0] in best]
    rows = []
    for leaf in best.index[::-1]:
        cells = [
            " ".join(
                form.format(f"{_shown(name, factor * measures[leaf]):.{digits}f}")
                for form, measures in (
                    ("{}", best[name]), ("({})", baseline[name]),
                )
            )
            for name, _, factor, digits in shown
        ]  # fmt: skip
        rows.append([str(leaf), *cells])
    return Table(
        ("leaf", *(title for _, title, *_ in shown)),
        rows,
        "The leaves of the best plant, the highest first, counted from the "
        "lowest; in brackets those of the baseline. The angle is that of the "
        "base from the stalk, the bend how much further the tip bends down; "
        "leaves point to a direction clockwise from the row.",
    )
