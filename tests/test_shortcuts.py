"""Shortcuts planted in artificial homes are detected. The rendered homes are judged in test_data.py."""

import cv2
import numpy as np
import pytest

from placecat import settings
from placecat.errors import PlacecatError
from placecat_homes import shortcuts
from placecat_homes.drawn.rendering import dataset
from placecat_homes.mp4 import frame_sizes
from placecat_homes.shortcuts import LIMIT, measure, report
from project import ROOT

CLASSES = ["bedroom", "bathroom", "kitchen", "living_room", "dining_room"]
STAY = 30
"""Number of frames per room in an artificial home."""


def data_set(name):
    """Return a data set from conf/dataset with an absolute root."""
    content = settings.read_yaml(ROOT / f"conf/dataset/{name}.yaml")
    return content | {"root": ROOT / content["root"]}


def view(rng, *, tint=0.0, light=0.0, grain=0.0):
    """Return an image of random patches with a random mean colour and brightness.

    A tint does not change the brightness.
    """
    patches = rng.uniform(60, 190, (6, 8, 3)) + rng.uniform(-20, 20, 3)
    image = cv2.resize(patches, (160, 120), interpolation=cv2.INTER_LINEAR)
    image += tint * np.array([1, 0, -0.38]) + light + rng.normal(0, 6 + grain, image.shape[:2])[:, :, None]
    return np.clip(image, 0, 255).astype(np.uint8)


def made_homes(root, planted):
    """Make four homes whose rooms differ only in the options of `view` that `planted` returns for each."""
    rng = np.random.default_rng(3)
    homes = ["a", "b", "c", "d"]
    for home in homes:
        writer = cv2.VideoWriter(str(root / f"{home}.mp4"), cv2.VideoWriter.fourcc(*"mp4v"), 5, (160, 120))
        lines = ["start,end,label"]
        for stay, room in enumerate(rng.permutation(len(CLASSES))):
            lines.append(f"{stay * STAY + 1},{(stay + 1) * STAY},{CLASSES[room]}")
            for _ in range(STAY):
                writer.write(view(rng, **planted(int(room))))
        writer.release()
        (root / f"{home}.csv").write_text("\n".join(lines) + "\n")
    return data_set("homes") | {"root": root, "homes": homes}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("planted", "found"),
    [
        (lambda room: {}, set()),
        (lambda room: {"tint": 20 * (room - 2)}, {"mean colour"}),
        (
            lambda room: {"grain": 4 * room},
            {"JPEG size", "video size of the frame", "video size of 5 s"},
        ),
    ],
    ids=["nothing", "a tint", "grain"],
)
def test_a_planted_shortcut_is_found(tmp_path, planted, found):
    assert_found(measure(made_homes(tmp_path, planted)), found)


def assert_found(table, found):
    best = table["average"].groupby("shortcut").max()
    assert set(best.index[best > LIMIT]) == found, best.round(1).to_string()


def test_the_size_of_each_frame_is_read_in_the_order_of_showing(tmp_path):
    """A grey frame takes few bytes and a noisy one takes many, even if frames refer to later ones."""
    av = pytest.importorskip("av")
    rng = np.random.default_rng(5)
    noisy = rng.random(40) < 0.4
    path = tmp_path / "frames.mp4"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=5, options={"bf": "3", "b-adapt": "0"})
        stream.width, stream.height, stream.pix_fmt = 64, 48, "yuv420p"
        for loud in noisy:
            image = rng.integers(0, 255, (48, 64, 3)) if loud else np.full((48, 64, 3), 128)
            container.mux(stream.encode(av.VideoFrame.from_ndarray(image.astype(np.uint8), "bgr24")))
        container.mux(stream.encode())
    with av.open(str(path)) as container:
        packets = [packet for packet in container.demux(video=0) if packet.size]
    stored = [packet.size for packet in packets]
    shown = [packet.size for packet in sorted(packets, key=lambda packet: packet.pts)]
    assert shown != stored
    assert frame_sizes(path).tolist() == shown
    assert frame_sizes(path)[noisy].min() > frame_sizes(path)[1:][~noisy[1:]].max()


@pytest.mark.slow
def test_the_command_judges_the_homes_in_a_folder(tmp_path, capsys, monkeypatch):
    """The command finds planted brightness, ends with an error, and prints the numbers from `measure`."""
    tables = []

    def measured(*arguments):
        assert arguments == (dataset(tmp_path),)
        tables.append(measure(*arguments))
        return tables[-1]

    monkeypatch.setattr(shortcuts, "measure", measured)
    made_homes(tmp_path, lambda room: {"light": 20 * (room - 2)})
    for old in sorted(tmp_path.iterdir()):
        old.rename(old.with_name(f"home_{'abcd'.index(old.stem) + 1}{old.suffix}"))
    with pytest.raises(SystemExit) as ended:
        shortcuts.main([str(tmp_path)])
    assert "more than 35%" in str(ended.value)
    assert capsys.readouterr().out.strip() == report(*tables).strip()
    assert_found(*tables, {"mean colour", "brightness"})


def test_a_folder_without_two_homes_cannot_be_judged(tmp_path):
    with pytest.raises(PlacecatError, match="has no homes"):
        dataset(tmp_path)
    with pytest.raises(PlacecatError, match="at least two homes"):
        measure(data_set("homes") | {"homes": ["home_1"]})
