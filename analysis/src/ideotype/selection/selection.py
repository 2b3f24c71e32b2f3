# SPDX-License-Identifier: Apache-2.0
"""From the data of lines and a campaign to an index and a programme."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pandas as pd

from ..errors import Error
from . import results
from .covariances import Matrix
from .field import Field
from .genetics import Population
from .genome import Founders, draw_founders, read_founders
from .index import Index, intensity, make_index
from .programme import EXHAUSTED, Method, Plan, World, repeat
from .reach import (
    Reach,
    choose_crosses,
    evaluate_ceiling,
    find_reach,
    mean_gains,
    rank_lines,
    set_targets,
)
from .surface import (
    GRADIENT_STEP,
    TRUSTED,
    Surface,
    explore,
    paired_difference,
)
from .traits import yield_trait

Progress = Callable[[int, int, str], object]

FEW = 5
"""Errors of gains of fewer repeats are not reliable."""

_MEAN = "mean"
"""The name of the mean over cases."""


@dataclass(frozen=True)
class Options:
    """The choices of a selection."""

    plan: Plan = field(default_factory=Plan)
    methods: tuple[Method, ...] = tuple(Method)
    repeats: int = 3
    """Programmes of each method, with different founders and errors."""
    draws: int = 16
    """Draws of fields and light of each plant of the gradient."""
    line_draws: int = 8
    """Those of each line, cross and target, and of the gradients at the means
    of later cycles."""
    is_traced: bool = True
    """Whether the value of each genotype of the programme is evaluated with
    traced light, instead of by the quadratic approximation."""
    yield_heritability: float = math.nan
    """Of a plot; NaN: that of the trial, or 0.12 (E)."""
    seed: int = 1


@dataclass(frozen=True)
class Selection:
    """The results of a selection."""

    population: Population
    """The traits that are measures of plants."""
    surface: Surface
    indices: tuple[Index, ...]
    """Of each case, and of their mean as the last."""
    reaches: dict[str, Reach]
    """By method."""
    tables: dict[str, pd.DataFrame]
    """The tables of `results.COLUMNS`."""
    objective: str
    notes: tuple[str, ...]

    @property
    def index(self) -> Index:
        """The index for the mean over cases."""
        return self.indices[-1]


def digest_inputs(*parts: object) -> str:
    """Returns a digest of the inputs of a selection; files count by their
    content."""
    digest = hashlib.sha256()
    for part in parts:
        if isinstance(part, Path) and part.is_file():
            content = part.read_bytes()
        else:
            content = repr(part).encode()
        digest.update(len(content).to_bytes(8) + content)
    return digest.hexdigest()


def select(
    population: Population,
    under: Field,
    options: Options = Options(),
    *,
    history: str | Path | None = None,
    markers: str | Path | None = None,
    effects: str | Path | None = None,
    on_progress: Progress = lambda done, count, part: None,
) -> Selection:
    """Computes index, programme and reach.

    population: genetic parameters; traits that are no measures of plants give
        the heritability of yield at most.
    under: the field of the measures of plants of the population.
    history: history of a search with the same objective, for the ceiling.
    markers, effects: files of the user's lines, as for read_founders().

    Raises Error if an evaluation fails or an input is invalid."""
    if (markers is None) != (effects is None):
        raise Error("markers and effects belong together; give both files")
    plants = population.of_plants()
    plan = options.plan

    founders = None
    if markers is not None and effects is not None:
        founders = read_founders(markers, effects, plants)
        if len(founders.names) <= plan.parents:
            raise Error(
                f"{markers}: {len(founders.names)} lines are too few for "
                f"{plan.parents} parents; select fewer"
            )

    def tell(part: str) -> Callable[[int, int], object]:
        return lambda done, count: on_progress(done, count, part)

    surface = explore(
        under, plants, draws=options.draws, on_progress=tell("gradient")
    )
    cases = [(name, surface.of_case(c)) for c, name in enumerate(under.cases)]
    surfaces = [*(cases if len(cases) > 1 else ()), (_MEAN, surface)]
    strength = intensity(plan.parents, plan.lines)
    indices = tuple(
        make_index(
            plants, part, plots=plan.plots, strength=strength, case=name,
            seed=options.seed,
        )
        for name, part in surfaces
    )  # fmt: skip
    tables = {
        "traits": results.traits_table(population),
        "covariances": results.covariances_table(population),
        "gradient": results.gradient_table(plants, surfaces),
        "curvature": results.curvature_table(plants, surface),
        "index": results.index_table(plants, indices),
        "response": results.response_table(plants, indices, surfaces),
    }
    if len(plants.lines) > 1:
        tables["lines"] = rank_lines(
            under, plants, options.line_draws, tell("lines")
        )
        tables["crosses"] = choose_crosses(
            under, plants, surface,
            count=plan.crosses, draws=options.line_draws,
        )  # fmt: skip
    runs = _run(population, plants, under, surface, options, founders, tell)
    ceiling = evaluate_ceiling(under, history, plants) if history else None
    reaches = {
        str(method): find_reach(runs, str(method), ceiling)
        for method in options.methods
    }
    tables["programme"] = _programme_table(
        runs, plants, under, surface, options
    )
    tables["reach"] = _reach_table(reaches)
    best = str(
        Method.smith_hazel
        if Method.smith_hazel in options.methods
        else options.methods[0]
    )
    last = runs[(runs.method == best) & (runs.cycle == plan.cycles)]
    target = np.array([last[str(i)].mean() for i in range(len(plants.traits))])
    tables["targets"] = set_targets(
        under, plants, target, draws=options.line_draws
    )
    return Selection(
        plants,
        surface,
        indices,
        reaches,
        tables,
        under.objective,
        (*population.notes, *_notes(tables, options)),
    )


def _run(
    population: Population,
    plants: Population,
    under: Field,
    surface: Surface,
    options: Options,
    founders: Founders | None,
    tell: Callable[[str], Callable[[int, int], object]],
) -> pd.DataFrame:
    """Runs the programmes of all methods and repeats."""
    heritability = options.yield_heritability
    if math.isnan(heritability):
        heritability = _yield_heritability(population)
    scale = abs(surface.objective.mean())
    step = surface.step

    def traced(values: Matrix, draw: int, draws: int = 1) -> Matrix:
        objective = under.evaluate(values, draws, first=draw)
        return np.asarray((100 * objective / scale).mean(axis=(1, 2)))

    def traced_slope(mean: Matrix, cycle: int) -> Matrix:
        if cycle == 0:
            return surface.gradient
        offsets = GRADIENT_STEP * np.diag(step)
        plants = np.vstack([mean + offsets, mean - offsets])
        # Draw 0 is only for the measurement of gains.
        above, below = traced(plants, 1, options.line_draws).reshape(2, -1)
        return np.divide(
            above - below, 2 * GRADIENT_STEP * step,
            out=np.zeros(len(step)), where=step > 0,
        )  # fmt: skip

    def approximate(values: Matrix, draw: int) -> Matrix:
        return surface.value(values)

    def approximate_slope(mean: Matrix, cycle: int) -> Matrix:
        return surface.slope(mean)

    lines = len(plants.lines)
    count = lines if lines > options.plan.parents else options.plan.lines

    def make_world(number: int) -> World:
        random = np.random.default_rng([options.seed, number, 17])
        return World(
            founders or draw_founders(plants, count, random),
            plants.genetic,
            plants.error,
            traced if options.is_traced else approximate,
            heritability,
            traced_slope if options.is_traced else approximate_slope,
        )

    return repeat(
        make_world,
        options.plan,
        options.methods,
        options.repeats,
        options.seed,
        tell("programme"),
    )


def _yield_heritability(population: Population) -> float:
    """Returns the heritability of a plot of the trial's yield, or the usual
    one."""
    for i, trait in enumerate(population.traits):
        if not trait.measure:
            return float(population.heritability[1, i])
    return yield_trait().heritability[1]


def _programme_table(
    runs: pd.DataFrame,
    plants: Population,
    under: Field,
    surface: Surface,
    options: Options,
) -> pd.DataFrame:
    """Returns the table `programme`: means over repeats, with the plant of the
    mean traits of each cycle evaluated with traced light."""
    names = [str(i) for i in range(len(plants.traits))]
    rows = []
    for method in options.methods:
        own = runs[runs["method"] == str(method)]
        first = own[own.cycle == 0]
        spread = first.set_index("repeat")["variance"]
        means = zip(*mean_gains(runs, str(method)), strict=True)
        for (cycle, part), (gain, error) in zip(own.groupby("cycle"), means):
            variance = part.set_index("repeat")["variance"] / spread
            rows.append(
                {
                    "method": str(method),
                    "cycle": int(cycle),
                    "gain": gain,
                    "gain_standard_error": error,
                    "variance": variance.mean(),
                    "inbreeding": part["inbreeding"].mean(),
                    "accuracy": part["accuracy"].mean(),
                    "plots": options.plan.lines * options.plan.plots * cycle,
                    "cost": options.plan.cost(method, int(cycle)),
                    **{name: part[name].mean() for name in names},
                }
            )
    table = pd.DataFrame(rows)
    means = table[names].to_numpy()
    values = under.evaluate(
        np.vstack([plants.mean, means]), options.line_draws
    )
    gains = [paired_difference(plant, values[0]) for plant in values[1:]]
    place = table.columns.get_loc("variance")
    table.insert(place, "mean_plant", [gain for gain, _ in gains])
    table.insert(
        place + 1, "mean_plant_standard_error", [error for _, error in gains]
    )
    table.insert(place + 2, "mean_plant_approximate", surface.value(means))
    for name, trait in zip(names, plants.traits):
        table[name] *= trait.factor
    return table.rename(
        columns={n: t.label for n, t in zip(names, plants.traits)}
    )


def _reach_table(reaches: dict[str, Reach]) -> pd.DataFrame:
    rows = []
    for method, reach in reaches.items():
        half = reach.half_cycles
        rows.append(
            {
                "method": method,
                "ceiling": reach.ceiling,
                "ceiling_standard_error": reach.ceiling_standard_error,
                "gain": reach.curve[-1],
                "gain_standard_error": reach.curve_standard_error[-1],
                "cycles": len(reach.curve) - 1,
                "half_cycles": half if math.isfinite(half) else math.nan,
            }
        )
    return pd.DataFrame(rows)


def _notes(tables: dict[str, pd.DataFrame], options: Options) -> list[str]:
    """Returns remarks on the validity of the programme."""
    programme, targets = tables["programme"], tables["targets"]
    notes = []
    far = targets[targets["distance"].abs() > TRUSTED]
    if len(far):
        notes.append(
            f"targets of {', '.join(far['trait'])} are more than "
            f"{TRUSTED:g} genetic standard deviations from the mean, where "
            "few lines have been measured"
        )
    if not options.is_traced:
        apart = (
            programme["mean_plant_approximate"] - programme["mean_plant"]
        ).abs()
        worst = int(apart.argmax())
        notes.append(
            "genotypes have values of the quadratic approximation; for the "
            "mean plants of all cycles it differs from traced light by at most "
            f"{apart.iloc[worst]:.1f} % (method "
            f"{programme['method'].iloc[worst]}, cycle "
            f"{programme['cycle'].iloc[worst]})"
        )
    if options.repeats < FEW:
        notes.append(
            f"gains are means of {options.repeats} programmes, too few for "
            "reliable errors; more --repeats improve them"
        )
    for method, part in programme.groupby("method", sort=False):
        spent = part[part["variance"] < EXHAUSTED]
        if len(spent):
            notes.append(
                f"{method}: the genetic variance of the objective is exhausted "
                f"(below {EXHAUSTED:.0%} of the founders') in cycle "
                f"{spent['cycle'].iloc[0]}"
            )
    return notes
