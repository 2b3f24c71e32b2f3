# SPDX-License-Identifier: Apache-2.0
"""Covariances of traits between and within lines, from the values of plots:
mean products, restricted maximum likelihood, and draws of their errors."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import Error

Matrix = NDArray[np.float64]


def square_root(matrix: Matrix) -> Matrix:
    """Returns the symmetric square root of a matrix; negative eigenvalues
    count as 0."""
    roots, vectors = np.linalg.eigh(matrix)
    return np.asarray((vectors * np.sqrt(np.maximum(roots, 0))) @ vectors.T)


def without_negative(matrix: Matrix) -> Matrix:
    """Returns a covariance matrix with its negative eigenvalues, which
    different plots of each pair of traits may cause, set to 0."""
    root = square_root(matrix)
    return matrix if np.linalg.eigvalsh(matrix)[0] >= 0 else root @ root


@dataclass(frozen=True)
class MeanProducts:
    """Mean products of several traits between and within lines, with their
    degrees of freedom. For pairs of traits with missing values these are
    those of the pair with the fewest plots."""

    between: Matrix
    """Adjusted for blocks [traits x traits]."""
    within: Matrix
    between_freedom: int
    within_freedom: int
    plots: float
    """The effective number of plots of a line."""

    @property
    def genetic(self) -> Matrix:
        """The covariances between lines; eigenvalues may be negative."""
        return (self.between - self.within) / self.plots


def mean_products(
    values: Matrix, line: NDArray[np.int64], block: NDArray[np.int64]
) -> MeanProducts:
    """Computes mean products between lines, adjusted for blocks, and within
    lines; their expectations give covariances (Henderson 1953, method 3,
    doi:10.2307/3001853).

    values: [plots x traits], NaN: missing. A pair of traits uses the plots
        with both.
    line, block: indices [plots].

    Raises Error if no line has several plots of a pair of traits."""
    known = np.isfinite(values)
    count = values.shape[1]
    between, within, plots = np.zeros((3, count, count))
    freedoms = []
    groups: dict[bytes, list[tuple[int, int]]] = {}
    for i in range(count):
        for j in range(i, count):
            both = known[:, i] & known[:, j]
            groups.setdefault(both.tobytes(), []).append((i, j))
    for pattern, pairs in groups.items():
        rows = np.frombuffer(pattern, bool)
        names = sorted({k for pair in pairs for k in pair})
        part = _products(values[rows][:, names], line[rows], block[rows])
        freedoms.append((part.between_freedom, part.within_freedom))
        for i, j in pairs:
            at = names.index(i), names.index(j)
            between[i, j] = between[j, i] = part.between[at]
            within[i, j] = within[j, i] = part.within[at]
            plots[i, j] = part.plots
    first, second = map(min, zip(*freedoms))
    return MeanProducts(
        without_negative(between),
        without_negative(within),
        first,
        second,
        np.diag(plots).mean(),
    )


def _products(
    values: Matrix, line: NDArray[np.int64], block: NDArray[np.int64]
) -> MeanProducts:
    """Returns the mean products of traits without missing values."""
    _, line = np.unique(line, return_inverse=True)
    _, block = np.unique(block, return_inverse=True)
    lines = np.eye(line.max() + 1)[line]
    # Residuals of the block means, of the values and of the lines' design.
    cells = np.zeros((block.max() + 1, line.max() + 1))
    np.add.at(cells, (block, line), 1)
    sizes = cells.sum(axis=1)
    sums = np.zeros((block.max() + 1, values.shape[1]))
    np.add.at(sums, block, values)
    within_blocks = values - (sums / sizes[:, None])[block]
    adjusted = lines - (cells / sizes[:, None])[block]
    # Least squares for lines within blocks.
    information = adjusted.T @ lines
    roots, vectors = np.linalg.eigh(information)
    kept = roots > 1e-9 * roots.max(initial=0)
    between = vectors[:, kept] / np.sqrt(roots[kept])
    projected = between.T @ (adjusted.T @ values)
    product = projected.T @ projected
    freedom = int(kept.sum())
    rest = within_blocks.T @ within_blocks - product
    left = len(values) - len(sizes) - freedom
    if left < 1 or freedom < 1:
        raise Error(
            "no line has several plots with the same traits; give replicates, "
            "or means of lines"
        )
    effective = float(np.trace(information)) / freedom
    return MeanProducts(
        product / freedom, rest / left, freedom, left, effective
    )


def draw_covariances(
    parts: MeanProducts, count: int, random: np.random.Generator
) -> tuple[Matrix, Matrix]:
    """Draws G, without negative eigenvalues, and error covariances: mean
    products over draws of their Wishart distributions (generalised pivotal
    quantities, Weerahandi 1993, doi:10.1080/01621459.1993.10476355). With 40
    lines their quantiles cover the truth more often than those of a bootstrap
    of lines do.

    Returns two arrays [draws x traits x traits]. Raises Error if there are
    too few lines or plots for the number of traits."""
    between = draw_inverse_wishart(
        parts.between, parts.between_freedom, count, random
    )
    within = draw_inverse_wishart(
        parts.within, parts.within_freedom, count, random
    )
    genetic = [
        make_semidefinite((b - w) / parts.plots, b / parts.plots)
        for b, w in zip(between, within)
    ]
    return np.array(genetic), within


def draw_inverse_wishart(
    matrix: Matrix, freedom: int, count: int, random: np.random.Generator
) -> Matrix:
    """Draws the expectations of mean products from these and their degrees of
    freedom [draws x traits x traits]. Raises Error if these are too few."""
    from scipy.stats import invwishart

    size = len(matrix)
    if freedom < size:
        raise Error(
            f"{freedom} degrees of freedom are too few for {size} traits; "
            "give more lines or plots, or fewer traits"
        )
    floor = 1e-9 * np.diag(np.diag(matrix))
    sample = invwishart.rvs(
        freedom, freedom * (matrix + floor), count, random_state=random
    )
    return np.reshape(sample, (count, size, size))


def make_semidefinite(genetic: Matrix, phenotypic: Matrix) -> Matrix:
    """Returns G with negative eigenvalues of P^-1 G set to 0, so that no
    combination of traits has a negative heritability (Hayes and Hill 1981,
    doi:10.2307/2530561, who bend all eigenvalues to their mean)."""
    roots, vectors = np.linalg.eigh(phenotypic)
    keep = roots > 1e-12 * roots.max()
    root = vectors[:, keep] * np.sqrt(roots[keep])
    inverse = vectors[:, keep] / np.sqrt(roots[keep])
    heritabilities, axes = np.linalg.eigh(inverse.T @ genetic @ inverse)
    clipped = (axes * np.maximum(heritabilities, 0)) @ axes.T
    fixed = root @ clipped @ root.T
    return (fixed + fixed.T) / 2


def reml(
    values: Matrix, line: NDArray[np.int64], block: NDArray[np.int64]
) -> tuple[float, float]:
    """Returns the variances between lines and between plots of one trait, by
    restricted maximum likelihood (Patterson and Thompson 1971,
    doi:10.1093/biomet/58.3.545) with fixed blocks.

    Raises Error if statsmodels is not installed."""
    try:
        from statsmodels.regression.mixed_linear_model import MixedLM
    except ImportError:
        raise Error(
            "statsmodels, which estimates heritabilities, is not installed; "
            'run pip install "ideotype[select]"'
        ) from None
    rows = np.isfinite(values)
    _, blocks = np.unique(block[rows], return_inverse=True)
    scale = float(np.std(values[rows])) or 1.0
    design = np.eye(blocks.max() + 1)[blocks]
    with warnings.catch_warnings():
        # At the boundary of no variance between lines statsmodels warns.
        warnings.simplefilter("ignore")
        fit = MixedLM(values[rows] / scale, design, groups=line[rows]).fit(
            reml=True, method=["bfgs", "powell"]
        )
    between = float(np.asarray(fit.cov_re)[0, 0])
    return between * scale**2, float(fit.scale) * scale**2
