# SPDX-License-Identifier: Apache-2.0
"""Splits the gain of an optimised plant by intervention: plant and baseline
are re-evaluated without other organs, so that the gain of the leaves alone
remains."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..errors import Error
from ..history.case import Case
from ..history.estimate import NORMAL, Estimate, difference
from .blocks import Block, Fact, Note, Table

Numbers = NDArray[np.float64]

_OF_LEAVES = {
    *("absorbed_par", "absorbed_par_per_leaf_area"),
    *("gross_assimilation", "gross_co2", "net_co2", "net_assimilation"),
    *("net_assimilation_per_leaf_area", "carbon_balance", "dry_matter"),
    "carbon_after_silking",
}
"""The objectives that other organs lower by shading leaves."""


@dataclass(frozen=True)
class Variant:
    """A change of the organs of all plants of a campaign."""

    name: str
    title: str
    settings: Mapping[str, Any]
    """The keys of the campaign that make the change."""
    removed: str = ""
    """The source of the gain that this variant lacks and the one before it
    has; none of the first."""
    meaning: str = ""
    """A sentence that explains the variant."""


AS_SHIPPED = Variant("all_organs", "with all organs", {})
LEAVES_ALONE = Variant(
    "leaves_alone",
    "with leaves alone",
    {"plant.organs": []},
    "light of other organs",
    "Leaves alone: plants without other organs (plant.organs = []).",
)


_CARBON = ("capacity", "density")
"""The keys by which organs assimilate and cost carbon; 0: they do not."""


def make_variants(resolved: Mapping[str, Any]) -> list[Variant]:
    """Returns the variants of a resolved campaign, each with fewer functions
    of other organs than the preceding one; none if plants consist of leaves
    only. If other organs assimilate or cost carbon, one variant has organs
    that only absorb light."""
    plant = resolved.get("plant", {})
    if not plant.get("organs"):
        return []
    dead = _remove_carbon(plant.get("baseline", {}))
    between = [
        Variant(
            "dead_organs",
            "with dead organs",
            dead,
            "carbon of other organs",
            "Dead organs absorb light, but neither assimilate nor cost carbon.",
        )
    ]
    return [AS_SHIPPED, *(between if dead else ()), LEAVES_ALONE]


def _remove_carbon(crop: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the settings with which the organs of a crop neither assimilate
    nor cost carbon; none if they do neither."""
    settings: dict[str, Any] = {
        f"plant.baseline.{part}.{key}": 0
        for part in ("stalk", "sheath", "petiole")
        for key in _CARBON
        if crop.get(part, {}).get(key)
    }
    organs = crop.get("organ", [])
    if any(organ.get(key) for organ in organs for key in _CARBON):
        # A setting replaces a list as a whole.
        settings["plant.baseline.organ"] = [
            organ | {key: 0 for key in _CARBON if key in organ}
            for organ in organs
        ]
    return settings


@dataclass(frozen=True)
class Split:
    """The gain of a plant over the baseline by variant, evaluated with common
    random numbers."""

    variants: tuple[Variant, ...]
    gains: tuple[Estimate, ...]
    """The gain in each variant: in % of the baseline in the first variant, so
    that parts add up, or in the unit of the objective where that baseline is
    not above zero."""

    @property
    def parts(self) -> tuple[Estimate, ...]:
        """The gain that is lost from each variant to the next, with paired
        standard errors."""
        return tuple(map(difference, self.gains, self.gains[1:]))

    @property
    def unit(self) -> str:
        """The unit of gains."""
        return self.gains[0].unit


def split_gain(
    variants: Sequence[Variant], values: Sequence[Numbers], unit: str
) -> Split:
    """Returns the split of the gain of a plant. `values` are the objective of
    baseline and plant in each variant [plants, randomisations], `unit` is that
    of the objective."""
    reference = values[0][0]
    changes = [best - baseline for baseline, best in values]
    if _is_above_zero(reference):
        gains = [_relative(reference, each) for each in changes]
    else:
        gains = [_mean(each, unit) for each in changes]
    return Split(tuple(variants), tuple(gains))


