"""The schema of each section of params.yaml: names, types and ranges.

The settings of classifiers, estimators, descriptors and figures are the parameters of their functions.
:mod:`placecat.schema.signatures` checks them.
"""

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from annotated_types import Interval, MinLen
from pydantic import BaseModel, ConfigDict, Field, model_validator

from placecat import lookup
from placecat.ranges import Count, Index, NonNegative, PartShare, Pixels, Positive, Seed, Share, Two
from placecat.schema.base import Keys, Level, Levels, Odd, Own, Schemes, Section, Seeds, Window
from placecat.schema.names import Distinct, FileName, Folder, Key, Label, Text


class Dataset(Section):
    """conf/dataset."""

    name: Label
    title: Label
    thesis_data: Label | None
    layout: str
    root: Folder
    homes: Annotated[Distinct[FileName], MinLen(1)]
    fps: Annotated[float, Interval(gt=0, le=1000)] | None
    camera: Label | dict[FileName, Label]
    classes: Annotated[Distinct[Label], MinLen(2)]
    ignored: Distinct[Label]
    aliases: dict[Label, Label]
    require_all_classes: bool
    note: Label | None = None

    @model_validator(mode="after")
    def _check_names(self) -> Self:
        folded = [home.casefold() for home in self.homes]
        for home, name in zip(self.homes, folded, strict=True):
            if folded.count(name) > 1:
                raise ValueError(f"homes: {home!r} and another differ only in capitalization: rename one")
        for name in self.ignored:
            if name in self.classes:
                raise ValueError(f"ignored: {name!r} is also a class; remove it from one of the two")
        return self

    @model_validator(mode="before")
    @classmethod
    def _without_those_of_the_layout(cls, content: Any) -> Any:
        """Leave out the settings of the layout reader, which the reader checks itself."""
        if not isinstance(content, Mapping) or set(content) <= set(cls.model_fields):
            return content
        own = lookup.parameters("placecat.sequences", str(content.get("layout")), "read_home")
        return {key: value for key, value in content.items() if key in cls.model_fields or key not in own}


class Attention(Section):
    """conf/attention."""

    scales: Levels
    radii: Annotated[Distinct[Count], MinLen(1)]
    clip_color: bool
    gabor_size: Odd
    gabor_sigma: Positive
    gabor_wavelength: Positive
    gabor_aspect: Positive
    gabor_phase: Annotated[float, Interval(ge=-7, le=7)] | None
    use_residual: bool
    residual_box: Odd
    residual_sigma: NonNegative
    residual_width: Two | None
    residual_floor: Positive


class Regions(Section):
    """conf/regions."""

    max_regions: Count
    scale_distance: NonNegative
    min_distance: NonNegative
    fusion_scale: Annotated[int, Interval(ge=0, le=16)]
    maximum_window: Window
    intensity_unit: Positive
    color_unit: Positive
    orientation_unit: Positive
    residual_unit: Positive
    use_residual: bool


class Frames(Section):
    """Every ``step``-th frame, starting at ``offset``."""

    offset: Index
    step: Count


class Variant(Section):
    """A variant of the salient regions."""

    scales: Levels | None
    regions: Own


class RegionVariants(Section):
    """conf/region_variants."""

    frames: Frames
    descriptors: Keys
    variants: dict[Key, Variant]


class Information(Section):
    """conf/information."""

    fine: Level
    coarse: Level | None
    unit: Positive


class Tracking(Section):
    """conf/tracking."""

    descriptors: Keys
    max_regions: Count
    width: Pixels
    window: Window
    levels: Annotated[int, Interval(ge=0, le=16)]
    iterations: Count
    epsilon: Positive
    min_eigenvalue: NonNegative
    forward_backward: Positive
    scale_distance: NonNegative
    min_distance: NonNegative


class Extra(Section):
    """Additional training data."""

    split: Key
    sequences: Annotated[Distinct[FileName], MinLen(1)]


class Protocol(Section):
    """conf/protocol."""

    schemes: Schemes
    test_homes: str | Annotated[Distinct[FileName], MinLen(1)]
    cue_frames: Frames
    integration_frames: Frames
    seeds: Seeds
    extra: Extra | None


class Smoothing(Section):
    """conf/smoothing."""

    delay_seconds: NonNegative
    evidence: Literal["hard", "soft"]
    evidence_seconds: Positive
    reliability: Literal["hard", "soft"]
    transition_counts: Positive
    emission_counts: Positive
    cues: Keys
    filtered: Distinct[str]


class Model(Section):
    """conf/model."""

    system: Key
    seed: Seed
    risk: PartShare
    risks_shown: Distinct[PartShare]


class Verdict(Section):
    """conf/verdict."""

    level: PartShare
    resamples: Count
    minimum_units: Count
    few_homes: Index
    about: Share
    margin: NonNegative
    noticeable: NonNegative
    rare: Share


