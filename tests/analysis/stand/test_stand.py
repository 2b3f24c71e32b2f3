# SPDX-License-Identifier: Apache-2.0
"""Plants evaluated in Python have bitwise the results of the program."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
import time
import tomllib
from concurrent.futures import ProcessPoolExecutor
from datetime import date
from datetime import time as clock
from multiprocessing import get_context
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np
import pytest
import xarray
from real_program import CAMPAIGNS, executable, run_with, write_campaign

import ideotype
from ideotype.live.opened import open_place

TOP = CAMPAIGNS.parent
AMES = CAMPAIGNS / "ames_quick.toml"
FAST = {"light.paths": 64, "light.tolerance": 0, "final.paths": 64}


@pytest.fixture(scope="module")
def stand() -> ideotype.Stand:
    return ideotype.Stand.from_campaign(AMES, settings=FAST)


@pytest.fixture(scope="module")
def history(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("stand")
    campaign = write_campaign(folder, 2)
    subprocess.run(
        [executable(), "run", campaign, "--out", folder],
        check=True,
        capture_output=True,
    )
    return next(folder.glob("*/*.h5"))


def test_rows_of_a_history_are_reproduced_bitwise(history: Path) -> None:
    stand = ideotype.Stand.from_history(history)
    rows = ideotype.open(history)
    size = rows.sizes["row"] // 2
    for generation in (0, 1):
        generation_rows = rows.isel(
            row=slice(generation * size, (generation + 1) * size)
        )
        again = stand.evaluate(
            generation_rows.genome.values, generation=generation
        )
        assert (
            list(again.message.values) == [""] * generation_rows.sizes["row"]
        )
        for name in stand.quantities.name:
            np.testing.assert_array_equal(
                again[name].values, generation_rows[name].values, err_msg=name
            )
    finalists = ideotype.open(history, "final")
    again = stand.evaluate(finalists.genome.values, final=True)
    np.testing.assert_array_equal(
        again.objective_by_randomisation.values,
        finalists.objectives_by_randomisation.values,
    )


def test_rows_with_varied_keys_are_reproduced_bitwise(
    tmp_path: Path,
) -> None:
    keys = '[[search.keys]]\nkey = "spacing.row"\nrange = [0.5, 1.0]\n'
    path = run_with(tmp_path, keys)
    rows = ideotype.open(path)
    half = rows.isel(row=slice(0, rows.sizes["row"] // 2))
    genomes = half.genome.values
    assert len(set(genomes[:, -1])) > 1
    stand = ideotype.Stand.from_history(path)
    again = stand.evaluate(genomes, generation=0)
    for name in stand.quantities.name:
        np.testing.assert_array_equal(again[name].values, half[name].values)
    bare = stand.evaluate(genomes[1, :-1], ["lai"], generation=0)
    assert bare.lai[0] != again.lai[1]
    light = [
        stand.light_at(x, 0.1).fraction.values
        for x in (genomes[1], genomes[1, :-1])
    ]
    assert (light[0] != light[1]).any()
    assert len(stand.mesh(genomes[1]).faces) > 0
    with ideotype.open_history(path) as opened:
        best = opened.best()
    assert best is not None
    found = open_place(str(path))
    assert found.conditions.row == pytest.approx(best.row.genome[0, -1])
    done = subprocess.run(
        [executable(), "export", path, "--best", "--to", tmp_path / "b.toml"],
        check=True,
        capture_output=True,
        text=True,
    )
    setting = f"spacing.row={float(best.row.genome[0, -1])!r}"
    assert f"evaluate this plant with --set {setting}" in done.stderr
    assert setting in (tmp_path / "b.toml").read_text().splitlines()[0]


def test_an_evaluation_agrees_bitwise_with_the_command_line(
    stand: ideotype.Stand,
) -> None:
    said = subprocess.run(
        [
            executable(),
            *("evaluate", AMES, "--json", "--set", "seed=7"),
            *("--set", "final.paths=64"),
        ],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    quantities = json.loads(said)["quantities"]
    found = stand.evaluate(stand.baseline, seed=7, final=True)
    for name, value in quantities.items():
        assert found[name].item() == value["mean"], name


@pytest.mark.parametrize("tolerance", [None, 0.01])
def test_evaluations_agree_bitwise_with_a_comparison(
    stand: ideotype.Stand, tmp_path: Path, tolerance: float | None
) -> None:
    longer = stand.baseline
    longer[0] *= 1.1
    (tmp_path / "longer.toml").write_text(stand.crop_file(longer))
    said = subprocess.run(
        [
            executable(), "compare", AMES, tmp_path / "longer.toml",
            *("--under", AMES, "--json", "--seed", "7"),
            *("--set", "final.paths=64"),
            *(("--tolerance", str(tolerance)) if tolerance else ()),
        ],
        check=True,
        capture_output=True,
        text=True,
    ).stdout  # fmt: skip
    report = json.loads(said)
    evaluated = stand.evaluate(
        [stand.baseline, longer], seed=7, final=True, tolerance=tolerance
    )
    for name, value in (report["quantities"] | report["profiles"]).items():
        for part, array in (
            ("mean", evaluated[name]),
            ("standard_error", evaluated.get(f"{name}_standard_error")),
        ):
            if array is not None:
                np.testing.assert_array_equal(
                    array.values, [case[0] for case in value[part]], name
                )


def test_evaluate_one_agrees_with_evaluate(
    stand: ideotype.Stand,
) -> None:
    """Numbers are in the order of quantities and of their axes."""
    request: dict[str, Any] = {"seed": 5, "generation": 3, "tolerance": 0.02}
    evaluated = stand.evaluate_one(stand.baseline, **request)
    labelled = stand.evaluate(stand.baseline, **request).isel(plant=0)
    begin = 0
    for _, name, axes in stand.quantities[["name", "axes"]].itertuples():
        shape = tuple(len(stand.axes[axis]) for axis in axes)
        end = begin + int(np.prod(shape))
        values = evaluated.numbers[begin:end, 0].reshape(shape)
        np.testing.assert_array_equal(values, labelled[name], err_msg=name)
        begin = end
    assert begin == len(evaluated.numbers)
    (objective,) = stand.objectives
    assert evaluated.objectives.shape == (1, 2)
    assert evaluated.objectives[0, 0] == labelled[objective]
    assert (
        evaluated.objectives[0, 1] == labelled[f"{objective}_standard_error"]
    )
    assert evaluated.violation == labelled.violation
    with pytest.raises(ideotype.Error, match="genomes are an array"):
        stand.evaluate_one(stand.baseline[:-1])
    with pytest.raises(ideotype.Error, match="seed"):
        stand.evaluate_one(stand.baseline, seed=-1)


def test_results_of_a_stand_do_not_depend_on_threads(
    stand: ideotype.Stand,
) -> None:
    rng = np.random.default_rng(1)
    lower, upper = stand.bounds
    genomes = rng.uniform(lower, upper, (6, len(lower)))
    alone = stand.evaluate(genomes, threads=1)
    xarray.testing.assert_identical(alone, stand.evaluate(genomes, threads=4))
    assert alone.sizes["plant"] == 6
    assert len(set(alone.absorbed_par.values)) == 6


def test_evaluations_release_the_interpreter_lock(
    stand: ideotype.Stand,
) -> None:
    done = threading.Event()
    counted = 0

    def count() -> None:
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    stand.evaluate(stand.baseline, tolerance=0.0005, threads=1)
    done.set()
    counter.join()
    # If evaluations held the interpreter lock, the count would be one or two.
    assert counted > 5


def test_free_genes_are_accepted_as_a_genome() -> None:
    breeding = {"traits": [{"name": "a", "free": ["azimuth"]}]}
    settings = FAST | breeding | {"light.randomisations": np.int64(4)}
    stand = ideotype.Stand.from_campaign(AMES, settings=settings)
    genes = stand.genes
    free = genes.is_free.values
    assert "randomisations = 4" in stand.campaign
    assert free.sum() == 10 and set(genes.trait[free]) == {"azimuth"}
    short = stand.start + 5
    whole = stand.baseline
    whole[free] = short
    xarray.testing.assert_identical(
        stand.evaluate(short), stand.evaluate([whole])
    )


FAST_TEXTS = [f"{key}={value}" for key, value in FAST.items()]


def test_errors_meet_the_tolerance_over_independent_seeds(
    stand: ideotype.Stand,
) -> None:
    results = [
        stand.evaluate(
            stand.baseline, ["absorbed_par"], tolerance=0.005, seed=seed
        )
        for seed in (1, 2)
    ]
    for result in results:
        error = result.absorbed_par_standard_error / result.absorbed_par
        assert error.item() < 0.008
        assert set(result.data_vars) == {
            "absorbed_par",
            "absorbed_par_standard_error",
            "violation",
            "message",
            "objective_by_randomisation",
        }
    first, second = (each.absorbed_par.item() for each in results)
    assert first != second
    assert first == pytest.approx(second, rel=0.04)


def test_a_campaign_is_built_from_dictionaries() -> None:
    tables = {
        "name": "built",
        "site": [
            {
                "name": "ames",
                "latitude": 42.03,
                "longitude": -93.63,
                "utc_offset": -5,
            }
        ],
        "day": [
            {
                "name": "july",
                "date": date(2021, 7, 1),
                "start": clock(7),
                "end": clock(20),
            }
        ],
        "spacing": [{"name": "wide", "row": 0.762, "plant": 0.1524}],
        "plant": {"baseline": "crops/maize.toml"},
        "light": {"paths": 64},
    }
    stand = ideotype.Stand(tables, folder=CAMPAIGNS)
    light = stand.evaluate(stand.baseline)
    assert 5 < light.absorbed_par.item() < 12
    again = ideotype.Stand(tables, folder=CAMPAIGNS, settings={"seed": 3})
    assert again.evaluate(again.baseline).absorbed_par != light.absorbed_par


def test_a_crop_without_photosynthesis_is_evaluated_with_a_warning() -> None:
    crop = tomllib.loads((CAMPAIGNS / "crops" / "maize.toml").read_text())
    tables = tomllib.loads(AMES.read_text())
    tables["objective"] = {"maximise": "net_assimilation"}
    stated = ideotype.Stand({**tables, "plant": {"baseline": crop}})
    assert stated.warnings == []
    del crop["photosynthesis"]
    bare = ideotype.Stand({**tables, "plant": {"baseline": crop}})
    (warning,) = bare.warnings
    assert 'the crop "b73" has no [photosynthesis]' in warning
    assert 'model = "farquhar" for a C3 crop' in warning


def test_a_baseline_outside_its_bounds_is_evaluated_with_a_warning() -> None:
    settings = ["plant.bounds={length=[1.05,1.1]}"]
    narrow = ideotype.Stand.from_campaign(AMES, settings=settings)
    assert "outside the" in "".join(narrow.warnings)
    wide = ideotype.Stand.from_campaign(AMES)
    light, expected = (
        stand.evaluate(wide.baseline, ["lai", "absorbed_par"], tolerance=0.05)
        for stand in (narrow, wide)
    )
    assert light.absorbed_par.item() == expected.absorbed_par.item()


def test_a_table_of_settings_replaces_the_table_of_the_file() -> None:
    path = CAMPAIGNS / "agrivoltaic.toml"

    def resolved(settings: dict[str, Any]) -> dict[str, Any]:
        stand = ideotype.Stand.from_campaign(path, settings=settings)
        return tomllib.loads(stand.campaign)

    before = resolved({})
    assert before["constraints"]["lai"] == [0, 5]
    assert before["field"]["variation"]["insertion_angle"] == 11
    after = resolved({"constraints": {}, "field.variation": {}})
    assert after["constraints"]["lai"] != [0, 5]
    assert "variation" not in after["field"]
    assert after["field"]["rows"] == 8

    small = {"rows": 8, "plants": 4}
    whole = resolved({"field.jitter": 0, "field": small})["field"]
    assert (whole["plants"], whole["jitter"]) == (4, 10)
    assert "variation" not in whole
    single = resolved({"field": small, "field.jitter": 0})["field"]
    assert (single["plants"], single["jitter"]) == (4, 0)


def test_too_few_paths_for_the_objective_give_a_warning(
    tmp_path: Path,
) -> None:
    campaign = write_campaign(tmp_path, 2)
    tables = """
