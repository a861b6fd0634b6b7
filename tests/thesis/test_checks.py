"""Invalid tables are rejected when settings are composed."""

import shutil

import pytest
import yaml

from placecat import settings
from placecat.config.tables import check
from placecat.errors import PlacecatError
from project import ROOT

PARAMS = settings.load(ROOT / "params.yaml")


def test_the_tables_are_valid():
    check(PARAMS, ROOT)


@pytest.mark.parametrize(
    ("file", "change", "message"),
    [
        ("table_07", {"layout": "x"}, r"table_07: the layout 'x' does not exist.*by_class, by_home"),
        (
            "gist/table_03",
            {"layout": "gird"},
            "table_03: .*'gird' does not exist; did you mean 'grid'",
        ),
        ("gist/table_03", {"trial": {}}, "table_03 changes classifier.base.gamma, but its trial has no such"),
    ],
)
def test_an_invalid_table_is_rejected(file, change, message, tmp_path):
    for name in ("data/thesis", "conf"):
        shutil.copytree(ROOT / name, tmp_path / name)
    path = tmp_path / f"data/thesis/tables/{file}.yaml"
    path.write_text(yaml.safe_dump(yaml.safe_load(path.read_text()) | change))
    with pytest.raises(PlacecatError, match=message):
        check(PARAMS, tmp_path)
