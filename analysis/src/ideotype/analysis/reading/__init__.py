# SPDX-License-Identifier: Apache-2.0
"""Reads the datasets of histories."""
