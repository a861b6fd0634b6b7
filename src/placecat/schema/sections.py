"""What each section of params.yaml and an experiment have: names and types.

Settings of classifiers, estimators, descriptors and figures are the parameters of their functions, of which
:mod:`placecat.signatures` knows. Ranges are checked where the numbers are used.
"""

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, model_validator

from placecat import lookup

# Settings of a function.
Own = dict[str, Any]
# YAML reads names such as 2 as numbers.
Name = str | int


class Section(BaseModel):
    """A mapping with these settings and no other, of these types."""

    model_config = ConfigDict(extra="forbid", strict=True)


class Dataset(Section):
    """conf/dataset."""

    name: Name
    title: Name
    thesis_data: str | None
    layout: str
    root: Name
    homes: list[Name]
    fps: float | None
    camera: Name | dict[Name, Name]
    classes: list[str]
    ignored: list[str]
    aliases: dict[Name, str]
    require_all_classes: bool

    @model_validator(mode="before")
    @classmethod
    def _without_those_of_the_layout(cls, content: Any) -> Any:
        """Leave out what the layout's reader takes beside the common settings, and so checks."""
        if not isinstance(content, Mapping) or set(content) <= set(cls.model_fields):
            return content
        own = lookup.parameters("placecat.sequences", str(content.get("layout")), "read_home")
        return {key: value for key, value in content.items() if key in cls.model_fields or key not in own}


class Attention(Section):
    """conf/attention."""

    scales: list[int]
    radii: list[int]
    clip_color: bool
    gabor_size: int
    gabor_sigma: float
    gabor_wavelength: float
    gabor_aspect: float
    gabor_phase: float | None
    use_residual: bool
    residual_box: int
    residual_sigma: float
    residual_width: int | None
    residual_floor: float


class Regions(Section):
    """conf/regions."""

    max_regions: int
    scale_distance: float
    min_distance: float
    fusion_scale: int
    maximum_window: int
    intensity_unit: float
    color_unit: float
    orientation_unit: float
    residual_unit: float
    use_residual: bool


class Frames(Section):
    """Every ``step``-th frame from ``offset``."""

    offset: int
    step: int


class Variant(Section):
    """A variant of the salient regions."""

    scales: list[int] | None
    regions: Own


class RegionVariants(Section):
    """conf/region_variants."""

    frames: Frames
    descriptors: list[str]
    variants: dict[str, Variant]


class Information(Section):
    """conf/information."""

    fine: int
    coarse: int | None
    unit: float


class Tracking(Section):
    """conf/tracking."""

    descriptors: list[str]
    max_regions: int
    width: int
    window: int
    levels: int
    iterations: int
    epsilon: float
    min_eigenvalue: float
    forward_backward: float
    scale_distance: float
    min_distance: float


class Extra(Section):
    """Further training data."""

    split: str
    sequences: list[Name]


class Protocol(Section):
    """conf/protocol."""

    schemes: list[str]
    test_homes: Name | list[Name]
    cue_frames: Frames
    integration_frames: Frames
    seeds: list[int]
    extra: Extra | None


class Smoothing(Section):
    """conf/smoothing."""

    delay_seconds: float
    evidence: str
    evidence_seconds: float
    reliability: str
    transition_counts: float
    emission_counts: float
    cues: list[str]
    filtered: list[str]


class Model(Section):
    """conf/model."""

    system: str
    seed: int


class Points(Section):
    """Of the circles."""

    radius: float
    inside: float


class Sensitivity(Section):
    """Variants of the circles."""

    seeds: list[int]
    radii: list[float]
    decisions: list[str]


class Toy(Section):
    """conf/toy."""

    schemes: dict[str, Own]
    training: int
    testing: int
    seeds: list[int]
    points: Points
    sensitivity: Sensitivity


class Verdict(Section):
    """conf/verdict."""

    level: float
    resamples: int
    minimum_units: int
    few_homes: int
    about: float
    margin: float
    noticeable: float
    rare: float


