import sys
from pathlib import Path

import pandas as pd
import pytest
import yaml

from placecat import paths
from placecat.stages import findings

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/thesis"))


@pytest.fixture
def folder(tmp_path, monkeypatch):
    from made_results import PARAMS, made, write_scores

    verdict = yaml.safe_load((ROOT / "conf/verdict/bootstrap.yaml").read_text()) | {"resamples": 200}
    (tmp_path / paths.PARAMS).write_text(yaml.safe_dump(PARAMS | {"verdict": verdict}))
    write_scores(tmp_path / paths.SCORES, made())
    (tmp_path / paths.PUBLISHED).parent.mkdir(parents=True)
    (tmp_path / paths.FINDING_DEFINITIONS).symlink_to(ROOT / paths.FINDING_DEFINITIONS)
    for path in (paths.PUBLISHED, paths.PUBLISHED_TEXT):
        (tmp_path / path).write_bytes((ROOT / path).read_bytes())
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_both_files_are_written_with_the_same_bytes_each_time(folder):
    findings.main()
    written = [(folder / path).read_bytes() for path in (paths.FINDINGS, paths.COMPARISONS)]
    ledger = pd.read_csv(folder / paths.FINDINGS)
    assert ledger["number"].tolist() == list(range(1, 35))
    assert len(pd.read_csv(folder / paths.COMPARISONS)) > 34
    findings.main()
    assert [(folder / path).read_bytes() for path in (paths.FINDINGS, paths.COMPARISONS)] == written
