import hashlib
import io
import json
import re
import struct
import zipfile
from collections import Counter
from dataclasses import replace
from pathlib import Path

import mutants
import numpy as np
import pytest
import yaml
from made_system import UNKNOWN, frames, make_system

from placecat import __version__
from placecat.__main__ import main
from placecat.categorizer import Categorizer, archive, model_file, train
from placecat.errors import PlacecatError
from placecat.settings import read_yaml
from project import ROOT


@pytest.fixture(scope="module")
def system():
    return make_system()


@pytest.fixture
def file(system, tmp_path):
    model_file.write(tmp_path / "model.placecat", system)
    return tmp_path / "model.placecat"


def test_a_stored_system_yields_identical_results(system, file):
    first, second = Categorizer(system), Categorizer.load(file)
    for frame in frames(4):
        one, two = first.update(frame), second.update(frame)
        np.testing.assert_array_equal(one.proba, two.proba)
        np.testing.assert_array_equal(one.integrated, two.integrated)
        assert one.place == two.place


def test_identical_systems_yield_identical_bytes_without_pickle(system, file, tmp_path):
    model_file.write(tmp_path / "again.placecat", system)
    assert file.read_bytes() == (tmp_path / "again.placecat").read_bytes()
    with zipfile.ZipFile(file) as archive:
        for name in archive.namelist():
            content = archive.read(name)
            if name.endswith(".npy"):
                assert b"'O'" not in content[:128]
            else:
                content.decode("utf-8")
    assert len(list(tmp_path.iterdir())) == 2


def test_the_card_has_the_facts_for_a_reader(file):
    card = model_file.read(file).card
    assert card["classes"] == ["bedroom", "kitchen", "bathroom"]
    with zipfile.ZipFile(file) as archive:
        text = archive.read("card.md").decode()
    for part in (
        "bedroom, kitchen, bathroom",
        "320x180",
        "noise (version v), homes a, excluding c, d.",
        "It hums.",
        "`unknown` if its confidence is below 0.400. Above this confidence, at most 10% of",
        "| 10% | 0.400 | 62.5% | 12.5% | 25.0% |",
        "| 1% | none | 0.0% | - | - |",
        "| 50.00 | 25.00 | 37.50 |",
        __version__,
        "numpy",
    ):
        assert part in text


def rewrite(file, name, change):
    """Change one member and correct the checksum."""
    with zipfile.ZipFile(file) as opened:
        members = {member: opened.read(member) for member in opened.namelist()}
    members[name] = change(members[name])
    archive.write(file, {member: content for member, content in members.items() if content is not None})


def reseal(file, *, compression=zipfile.ZIP_STORED, twice=(), comment=None):
    """Write the archive without `archive.write`, but with a correct checksum."""
    with zipfile.ZipFile(file) as opened:
        members = [(member, opened.read(member)) for member in opened.namelist()]
    with zipfile.ZipFile(file, "w", compression) as opened:
        opened.comment = archive._MARK + bytes(archive._DIGITS) if comment is None else comment
        for member, content in members:
            opened.writestr(member, content)
            if member in twice:
                with pytest.warns(UserWarning, match="Duplicate"):
                    opened.writestr(member, content)
    if comment is None:
        seal(file)


def seal(file):
    content = file.read_bytes()[: -archive._DIGITS]
    file.write_bytes(content + hashlib.sha256(content).hexdigest().encode())


def larger(file, member, size):
    """Make the archive's directory declare this size for a member."""
    with zipfile.ZipFile(file) as opened:
        before = opened.getinfo(member).file_size
    content = file.read_bytes()
    at = content.rindex(b"PK\x01\x02", 0, content.rindex(member.encode()))
    start, sizes = content[: at + 20], struct.pack("<II", before, before)
    assert content[at + 20 : at + 28] == sizes
    file.write_bytes(start + struct.pack("<II", size, size) + content[at + 28 :])
    seal(file)


def change_json(**changes):
    return lambda content: json.dumps(json.loads(content) | changes).encode()


def change_part(*path, value):
    """Return a function that changes one value in the content of system.json."""

    def change(content):
        whole = json.loads(content)
        here = whole
        for key in path[:-1]:
            here = here[key]
        assert path[-1] in here if isinstance(here, dict) else True
        here[path[-1]] = value
        return json.dumps(whole).encode()

    return change


def object_array(_):
    buffer = io.BytesIO()
    np.save(buffer, np.array([print], dtype=object), allow_pickle=True)
    return buffer.getvalue()


