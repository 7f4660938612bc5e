# Types of the module, for editors and type checkers; see __init__.py.

from collections.abc import Sequence
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
_Report = dict[str, Any]
_Body = Literal["auto", "lattice", "tetgen", "mesh"]
_Geodesics = Literal["heat", "wavefront", "exact"]
_Kernel = Literal["classical", "gaussian", "gaussian-uncentred"]
_TargetMode = Literal["mds", "unfold"]
_Frame = Literal["input", "canonical"]
_Components = Literal["auto", "refuse", "largest", "each"]
_Contacts = Literal["keep", "cut"]
_Solver = Literal["auto", "eigen", "cholmod"]
_Constraints = ArrayLike | Sequence[Sequence[float]] | None
_Path = str | PathLike[str]

class Mesh(NamedTuple):
    vertices: _Floats
    faces: _Integers | list[list[int]] | None
    cells: _Integers | None

def load(path: _Path) -> Mesh: ...
def save(path: _Path, vertices: ArrayLike, faces: _Faces | None = ..., *,
         cells: ArrayLike | None = ..., like: _Path | None = ...) -> None: ...

class _Options(TypedDict, total=False):
    detail_length: float
    landmarks: int
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
    frame: _Frame
    components: _Components
    contacts: _Contacts
    solver: _Solver
    seed: int
    threads: int
    matching_weights: ArrayLike | None
    stiffness: ArrayLike | None
    given_target: ArrayLike | None
    given_distances: ArrayLike | None
    spring: _Constraints
    direction: _Constraints
    handle: _Constraints
    symmetric: _Constraints

@overload
def pose(vertices: ArrayLike, faces: _Faces | None = ..., *, cells: ArrayLike | None = ...,
         return_target: Literal[False] = ..., **options: Unpack[_Options]
         ) -> tuple[_Floats, _Report]: ...
@overload
def pose(vertices: ArrayLike, faces: _Faces | None = ..., *, cells: ArrayLike | None = ...,
         return_target: Literal[True], **options: Unpack[_Options]
         ) -> tuple[_Floats, _Report, _Floats]: ...
def target(vertices: ArrayLike, faces: _Faces, **options: Unpack[_Options]
           ) -> tuple[_Floats, _Report]: ...
def geodesics(vertices: ArrayLike, faces: _Faces, source: int | ArrayLike, *,
              geodesics: _Geodesics = ..., threads: int = ...) -> _Floats: ...
def check(vertices: ArrayLike, faces: _Faces | None = ..., *, cells: ArrayLike | None = ...
          ) -> _Report: ...
def compare(pose: ArrayLike, other: ArrayLike, *more: ArrayLike) -> tuple[float, float]: ...
def segment(vertices: ArrayLike, faces: _Faces, *, parts: int | Literal["auto"] = ...,
            method: Literal["consensus", "sweep", "kmeans"] = ..., pose: ArrayLike | None = ...,
            **options: Unpack[_Options]) -> tuple[_Integers, _Report]: ...
def describe(vertices: ArrayLike, faces: _Faces, *, descriptor: str | Sequence[str] | None = ...,
             pose: ArrayLike | None = ..., **options: Unpack[_Options]
             ) -> dict[str, dict[str, Any]]: ...

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
    def register(self, target: ArrayLike, *, warm: bool = ...) -> tuple[_Floats, _Report]: ...

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
