# SPDX-License-Identifier: Apache-2.0
"""Tells which of the 30 noisy functions of BBOB 2009 in 20 dimensions `auto` and the
BIPOP-CMA-ES of the package cma solve within 200,000 evaluations.

bbob_noisy.py (auto|bipop) [--functions 101-130] [--instances 1-5]

A function is solved if a point within 1e-8 of the optimum was found: its value, and
the median of eleven values more, since noise may flatter one. Needs the packages
coco-experiment and cma beside ideotype."""

import argparse
import os
import statistics
import tempfile

import cma
import cocoex
import numpy as np

from ideotype import Search

BUDGET = 200_000
TARGET = 1e-8


class Function:
    """Counts evaluations of a problem until it is solved."""

    def __init__(self, problem):
        # The package reveals the optimum only by writing it to a file in the
        # working folder.
        problem._best_parameter("print")
        best = np.loadtxt("._bbob_problem_best_parameter.txt")
        self.problem, self.optimum = problem, problem(best)
        self.count, self.is_solved = 0, False

    def __call__(self, x):
        value = self.problem(x)
        self.count += 1
        if not self.is_solved and value - self.optimum <= TARGET:
            again = [self.problem(x) for _ in range(11)]
            self.is_solved = statistics.median(again) - self.optimum <= TARGET
        return value

    def is_over(self):
        return self.is_solved or self.count >= BUDGET


def by_auto(function, seed):
    lower, upper = function.problem.lower_bounds, function.problem.upper_bounds
    search = Search(lower, upper, maximise=[False], seed=seed)
    while not function.is_over():
        search.tell([function(x) for x in search.ask()])


def by_bipop(function, seed):
    rng = np.random.default_rng(seed)
    cma.fmin2(
        function,
        lambda: rng.uniform(-4, 4, 20),
        2,
        {
            "verbose": -9,
            "maxfevals": BUDGET,
            "seed": seed,
            "termination_callback": lambda _: function.is_solved,
        },
        restarts=9,
        bipop=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("search", choices=("auto", "bipop"))
    parser.add_argument("--functions", default="101-130")
    parser.add_argument("--instances", default="1-5")
    options = parser.parse_args()
    first, _, last = options.functions.partition("-")
    indices = f"{int(first) - 100}-{int(last or first) - 100}"
    os.chdir(tempfile.mkdtemp())
    suite = cocoex.Suite(
        "bbob-noisy",
        "",
        f"dimensions:20 function_indices:{indices} "
        f"instance_indices:{options.instances}",
    )
    solved = {}
    for problem in suite:
        function = Function(problem)
        {"auto": by_auto, "bipop": by_bipop}[options.search](
            function, problem.id_instance
        )
        solved.setdefault(problem.id_function, []).append(function.is_solved)
        print(
            problem.id_function,
            problem.id_instance,
            "solved" if function.is_solved else "not solved",
            function.count,
            flush=True,
        )
    print(
        f"{options.search}: {sum(map(any, solved.values()))} of {len(solved)} "
        f"functions, {sum(map(sum, solved.values()))} of "
        f"{sum(map(len, solved.values()))} runs"
    )


main()