class Local(Section):
    """conf/compute/local.yaml."""

    kind: Literal["local"]


class Dask(Section):
    """conf/compute/dask.yaml."""

    kind: Literal["dask"]
    scheduler: Text
    wait: Positive
    may_differ: Distinct[str]


class Reproducibility(Section):
    """conf/reproducibility."""

    tolerance: NonNegative


class Probabilities(Section):
    """conf/probabilities."""

    bins: Count
    smallest: PartShare


class Descriptors(Section):
    """conf/descriptor."""

    local: dict[Key, Own] = {}
    holistic: dict[Key, Own] = {}


class Descriptor(Section):
    """A reference to a descriptor, in a cue or codebook."""

    kind: Literal["local", "holistic"]
    name: Key
    y_pos: bool | None = None
    y_weight: NonNegative | None = None
    color: Key | None = None
    max_regions: Count | None = None
    tracked: bool | None = None


class Codebook(Section):
    """A file in conf/codebook."""

    descriptor: Descriptor
    tree: Own
    schemes: Schemes
    cells: Count


class Cue(Section):
    """A file in conf/cue."""

    title: Label
    codebook: Key | None
    schemes: Schemes
    cross_validate: bool
    extra: bool
    classifier: Own
    descriptor: Descriptor | None = None


class Integrator(Section):
    """A file in conf/integrator."""

    method: Literal["das", "vote_distribution", "vote_decision", "log_pool"]
    classifier: Own | None = None
    shrinkage: NonNegative | None = None
    smallest: PartShare | None = None

    @model_validator(mode="after")
    def _of_its_method(self) -> "Integrator":
        for name, method in (("classifier", "das"), ("shrinkage", "log_pool")):
            if (getattr(self, name) is not None) != (self.method == method):
                raise ValueError(f"{name} is required by method: {method}, and not allowed otherwise")
        if "smallest" in self.model_fields_set and (self.smallest is None or self.method != "log_pool"):
            raise ValueError("smallest must be a number, and needs method: log_pool; omit it for the default")
        return self


class System(Section):
    """A file in conf/system."""

    title: Label
    scheme: Literal["5-5-1", "4-5-1"]
    temperature: bool
    extra: bool
    cues: Annotated[Keys, MinLen(1)]
    integrator: Integrator

    @model_validator(mode="after")
    def _without_extra(self) -> "System":
        if self.extra and self.integrator.method == "log_pool":
            raise ValueError(
                "extra: true does not work with log_pool, which learns from the homes of the cues"
            )
        return self


class Filter(Section):
    """A file in conf/filter."""

    threshold: NonNegative | None
    share: PartShare | None
    cues: Keys
    systems: Keys

    @model_validator(mode="after")
    def _one_of_both(self) -> "Filter":
        if (self.threshold is None) == (self.share is None):
            raise ValueError("it needs either a threshold or a share, not both: set the other one to null")
        return self


class Part(Section):
    """A training sequence of a split."""

    sequence: FileName
    places: Annotated[Distinct[Label], MinLen(1)] | None


class Split(Section):
    """A file in conf/split."""

    dataset: Dataset
    integrator: Integrator
    descriptors: dict[Literal["local", "holistic"], Keys]
    cue_parts: Annotated[list[Part], MinLen(1)]
    integration_parts: Annotated[list[Part], MinLen(1)]
    test: Annotated[Distinct[FileName], MinLen(1)]
    systems: dict[Key, Annotated[Keys, MinLen(1)]]

    @model_validator(mode="after")
    def _cues_are_not_judged(self) -> "Split":
        if self.integrator.method == "log_pool":
            raise ValueError("log_pool does not work with a fixed split, as its cues are not cross-validated")
        return self


class Example(Section):
    """The example in Figures 2 to 7."""

    home: Count | None = None
    frame: Index | None = None


class Figures(BaseModel):
    """conf/figures; each figure has its own settings."""

    model_config = ConfigDict(extra="allow", strict=True, allow_inf_nan=False)
    __pydantic_extra__: dict[str, Own]

    example: Example = Example()


class Points(Section):
    """The points of the circles."""

    radius: Positive
    inside: Annotated[float, Interval(gt=0, lt=0.785)]


class Sensitivity(Section):
    """Variants of the circles."""

    seeds: Seeds
    radii: Annotated[Distinct[Positive], MinLen(1)]
    decisions: Annotated[Distinct[Literal["sign", "probability", "product"]], MinLen(1)]


class Toy(Section):
    """conf/toy."""

    schemes: dict[Key, Own]
    training: Count
    testing: Count
    seeds: Seeds
    points: Points
    sensitivity: Sensitivity


class Params(Section):
    """params.yaml. If a section is missing, the stage that reads it says so."""

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
    codebooks: dict[Key, Codebook] = {}
    cues: dict[Key, Cue] = {}
    systems: dict[Key, System] = {}
    filters: dict[Key, Filter] = {}
    splits: dict[Key, Split] = {}
