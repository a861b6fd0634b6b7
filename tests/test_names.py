"""Names with a special meaning in a shell, a URL or a parser, with real DVC."""

import pytest

from placecat.config.compose import compose
from project import HOMES, SMALL, copy_project, repro

NAMES = ["Flat A", "o'hara & Söhne", "$HOME", "home 1;touch PWNED"]


@pytest.mark.slow
def test_homes_may_have_names_with_shell_syntax(tmp_path):
    folder = copy_project(tmp_path / "project folder")
    for number, name in enumerate(NAMES, 1):
        (folder / HOMES / f"Home{number}").rename(folder / HOMES / name)
    listed = ",".join(f'"{name}"' for name in NAMES)
    overrides = [one for one in SMALL if not one.startswith(("dataset.homes=", "protocol.test_homes="))]
    (folder / "params.yaml").write_text(compose([*overrides, f"dataset.homes=[{listed}]"], folder / "conf"))
    ran, _ = repro(folder, "features", PLACECAT_WORKERS="1")
    assert ran == ["sequences", "features"]
    assert sorted(path.name for path in (folder / "data/features").iterdir()) == sorted(NAMES)
    assert not list(folder.rglob("PWNED"))
