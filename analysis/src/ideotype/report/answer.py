# SPDX-License-Identifier: Apache-2.0
"""The first screen of a report: the gain, its uncertainty, its costs and the
limits of the search; and the leaves of the best plant."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ..common.labels import describe_span, words
from ..errors import Error
from ..figures.comparison import select_known
from ..history.bounds import bounds_in_words, traits_at_bounds
from ..history.case import Case
from ..history.coordinates import short_names
from ..history.estimate import NORMAL
from ..history.file import HistoryError
from ..history.interval import ENOUGH, ONE_SEED, Interval
from ..history.results import count_evaluations
from .blocks import Answer, Block, Fact, Note, Table
from .estimates import DrawnGains, describe_drawn
from .organ_split import Split, describe_splits

_COSTS = ("leaf_nitrogen", "nitrogen", "water_use", "transpiration")
"""Quantities besides leaf area that are costs of a plant, if a campaign
measures them."""

_MEASURES = (
    ("length", "length [cm]", 100, 1),
    ("width", "width [cm]", 100, 1),
    ("insertion_angle", "insertion angle [°]", 1, 0),
    ("curvature", "curvature [°]", 1, 0),
    ("azimuth", "azimuth [°]", 1, 0),
    ("insertion_height", "height [cm]", 100, 0),
)
"""Measures of leaves: name, title, factor and digits."""


def make_answer(
    cases: Sequence[Case],
    splits: Mapping[str, Split | Note] = {},
    drawn: Mapping[str, DrawnGains | Note] = {},
) -> Answer:
    """Returns the gain of the best plants, its uncertainty, the costs of the
    plants and of the search, and the limits of the search. `splits` are the
    gains with leaves alone, and `drawn` those with other estimates of the crop,
    by the names of cases.

    Raises HistoryError if nothing is evaluated yet."""
    known = select_known(cases)
    shown = [splits.get(case.name) for case in known]
    make_facts = _describe_one if len(known) == 1 else _describe_many
    gain, claim, sure = make_facts(known, shown)
    return Answer(
        gain,
        claim,
        [*map(_keep_units, (*sure, *describe_drawn(drawn)))],
        [*map(_keep_units, (*_search_costs(known), *_plant_costs(known)))],
        [*_limits(known)],
        is_provisional=not all(case.is_final for case in known),
    )


def _keep_units(fact: Fact) -> Fact:
    # No-break spaces keep numbers and per cent signs on one line.
    return Fact(fact.name, fact.value.replace(" %", "\u00a0%"))


_Gain = tuple[str, str, list[Fact]]
"""The gain in large type, the quantity that is gained, and the facts about its
uncertainty."""


def _describe_one(
    known: Sequence[Case], splits: Sequence[Split | Note | None]
) -> _Gain:
    (case,) = known
    goal = case.best.row.goals[0]
    gain = case.relative_gain()
    searches = len(case.pairs)
    gains = [pair.gain.mean for pair in case.pairs]
    if searches > 1:
        by_search = f"{searches}, with gains of {_range(gains)}"
    else:
        by_search = ONE_SEED
    return (
        f"{_signed(gain.mean)} %",
        f"{words(goal.name)} of the best plant over the baseline"
        + (f", mean of {searches} searches" if searches > 1 else ""),
        [
            Fact(
                "95 % confidence interval, with the possible optimum",
                _interval_text(gain),
            ),
            Fact("searches", by_search),
            Fact(
                "evaluation noise (paired, best search)",
                f"± {NORMAL * case.best_pair.gain.standard_error:.2g} %"
                if case.best_pair.gain.standard_error > 0
                else "unknown",
            ),
            *describe_splits(splits),
        ],
    )


def _describe_many(
    known: Sequence[Case], splits: Sequence[Split | Note | None]
) -> _Gain:
    names = short_names(known)
    gains = {case.name: case.relative_gain() for case in known}
    order = sorted(known, key=lambda case: gains[case.name].mean)
    lowest, highest = order[0], order[-1]
    significant = sum(gain.is_sure for gain in gains.values())
    goals = {case.best.row.goals[0].name for case in known}
    quantity = words(goals.pop()) if len(goals) == 1 else "the objective"
    counts = [len(case.pairs) for case in known]
    searches = describe_span(counts)
    note = f"; {ONE_SEED}" if 1 in counts else ""
    median = float(np.median([gain.mean for gain in gains.values()]))
    return (
        _range([gains[lowest.name].mean, gains[highest.name].mean]),
        f"{quantity} of the best plants over the baseline in {len(known)} "
        "cases",
        [
            Fact("median of cases", f"{_signed(median)} %"),
            Fact(
                "smallest gain",
                f"{gains[lowest.name].number()} % ({names[lowest.name]})",
            ),
            Fact(
                "largest gain",
                f"{gains[highest.name].number()} % ({names[highest.name]})",
            ),
            Fact(
                "95 % confidence interval excludes 0",
                f"in {significant} of {len(known)} cases",
            ),
            Fact("searches of each case", f"{searches}{note}"),
            *describe_splits(splits),
        ],
    )


def _search_costs(known: Sequence[Case]) -> Iterator[Fact]:
    histories = [history for case in known for history in case.histories]
    counts = [count_evaluations(history) for history in histories]
    searches = f" in {len(counts)} searches" if len(counts) > 1 else ""
    yield Fact("evaluations", f"{sum(counts):,}{searches}")
    seconds = [
        float(np.nansum(history.datasets.read("evaluations/seconds")))
        for history in histories
    ]
    if sum(seconds) > 0:
        yield Fact("CPU time of evaluations", _duration(sum(seconds)))


def _duration(seconds: float) -> str:
    for size, unit in ((3600, "core-hours"), (60, "core-minutes")):
        if seconds >= size:
            return f"{seconds / size:,.1f} {unit}"
    return f"{seconds:.1f} core-seconds"


def _plant_costs(known: Sequence[Case]) -> Iterator[Fact]:
    try:
        areas = [
            [plant.estimate("lai").mean for plant in (c.baseline, c.best)]
            for c in known
        ]
    except HistoryError:
        yield Fact("leaf area index", "not in the history")
    else:
        changes = [100 * (best / base - 1) for base, best in areas]
        ((base, best), *others) = areas
        yield Fact(
            "leaf area index",
            f"{_range(changes)}, median {_signed(float(np.median(changes)))} %"
            if others
            else f"{best:.2f} instead of {base:.2f} ({_signed(changes[0])} %)",
        )
    costs = [x for x in _COSTS if x in known[0].best.row.quantities]
    for name in costs:
        changes = [case.best_pair.gain_in(name).mean for case in known]
        yield Fact(
            words(name),
            _range(changes) if len(known) > 1 else f"{_signed(changes[0])} %",
        )
    if not costs:
        yield Fact("nitrogen, water", "not evaluated")
    limited = traits_at_bounds(known)
    if limited:
        text = ", ".join(f"{words(x.trait)} ({x.bound})" for x in limited)
        yield Fact("traits at a bound", text)


def _interval_text(gain: Interval) -> str:
    if not np.isfinite([gain.low, gain.high]).all():
        return "unknown"
    digits = 1 if max(gain.below, gain.above) >= 0.1 else 2
    return _range([gain.low, gain.high], digits)


def _range(values: Sequence[float], digits: int = 1) -> str:
    low, high = min(values), max(values)
    return f"{_signed(low, digits)} to {_signed(high, digits)} %"


def _signed(value: float, digits: int = 1) -> str:
    return f"{value:+.{digits}f}".replace("-", "\N{MINUS SIGN}")


def _limits(known: Sequence[Case]) -> Iterator[str]:
    first = known[0]
    genes = first.genes
    free = {t for t, is_free in zip(genes.traits, genes.is_free) if is_free}
    kept = [t for t in dict.fromkeys(genes.traits) if t not in free]
    kept = [
        _plain(t) for t in kept if _plain(t) not in {_plain(x) for x in free}
    ]
    if kept:
        names = _join_words(list(dict.fromkeys(kept)))
        verb = "is" if len({*kept}) == 1 else "are"
        yield f"{names[:1].upper()}{names[1:]} {verb} fixed to the baseline."
    if len(known) == 1:
        site, day, spacing = _describe_place(first)
        keys = [
            f"{name} = {genes.text(i, first.best.row.genome[0, i])}"
            + ("" if genes.is_choice(i) else f" {genes.units[i]}")
            for i, name in enumerate(genes.names)
            if "." in name
        ]
        if keys:
            yield (
                f"The plant is optimised for {site} and {day} only, together "
                f"with {_join_words(keys)}."
            )
        else:
            yield f"The plant is optimised for {site}, {day} and {spacing} only."
    if at_bounds := bounds_in_words(known):
        yield f"{at_bounds[:1].upper()}{at_bounds[1:]}."
    bounds = first.resolved.get("plant", {}).get("bounds")
    within = f'the bounds "{bounds}"' if isinstance(bounds, str) else "bounds"
    counts = [count_evaluations(h) for c in known for h in c.histories]
    yield (
        f"The search is limited to {within} and to {max(counts):,} evaluations. "
        "The optimum may be better: the upper end of the interval of a gain "
        f"includes the optimum as found in a reference case after {ENOUGH} "
        "evaluations"
        f"{', which may be too low here' if max(counts) < ENOUGH else ''}."
    )


def _describe_place(case: Case) -> tuple[str, str, str]:
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


def _join_words(names: Sequence[str]) -> str:
    *others, last = names
    return f"{', '.join(others)} and {last}" if others else last


def _shown(measure: str, value: float) -> float:
    """Returns a measure as it is printed: azimuths are below 360."""
    return round(value) % 360 if measure == "azimuth" else value


def tabulate_leaves(case: Case) -> Block:
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
        return Note(f"The leaves of the best plant are not listed: {reason}.")
    measures = [measure for measure in _MEASURES if measure[0] in best]
    rows = []
    for leaf in best.index[::-1]:
        cells = [
            " ".join(
                form.format(f"{_shown(name, factor * values[leaf]):.{digits}f}")
                for form, values in (
                    ("{}", best[name]), ("({})", baseline[name]),
                )
            )
            for name, _, factor, digits in measures
        ]  # fmt: skip
        rows.append([str(leaf), *cells])
    return Table(
        ("leaf", *(title for _, title, *_ in measures)),
        rows,
        "Leaves of the best plant, the highest first; leaf 1 is the lowest. "
        "Baseline in brackets. Insertion angle: between stalk and leaf base. "
        "Curvature: further bending from base to tip. Azimuth: clockwise from "
        "the row. Height: of insertion.",
    )
