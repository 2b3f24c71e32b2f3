#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A sensitivity study: on which traits the result depends.
#
# Plants are drawn over the whole range of all traits after Saltelli, and Sobol's
# indices tell which part of the variance each trait causes. This teaches
# `sensitivity` and `indices`.
set -euo pipefail

ideotype sensitivity campaigns/ames_quick.toml --threads 2 \
    --set sensitivity.samples=64 --set light.paths=2048
ideotype indices results/sensitivity/ames_quick/*.h5 --json >16_sensitivity.json
ideotype indices results/sensitivity/ames_quick/*.h5