def _is_above_zero(values: Numbers) -> bool:
    found = _mean(values, "1")
    return found.mean > 0 and not found.is_near_zero


def _relative(reference: Numbers, change: Numbers) -> Estimate:
    """Returns 100 change / reference [%]. Its randomisations are those of a
    first-order expansion of the ratio, so that their scatter gives the
    standard error of the ratio, and of differences between ratios."""
    mean = float(reference.mean())
    ratio = float(change.mean()) / mean
    draws = ratio + (change - ratio * reference) / mean
    return _mean(100 * draws, "%")


def _mean(draws: Numbers, unit: str) -> Estimate:
    error = float(draws.std(ddof=1)) / math.sqrt(len(draws))
    return Estimate(float(draws.mean()), error, unit, draws)


def split_case(case: Case) -> Split | Note | None:
    """Evaluates the best plant of a case and the baseline in each variant, as
    finalists are evaluated, with the random numbers of their history. Returns
    None if the search has not ended, its plants have no other organs, or its
    first objective is not the light or the assimilation of leaves, and the
    reason if the plants cannot be evaluated."""
    if case.is_sensitivity or not case.pairs or not case.best_pair.is_final:
        return None
    variants = make_variants(case.best_history.resolved)
    goal = case.best.row.goals[0]
    is_of_leaves = goal.name.rpartition(".")[2] in _OF_LEAVES
    if not variants or not is_of_leaves or goal.sign < 0:
        return None
    try:
        values = [evaluate_pair(case, each.settings) for each in variants]
    except Error as reason:
        return Note(f"The gain of {case.name} is not split: {reason}.")
    return split_gain(variants, values, goal.unit)


def evaluate_pair(case: Case, settings: Mapping[str, Any]) -> Numbers:
    """Returns the first objective of the baseline and the best plant of a case
    by randomisation [2, randomisations], evaluated as finalists are, with keys
    that replace those of the campaign.

    Raises Error if one of them cannot be evaluated."""
    from ..stand.stand import Stand

    plants = np.array(
        [plant.row.genome[0] for plant in (case.baseline, case.best)]
    )
    stand = Stand.from_history(
        case.best_history.path, settings=settings, same_isa=False
    )
    evaluated = stand.evaluate(plants, [], final=True)
    for message in evaluated.message.values:
        if message:
            raise Error(str(message))
    return np.asarray(evaluated.objective_by_randomisation[:, 0])


def split_cases(
    cases: Sequence[Case],
    tell: Callable[[int, int], object] = lambda done, count: None,
) -> dict[str, Split | Note]:
    """Returns the splits of the cases that have one by the names of the cases,
    by as many threads as there are processors. `tell` gets the number of
    finished cases and of all."""
    splits: list[Split | Note | None] = []
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for each in pool.map(split_case, cases):
            splits.append(each)
            tell(len(splits), len(cases))
    return name_results(cases, splits)


_Result = TypeVar("_Result")


def name_results(
    cases: Sequence[Case], results: Iterable[_Result | None]
) -> dict[str, _Result]:
    """Returns the results of the cases that have one by the names of the
    cases."""
    return {
        case.name: each
        for case, each in zip(cases, results, strict=True)
        if each is not None
    }


