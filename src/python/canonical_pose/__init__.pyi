# Types of the module, for editors and type checkers; see __init__.py.

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, NamedTuple, TypedDict, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Unpack

__version__: str
__all__: list[str]

_Floats = NDArray[np.float64]
_Integers = NDArray[np.intp]
_Faces = ArrayLike | Sequence[Sequence[int]]
_Body = Literal["auto", "lattice", "tetgen", "mesh"]
_Geodesics = Literal["heat", "wavefront", "exact"]
_Kernel = Literal["classical", "gaussian", "gaussian-uncentred"]
_TargetMode = Literal["mds", "unfold"]
_Frame = Literal["auto", "input", "canonical", "body"]
_Stance = Literal["canonical", "t", "a", "vitruvian", "stand"]
_Components = Literal["auto", "refuse", "largest", "each"]
_Contacts = Literal["keep", "cut"]
_Symmetry = Literal["auto", "none"]
_Solver = Literal["auto", "eigen", "cholmod"]
_Constraints = ArrayLike | Sequence[Sequence[float]] | None
_Path = str | PathLike[str]
_Descriptors = str | Sequence[str] | None
_WeightedDescriptors = _Descriptors | Mapping[str, float]

class Mesh(NamedTuple):
    vertices: _Floats
    faces: _Integers | list[list[int]] | None
    cells: _Integers | None

class Progress(NamedTuple):
    iteration: int
    round: int
    component: int
    energy: float
    energy_match: float
    energy_arap: float
    energy_constraints: float
    largest_move: float

_Progress = Callable[[Progress], object] | None

# Reports. Numbers that are not finite are None.

class _Input(TypedDict):
    vertices: int
    faces: int
    components: int
    boundary_edges: int
    non_manifold: int
    degenerate_faces: int
    self_intersections: int | Literal["not searched"] | None

class _BodyReport(TypedDict):
    kind: str
    vertices: int
    tetrahedra: int

class _Follower(TypedDict):
    component: int
    vertex: int
    leader: int
    rigid: bool

class _Target(TypedDict):
    kernel: str
    landmarks: int
    covering_radius: float
    stress: float
    eigenvalues: list[float]
    max_geodesic: float
    scale: float
    reflected: bool
    is_handedness_certain: bool
    symmetry_distortion: float | None

class _Round(TypedDict):
    stress: float
    energy: float
    median_edge_strain: float
    seconds: float

class _Registration(TypedDict):
    iterations: int
    converged: bool
    energy: float
    energy_match: float
    energy_arap: float
    energy_constraints: float
    inverted: int
    flipped_faces: int
    volume_ratio: float
    median_edge_strain: float

class _Joint(TypedDict):
    name: str
    parent: str
    position: list[float]
    radius: float

class _Skeleton(TypedDict):
    kind: Literal["person", "four-legged"]
    is_front_certain: bool
    joints: list[_Joint]

class _Stage(TypedDict):
    name: str
    seconds: float

class _Versions(TypedDict):
    canonical_pose_3: str
    cgal: str
    eigen: str
    boost: str
    cholmod: str | None
    tbb: str | None
    compiler: str

class _Run(TypedDict):
    stages: list[_Stage]
    total_seconds: float
    peak_memory_bytes: int
    versions: _Versions

class _PoseReport(_Run):
    input: _Input
    body: _BodyReport
    followers: list[_Follower]
    target: _Target
    rounds: list[_Round]
    registration: _Registration
    skeleton: _Skeleton | None
    solver: str
    warnings: list[str]

class _Defect(TypedDict):
    kind: str
    count: int
    element: str
    examples: list[list[int]]
    message: str

class _CheckReport(_Run):
    input: _Input
    first_defect: str | None
    defects: list[_Defect]

class _Neighbor(TypedDict):
    part: int
    boundary_length: float
    boundary_centroid: list[float]

class _Part(TypedDict):
    area: float
    faces: int
    neighbors: list[_Neighbor]

class _Merge(TypedDict):
    nodes: list[int]
    cost: float

class _Tree(TypedDict):
    leaves: int
    leaf_of_face: _Integers
    merges: list[_Merge]

class _SegmentReport(_Run):
    method: str
    parts: list[_Part]
    tree: _Tree | None
    warnings: list[str]

