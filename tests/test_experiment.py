"""Experiments: e from what was measured."""

from __future__ import annotations

import numpy as np
import pytest

import restitution as r


def test_exact_angles_give_e_exactly():
    alpha = np.linspace(15, 75, 8)
    beta = np.degrees(np.arctan(0.6 * np.tan(np.radians(alpha))))
    result = r.experiment({"alpha": alpha, "beta": beta}, angle_error=1)
    assert result.e == pytest.approx(0.6, abs=1e-9)
    assert result.interval.low < 0.6 < result.interval.high
