# SPDX-License-Identifier: Apache-2.0
"""Lists the parts of the study with their scripts, for study.py."""

from __future__ import annotations

from dataclasses import dataclass

from shared import CAMPAIGNS


@dataclass(frozen=True)
class Part:
    question: str
    words: tuple[str, ...]
    """The script, or -m and a module, and its options; {folder} is the folder of the part, {study}
    the one of all parts."""
    short: tuple[str, ...] = ()
    """Further options of a short study."""


PARTS = {
    "interventions": Part(
        "Which single trait gains, with other organs and without?",
        ("interventions.py", "{folder}"),
        (
            *("--rough", "--fields", "4"),
            *("--evaluations", "72", "--seeds", "2"),
        ),
    ),
    "paper_table": Part(
        "How much can breeding gain?",
        (
            *("paper_table.py", "{folder}", "--search", "auto"),
            *("--figure", "{figures}/paper_table.png"),
        ),
        (
            *("--rough", "--objective", "absorbed_par"),
            *("--condition", "all", "azimuth", "angles", "widths"),
            *("7", "56p2", "15x3", "15x6"),
            *("--evaluations", "20", "--seeds", "1"),
        ),
    ),
    "paper_grain": Part(
        "How much grain can breeding gain?",
        (
            *("paper_table.py", "{folder}", "--search", "auto"),
            *("--objective", "grain_yield", "--evaluations", "1000"),
            *("--condition", "all", "7", "56p2", "15x6", "30x3"),
        ),
        (
            *("--rough", "--condition", "all"),
            *("--evaluations", "20", "--seeds", "1"),
        ),
    ),
    "plants_differ": Part(
        "Does the search need within-line variation?",
        ("plants_differ.py", "--figure", "{figures}/plants_differ.png"),
        ("--under", str(CAMPAIGNS / "ames_quick.toml"), "--plants", "2"),
    ),
    "uniform_stands": Part(
        "How good are plants optimised in uniform stands where plants differ?",
        (
            *("paper_table.py", "{folder}", "--search", "auto", "--alike"),
            *("--condition", "all", "15x3", "--other-seeds", "3"),
        ),
        (
            *("--rough", "--objective", "absorbed_par", "--condition", "all"),
            *("--evaluations", "20", "--seeds", "1", "--other-seeds", "1"),
        ),
    ),
    "feasible": Part(
        "What does it cost to stay within measured maize lines?",
        ("feasible.py", "{folder}"),
        ("--rough", "--evaluations", "48"),
    ),
    "validation": Part(
        "Do the numbers agree with the field?",
        ("-m", "ideotype.tools.validate", "-o", "{figures}/facts"),
        ("--seeds", "2"),
    ),
    "k_plastic": Part(
        "Does plasticity explain extinction at high density?",
        ("plasticity.py", "{folder}", "--only", "extinction"),
        ("--rough",),
    ),
    "erect_plastic": Part(
        "From which leaf area does an erect top pay in plants that respond?",
        ("plasticity.py", "{folder}", "--only", "erect"),
        ("--rough",),
    ),
    "densities": Part(
        "What does one plant for several densities cost?",
        ("plasticity.py", "{folder}", "--only", "densities", "--seeds", "3"),
        ("--rough", "--evaluations", "40", "--seeds", "1"),
    ),
    "narrow_plastic": Part(
        "What do plants that respond to density gain in narrow rows?",
        ("plasticity.py", "{folder}", "--only", "narrow", "--seeds", "3"),
        ("--rough", "--evaluations", "40", "--seeds", "1"),
    ),
    "erect_tops": Part(
        "When does an erect top pay?",
        (
            *("erect_tops.py", "{folder}"),
            *("--limit", "area", "carbon", "--latitudes", "7", "42"),
            *("--figure", "{figures}/erect_tops.png"),
        ),
        (
            *("--rough", "--light", "clear", "--limit", "area"),
            *("--densities", "4", "20", "--latitudes", "42"),
            *("--evaluations", "120", "--seeds", "2"),
        ),
    ),
    "claims": Part(
        "Do the claims of arXiv:2512.06064 hold?",
        ("claims.py", "{folder}", "--table", "{study}/paper_table"),
        (
            *("--set-up", "stand, absorbed PAR"),
            *("--evaluations", "20", "--seeds", "1", "--rough"),
        ),
    ),
    "what_matters": Part(
        "Which traits matter?",
        (
            *("what_matters.py", "{folder}", "--seeds", "4"),
            *("--figure", "{figures}/what_matters.png"),
        ),
        (
            *("--rough", "--only", "absorbed_par", "--samples", "4"),
            *("--evaluations", "40", "--seeds", "1", "--draws", "2"),
        ),
    ),
    "physiology": Part(
        "Do traits of architecture matter beside those of physiology?",
        ("physiology.py", "{folder}"),
        ("--rough", "--samples", "4"),
    ),
    "selection_grain": Part(
        "What grain does selection among lines reach in five cycles?",
        (
            *("select_panel.py", "{folder}", "--only", "grain"),
            *("--figure", "{figures}/select_grain.png"),
        ),
        ("--rough",),
    ),
    "selection_carbon": Part(
        "What carbon does selection among lines reach in five cycles?",
        ("select_panel.py", "{folder}", "--only", "carbon"),
        ("--rough",),
    ),
    "over_draws": Part(
        "Does a plant bred over draws of uncertain parameters do better?",
        ("calibration.py", "{folder}", "--only", "bred"),
        ("--rough",),
    ),
    "robust": Part(
        "Does one plant suit five latitudes?",
        (
            *("robust.py", "{folder}", "--seeds", "3"),
            *("--figure", "{figures}/robust.png"),
        ),
        (
            *("--rough", "--latitudes", "7", "56.2"),
            *("--evaluations", "20", "--seeds", "1"),
        ),
    ),
    "front": Part(
        "How much leaf area does a season's carbon need?",
        ("fronts.py", "{folder}", "--figure", "{figures}/front.png"),
        ("--rough", "--generations", "2", "--seeds", "1"),
    ),
    "robust_growing": Part(
        "Does one plant suit five latitudes where plants grow?",
        ("robust.py", "{folder}", "--growing", "--evaluations", "400"),
        ("--rough", "--latitudes", "7", "56.2", "--evaluations", "20"),
    ),
    "traits_growing": Part(
        "Which traits matter where plants grow?",
        (
            *("what_matters.py", "{folder}", "--growing"),
            *("--only", "carbon_balance", "--samples", "256"),
            *("--evaluations", "400", "--seeds", "4"),
        ),
        ("--rough", "--samples", "4", "--evaluations", "20", "--seeds", "1"),
    ),
    "front_growing": Part(
        "How much leaf area does the carbon of a growing season need?",
        (
            *("fronts.py", "{folder}", "--growing"),
            *("--generations", "40", "--seeds", "1"),
        ),
        ("--rough", "--generations", "2"),
    ),
    "nitrogen": Part(
        "How much leaf nitrogen does a season's carbon need?",
        ("nitrogen.py", "{folder}"),
        ("--rough", "--evaluations", "24", "--seeds", "1"),
    ),
    "front_water": Part(
        "How much water does the carbon of a dry month need?",
        (
            *("fronts.py", "{folder}", "--water"),
            *("--generations", "40", "--seeds", "2"),
            *("--figure", "{figures}/front_water.png"),
        ),
        ("--rough", "--generations", "2"),
    ),
    "water": Part(
        "Does more carbon need more water?",
        (
            *("water_bred.py", "{folder}"),
            *("--evaluations", "300", "--seeds", "4"),
        ),
        ("--rough", "--only", "strip", "--evaluations", "12", "--seeds", "1"),
    ),
    "grain_ames": Part(
        "How much grain does a rain-fed field bear?",
        ("drought.py", "{folder}", "--only", "ames"),
        ("--seeds", "2"),
    ),
    "grain_shade": Part(
        "What do shade and modules cost in grain?",
        ("drought.py", "{folder}", "--only", "shade"),
        ("--seeds", "2"),
    ),
    "growth_best": Part(
        "Does the search need plant growth?",
        ("growth_maps.py", "{folder}", "--only", "best", "--seeds", "6"),
        ("--rough", "--evaluations", "20", "--seeds", "1"),
    ),
    "growth_tops": Part(
        "When does an erect top pay where plants grow?",
        (
            *("growth_maps.py", "{folder}", "--only", "tops"),
            *("--densities", "3", "8", "--seeds", "4"),
        ),
        (
            *("--rough", "--densities", "8"),
            *("--evaluations", "160", "--seeds", "1"),
        ),
    ),
    "seasons": Part(
        "Why is the dry matter of measured seasons missed?",
        ("growth_maps.py", "{folder}", "--only", "season"),
        ("--rough",),
    ),
    "strips": Part(
        "Do strips of maize and soybean save land?",
        (
            *("neighbours.py", "{folder}", "--only", "strips"),
            *("--evaluations", "480", "--seeds", "4"),
            *("--figure", "{figures}/strip_rows.png"),
        ),
        ("--rough", "--evaluations", "24", "--seeds", "1"),
    ),
    "invaders": Part(
        "Does a plant that outcompetes its neighbours make a good stand?",
        (
            *("neighbours.py", "{folder}", "--only", "invaders"),
            *("--evaluations", "480", "--seeds", "4"),
        ),
        ("--rough", "--evaluations", "200", "--seeds", "1"),
    ),
    "panels_measured": Part(
        "Does the light on modules agree with measurements?",
        ("panels.py", "{folder}", "--only", "measured"),
        ("--rough",),
    ),
    "panels_trial": Part(
        "How much does maize lose below modules of a trial?",
        ("panels.py", "{folder}", "--only", "trial"),
        ("--rough",),
    ),
    "panels_bred": Part(
        "Which maize suits rows of photovoltaic modules?",
        (
            *("panels.py", "{folder}", "--only", "bred"),
            *("--generations", "30", "--seeds", "6"),
            *("--figure", "{figures}/panels.png"),
        ),
        ("--rough", "--generations", "1", "--seeds", "1"),
    ),
    "strip_light": Part(
        "Does the light in strips agree with reports?",
        *(("strip_light.py",), ("--rough",)),
    ),
    "atlas": Part(
        "How good can each type of plant be?",
        ("atlas.py", "{folder}", "--figure", "{figures}/atlas.png"),
        ("--rough", "--generations", "2"),
    ),
}
