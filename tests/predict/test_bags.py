"""Predict from bags, and export predictions to MCAP and Rerun files."""

import json
import sys

import cv2
import numpy as np
import pandas as pd
import pytest
from commands import predict, refused
from fake_categorizer import CLASSES, STAY, FakeCategorizer, expected
from helpers_sequences import coded, decoded, write_image
from made_bags import CAMERA, START, STORES, picture, rosbag2, walk

from placecat.predict import command, mcap_file, rerun_file

COUNT = 30
# The confidence is below the threshold from frame 11.
NAMES = [(0, CLASSES[0]), (STAY, CLASSES[1]), (11, "unknown")]
STAMPS = [START + number * 4 * 10**7 for number in range(COUNT)]


@pytest.fixture
def system(tmp_path, monkeypatch):
    """Return a system that needs no training, and change to an empty folder."""
    made = FakeCategorizer()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command.Categorizer, "load", lambda path, **_: made)
    return made


@pytest.mark.parametrize("kind", ["walk.bag", "walk_ros2"])
def test_predict_from_a_bag(system, tmp_path, capsys, kind):
    walk(tmp_path / kind)
    predict(kind)
    folder = tmp_path / "predictions" / kind.partition(".")[0]
    table = pd.read_csv(folder / "frames.csv")
    assert table["frame"].tolist() == list(range(1, COUNT + 1))
    assert np.allclose(table["seconds"], np.arange(COUNT) / 25)
    smoothed = np.stack([expected(number)[0] for number in range(COUNT)])
    assert np.array_equal(table[[f"p_{name}" for name in CLASSES]], smoothed)
    assert np.allclose(system.times, 1 / 25)
    told = capsys.readouterr()
    assert "Topic: /camera/image_raw." in told.out and "no frame rate" not in told.out
    assert told.err == ""


def test_uneven_times_topics_and_labels(system, tmp_path, capsys):
    stamps = [*STAMPS[:20], *(START + 10**9 + number * 10**9 for number in range(10))]
    other = [("/left", START, picture(1, START, coded(77)))]
    walk(tmp_path / "walk.bag", stamps=stamps, others=other)
    (tmp_path / "walk.csv").write_text(
        "start_seconds,end_seconds,label\n0,0.95,bedroom\n0.95,10.04,kitchen\n"
    )
    assert "choose one with --topic: /camera/image_raw, /left" in refused("walk.bag")
    predict("walk.bag", "--topic", CAMERA, "--labels", "walk.csv", "--every", 2)
    table = pd.read_csv(tmp_path / "predictions/walk/frames.csv")
    assert table["frame"].tolist() == list(range(1, COUNT + 1, 2))
    assert np.allclose(table["seconds"], (np.array(stamps[::2]) - START) / 1e9)
    summary = json.loads((tmp_path / "predictions/walk/summary.json").read_text())
    assert list(map(sum, summary["agreement"]["confusion"])) == [10, 0, 5]
    predict("walk.bag", "--topic", CAMERA, "--fps", 10, "--output", "even")
    assert np.allclose(pd.read_csv(tmp_path / "even/frames.csv")["seconds"], np.arange(COUNT) / 10)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("walk.mcap --topic /none", "no topic '/none'; the bag has /camera/image_raw"),
        ("images --topic /none", "--topic works only with bags, but images is not a bag"),
        ("missing.bag --topic /none", "--topic works only with bags, but missing.bag is not a bag"),
        ("missing.bag", "there is no file or folder missing.bag"),
        (
            "walk.mcap --mcap walk.mcap --force",
            "--mcap is walk.mcap, which is an input to the prediction: choose another name",
        ),
        ("images --mcap images/a.mcap", "an input to the prediction"),
        ("walk.mcap --mcap out.bag", "--mcap is out.bag: choose a name that ends in .mcap"),
        (
            "walk.mcap --mcap there.mcap",
            "--mcap is there.mcap, which already exists: choose another name, or use --force",
        ),
        (
            "walk.mcap --mcap predictions/walk/a.mcap",
            "but the prediction replaces the folder predictions/walk",
        ),
        ("walk.mcap --mcap there.mcap/a.mcap", "cannot write there.mcap/a.mcap"),
    ],
)
def test_user_errors_give_one_message_and_leave_no_files(system, tmp_path, arguments, message):
    walk(tmp_path / "walk.mcap")
    write_image(tmp_path / "images/1.png", 1)
    (tmp_path / "there.mcap").write_text("mine")
    before = sorted(tmp_path.rglob("*"))
    assert message in refused(*arguments.split())
    assert sorted(tmp_path.rglob("*")) == before


