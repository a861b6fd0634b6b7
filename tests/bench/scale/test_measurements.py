import numpy as np
import pandas as pd
import pytest

from placecat_bench.scale.measurements import COLUMNS, GROWTH_COLUMNS, fit, growths


@pytest.mark.parametrize("exponent", [0.0, 1.0, 2.5])
def test_fit_recovers_a_power_law(exponent):
    frames = np.array([400, 100, 200, 800])
    assert fit(frames, 3.0 * frames**exponent) == (exponent, pytest.approx(1.0), exponent)


def test_a_constant_cost_lowers_the_last_exponent_less():
    frames = np.array([100, 200, 400, 800])
    exponent, r2, last = fit(frames, 10.0 + 1e-3 * frames**2)
    assert exponent < last < 2.0
    assert r2 < 1.0


def test_a_single_size_raises_an_error():
    with pytest.raises(ValueError, match="two different"):
        fit([100, 100], [1.0, 2.0])


def test_the_row_all_has_the_total_time_and_the_highest_peak():
    rows = [
        (size, frames, stage, "", 2.0 * cpu, cpu, peak)
        for size, frames in ((0.5, 100), (1.0, 200))
        for stage, cpu, peak in (
            ("codebooks", frames / 100.0, 1.0),
            ("cues", (frames / 100.0) ** 2, frames / 50.0),
            ("scores", 3.0, 0.5),
        )
    ]
    found = growths(pd.DataFrame(rows, columns=COLUMNS))
    assert list(found.columns) == GROWTH_COLUMNS
    assert (found["item"] == "").all()
    found = found.set_index("stage")
    assert found.index.to_list() == ["codebooks", "cues", "scores", "all"]
    assert found["exponent"].tolist()[:3] == [1.0, 2.0, 0.0]
    assert found.loc["all", "exponent"] == pytest.approx(np.log2(9.0 / 5.0), abs=0.01)
    assert found.loc["all", ["seconds", "peak_gib"]].tolist() == [18.0, 4.0]
