# SPDX-License-Identifier: Apache-2.0
"""Weather files of several formats."""