[photosynthesis]
[objective]
maximise = "net_assimilation"
[sensitivity]
method = "morris"
samples = 4
"""
    campaign.write_text(campaign.read_text() + tables)
    warnings = ideotype.Stand.from_campaign(campaign).warnings
    warning = "too few for this objective"
    assert [warning in each for each in warnings] == [True]
    for command in (["check"], ["sensitivity", "--out", str(tmp_path)]):
        name, *options = command
        done = subprocess.run(
            [executable(), name, campaign, *options],
            capture_output=True,
            text=True,
            check=True,
        )
        assert warnings[0] in done.stderr
    enough = ideotype.Stand.from_campaign(
        campaign, settings={"light.paths": 65536}
    )
    assert enough.warnings == []


def test_all_problems_of_a_campaign_are_reported_together(
    tmp_path: Path,
) -> None:
    text = AMES.read_text().replace("latitude", "lattitude")
    path = tmp_path / "typo.toml"
    path.write_text(text + "\n[ligth]\npaths = 1\n")
    with pytest.raises(ideotype.InputError) as caught:
        ideotype.Stand.from_campaign(path)
    problems = caught.value.problems
    assert len(problems) >= 2
    assert all(each.file == str(path) and each.line for each in problems)
    assert {(each.key, each.code) for each in problems} >= {
        ("site.lattitude", "unknown_key"),
        ("ligth", "unknown_key"),
    }
    assert "did you mean 'latitude'" in str(caught.value)
    said = subprocess.run(
        [executable(), "check", path],
        capture_output=True,
        text=True,
        check=False,
    ).stderr
    assert str(caught.value).splitlines()[0] in said


@pytest.mark.parametrize(
    ("genomes", "words"),
    [
        (np.zeros(3), r"give \[plants, \d+\] for all genes"),
        (np.zeros((2, 2, 2)), "genomes are an array of"),
        (np.zeros((0, 40)), "of one plant or more"),
        ("nan", r"genomes\[0, 4\] is nan"),
    ],
)
def test_invalid_genomes_are_errors(
    stand: ideotype.Stand, genomes: object, words: str
) -> None:
    if isinstance(genomes, str):
        genomes = stand.baseline
        genomes[4] = np.nan
    with pytest.raises(ideotype.Error, match=words):
        stand.evaluate(genomes)  # type: ignore[arg-type]


def test_invalid_arguments_of_a_stand_are_errors(
    stand: ideotype.Stand,
) -> None:
    with pytest.raises(ideotype.Error, match="no quantity 'water'; use"):
        stand.evaluate(stand.baseline, ["water"])
    with pytest.raises(ideotype.Error, match="did you mean 'absorbed_par'"):
        stand.evaluate(stand.baseline, ["absorbed_parr"])
    with pytest.raises(ideotype.Error, match="tolerance is 0.3"):
        stand.evaluate(stand.baseline, tolerance=0.3)
    for name in "seed", "generation", "threads":
        with pytest.raises(
            ideotype.Error, match=f"{name} is 1.5; use a whole"
        ):
            stand.evaluate(stand.baseline, **{name: 1.5})
    with pytest.raises(ideotype.Error, match="threads is 0; use a whole"):
        stand.evaluate(stand.baseline, threads=0)
    with pytest.raises(ideotype.Error, match="cannot read"):
        ideotype.Stand.from_campaign("gone.toml")
    with pytest.raises(ideotype.Error, match="no case 99"):
        ideotype.Stand.from_campaign(AMES, case=99)
    with pytest.raises(ideotype.Error, match="avx1024"):
        ideotype.Stand.from_campaign(AMES, isa="avx1024")


def test_an_impossible_plant_is_a_failed_row(
    stand: ideotype.Stand,
) -> None:
    huge = stand.baseline
    huge[0] = 1e300
    light = stand.evaluate([stand.baseline, huge], ["absorbed_par"])
    assert light.message.values[0] == ""
    assert np.isfinite(light.absorbed_par.values[0])
    if light.message.values[1]:
        assert np.isnan(light.absorbed_par.values[1])


def test_the_crop_file_of_a_plant_reproduces_it(
    stand: ideotype.Stand, tmp_path: Path
) -> None:
    plant = stand.baseline
    plant[0] *= 1.1
    (tmp_path / "longer.toml").write_text(stand.crop_file(plant))
    settings = [*FAST_TEXTS, f'plant.baseline="{tmp_path}/longer.toml"']
    again = ideotype.Stand.from_campaign(AMES, settings=settings)
    np.testing.assert_array_equal(again.baseline, plant)


def test_a_copy_in_another_process_evaluates_bitwise_alike(
    stand: ideotype.Stand,
) -> None:
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        there = pool.submit(_evaluated, stand).result()
    assert there == _evaluated(stand)


def _evaluated(stand: ideotype.Stand) -> bytes:
    found = stand.evaluate(stand.baseline)
    return found.objective_by_randomisation.values.tobytes()


def test_histories_are_read_without_the_compiled_module(history: Path) -> None:
    code = f"""
