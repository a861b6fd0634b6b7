import cv2
import pytest
from makers import frame

from placecat.errors import PlacecatError
from placecat_bench import frames
from placecat_bench.pieces import frame_features


@pytest.mark.slow
def test_entries_and_targets():
    entries = list(frame_features.entries(frames=[frame()]))
    assert [(entry.input, entry.target) for entry in entries] == [
        ("320x240 JPEG, for the cues", "at most 7x its time"),
        ("320x240 JPEG, for the cues", "at least 40"),
        ("320x240 JPEG, for the trials too", "at most 7x its time"),
        ("320x240 JPEG, for the trials too", "at least 40"),
    ]
    (cues,), (every,) = entries[0].ours(), entries[2].ours()
    assert set(cues) < set(every)
    assert (len(cues["regions"]), len(every["regions"])) == (25, 38)
    assert {"regions", "information", "local_sift", "holistic_gist", "holistic_centrist"} < set(cues)
    assert "holistic_centrist_full" in every
    assert [picture.shape for picture in entries[0].theirs()] == [(240, 320, 3)]
    assert entries[1].measure() > 0
    # If a target is missed, the row shows where the time goes.
    assert all("maps" in entry.parts for entry in entries)
    assert all("decoding" in entry.parts for entry in entries[1::2])


def test_every_descriptor_is_timed_as_a_part():
    own = frames.options()
    parts = frame_features.parts([frame()], own)
    assert set(parts) == {"maps", "regions", *own["local"], *(f"holistic {name}" for name in own["holistic"])}
    for part in parts.values():
        assert len(part()) == 1


@pytest.mark.slow
def test_jpegs_has_a_frame_of_each_home():
    found = frames.jpegs()
    assert len(found) == 6
    picture = frames.decoded(found[0])
    assert frames.size(picture) == "1280x720"
    assert (picture == cv2.imdecode(found[0], cv2.IMREAD_COLOR)).all()
    assert len({file.tobytes() for file in found}) == 6


def test_a_folder_without_videos_raises_an_error(tmp_path):
    with pytest.raises(PlacecatError, match="has no videos: restore the rendered homes"):
        frames.jpegs(tmp_path)