def header(text):
    """Return a function that makes an array with this header."""
    padded = text.encode().ljust(117) + b"\n"
    return lambda _: b"\x93NUMPY\x01\x00" + struct.pack("<H", len(padded)) + padded + bytes(8)


MODEL = ("cues", 0, "model", "state")


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda file: file.unlink(), "placecat train"),
        (lambda file: file.write_bytes(b"no zip"), "not a placecat model"),
        (lambda file: file.write_bytes(file.read_bytes()[:5000]), "not a placecat model.* truncated"),
        (lambda file: file.write_bytes(file.read_bytes().replace(b"\x93NUMPY", b"\x93NUMPX", 1)), "damaged"),
        (lambda file: reseal(file, comment=b""), "written by an earlier version: train it again"),
        (lambda file: rewrite(file, "card.json", change_json(format=99)), "format 99"),
        (lambda file: rewrite(file, "card.json", change_json(placecat="9.3.0")), "placecat 9.3.0"),
        (lambda file: rewrite(file, "card.json", change_json(format=None)), "its card has no version"),
        (lambda file: rewrite(file, "card.json", change_json(classes=["a", "a", "b"])), "listed twice"),
        (
            lambda file: rewrite(file, "card.json", change_json(classes=["a", "b"])),
            "smoothing does not match its 2 places",
        ),
        (lambda file: rewrite(file, "card.json", change_json(frame_sizes=[[320, 10**9]])), "frame_sizes"),
        (lambda file: rewrite(file, "card.json", change_json(fps=[float("nan")])), "NaN is not a number"),
        (
            lambda file: rewrite(file, "card.json", change_json(unknown=UNKNOWN | {"threshold": -1})),
            "threshold",
        ),
        (lambda file: rewrite(file, "card.json", change_json(unknown={"risk": 0.1})), "unknown"),
        (lambda file: rewrite(file, "card.json", lambda _: None), "card.json"),
        (lambda file: rewrite(file, "system.json", lambda _: b"{}"), "damaged"),
        (lambda file: rewrite(file, "system.json", lambda _: b"[1"), "damaged"),
        (lambda file: rewrite(file, "system.json", lambda _: b"[" * 10**5), "damaged"),
        (
            lambda file: rewrite(file, "system.json", change_json(smoothing={"$": "float", "text": "1"})),
            "wrong types",
        ),
        (lambda file: rewrite(file, "system.json", change_json(arrays=10**9)), "arrays"),
        (
            lambda file: rewrite(
                file, "system.json", change_part("vision", "attention", value={"gabor_size": 10**9})
            ),
            "gabor_size",
        ),
        (
            lambda file: rewrite(
                file, "system.json", change_part(*MODEL, "scheme", "state", "folds", value=-3)
            ),
            "folds of a OneAgainstAll",
        ),
        (
            lambda file: rewrite(
                file, "system.json", change_part("integrator", "state", "method", value="os")
            ),
            "method of a Integrator",
        ),
        (
            lambda file: rewrite(
                file, "system.json", change_part("smoothing", "state", "frame_rate", value=0.0)
            ),
            "frame_rate of a SmoothingModel",
        ),
        (lambda file: rewrite(file, "arrays/0000.npy", lambda _: None), "0000.npy|other members"),
        (lambda file: rewrite(file, "arrays/0000.npy", object_array), "damaged"),
        (
            lambda file: rewrite(
                file,
                "arrays/0000.npy",
                header("{'descr': '<f8', 'fortran_order': False, 'shape': (10000, 1000000), }"),
            ),
            "it declares 80000000000 bytes but contains 8",
        ),
        (lambda file: rewrite(file, "arrays/0000.npy", header("(" * 100)), "0000.npy has no array header"),
        (lambda file: reseal(file, compression=zipfile.ZIP_DEFLATED), "compressed"),
        (lambda file: reseal(file, twice=["arrays/0003.npy"]), "two of its members"),
        (lambda file: larger(file, "arrays/0003.npy", 2**31), "exceed the file size"),
    ],
)
def test_other_files_and_versions_are_rejected(file, damage, message):
    damage(file)
    with pytest.raises(PlacecatError, match=message) as refused:
        model_file.read(file)
    assert str(refused.value).count(str(file)) == 1
    assert "\n" not in str(refused.value)