import sys
sys.modules["ideotype._core"] = None
import ideotype
print(ideotype.open({str(history)!r}).sizes["row"])
import ideotype.report.report
try:
    ideotype.Stand
except ideotype.Error as error:
    print(error)
"""
    said = subprocess.run(
        [sys.executable, "-c", code],
        check=True,
        capture_output=True,
        text=True,
    ).stdout.splitlines()
    assert int(said[0]) > 0
    assert "needs the compiled module" in said[1]


def test_the_pure_python_wheel_is_for_any_system(tmp_path: Path) -> None:
    subprocess.run(
        [
            *(sys.executable, "-m", "pip", "wheel", "--no-build-isolation"),
            *("--no-deps", "--quiet", "-w", tmp_path, TOP),
        ],
        env=os.environ | {"IDEOTYPE_PURE_PYTHON": "1"},
        check=True,
    )
    (wheel,) = tmp_path.iterdir()
    assert wheel.name.endswith("-py3-none-any.whl")
    with ZipFile(wheel) as archive:
        names = archive.namelist()
    assert "ideotype/report/page/page.html" in names
    assert not [name for name in names if name.endswith(".so")]


STARVED = """
import resource, sys
import ideotype

stand = ideotype.Stand.from_campaign(
    sys.argv[1],
    settings={"light.paths": 16, "field.rows": 30, "field.plants": 30},
)
before = resource.getrlimit(resource.RLIMIT_DATA)
resource.setrlimit(resource.RLIMIT_DATA, (20_000_000, before[1]))
try:
    stand.evaluate(stand.baseline)
except MemoryError as error:
    sys.exit(7)
except RuntimeError as error:
    sys.exit(7 if "not enough memory" in str(error) else str(error))
finally:
    # The ray tracer starts threads to release its memory.
    resource.setrlimit(resource.RLIMIT_DATA, before)
"""


def test_a_lack_of_memory_is_not_recorded_as_a_result() -> None:
    done = subprocess.run(
        [sys.executable, "-c", STARVED, AMES],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 7, done.stderr
