import kills
import pytest


@pytest.mark.slow
def test_killed_runs_resume_and_produce_the_same_bytes(tmp_path):
    """Two runs are killed at random moments, and one while dvc.lock is written."""
    lines = []
    counts = kills.campaign(tmp_path / "campaign", 3, 300, seed=1, say=lines.append)
    assert counts == {"clean": 3}, lines
