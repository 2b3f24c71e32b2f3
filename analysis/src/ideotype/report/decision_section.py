# SPDX-License-Identifier: Apache-2.0
"""The section of a report that decides between plants and managements, at the
prices of the campaign or by an objective over scenarios."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from ..decision import Decision, decide, read_options
from ..decision.decision import is_significant
from ..decision.options import find_worth
from ..decision.worth import PRICE_UNITS, PRICED
from ..errors import Error
from ..figures.style import axis_label
from ..history.case import Case
from ..history.estimate import Estimate
from .blocks import Note, Section, Table

_LIMITS = (
    "Not certain on this page: environments other than those listed, and what "
    "the model lacks: nutrients, weeds, pests, lodging and frost. Plants that "
    "were not evaluated may be better than all listed ones."
)
_LIMITS_OF_PRICES = (
    " That is likely at other prices, for which no search was run. Prices are "
    "inputs without errors. Electricity outside the season of the crop does not "
    "count."
)
_QUANTITIES = {
    "grain": "grain [t ha\N{SUPERSCRIPT MINUS}\N{SUPERSCRIPT ONE}]",
    "seed": "plants sown [m\N{SUPERSCRIPT MINUS}\N{SUPERSCRIPT TWO}]",
    "water": "irrigation [mm]",
    "electricity": "electricity [kWh m\N{SUPERSCRIPT MINUS}"
    "\N{SUPERSCRIPT TWO}]",
}


def decide_case(
    case: Case,
    tell: Callable[[int, int, str], object] = lambda done, count, part: None,
) -> Decision | Note | None:
    """Returns the decision of a case, the reason why there is none, or None if
    there is nothing to decide or the search has not ended."""
    if not case.pairs or not case.is_final or find_worth(case) is None:
        return None
    try:
        return decide(
            read_options(case),
            tell=lambda done, count: tell(
                done, count, f"options of {case.name}"
            ),
        )
    except Error as reason:
        return Note(f"No decision for {case.name}: {reason}.")


def make_decision_section(
    decisions: Sequence[Decision | Note | None],
) -> Section:
    """Returns the section with the decision of each case; it is empty if no
    case has one."""
    section = Section("Decision")
    for each in decisions:
        if isinstance(each, Note):
            section.blocks.append(each)
        elif each is not None:
            _add(section, each)
    if section.blocks:
        has_prices = any(
            isinstance(each, Decision) and each.worth.prices
            for each in decisions
        )
        section.note(_LIMITS + (_LIMITS_OF_PRICES if has_prices else ""))
    return section


def _add(section: Section, decision: Decision) -> None:
    best = decision.best
    prices = decision.worth.prices
    listed = ", ".join(
        f"{name} {prices[name]:g} {unit}"
        for name, unit in PRICE_UNITS.items()
        if prices.get(name, 0) > 0
    )
    section.note(
        f"{decision.case}: choose {_describe(decision, best)}. Its "
        f"{_value_name(decision)} is {_text(decision.value(best))}"
        + (f" at these prices: {listed}." if prices else ".")
    )
    for sentence in _certain(decision):
        section.note(sentence)
    for sentence in describe_switches(decision):
        section.note(sentence)
    section.blocks.append(_tabulate_candidates(decision))
    if len(decision.environments) > 1:
        section.blocks.append(_tabulate_regret(decision))


def _value_name(decision: Decision) -> str:
    rule = str(decision.rule)
    if decision.rule.name == "probability":
        return rule
    over = "" if len(decision.environments) == 1 else f" ({rule})"
    return f"{_worth_name(decision)}{over}"


def _worth_name(decision: Decision) -> str:
    if decision.worth.prices:
        return "margin per hectare"
    return axis_label(decision.worth.name, decision.worth.unit)


def _describe(decision: Decision, candidate: int) -> str:
    keys = ", ".join(
        f"{key} {value}" for key, value in decision.keys[candidate].items()
    )
    name = decision.names[candidate]
    return f"{name} with {keys}" if keys else name


def _certain(decision: Decision) -> list[str]:
    """Returns what the comparison of the best candidate with the others
    shows."""
    best, baseline = decision.best, decision.baseline
    sentences = []
    if baseline is not None and best != baseline:
        text = (
            "Advantage over the baseline: "
            f"{_text(decision.advantage(best, baseline))}"
        )
        if len(decision.environments) > 1:
            share = 100 * decision.wins(best, baseline)
            years = decision.advantage_between_environments(best, baseline)
            text += (
                f"; it is better in {share:.0f} % of the environments by "
                "weight. If these are a random sample, its mean is "
                f"{_text(years)} higher"
            )
        sentences.append(text + ".")
    equal = decision.equals()
    if equal:
        sentences.append(
            "No significant difference from the chosen one (5 %, Holm): "
            + "; ".join(
                f"{_describe(decision, c)} "
                f"({_text(decision.advantage(c, best))})"
                for c in equal
            )
            + ". Choose among them by other properties."
        )
    elif len(decision.names) > 1:
        sentences.append(
            "All other listed options are significantly worse (5 %, Holm)."
        )
    return sentences


def describe_switches(decision: Decision) -> list[str]:
    """Returns a sentence for each price at which the decision changes."""
    if not decision.worth.prices:
        return []
    sentences = []
    for switch in decision.switches:
        below, above = (
            _describe(decision, c) for c in (switch.below, switch.above)
        )
        if not is_significant(switch.difference):
            sentences.append(
                f"At a price of {switch.price} near {switch.at:.2g}, the best "
                f"option changes from {below} to {above}, without a "
                f"significant difference ({_text(switch.difference)} at 10 % "
                "more, in other randomisations)."
            )
            continue
        at = f"{switch.at:.2g}"
        if math.isfinite(switch.at_standard_error):
            at = Estimate(
                switch.at, switch.at_standard_error, ""
            ).interval_text()
        sentences.append(
            f"From a price of {switch.price} of {at} "
            f"{PRICE_UNITS[switch.price]} on: {above} instead of {below} "
            f"({_text(switch.difference)} at 10 % more, in other "
            "randomisations)."
        )
    changing = {switch.price for switch in decision.switches}
    same = [
        price
        for price in PRICED
        if decision.worth.prices.get(price, 0) > 0 and price not in changing
    ]
    if same:
        sentences.append(
            "The decision among these options does not change with the price "
            f"of {' or of '.join(same)} between 0 and three times the price "
            "above."
        )
    return sentences


def _tabulate_candidates(decision: Decision) -> Table:
    shown = [
        (i, _QUANTITIES[price])
        for i, price in enumerate(PRICED if decision.worth.prices else ())
        if decision.draws[..., i].any()
    ]
    order = (-decision.value_draws().mean(-1)).argsort()
    rows = []
    for c in map(int, order):
        parts = decision.weights @ decision.draws[c].mean(1)
        mean, largest = decision.regret_over_environments(c)
        rows.append(
            [
                decision.names[c],
                decision.roles[c],
                *decision.keys[c].values(),
                _text(decision.value(c)),
                _text(decision.advantage(c, decision.best)),
                *(f"{parts[i]:.4g}" for i, _ in shown),
                *(
                    [f"{mean.mean:.4g}", f"{largest:.4g}"]
                    if len(decision.environments) > 1
                    else []
                ),
            ]
        )
    header = [
        "option",
        "chosen as",
        *decision.keys[0],
        _value_name(decision),
        "less the best",
        *(title for _, title in shown),
    ]
    if len(decision.environments) > 1:
        header += ["mean regret", "largest regret"]
    return Table(
        header,
        rows,
        f"{decision.case}: options from the rows of the histories, "
        "re-evaluated with independent random numbers, which they have in "
        "common. Intervals: 95 %, noise of light and field, paired where two "
        "options are compared.",
    )


def _tabulate_regret(decision: Decision) -> Table:
    candidates = range(len(decision.names))
    rows = [
        [
            name,
            f"{decision.weights[e]:.3f}",
            *(_text(decision.regret(c, e)) for c in candidates),
        ]
        for e, name in enumerate(decision.environments)
    ]
    return Table(
        ["environment", "weight", *decision.names],
        rows,
        f"Regret: {_worth_name(decision)} of the best listed option of an "
        "environment less that of each option. Paired 95 % intervals, each by "
        "itself.",
    )


def _text(value: Estimate) -> str:
    if value.standard_error == 0:
        return f"{value.mean:.4g}"
    return value.interval_text().replace("-", "\N{MINUS SIGN}")