def read_back(path):
    """Return the times and messages for each topic of an MCAP file, and the connection for each topic."""
    store = STORES[2]
    for name, text in mcap_file._DEFINITIONS.items():
        if name not in store.types:
            from rosbags.typesys import get_types_from_msg

            store.register(get_types_from_msg(text, name))
    found = {}
    with rosbag2.Reader(path) as reader:
        for connection, time, content in reader.messages():
            message = store.deserialize_cdr(content, connection.msgtype)
            found.setdefault(connection.topic, []).append((time, message))
        return found, {connection.topic: connection for connection in reader.connections}


@pytest.mark.parametrize("kind", ["walk.bag", "images"])
def test_an_mcap_file_has_pictures_probabilities_and_places(system, tmp_path, kind):
    if kind == "walk.bag":
        walk(tmp_path / kind)
    else:
        for number in range(COUNT):
            write_image(tmp_path / kind / f"{number}.png", number)
    predict(kind, "--mcap", "out/said.mcap", "--fps", 25)
    found, connections = read_back(tmp_path / "out/said.mcap")
    start = START if kind == "walk.bag" else 0
    times = [start + number * 4 * 10**7 for number in range(COUNT)]
    assert [time for time, _ in found[mcap_file.PICTURE]] == times
    for number, (time, message) in enumerate(found[mcap_file.PROBABILITIES]):
        stamp = message.header.stamp
        assert time == times[number] == stamp.sec * 10**9 + stamp.nanosec
        assert [one.class_id for one in message.results] == list(CLASSES)
        assert [one.score for one in message.results] == expected(number)[0].tolist()
    places = [(time, message.data) for time, message in found[mcap_file.PLACE]]
    assert places == [(times[first], name) for first, name in NAMES]
    for number, (_, message) in enumerate(found[mcap_file.PICTURE]):
        image = cv2.imdecode(message.data, cv2.IMREAD_COLOR)
        assert image.shape == (480, 920, 3) and message.format == "jpeg"
        # Avoid the regions that are drawn over the middle and the left of the frame.
        assert decoded(image[400:470, :640]) == number
    quality = {topic: one.ext.offered_qos_profiles[0] for topic, one in connections.items()}
    assert quality[mcap_file.PLACE].durability.name == "TRANSIENT_LOCAL"
    assert quality[mcap_file.PICTURE].durability.name == "VOLATILE"
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["said.mcap"]


def test_an_mcap_file_opens_without_ros(system, tmp_path):
    """Foxglove needs message definitions, CDR data, a summary and chunk indices."""
    mcap = pytest.importorskip("mcap.reader", reason="mcap is not installed: pip install mcap")
    walk(tmp_path / "walk.bag")
    predict("walk.bag", "--mcap", "said.mcap")
    with (tmp_path / "said.mcap").open("rb") as file:
        reader = mcap.make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        places = [content.data for _, _, content in reader.iter_messages(topics=mcap_file.PLACE)]
    assert {one.encoding for one in summary.schemas.values()} == {"ros2msg"}
    assert {one.message_encoding for one in summary.channels.values()} == {"cdr"}
    text = next(one.data.decode() for one in summary.schemas.values() if one.name.endswith("Classification"))
    assert "vision_msgs/ObjectHypothesis[] results" in text and f"{'=' * 80}\nMSG: std_msgs/Header" in text
    assert summary.statistics.message_count == 2 * COUNT + len(NAMES)
    assert summary.chunk_indexes[0].message_index_offsets.keys() == summary.channels.keys()
    # A little-endian CDR header, the length of the string, and the null-terminated string.
    assert places[1] == b"\x00\x01\x00\x00" + (12).to_bytes(4, "little") + b"living_room\x00"


def test_mcap_files_are_reproducible(system, tmp_path):
    walk(tmp_path / "walk.bag")
    predict("walk.bag", "--mcap", "one/said.mcap")
    predict("walk.bag", "--mcap", "two/said.mcap")
    assert (tmp_path / "one/said.mcap").read_bytes() == (tmp_path / "two/said.mcap").read_bytes()


