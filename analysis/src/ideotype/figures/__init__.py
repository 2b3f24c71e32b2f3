# SPDX-License-Identifier: Apache-2.0
"""The figures of reports and of stands."""