def test_an_unreadable_file_raises_one_error(file, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied", str(file))

    monkeypatch.setattr("pathlib.Path.open", refuse)
    with pytest.raises(PlacecatError, match=r"the model .*model\.placecat cannot be read: Permission denied"):
        model_file.read(file)


def test_a_model_is_tried_before_use(file):
    """Each part is valid, but the descriptor does not fit the model of the cue."""
    rewrite(file, "system.json", change_part("cues", 1, "descriptor", "y_pos", value=False))
    with pytest.raises(PlacecatError, match=r"model\.placecat is damaged.*features, but"):
        Categorizer.load(file)


def most_memory(*, forget=False):
    """Return the peak memory of this process since the last reset, or 0 if it is unknown."""
    process = Path("/proc/self")
    if not (process / "clear_refs").exists():
        return 0
    if forget:
        (process / "clear_refs").write_text("5")
    return 1024 * int(re.search(r"VmHWM:\s+(\d+) kB", (process / "status").read_text())[1])


@pytest.mark.parametrize("is_forged", [False, True], ids=["damaged", "forged"])
def test_mutants_are_rejected_or_valid(file, is_forged):
    shown, before = frames(2), most_memory(forget=True)
    expected = mutants.decisions(file, shown)
    intact, counts = file.read_bytes(), Counter()
    for seed in range(50):
        rng = np.random.default_rng(seed)
        file.write_bytes(intact if is_forged else mutants.damaged(intact, rng))
        if is_forged:
            mutants.forged(file, rng)
        counts[mutants.outcome(file, shown, expected, is_forged=is_forged)] += 1
    assert set(counts) <= {"refused", "same", "other"}, counts
    assert counts["refused"] >= 15, counts
    # The memory `before` includes the leftovers of earlier tests in this process.
    assert most_memory() - before < 2**29


def test_other_classes_are_rejected(file):
    Categorizer.load(file, classes=["bedroom", "kitchen", "bathroom"])
    with pytest.raises(PlacecatError, match="bedroom, kitchen, bathroom"):
        Categorizer.load(file, classes=["kitchen", "bedroom", "bathroom"])


def test_only_a_model_is_replaced(file, tmp_path):
    """An intact or damaged model may be replaced, but nothing else."""
    assert model_file.is_model(file)
    reseal(file, twice=["arrays/0003.npy"])
    assert model_file.is_model(file)
    for name, content in (("notes.md", b"text"), ("void.placecat", b"")):
        (tmp_path / name).write_bytes(content)
        assert not model_file.is_model(tmp_path / name)


def test_the_output_path_is_checked_before_training(tmp_path, monkeypatch):
    monkeypatch.setattr(train, "train", lambda *_, **__: pytest.fail("it trains"))
    (tmp_path / "README.md").write_text("text")
    with pytest.raises(
        PlacecatError, match=r"README\.md already exists and is not a model, so it will not be overwritten"
    ):
        train.train_command("das_551_best", [], None, tmp_path / "README.md")
    with pytest.raises(PlacecatError, match="a file is where a folder should be"):
        train.train_command("das_551_best", [], None, tmp_path / "README.md/x")


def test_a_trained_model_is_measured_without_the_same_homes(tmp_path, monkeypatch, capsys, system):
    calls = []
    params = read_yaml(ROOT / "params.yaml")
    (tmp_path / "params.yaml").write_text(yaml.safe_dump(params))
    monkeypatch.chdir(tmp_path)
    plain = replace(system, card=system.card | {"settings": {"seed": 1}, "unknown": None})
    monkeypatch.setattr(train, "train", lambda *_, **options: calls.append(options) or plain)
    monkeypatch.setattr(train.held_out, "by_training", lambda *options: calls.append(options) or {})
    monkeypatch.setattr(train, "check_data", lambda own: calls.append(own))
    homes = ["--without", "home_6", "--without", "home_1", "--without", "home_6"]
    with pytest.raises(SystemExit, match="data/features/home_1 is missing: run `placecat repro` first"):
        main(["train", "das_551_all", *homes])
    calls.clear()
    for home in params["dataset"]["homes"]:
        (tmp_path / "data/features" / home).mkdir(parents=True)
    main(["train", "das_551_all", *homes])
    assert calls == [
        params,
        {"without": ["home_6", "home_1"], "seed": None},
        (params, "das_551_all", ["home_6", "home_1"], 1),
    ]
    output = "data/models/das_551_all-without-home_6-without-home_1.placecat"
    assert model_file.read(tmp_path / output).card["accuracy"] == {}
    assert f"`placecat predict SOURCE --model {output}`" in capsys.readouterr().out