class _RegistrarReport(TypedDict):
    iterations: int
    converged: bool
    energy: float
    energy_match: float
    energy_arap: float
    inverted: int
    volume_ratio: float

class _Descriptor(TypedDict):
    version: int
    values: _Floats

class _ShapeMatch(TypedDict):
    mean_distance: float
    mean_round_trip: float
    is_rotation_certain: bool
    warnings: list[str]
    seconds: float
    template: str
    template_checksum: str
    checksum: str

class _MatchedReport(_PoseReport):
    match: _ShapeMatch

class _Shape(TypedDict):
    path: str
    checksum: str
    options: str
    version: str
    outcome: str
    message: str
    seconds: float
    has_pose: bool
    is_segmented: bool
    descriptors: dict[str, int]
    report: _PoseReport | _MatchedReport | _CheckReport | None

class _Answer(TypedDict):
    path: str
    distance: float

class _Measures(TypedDict):
    nearest_neighbor: float
    first_tier: float
    second_tier: float
    e_measure: float
    discounted_cumulative_gain: float
    average_precision: float

class _Evaluation(TypedDict):
    mean: _Measures
    classes: dict[str, _Measures]
    precision: list[float]
    nearest: dict[str, dict[str, int]]

def load(path: _Path) -> Mesh: ...
def save(path: _Path, vertices: ArrayLike, faces: _Faces | None = ..., *,
         cells: ArrayLike | None = ..., like: _Path | None = ...) -> None: ...

class _OptionsButLandmarks(TypedDict, total=False):
    detail_length: float
    rounds: int | None
    body: _Body
    spacing: float | None
    geodesics: _Geodesics
    target_mode: _TargetMode
    kernel: _Kernel
    tikhonov: float
    iterations: int
    paper_weights: tuple[float, float] | None
    injective: bool | None
    components: _Components
    contacts: _Contacts
    symmetry: _Symmetry
    solver: _Solver
    seed: int
    threads: int

class _RecordedOptions(_OptionsButLandmarks, total=False):
    landmarks: int

class _OptionsOfInput(TypedDict, total=False):
    stance: (_Stance | Mapping[Any, _Stance | Sequence[float | str]]
             | Sequence[Sequence[float | str]])
    frame: _Frame
    matching_weights: ArrayLike | None
    stiffness: ArrayLike | None
    given_target: ArrayLike | None
    given_distances: ArrayLike | None
    spring: _Constraints
    direction: _Constraints
    handle: _Constraints
    symmetric: _Constraints

class _Options(_RecordedOptions, _OptionsOfInput, total=False): ...
class _MatchOptions(_OptionsButLandmarks, _OptionsOfInput, total=False): ...

@overload
def pose(vertices: ArrayLike, faces: _Faces | None = ..., *, cells: ArrayLike | None = ...,
         return_target: Literal[False] = ..., progress: _Progress = ...,
         **options: Unpack[_Options]) -> tuple[_Floats, _PoseReport]: ...
@overload
def pose(vertices: ArrayLike, faces: _Faces | None = ..., *, cells: ArrayLike | None = ...,
         return_target: Literal[True], progress: _Progress = ..., **options: Unpack[_Options]
         ) -> tuple[_Floats, _PoseReport, _Floats]: ...
def target(vertices: ArrayLike, faces: _Faces, **options: Unpack[_Options]
           ) -> tuple[_Floats, _PoseReport]: ...
def geodesics(vertices: ArrayLike, faces: _Faces, source: int | ArrayLike, *,
              geodesics: _Geodesics = ..., threads: int = ...) -> _Floats: ...
def check(vertices: ArrayLike, faces: _Faces | None = ..., *, cells: ArrayLike | None = ...
          ) -> _CheckReport: ...
def compare(pose: ArrayLike, other: ArrayLike, *more: ArrayLike) -> tuple[float, float]: ...
def align_handedness(pose: ArrayLike, other: ArrayLike, *more: ArrayLike) -> NDArray[np.bool_]: ...
def mean_pose(poses: Sequence[ArrayLike]) -> _Floats: ...
def segment(vertices: ArrayLike, faces: _Faces, *, parts: int | Literal["auto"] = ...,
            method: Literal["consensus", "sweep", "kmeans"] = ..., pose: ArrayLike | None = ...,
            progress: _Progress = ..., **options: Unpack[_Options]
            ) -> tuple[_Integers, _SegmentReport]: ...
