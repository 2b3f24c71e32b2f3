# SPDX-License-Identifier: Apache-2.0
"""The user's own plants are shown next to the plants of a case."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from made_campaign import resolved
from made_history import MadeHistory

import ideotype
from ideotype.history.case import Case
from ideotype.history.study import open_study
from ideotype.report.own_plants import evaluate_own_plants
from ideotype.report.scene import build_plants, make_scene

PLANTS = Path(__file__).parents[3] / "campaigns" / "plants"


@pytest.fixture(scope="module")
def case(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Case]:
    path = tmp_path_factory.mktemp("own") / "case_r1.h5"
    attributes = {"case": "ames_0807_762x152_all_r1", "site": "ames"}
    made = MadeHistory(path, attributes=attributes, resolved=resolved())
    made.evolve(1)
    made.finish()
    made.close()
    with open_study(path) as study:
        (found,) = study.cases()
        yield found


def test_measured_and_digitised_plants_have_their_own_shape(
    case: Case, tmp_path: Path
) -> None:
    stand = ideotype.Stand.from_history(case.best_history.path, same_isa=False)
    mesh = stand.mesh(stand.baseline)
    names = list(dict.fromkeys(mesh.groups))
    digitised = tmp_path / "digitised.obj"
    with digitised.open("w") as file:
        file.writelines("v {} {} {}\n".format(*x) for x in mesh.vertices)
        for name in names:
            if not name.startswith("leaf"):
                continue
            file.write(f"g {name}\n")
            file.writelines(
                "f {}\n".format(" ".join(str(i + 1) for i in face))
                for face, group in zip(mesh.faces, mesh.groups)
                if group == name
            )
    measured = PLANTS / "Dea_2008.csv"
    found = list(evaluate_own_plants(case, [measured, digitised]))
    rows = [
        line
        for line in measured.read_text().splitlines()
        if line[:1].isdigit()
    ]
    for own, count in zip(found, (len(rows), 10), strict=True):
        leaves = {x for x in own.mesh.groups if x.startswith("leaf")}
        taken = own.profile("absorbed_by_leaf")
        assert len(leaves) == len(taken.values) == count
        assert taken.values.sum() == pytest.approx(own.objective.mean)
        assert 0 < own.objective.standard_error < 0.1 * own.objective.mean
    # The digitised plant is the baseline, so that both have equal leaves.
    whole = sum(mesh.area(name) for name in names if name.startswith("leaf"))
    again = sum(
        found[1].mesh.area(x)
        for x in {*found[1].mesh.groups}
        if x.startswith("leaf")
    )
    assert again == pytest.approx(whole, rel=0.05)


def test_the_view_has_them_after_those_of_the_case(case: Case) -> None:
    plants = build_plants(case, [PLANTS / "Dea_2008.csv"])
    (scene,) = json.loads(make_scene([(case, plants)]))["cases"]
    *_, title = [plant["title"] for plant in scene["plants"]]
    assert title.startswith("Dea")
    colours = scene["quantities"][0]["values"][-1]
    known = [x for x in colours if x is not None]
    assert np.min(known) > 0
    assert len(scene["plants"]) == len(scene["quantities"][0]["values"])


def test_unreadable_plants_are_reported(case: Case, tmp_path: Path) -> None:
    with pytest.raises(ideotype.Error, match="nowhere"):
        list(evaluate_own_plants(case, [tmp_path / "nowhere.obj"]))
