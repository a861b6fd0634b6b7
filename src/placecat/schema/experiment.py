"""The schema of an experiment (conf/experiment.yaml): names, types and ranges."""

from typing import Literal

from placecat.ranges import Count, Index, Seed
from placecat.schema.base import Own, Section, Seeds
from placecat.schema.names import Key
from placecat.schema.sections import Descriptor


class ExperimentFrames(Section):
    """The frames of an experiment; None means the value in params.yaml."""

    offset: Index | None
    step: Count | None


class ExperimentCodebook(Section):
    """The codebook of an experiment; None means the classifier's default."""

    cells: Count | None
    tree: Own


class Limits(Section):
    """The limits of an experiment, which users may raise."""

    kernel_rows: Count


class Experiment(Section):
    """conf/experiment.yaml."""

    descriptor: Descriptor
    classifier: Own
    data: Key
    # A home may be spelled in any way, even 1 for Home1.
    test_home: str | int | list[str | int]
    judge: Literal["test_home", "training_homes"]
    frames: ExperimentFrames
    seeds: Seed | Seeds | None
    codebook: ExperimentCodebook
    cells_of_frames: dict[Key, Count]
    limits: Limits
    track: bool