def describe(vertices: ArrayLike, faces: _Faces, *, descriptor: _Descriptors = ...,
             pose: ArrayLike | None = ..., progress: _Progress = ..., **options: Unpack[_Options]
             ) -> dict[str, _Descriptor]: ...
class Match(NamedTuple):
    faces: _Integers
    vertices: _Integers
    weights: _Floats
    faces_at_other: _Integers
    vertices_at_other: _Integers
    weights_at_other: _Floats
    round_trips: _Floats
    scale: float
    mean_distance: float
    edge_strain: float
    is_rotation_certain: bool
    compared_share: float
    compared_share_of_other: float
    def interpolated(self, values: ArrayLike) -> _Floats: ...
    def interpolated_at_other(self, values: ArrayLike) -> _Floats: ...
    def transferred_labels(self, faces: _Faces, other_vertices: ArrayLike, other_faces: _Faces,
                           labels: ArrayLike) -> NDArray[Any]: ...
def match(vertices: ArrayLike, faces: _Faces, other_vertices: ArrayLike, other_faces: _Faces, *,
          pose: ArrayLike | None = ..., other_pose: ArrayLike | None = ...,
          landmarks: Sequence[tuple[int, int]] = ..., progress: _Progress = ...,
          **options: Unpack[_MatchOptions]) -> Match: ...
def shape_distance(vertices: ArrayLike, faces: _Faces, other_vertices: ArrayLike,
                   other_faces: _Faces, *, descriptor: _Descriptors = ...,
                   pose: ArrayLike | None = ..., other_pose: ArrayLike | None = ...,
                   progress: _Progress = ..., **options: Unpack[_Options]) -> dict[str, float]: ...
def collection(database: _Path, shapes: _Path | Sequence[_Path] | None = ..., *,
               descriptor: _Descriptors = ..., poses: _Path | None = ..., match: _Path | None = ...,
               matches: _Path | None = ..., segment: bool = ..., workers: int = ...,
               time_limit: float = ..., memory_limit: float = ..., failed: bool = ...,
               **options: Unpack[_RecordedOptions]) -> list[_Shape]: ...
def search(database: _Path, query: _Path, *, number: int = ...,
           descriptor: _WeightedDescriptors = ..., pose: _Path | None = ...,
           **options: Unpack[_RecordedOptions]) -> list[_Answer]: ...
def evaluate(database: _Path, classes: _Path, *, descriptor: _WeightedDescriptors = ...,
             rerank: Literal["manifold"] | None = ..., **options: Unpack[_RecordedOptions]
             ) -> dict[str, _Evaluation]: ...

class HeatSolver:
    def __init__(self, vertices: ArrayLike, faces: _Faces, *, time_step_factor: float = ...
                 ) -> None: ...
    def distances(self, source: int | ArrayLike) -> _Floats: ...
    def distance_to_nearest(self, sources: ArrayLike) -> _Floats: ...

class Registrar:
    def __init__(self, vertices: ArrayLike, faces: _Faces, **options: Unpack[_Options]) -> None: ...
    @property
    def target(self) -> _Floats: ...
    @property
    def body_vertices(self) -> _Floats: ...
    @property
    def body_cells(self) -> NDArray[np.intc]: ...
    def set_detail_length(self, detail_length: float) -> None: ...
    def register(self, target: ArrayLike, *, warm: bool = ..., progress: _Progress = ...
                 ) -> tuple[_Floats, _RegistrarReport]: ...

class DescriptorIndex:
    def __init__(self, descriptor: str) -> None: ...
    def __len__(self) -> int: ...
    def save(self, path: _Path) -> None: ...
    @staticmethod
    def load(path: _Path) -> DescriptorIndex: ...
    def insert(self, values: ArrayLike) -> int: ...
    def values(self, shape: int) -> _Floats: ...
    def distances(self, query: ArrayLike | None = ...) -> _Floats: ...
    def nearest(self, query: ArrayLike, number: int = ...) -> tuple[_Integers, _Floats]: ...
