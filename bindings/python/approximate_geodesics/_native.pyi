from typing import Any, Callable, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

_Floats = npt.NDArray[np.float64]
_Integers = npt.NDArray[np.int64]
_Progress = Optional[Callable[[int, int], object]]

def read_mesh(file: str) -> Tuple[_Floats, npt.NDArray[np.int32]]: ...

version: str

class Locator:
    def __init__(self, solver: Solver) -> None: ...
    def locate(self, points: _Floats) -> Tuple[_Integers, _Floats, _Floats]: ...

class Grid:
    def __init__(
        self,
        rows_columns: Tuple[int, int],
        cell_size: Tuple[float, float],
        no_data: Optional[float],
        first_latitude: Optional[float],
        ellipsoid: Tuple[float, float],
        is_periodic: bool,
        friction: Optional[_Floats],
        heights: Optional[_Floats],
        epsilon: Optional[float],
        cost: Optional[Tuple[int, List[float], _Floats]],
        slope_costs: Optional[_Floats],
        max_slope: float,
        progress: _Progress,
    ) -> None: ...
    def distances(
        self,
        sources: _Integers,
        maximum_distance: float,
        direction_to_source: bool,
        wants_nearest: bool,
        wants_predecessors: bool,
        progress: _Progress,
    ) -> Tuple[_Floats, _Integers, _Integers]: ...
    def path(self, ends: _Integers) -> Tuple[_Floats, float]: ...
    def isolines(self, values: _Floats, level: float) -> list[_Floats]: ...
    def can_enter(self) -> npt.NDArray[np.bool_]: ...
    @property
    def error_on_equal_cells(self) -> float: ...
    @property
    def error_of_slopes(self) -> float: ...
    @property
    def memory(self) -> int: ...

def distances_from_curve(
    solver: Solver,
    elements: _Integers,
    coordinates: Optional[_Floats],
    is_closed: bool,
    is_signed: bool,
    progress: _Progress,
) -> _Floats: ...
def distances_from_region(solver: Solver, faces: list[int], progress: _Progress) -> _Floats: ...
def offsets_of_curve(
    solver: Solver,
    elements: _Integers,
    coordinates: Optional[_Floats],
    is_closed: bool,
    distances: list[float],
    progress: _Progress,
) -> list[Tuple[float, _Floats]]: ...

class Walks:
    def __init__(self, solver: Solver) -> None: ...
    def trace(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        direction: _Floats,
        length: float,
    ) -> Tuple[_Floats, _Floats, float, bool]: ...
    def logarithmic_map(self, elements: _Integers, coordinates: Optional[_Floats]) -> _Floats: ...
    def transport(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        target_elements: _Integers,
        target_coordinates: Optional[_Floats],
        vector: _Floats,
    ) -> _Floats: ...
    def extend_vectors(
        self, elements: _Integers, coordinates: Optional[_Floats], vectors: _Floats
    ) -> _Floats: ...
    def mean(
        self, elements: _Integers, coordinates: Optional[_Floats], weights: _Floats
    ) -> Tuple[Any, float, bool]: ...
    def shorten_loop(
        self, elements: _Integers, coordinates: Optional[_Floats]
    ) -> Tuple[_Floats, float]: ...
    def shorten_curve(
        self, elements: _Integers, coordinates: Optional[_Floats]
    ) -> Tuple[_Floats, float]: ...
    def shortest_loop_through(
        self, elements: _Integers, coordinates: Optional[_Floats]
    ) -> Tuple[_Floats, float]: ...
    def frames(self) -> Tuple[_Floats, _Floats, _Floats]: ...

class Solver:
    def __init__(
        self,
        vertices: _Floats,
        faces: npt.NDArray[Any],
        epsilon: Optional[float],
        face_weights: Optional[_Floats],
        costs: Optional[Tuple[int, List[float], _Floats]],
        max_slope: float,
        accept_weaker_bound: bool,
        maximum_number_of_points: int,
        barriers: Optional[_Integers],
        may_change: bool,
        threads: int,
        progress: _Progress,
    ) -> None: ...
    @staticmethod
    def load(file: str, threads: int) -> Solver: ...
    @staticmethod
    def from_bytes(contents: bytes, threads: int) -> Solver: ...
    def save(self, file: str) -> None: ...
    def to_bytes(self) -> bytes: ...
    def set_weights(self, faces: _Integers, weights: _Floats) -> None: ...
    def set_barriers(self, ends: _Integers, is_barrier: npt.NDArray[np.bool_]) -> None: ...
    def prepare_pairs(self, number_of_landmarks: int, progress: _Progress) -> None: ...
    def prepare_intervals(self, epsilon: float, progress: _Progress) -> None: ...
    def distances(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        maximum_distance: float,
        direction_to_source: bool,
        wants_nearest: bool,
        wants_predecessors: bool,
        progress: _Progress,
    ) -> Tuple[_Floats, _Integers, _Integers]: ...
    def path(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        target_elements: _Integers,
        target_coordinates: Optional[_Floats],
        straighten: bool,
    ) -> Tuple[_Floats, float]: ...
    def pair_distances(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        target_elements: _Integers,
        target_coordinates: Optional[_Floats],
        wants_intervals: bool,
        maximum_distance: float,
        threads: int,
        progress: _Progress,
    ) -> _Floats: ...
    def paths(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        target_elements: _Integers,
        target_coordinates: Optional[_Floats],
        straighten: bool,
        maximum_distance: float,
        threads: int,
        progress: _Progress,
    ) -> Tuple[list[_Floats], _Floats]: ...
    def matrix(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        targets: Optional[Tuple[_Integers, Optional[_Floats]]],
        maximum_distance: Optional[float],
        k: Optional[int],
        direction_to_source: bool,
        symmetric: bool,
        threads: int,
        progress: _Progress,
    ) -> Union[_Floats, Tuple[_Floats, npt.NDArray[np.int32], npt.NDArray[Any]]]: ...
    def voronoi(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        direction_to_source: bool,
        progress: _Progress,
    ) -> _Integers: ...
    def cells(
        self,
        elements: _Integers,
        coordinates: Optional[_Floats],
        within_cells: bool,
        initial_distances: List[float],
        chord_error: Optional[float],
    ) -> Tuple[_Floats, list[_Floats], _Integers, _Integers, _Integers]: ...
    def farthest_points(
        self, number: int, sources: _Integers, progress: _Progress
    ) -> Tuple[_Integers, float]: ...
    def gradient(self, values: _Floats) -> _Floats: ...
    def isolines(self, values: _Floats, level: float) -> list[_Floats]: ...
    @property
    def vertices(self) -> _Floats: ...
    @property
    def faces(self) -> _Integers: ...
    @property
    def number_of_vertices(self) -> int: ...
    @property
    def number_of_faces(self) -> int: ...
    @property
    def epsilon(self) -> Optional[float]: ...
    @property
    def error_bound(self) -> float: ...
    @property
    def has_face_weights(self) -> bool: ...
    @property
    def max_slope(self) -> float: ...
    @property
    def cost_model(self) -> Optional[int]: ...
    @property
    def has_barriers(self) -> bool: ...
    @property
    def threads(self) -> int: ...
    @property
    def memory(self) -> int: ...
