#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sensitivity analysis: the traits on which absorbed light depends.
#
# Plants are sampled over the whole range of all traits (Saltelli's design).
# Sobol' indices are the shares of the variance that each trait causes. This
# example uses `sensitivity` and `indices`.
set -euo pipefail

ideotype sensitivity campaigns/ames_quick.toml --threads 2 \
    --set sensitivity.samples=64 --set light.paths=2048
ideotype indices results/sensitivity/ames_quick/*.h5 --json >16_sensitivity.json
ideotype indices results/sensitivity/ames_quick/*.h5
