# SPDX-License-Identifier: Apache-2.0
"""Helpers that several packages use: arrays, files, names, options,
progress."""
