"""Test that training from a plan agrees with the stages, and that the code in docs/usage.md works."""

import re
import runpy
from pathlib import Path

import numpy as np
import pytest
from made_features import PARAMS, ran_once

from placecat.training import fold_file
from placecat.training import system as systems
from placecat.training.plan import of_homes

ROOT = Path(__file__).resolve().parents[2]
# Use only two of the five cues, with small codebooks.
SMALL = [
    "dataset.fps=5.0",
    "dataset.homes=[Home1,Home2,Home3]",
    "codebooks.hog_y.tree.max_clusters=46",
    "cues.hog_y.classifier.clusters=46",
    "systems.das_551_best.cues=[hog_y,gist]",
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return ran_once(tmp_path_factory)


@pytest.mark.parametrize(
    ("name", "scheme"), [("das", "5-5-1"), ("das_451", "4-5-1"), ("vote", "5-5-1"), ("pool", "5-5-1")]
)
def test_system_results_equal_those_of_the_stages(folder, monkeypatch, name, scheme):
    """Results are bitwise identical with extra data (vote), tempering (das_451) and held-out data (pool)."""
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    system = systems.System.of(PARAMS, name)
    (plan,) = of_homes(PARAMS, scheme, "H2", extra=system.extra)
    tested = systems.train(plan, system, 1).test("H2")
    expected = {
        "hog_y": (f"cues/hog_y/{scheme}/H2.seed-1.npz", "test"),
        "gist": (f"cues/gist/{scheme}/H2.no-seed.npz", "test"),
        "integration": (f"integration/{name}/H2.seed-1.npz", "test"),
        "hmm": (f"smoothing/{name}/H2.seed-1.npz", "hmm"),
        "delayed": (f"smoothing/{name}/H2.seed-1.npz", "delayed"),
    }
    assert tested.keys() == expected.keys()
    for part, (file, array) in expected.items():
        expected_array = fold_file.read(Path("data") / file, array)
        np.testing.assert_array_equal(tested[part], expected_array, err_msg=part)


@pytest.mark.slow
def test_usage_page_prints_a_table_of_homes(tmp_path, monkeypatch, capsys):
    """Run the code in docs/usage.md on synthetic homes with small codebooks."""
    from sketch import draw_homes

    page = (ROOT / "docs/usage.md").read_text()
    code, _ = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert code.count('"dataset.root=homes"') == 1
    small = ", ".join(f'"{one}"' for one in SMALL)
    script = tmp_path / "page.py"
    script.write_text(code.replace('"dataset.root=homes"', f'"dataset.root=homes", {small}'))
    draw_homes(tmp_path / "homes", homes=3, frames_per_room=10, width=160, height=90)
    (tmp_path / "conf").symlink_to(ROOT / "conf")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    runpy.run_path(str(script), run_name="__main__")
    head, *rows = capsys.readouterr().out.splitlines()
    assert head.split() == ["Home1", "Home2", "Home3", "Average"]
    assert [row.split()[0] for row in rows] == ["hog_y", "gist", "integration", "hmm", "delayed"]
    numbers = np.array([row.split()[1:] for row in rows], dtype=float)
    assert ((numbers >= 0) & (numbers <= 100)).all()
    np.testing.assert_allclose(numbers[:, 3], numbers[:, :3].mean(axis=1), atol=0.011)