class Local(Section):
    """conf/compute/local.yaml."""

    kind: Literal["local"]


class Dask(Section):
    """conf/compute/dask.yaml."""

    kind: Literal["dask"]
    scheduler: str
    wait: float
    may_differ: list[str]


class Reproducibility(Section):
    """conf/reproducibility."""

    tolerance: float


class Probabilities(Section):
    """conf/probabilities."""

    bins: int
    smallest: float


class Descriptors(Section):
    """conf/descriptor."""

    local: dict[str, Own] = {}
    holistic: dict[str, Own] = {}


class Descriptor(Section):
    """By which a cue or codebook knows a descriptor."""

    kind: Literal["local", "holistic"]
    name: str
    y_pos: bool | None = None
    y_weight: float | None = None
    color: str | None = None
    max_regions: int | None = None
    tracked: bool | None = None


class Codebook(Section):
    """A file of conf/codebook."""

    descriptor: Descriptor
    tree: Own
    schemes: list[str]
    cells: int


class Cue(Section):
    """A file of conf/cue."""

    title: Name
    codebook: str | None
    schemes: list[str]
    cross_validate: bool
    extra: bool
    classifier: Own
    descriptor: Descriptor | None = None


class Integrator(Section):
    """A file of conf/integrator."""

    method: str
    classifier: Own | None = None


class System(Section):
    """A file of conf/system."""

    title: Name
    scheme: str
    temperature: bool
    extra: bool
    cues: list[str]
    integrator: Integrator


class Filter(Section):
    """A file of conf/filter."""

    threshold: float | None
    share: float | None
    cues: list[str]
    systems: list[str]


class Part(Section):
    """A training sequence of a split."""

    sequence: Name
    places: list[str] | None


class Split(Section):
    """A file of conf/split."""

    dataset: Dataset
    integrator: Integrator
    descriptors: dict[Literal["local", "holistic"], list[str]]
    cue_parts: list[Part]
    integration_parts: list[Part]
    test: list[Name]
    systems: dict[str, list[str]]


class Example(Section):
    """What Figures 2 to 7 show."""

    home: int | None = None
    frame: int | None = None


class Figures(BaseModel):
    """conf/figures; each figure has settings of its own."""

    model_config = ConfigDict(extra="allow", strict=True)
    __pydantic_extra__: dict[str, Own]

    example: Example = Example()


class Params(Section):
    """params.yaml. A section that is left out is missed by the stage that reads it."""

    dataset: Dataset | None = None
    attention: Attention | None = None
    regions: Regions | None = None
    region_variants: RegionVariants | None = None
    information: Information | None = None
    tracking: Tracking | None = None
    protocol: Protocol | None = None
    smoothing: Smoothing | None = None
    model: Model | None = None
    toy: Toy | None = None
    verdict: Verdict | None = None
    compute: Annotated[Local | Dask, Field(discriminator="kind")] | None = None
    reproducibility: Reproducibility | None = None
    probabilities: Probabilities | None = None
    figures: Figures | None = None
    descriptors: Descriptors | None = None
    codebooks: dict[str, Codebook] = {}
    cues: dict[str, Cue] = {}
    systems: dict[str, System] = {}
    filters: dict[str, Filter] = {}
    splits: dict[str, Split] = {}


class ExperimentFrames(Section):
    """Of an experiment; None: as in params.yaml."""

    offset: int | None
    step: int | None


class ExperimentCodebook(Section):
    """Of an experiment; None: as usual for the classifier."""

    cells: int | None
    tree: Own


class Limits(Section):
    """What an experiment may need unasked."""

    kernel_rows: int


class Experiment(Section):
    """conf/experiment.yaml."""

    descriptor: Descriptor
    classifier: Own
    data: str
    test_home: Name | list[Name]
    judge: Literal["test_home", "training_homes"]
    frames: ExperimentFrames
    seeds: int | list[int] | None
    codebook: ExperimentCodebook
    cells_of_frames: dict[str, int]
    limits: Limits
    track: bool
