"""`placecat demo`."""

import pytest

from placecat.demo import command
from placecat.errors import PlacecatError


def test_it_replaces_its_own_files_only(tmp_path):
    folder = tmp_path / "demo"
    command._check(folder)
    folder.mkdir()
    (folder / command.PAGE).touch()
    command._check(folder)
    (folder / "mine.txt").touch()
    with pytest.raises(PlacecatError, match=r"mine\.txt is not the demo's.*move it away"):
        command._check(folder)


def test_a_file_in_the_way_is_refused(tmp_path):
    (tmp_path / "demo").touch()
    with pytest.raises(PlacecatError, match="is a file, where the demo writes a folder"):
        command._check(tmp_path / "demo")
