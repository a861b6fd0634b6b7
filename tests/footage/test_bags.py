"""Tests of every kind of bag: topics, times, and damaged bags."""

import sys

import numpy as np
import pytest
from helpers_sequences import coded, decoded
from made_bags import CAMERA, KINDS, START, compressed, picture, rosbag1, rosbag2, string, walk, write_bag

from placecat.errors import PlacecatError
from placecat.footage.bag_recording import BagRecording
from placecat.footage.bags import Bag, is_bag


def shown(recording):
    return [
        (frame.number, decoded(image))
        for frame in recording.pictures()
        if (image := frame.image()) is not None
    ]


def refused(message, path, *arguments, **options):
    with pytest.raises(PlacecatError, match=message) as caught:
        BagRecording(path, *arguments, **options).size()
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize("kind", KINDS)
def test_a_bag_has_its_frames_and_times(tmp_path, kind):
    recording = BagRecording(walk(tmp_path / kind))
    assert is_bag(tmp_path / kind)
    assert shown(recording) == [(number + 1, number) for number in range(30)]
    assert np.allclose(recording.timing.seconds, np.arange(30) / 25, rtol=0, atol=1e-12)
    assert recording.timing.fps == pytest.approx(25)
    assert (recording.topic, recording.size(), recording.start) == (CAMERA, (64, 48), START)
    assert recording.note() == "" and recording.lost == []


def compressions():
    for mode in ("FILE", "MESSAGE", "STORAGE"):
        name = "walk_mcap" if mode == "STORAGE" else "walk"
        yield name, (rosbag2.CompressionMode[mode], rosbag2.CompressionFormat.ZSTD)
    for fmt in ("BZ2", "LZ4"):
        yield "walk.bag", (rosbag1.Writer.CompressionFormat[fmt],)


@pytest.mark.parametrize(("name", "compression"), list(compressions()))
def test_compressed_bags(tmp_path, name, compression):
    version = 1 if name.endswith(".bag") else 2
    messages = [
        (CAMERA, START + number * 10**8, picture(version, START + number * 10**8, coded(number)))
        for number in range(3)
    ]
    path = write_bag(tmp_path / name, messages, compression=compression)
    assert shown(BagRecording(path)) == [(1, 0), (2, 1), (3, 2)]


@pytest.mark.parametrize("kind", ["walk.bag", "walk.mcap"])
def test_times_are_the_stamps_or_else_the_times_of_reception(tmp_path, kind):
    stamps = [START, START + 10**8, START + 3 * 10**8]
    recording = BagRecording(walk(tmp_path / "a" / kind, stamps=stamps, late=5 * 10**7))
    assert np.allclose(recording.timing.seconds, [0, 0.1, 0.3])
    version = 1 if kind == "walk.bag" else 2
    zero = [(CAMERA, one, picture(version, 0, coded(number))) for number, one in enumerate(stamps)]
    recording = BagRecording(write_bag(tmp_path / "b" / kind, zero))
    assert np.allclose(recording.timing.seconds, [0, 0.1, 0.3])
    assert "some stamps are zero, so the reception times are used" in recording.note()


def test_frames_that_come_late_or_twice_are_left_out(tmp_path):
    version, times = 2, [0, 100, 300, 200, 300, 400, 500]
    messages = [
        (CAMERA, START + place * 10**8, picture(version, START + time * 10**6, coded(place)))
        for place, time in enumerate(times)
    ]
    path = write_bag(tmp_path / "walk.mcap", messages)
    recording = BagRecording(path)
    assert shown(recording) == [(1, 0), (2, 1), (3, 2), (4, 5), (5, 6)]
    assert np.allclose(recording.timing.seconds, [0, 0.1, 0.3, 0.4, 0.5])
    assert recording.note() == (
        f"{path}: 2 of 7 frames are left out because they are no later than a preceding frame."
    )
    # With a given rate, all frames count.
    assert shown(BagRecording(path, fps=10)) == [(number + 1, number) for number in range(7)]


def test_a_clock_that_was_set_is_refused(tmp_path):
    stamps = [START + number * 10**8 for number in range(5)]
    stamps = [*stamps, *(one - 3600 * 10**9 for one in stamps)]
    messages = [
        (CAMERA, START + place * 10**8, picture(2, stamp, coded(place))) for place, stamp in enumerate(stamps)
    ]
    path = write_bag(tmp_path / "walk.mcap", messages)
    refused(r"frame 6 of /camera/image_raw is 3.6e\+03 s earlier .* rate with --fps", path)
    assert BagRecording(path, fps=10).count == 10
    refused(
        "hours after the previous one", walk(tmp_path / "gap.mcap", stamps=[START, START + 4 * 3600 * 10**9])
    )
    refused(r"no frame rate .* stamps of .* \(1 frame in 0 s\)", walk(tmp_path / "one.mcap", count=1))