def tabulate_splits(splits: Mapping[str, Split | Note]) -> list[Block]:
    """Tabulates splits by the names of cases, with notes on cases that cannot
    be split; nothing if there is no split."""
    known = {
        x: case_split
        for x, case_split in splits.items()
        if isinstance(case_split, Split)
    }
    notes: list[Block] = [x for x in splits.values() if isinstance(x, Note)]
    if not known:
        return notes
    # The variants of each case are some or all of the same variants.
    variants = max((x.variants for x in known.values()), key=len)
    titles = [f"gain {v.title} [%]" for v in variants]
    titles += [
        f"by {v.removed} [percentage points]" for v in variants if v.removed
    ]
    rows = [
        [case, *_cells(case_split, variants)]
        for case, case_split in known.items()
    ]
    return [
        Table(
            ("case", *titles),
            rows,
            "The best plant of each case and the baseline, re-evaluated with "
            "common random numbers. Gains are in % of the baseline with all "
            "organs, so that their differences in percentage points add up. "
            + "".join(f"{v.meaning} " for v in variants if v.meaning)
            + "A gain by light of other organs arises if these absorb less of "
            "the light of the leaves than in the baseline. Intervals: 95 % "
            "confidence intervals of paired differences, without the "
            "differences between searches.",
        ),
        *notes,
    ]


def _cells(case_split: Split, variants: Sequence[Variant]) -> list[str]:
    names = [v.name for v in case_split.variants]
    gains = dict(zip(names, case_split.gains, strict=True))
    parts = dict(zip(names[1:], case_split.parts, strict=True))
    found = [gains.get(v.name) for v in variants]
    found += [parts.get(v.name) for v in variants if v.removed]
    return [_text(x) if x else "" for x in found]


def _text(value: Estimate) -> str:
    unit = "" if value.unit == "%" else f" {value.unit}"
    text = f"{value.interval_text()}{unit}"
    return text.replace(" ", "\u00a0").replace("-", "\N{MINUS SIGN}")


def describe_splits(splits: Sequence[Split | Note | None]) -> list[Fact]:
    """Returns the gain with leaves alone and the parts that other organs
    contribute, for one case; for several, the number of cases with a
    significantly smaller gain. Returns nothing without a split."""
    known = [split for split in splits if isinstance(split, Split)]
    if not known:
        return []
    if len(splits) > 1:
        smaller = sum(
            split.parts[-1].mean > NORMAL * split.parts[-1].standard_error
            for split in known
        )
        return [
            Fact(
                f"gain significantly smaller {known[0].variants[-1].title}",
                f"in {smaller} of {len(known)} cases",
            )
        ]
    (split,) = known
    whole, alone = split.gains[0], split.gains[-1]
    share = ""
    if abs(alone.mean) <= NORMAL * alone.standard_error:
        share = ": no significant gain"
    elif whole.mean > NORMAL * whole.standard_error:
        share = f", {100 * alone.mean / whole.mean:.0f} % of the gain"
    unit = "percentage points" if split.unit == "%" else split.unit
    return [
        Fact(
            f"gain {split.variants[-1].title}",
            f"{_signed(alone)} {split.unit}{share}",
        ),
        *(
            Fact(f"gain by {variant.removed}", f"{_signed(part)} {unit}")
            for variant, part in zip(
                split.variants[1:], split.parts, strict=True
            )
        ),
    ]


def _signed(value: Estimate) -> str:
    plus = "+" if value.mean > 0 else ""
    return plus + value.interval_text().replace("-", "\N{MINUS SIGN}")


def columns_of(
    splits: Mapping[str, Split | Note],
) -> dict[str, dict[str, Any]]:
    """Returns the columns of splits in tables of results by the names of
    cases: gains and their differences with standard errors."""
    return {
        case: _columns(each)
        for case, each in splits.items()
        if isinstance(each, Split)
    }


def _columns(case_split: Split) -> dict[str, Any]:
    columns: dict[str, Any] = {"split_unit": case_split.unit}
    names = [f"gain_{v.name}" for v in case_split.variants]
    names += [
        f"gain_by_{v.removed.replace(' ', '_')}"
        for v in case_split.variants[1:]
    ]
    for name, value in zip(
        names, (*case_split.gains, *case_split.parts), strict=True
    ):
        columns[name] = value.mean
        columns[f"{name}_standard_error"] = value.standard_error
    return columns
