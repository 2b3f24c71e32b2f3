# SPDX-License-Identifier: Apache-2.0
"""The tables of a report."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ..common.labels import unit_label
from ..common.markdown import markdown_table
from ..figures.comparison import ELITE, describe_intervals
from ..figures.cross import Cross
from ..history.bounds import bounds_in_words
from ..history.case import Case
from ..history.file import HistoryError
from ..history.interval import BEYOND, SEARCH_SCATTER, Interval
from .blocks import Block, Note, Table

_MOST = 6
"""The number of cases that a remark names."""

UNKNOWN = "–"
"""The text of a cell without a figure."""

_GAINS = (
    *("case", "searches", "gain [%]", "by search [%]", "baseline", "best"),
    *("LAI baseline", "LAI best", "gain per leaf area [%]"),
)
_ELITE = "over elite [%]"
_CEILING = "below the ceiling [%]"


def tabulate_gains(cases: Sequence[Case], cross: Cross | None) -> list[Block]:
    """Tabulates the gain of each case, with remarks on the gains."""
    columns = {
        _ELITE: [_format_over_elite(case, cross) for case in cases],
        _CEILING: [_room(case) for case in cases],
    }
    shown = [x for x, cells in columns.items() if {*cells} != {UNKNOWN}]
    rows = [
        [*_make_gain_row(case), *(columns[name][i] for name in shown)]
        for i, case in enumerate(cases)
    ]
    blocks: list[Block] = [
        Table(
            (*_GAINS, *shown),
            rows,
            f"Gains are means of searches{bracket_intervals(cases)}. Baseline and best: "
            f"re-evaluated plants of the best search, in {_unit(cases)}.",
        )
    ]
    blocks += [Note(text) for text in _remarks(cases, cross)]
    blocks += _at_bounds(cases)
    return blocks


def _at_bounds(cases: Sequence[Case]) -> list[Note]:
    found = bounds_in_words(cases)
    return [Note(f"{found[:1].upper()}{found[1:]}.")] if found else []


SCREEN = 16
"""The number of cases that fit on a screen."""


def select_extremes(cases: Sequence[Case]) -> list[Case]:
    """Returns the cases with the largest and smallest gains, as many as fit on
    a screen, best first. If all cases fit, their order is unchanged."""
    if len(cases) <= SCREEN:
        return [*cases]
    known = sorted(
        (case for case in cases if case.pairs),
        key=lambda case: -case.relative_gain().mean,
    )
    half = SCREEN // 2
    return known if len(known) <= SCREEN else [*known[:half], *known[-half:]]


def bracket_intervals(cases: Sequence[Case]) -> str:
    text = describe_intervals(cases)
    return f" ({text})" if text else ""


def tabulate_screen(cases: Sequence[Case]) -> list[Block]:
    """Returns the table of gains, of no more cases than fit on a screen."""
    shown = select_extremes(cases)
    table, *_ = tabulate_gains(shown, None)
    limits = _at_bounds(cases)
    if len(shown) == len(cases):
        return [table, *limits]
    return [
        table,
        Note(
            "".join(f"{limit.text} " for limit in limits)
            + f"{len(shown)} of {len(cases)} cases, with the largest and the "
            "smallest gains; --all prints all, --csv all with coordinates."
        ),
    ]


def format_markdown(blocks: Sequence[Block]) -> str:
    """Returns tables and notes as legible text in Markdown."""
    return "\n\n".join(
        block.text if isinstance(block, Note) else _format_table(block)
        for block in blocks
        if isinstance(block, Note | Table)
    )


def _format_table(table: Table) -> str:
    lines = markdown_table(table.header, table.rows, is_padded=True)
    return "\n".join([*lines, "", table.caption]).replace("\u00a0", " ")


def _unit(cases: Sequence[Case]) -> str:
    units = {c.best.objective.unit for c in cases if c.pairs}
    return " or ".join(sorted(map(unit_label, units))) or "no unit yet"


def _make_gain_row(case: Case) -> list[str]:
    searches = str(len(case.histories))
    if not case.pairs:
        return [case.name, searches, *[UNKNOWN] * (len(_GAINS) - 2)]
    gains = [pair.gain.mean for pair in case.pairs]
    alone = f"{gains[0]:.1f}"
    return [
        case.name,
        searches,
        format_bare(case.relative_gain()),
        f"{min(gains):.1f} .. {max(gains):.1f}" if len(gains) > 1 else alone,
        case.baseline.objective.interval_text().replace(" ", "\u00a0"),
        case.best.objective.interval_text().replace(" ", "\u00a0"),
        _known(lambda: _lai(case, "baseline")),
        _known(lambda: _lai(case, "best")),
        _known(lambda: format_bare(case.gain_per_leaf_area())),
    ]


def _format_over_elite(case: Case, cross: Cross | None) -> str:
    gain = cross.relative_gain(case, ELITE) if cross and case.pairs else None
    return format_bare(gain) if gain else UNKNOWN


def format_bare(figure: Interval) -> str:
    # No-break spaces keep the number and its error on one line.
    text = figure.number().replace(" ", "\u00a0")
    return text.replace("-", "\N{MINUS SIGN}")


def _known(cell: Callable[[], str]) -> str:
    """Returns the text of a cell, or UNKNOWN if the history lacks its data."""
    try:
        return cell()
    except HistoryError:
        return UNKNOWN


def _lai(case: Case, who: str) -> str:
    return f"{getattr(case, who).estimate('lai').mean:.2f}"


def _room(case: Case) -> str:
    try:
        room = case.headroom()
    except HistoryError:
        return UNKNOWN
    ceiling = room.mean + case.best.objective.mean
    return room.scaled(100 / ceiling, "%").interval_text()


def _remarks(cases: Sequence[Case], cross: Cross | None) -> list[str]:
    remarks = [
        "Intervals of several seeds are Student's t intervals of their scatter, "
        "or of their standard errors where these are wider. The interval of a "
        "single seed includes its standard error, and "
        f"{100 * SEARCH_SCATTER:.0f} % of the gain as the standard deviation "
        "between searches. Towards an improvement each interval extends to at "
        f"least {100 * BEYOND:.0f} % of the gain beyond the mean, to include "
        "the possible optimum. Standard errors of gains over the baseline are "
        "paired standard errors: baseline and best are compared randomisation "
        "by randomisation, with common random numbers.",
        "LAI is the one-sided leaf area per ground area. The gain per leaf area "
        "is the gain in absorbed PAR per one-sided leaf area.",
        "The ceiling is the light that leaves would absorb if other organs and "
        "soil absorbed none: incident light less the reflection of the best "
        "plant's canopy.",
    ]
    if cross and ELITE in cross.plants:
        remarks.append(
            "The error of the gain over the elite plant treats both as "
            "independent, since a cross-evaluation has independent random numbers."
        )
    named: dict[str, list[str]] = {}
    for case in cases:
        for remark in _make_case_remarks(case, cross):
            named.setdefault(remark, []).append(case.name)
    return remarks + [
        f"{remark}: {_named(names, len(cases))}."
        for remark, names in named.items()
    ]


def _named(names: Sequence[str], cases: int) -> str:
    if len(names) == cases > 1:
        return "all cases"
    more = f" and {len(names) - _MOST} others" if len(names) > _MOST else ""
    return ", ".join(names[:_MOST]) + more


def _make_case_remarks(case: Case, cross: Cross | None) -> Iterator[str]:
    if not case.pairs:
        yield "No comparison yet"
        return
    if case.fronts:
        yield (
            "With several objectives the gain is that in the first, and the "
            "best plant is the best of the Pareto front in the first"
        )
    if not all(pair.is_paired for pair in case.pairs):
        yield (
            "Errors of gains treat baseline and best as independent and are "
            "mostly too large, since the history has no common randomisations"
        )
    if not case.is_final:
        yield (
            "Provisional, since not all seeds are re-evaluated, and the best of "
            "many noisy values is too high on average"
        )
    if (
        cross
        and ELITE in cross.plants
        and cross.relative_gain(case, ELITE) is None
    ):
        yield (
            "The gain over the elite plant is not known, since the "
            "cross-evaluation does not have it in the light of these cases "
            "(name a case CAMPAIGN: CASE where several campaigns have it)"
        )
    if not case.fronts:
        yield _describe_spread([pair.gain.mean for pair in case.pairs])
    if case.best_history.resolved.get("feasibility", {}).get("trait"):
        yield (
            f"Distance in standard deviations: best plant {_among(case, 'best')}; "
            f"baseline {_among(case, 'baseline')}"
        )
    try:
        if case.is_saturated():
            yield (
                "Saturated: the best plant is within its standard error of the "
                "ceiling, so that absorption cannot distinguish better plants"
            )
    except HistoryError as reason:
        yield f"No ceiling, since {reason}"


def _describe_spread(gains: Sequence[float]) -> str:
    """Returns the possible distance of the optimum; docs/optimisers.md
    discusses this bound."""
    if len(gains) < 3:
        return (
            "Three searches (replicates = 3) would show the possible distance "
            "of the best plant from the optimum"
        )
    return (
        f"{len(gains)} independent searches gained {min(gains):.1f} to "
        f"{max(gains):.1f} %, a spread of {max(gains) - min(gains):.1f} percentage "
        "points; after short searches the optimum may be further than that from "
        "the best plant"
    )


def _among(case: Case, who: str) -> str:
    """Returns the distance of a plant of a case from measured lines, and the
    nearest line."""
    plant = getattr(case, who)

    def number(name: str) -> float:
        return float(plant.estimate(name).mean)

    text = (
        f"{number('distance_from_lines'):.2f} from the mean of measured lines"
    )
    lines = case.best_history.resolved["feasibility"].get("line", [])
    if nearest := int(number("nearest_line")):
        text += (
            f" and {number('distance_from_line'):.2f} from the nearest, "
            f"{lines[nearest - 1]['name']}"
        )
    return text