def test_topics(tmp_path):
    others = [
        ("/depth/image", START, picture(2, START, np.full((48, 64), 9, np.uint16), "16UC1")),
        ("/front/compressed", START, compressed(2, START, coded(200))),
        ("/front/compressed", START + 10**8, compressed(2, START + 10**8, coded(201), ".jpg", "jpeg")),
        ("/room", START, string(2, "kitchen")),
    ]
    path = walk(tmp_path / "walk.mcap", others=others)
    refused(
        "several topics have images; choose one with --topic: /camera/image_raw, /depth/image, /front/comp",
        path,
    )
    assert shown(BagRecording(path, "/front/compressed")) == [(1, 200), (2, 201)]
    assert shown(BagRecording(path, CAMERA))[:2] == [(1, 0), (2, 1)]
    refused(
        r"no topic '/camera/image'; did you mean '/camera/image_raw'\?; the bag has /camera/",
        path,
        "/camera/image",
    )
    refused("'/room' has messages of type std_msgs/msg/String, not sensor_msgs/msg/Image or", path, "/room")
    refused("the encoding '16UC1' is not supported", path, "/depth/image", 10)
    refused(
        r"no topic has images .*the bag has /room \(std_msgs/msg/String\)",
        write_bag(tmp_path / "talk.bag", [("/room", START, string(1, "kitchen"))]),
    )


def test_damaged_pictures_are_lost_and_reported(tmp_path):
    content = [coded(number) for number in range(4)]
    content[1] = b"\xff\xd8\xffrubbish"
    messages = [
        (CAMERA, START + number * 10**8, compressed(2, START + number * 10**8, one))
        for number, one in enumerate(content)
    ]
    path = write_bag(tmp_path / "walk.mcap", messages)
    recording = BagRecording(path)
    assert shown(recording) == [(1, 0), (3, 2), (4, 3)]
    assert recording.lost == [2] and recording.count == 4
    assert f"{path}: frame 2 of 4 cannot be decoded and is lost ({path}, image 2" in recording.note()
    none = [
        (CAMERA, START + n * 10**8, compressed(2, START + n * 10**8, b"no", kind="h264")) for n in range(3)
    ]
    refused(
        r"no image on /camera/image_raw can be decoded: .*\(format 'h264'\): not a readable",
        write_bag(tmp_path / "none.mcap", none),
    )


def damage(path, kind):
    file = path if path.is_file() else next(one for one in path.iterdir() if one.suffix != ".yaml")
    content = bytearray(file.read_bytes())
    if kind == "cut off":
        content = content[: len(content) // 2]
    elif kind == "empty":
        content = bytearray()
    elif kind == "another file":
        content = bytearray(b"hello" * 1000)
    else:
        rng = np.random.default_rng(int(kind))
        content[rng.integers(len(content))] ^= 1 << int(rng.integers(8))
    file.write_bytes(content)


@pytest.mark.parametrize("damaged", ["cut off", "empty", "another file"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_damaged_bag_gives_one_message(tmp_path, kind, damaged):
    path = walk(tmp_path / kind, count=4)
    damage(path, damaged)
    mending = {".bag": "rosbag reindex", ".mcap": "mcap recover", ".db3": "sqlite3 FILE .recover"}
    command = mending.get(path.suffix, "ros2 bag reindex")
    refused(rf"not a readable bag \(.+\); restore it, or repair it with `{command}`", path)


@pytest.mark.parametrize("kind", KINDS)
def test_a_flipped_bit_gives_a_frame_or_one_message(tmp_path, kind):
    path = walk(tmp_path / kind, count=3, size=(16, 8))
    whole = {file: file.read_bytes() for file in ([path] if path.is_file() else path.iterdir())}
    for seed in range(12):
        damage(path, seed)
        try:
            recording = BagRecording(path)
            recording.size()
            shown(recording)
        except PlacecatError as error:
            assert len(str(error).splitlines()) == 1
        for file, content in whole.items():
            file.write_bytes(content)


def test_the_rest_of_a_bag_is_refused(tmp_path):
    path = walk(tmp_path / "walk", count=3)
    (path / "metadata.yaml").unlink()
    refused("not a readable bag .*repair it with `ros2 bag reindex`", path)


def test_a_definition_in_a_bag_is_not_run(tmp_path, monkeypatch):
    """Type definitions in a bag are not used, because rosbags would turn them into Python code."""
    from rosbags.typesys.store import Typestore

    path = walk(tmp_path / "walk.mcap", count=3)
    monkeypatch.setattr(Typestore, "register", lambda *_: pytest.fail("a type was registered"))
    assert Bag(path).count == 3 and len(shown(BagRecording(path))) == 3


def test_without_rosbags_the_extra_is_named(tmp_path, monkeypatch):
    path = walk(tmp_path / "walk.bag", count=3)
    monkeypatch.setitem(sys.modules, "rosbags", None)
    refused(r"bags need the optional extra \(rosbags is missing\): pip install -e '.\[robot\]'", path)