@pytest.mark.parametrize("ending", ["mcap", "rrd"])
def test_an_interrupted_export_leaves_no_files(system, tmp_path, monkeypatch, ending):
    if ending == "rrd":
        pytest.importorskip("rerun", reason="rerun is not installed: pip install -e '.[rerun]'")
    walk(tmp_path / "walk.bag")
    original = FakeCategorizer.update

    def update(self, frame, seconds):
        if len(self.times) == 5:
            raise KeyboardInterrupt
        return original(self, frame, seconds)

    monkeypatch.setattr(FakeCategorizer, "update", update)
    option = "--mcap" if ending == "mcap" else "--rerun"
    with pytest.raises(SystemExit):
        predict("walk.bag", option, f"said.{ending}")
    assert [path.name for path in tmp_path.iterdir()] == ["walk.bag"]


def test_rerun_export_stops_if_the_disk_is_full(system, tmp_path, monkeypatch):
    pytest.importorskip("rerun", reason="rerun is not installed: pip install -e '.[rerun]'")
    write_image(tmp_path / "images/1.png", 1)
    before = sorted(tmp_path.rglob("*"))
    monkeypatch.setattr(rerun_file, "LEAST_FREE", 10**18)
    assert "MB of free disk space: free up some space" in refused("images", "--rerun", "a.rrd")
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize(("option", "package"), [("--mcap", "rosbags"), ("--rerun", "rerun")])
def test_message_for_a_missing_package_names_the_extra(system, tmp_path, monkeypatch, option, package):
    write_image(tmp_path / "images/1.png", 1)
    monkeypatch.setitem(sys.modules, package, None)
    name = f"a{'.mcap' if option == '--mcap' else '.rrd'}"
    assert f"{option} needs the optional extra ({package} is missing)" in refused("images", option, name)


def recorded(path, entity, field):
    """Return the value of an entity's field for each frame, read with the installed version of Rerun."""
    import rerun

    if hasattr(rerun, "dataframe"):
        view = rerun.dataframe.load_recording(path).view(index="frame", contents=entity)
        # The column of a timeline has no entity in its name.
        tables = [(view.select().read_all(), f"{entity}:{field}" if ":" in field else field)]
    else:
        from rerun.chunk import RrdReader

        chunks = [chunk for chunk in RrdReader(path).stream() if chunk.entity_path == entity]
        tables = [(chunk.to_record_batch(), field) for chunk in chunks if not chunk.is_static]
    found = {}
    for table, column in tables:
        pairs = zip(table["frame"].to_pylist(), table[column].to_pylist(), strict=True)
        found |= {frame: value for frame, value in pairs if value is not None}
    return found


def test_a_rerun_recording_has_frames_regions_probabilities_and_places(system, tmp_path):
    pytest.importorskip("rerun", reason="rerun is not installed: pip install -e '.[rerun]'")
    walk(tmp_path / "walk.bag")
    predict("walk.bag", "--rerun", "out/said.rrd")
    path = tmp_path / "out/said.rrd"
    for index, name in enumerate(CLASSES):
        scores = recorded(path, f"/{rerun_file.PROBABILITIES}/{name}", "Scalars:scalars")
        assert scores == {number + 1: [expected(number)[0][index]] for number in range(COUNT)}
    images = recorded(path, f"/{rerun_file.IMAGE}", "EncodedImage:blob")
    for frame, (content,) in images.items():
        assert decoded(cv2.imdecode(np.array(content, np.uint8), cv2.IMREAD_COLOR)) == frame - 1
    regions = recorded(path, f"/{rerun_file.REGIONS}", "Points2D:positions")
    assert regions == {number + 1: [[32.5, 24.5], [10.5, 10.5]] for number in range(COUNT)}
    assert recorded(path, f"/{rerun_file.REGIONS}", "Points2D:radii")[1] == [2, 8]
    places = recorded(path, f"/{rerun_file.PLACE}", "TextLog:text")
    assert places == {first + 1: [name.replace("_", " ")] for first, name in NAMES}
    times = recorded(path, f"/{rerun_file.PLACE}", "time")
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["said.rrd"]
    assert len(images) == COUNT and len(times) == len(places)
