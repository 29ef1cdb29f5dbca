"""The class `Solver`."""

from __future__ import annotations

import functools
import os
from typing import Any, Callable, Iterator, Literal, Optional, Sequence, TypeVar, Union, overload

import numpy as np
import numpy.typing as npt

from . import _arrays, _files, _meshes, _native
from ._cells import Cells
from ._costs import NAMES, CostFunction, DirectionalCost

File = Union[str, "os.PathLike[str]"]
Progress = Callable[[int, int], object]
CostFunctionLike = Callable[[_arrays.Integers, _arrays.Floats], npt.ArrayLike]
Self = TypeVar("Self", bound="Solver")


class Solver:
    """Shortest distances and paths on a triangle mesh.

    Parameters
    ----------
    vertices : (n, 3) array of float
        Coordinates of the vertices. The unit of all lengths is theirs.
    faces : (m, 3) array of int
        Vertices of each face, counterclockwise seen from one side of the surface.
    epsilon : float, optional
        Paths are at most `1 + epsilon` times as long as the shortest ones; `0` asks for exact ones.
        Without it, paths run along edges, which is the fastest, and has no bound: across a regular
        grid they are 41 % too long. `0` is refused with face weights, directional costs,
        `max_slope` and barriers, which there are no exact distances with.
    threads : int, optional
        How many threads build the graph and compute matrices; by default, one per core.
    face_weights : (m,) array of float, optional
        Cost of a unit of length in each face: not negative; infinity forbids a face. "Distance" and
        "length" mean costs then. Where faces cost nothing, paths are the shortest of those that
        cost the same.
    costs : DirectionalCost or callable, optional
        Cost of a unit of length in each face and direction: a `HikingTime`, `WalkingEnergy`,
        `DriftTime`, `OneWay` or `TensorCost`, or a function of your own for `CostFunction`; not
        with face weights. Infinity forbids only to walk straight on in a direction; zigzags may
        still follow it, at the cost of others.
    max_slope : float, optional
        The steepest slope of straight pieces of paths, uphill and downhill: z per horizontal
        length. Pieces cross a face, or follow its sides; there are no zigzags within faces in their
        place. Where paths turn, at sides of faces, they can still gain height on a steeper surface,
        as on a road. Give faces infinite weight that are too steep in any direction. There is no
        bound `epsilon` where faces are steeper.
    accept_weaker_bound : bool
        Whether meshes are accepted that the bound cannot be kept on, because of their faces or of
        forbidden directions. `error_bound` tells what is left of it.
    maximum_number_of_points : int, optional
        How many points on edges there may be for the bound with weights, costs or barriers; each
        takes about 50 bytes. By default, 1000 per edge, but at least a million and at most a
        hundred million.
    barriers : (k, 2) array of int, optional
        Edges that paths must not cross, by their two vertices.
    may_change : bool
        Whether the bound also holds after `set_weights` and `set_barriers`, which takes more
        points; not with directional costs or `max_slope`, where nothing can change. This is not
        saved.
    progress : callable, optional
        Called while the graph is built.

    Raises
    ------
    ValueError
        If the input cannot be right: a vertex that is not finite, a face with a vertex that does
        not exist, an edge with more than two faces, and so on. The message names the element.

    Arrays of `float64` and of `int32` or `int64` that are contiguous are read where they are; others
    are converted. The solver has a mesh of its own afterwards, and does not change.

    A *point* is the number of a vertex; a pair of two vertices and a parameter along the edge
    between them, 0 at the first and 1 at the second one; or a pair of the number of a face and
    three barycentric coordinates. *Points* are a sequence of points of one kind, or a pair of
    arrays: of edges, (k, 2), and parameters, (k,), or of faces, (k,), and barycentric coordinates,
    (k, 3). `locate` returns such points for points in space.

    Several threads can call all methods at the same time; all that takes long releases the
    interpreter's lock. Ctrl-C ends searches, matrices and constructions, and the solver can be used
    afterwards. `progress` is called during a run with two numbers: how much is done, and how much
    there is to do.
    """

    _solver: _native.Solver

    def __init__(
        self,
        vertices: npt.ArrayLike,
        faces: npt.ArrayLike,
        epsilon: Optional[float] = None,
        *,
        threads: Optional[int] = None,
        face_weights: Optional[npt.ArrayLike] = None,
        costs: Union[DirectionalCost, CostFunctionLike, None] = None,
        max_slope: Optional[float] = None,
        accept_weaker_bound: bool = False,
        maximum_number_of_points: Optional[int] = None,
        barriers: Optional[npt.ArrayLike] = None,
        may_change: bool = False,
        progress: Optional[Progress] = None,
    ) -> None:
        if may_change and not (costs is None and max_slope is None):
            raise ValueError(
                f"may_change: with {'max_slope' if costs is None else 'costs'}, neither weights nor "
                "barriers can change"
            )
        coordinates = _arrays.numbers(vertices, "vertices", (-1, 3))
        corners = _arrays.triangles(faces, "faces")
        weights = ends = None
        if face_weights is not None:
            weights = _arrays.numbers(face_weights, "face_weights", (len(corners),))
        if barriers is not None:
            ends = _arrays.integers(barriers, "barriers", (-1, 2)).astype(np.int64, copy=False)
        self._solver = _native.Solver(
            coordinates,
            corners,
            _bound(epsilon),
            weights,
            _native_costs(costs, coordinates, corners),
            _max_slope(max_slope),
            accept_weaker_bound,
            _limit_of_points(maximum_number_of_points),
            ends,
            may_change,
            _number_of_threads(threads),
            _checked(progress),
        )

    @classmethod
    def from_file(
        cls: type[Self], file: File, epsilon: Optional[float] = None, **options: Any
    ) -> Self:
        """Make a solver of the mesh in a file, which `read_mesh` reads. Options are as above."""
        return cls(*_files.read_mesh(file), epsilon, **options)

    @classmethod
    def from_trimesh(
        cls: type[Self], mesh: Any, epsilon: Optional[float] = None, **options: Any
    ) -> Self:
        """Make a solver of a `trimesh.Trimesh`."""
        return cls(*_meshes.of_trimesh(mesh), epsilon, **options)

    @classmethod
    def from_meshio(
        cls: type[Self], mesh: Any, epsilon: Optional[float] = None, **options: Any
    ) -> Self:
        """Make a solver of the triangles of a `meshio.Mesh`, which must have no other faces."""
        return cls(*_meshes.of_meshio(mesh), epsilon, **options)

    @classmethod
    def from_pyvista(
        cls: type[Self], mesh: Any, epsilon: Optional[float] = None, **options: Any
    ) -> Self:
        """Make a solver of a `pyvista.PolyData` or a `vtkPolyData` of triangles."""
        return cls(*_meshes.of_vtk(mesh), epsilon, **options)

    @classmethod
    def from_open3d(
        cls: type[Self], mesh: Any, epsilon: Optional[float] = None, **options: Any
    ) -> Self:
        """Make a solver of an `open3d.geometry.TriangleMesh`, or one of `open3d.t.geometry`."""
        return cls(*_meshes.of_open3d(mesh), epsilon, **options)

    # Points in space

    @overload
    def locate(
        self, points: npt.ArrayLike, *, return_distance: Literal[False] = False
    ) -> tuple[Any, _arrays.Floats]: ...

    @overload
    def locate(
        self, points: npt.ArrayLike, *, return_distance: Literal[True]
    ) -> tuple[tuple[Any, _arrays.Floats], Any]: ...

    def locate(self, points: npt.ArrayLike, *, return_distance: bool = False) -> Any:
        """The nearest points of the surface to points in space, as sources and targets can be.

        Parameters
        ----------
        points : (k, 3) array of float, or three numbers
        return_distance : bool
            Whether distances in space are returned, too.

        Returns
        -------
        points
            A pair of faces, (k,) int64, and barycentric coordinates, (k, 3) float64; or, of three
            numbers, a pair of a face and three barycentric coordinates.
        (k,) array of float64, or float
            The distance of each point from the surface; if wanted.

        The first call builds a tree of the faces, of about 200 bytes each, which is kept. Coordinates
        of at most 1e-10 become zero, so that points on edges and vertices are there exactly.
        """
        is_one = np.ndim(points) == 1
        places = _arrays.numbers(points, "points", (3,) if is_one else (-1, 3))
        faces, coordinates, distances = self._locator.locate(places.reshape(-1, 3))
        if is_one:
            result, distance = (int(faces[0]), coordinates[0]), float(distances[0])
            return (result, distance) if return_distance else result
        return ((faces, coordinates), distances) if return_distance else (faces, coordinates)

    @functools.cached_property
    def _locator(self) -> _native.Locator:
        return _native.Locator(self._solver)

    # Distances and paths

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[False] = False,
        return_predecessors: Literal[False] = False,
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> _arrays.Floats: ...

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[True],
        return_predecessors: Literal[False] = False,
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> tuple[_arrays.Floats, _arrays.Integers]: ...

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[False] = False,
        return_predecessors: Literal[True],
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> tuple[_arrays.Floats, _arrays.Integers]: ...

    @overload
    def distances(
        self,
        sources: Any,
        *,
        return_nearest: Literal[True],
        return_predecessors: Literal[True],
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> tuple[_arrays.Floats, _arrays.Integers, _arrays.Integers]: ...

    def distances(
        self,
        sources: Any,
        *,
        return_nearest: bool = False,
        return_predecessors: bool = False,
        max_distance: Optional[float] = None,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> Any:
        """Distances of all vertices from the nearest source.

        Parameters
        ----------
        sources : point or points
        return_nearest : bool
            Whether the nearest sources are returned, too.
        return_predecessors : bool
            Whether the vertices before each one on its path are returned, too.
        max_distance : float, optional
            Vertices that are farther are not reached; the run ends there.
        direction_to_source : bool
            Whether the distances are those to the sources, which differ with directional costs. The
            first time, the graph is copied for that.
        progress : callable, optional

        Returns
        -------
        (n,) array of float64
            Infinity for vertices that no source reaches.
        (n,) array of int64
            The position of the nearest source among the sources, or -1; if wanted.
        (n,) array of int64
            The last vertex before each one on a shortest path from its source; the vertex itself if
            there is none, as for sources, or -1 if it is not reached; if wanted. Across faces, the
            two need not share an edge.
        """
        (elements, coordinates), _ = _arrays.points(sources, "source")
        result, nearest, predecessors = self._solver.distances(
            elements,
            coordinates,
            _distance(max_distance),
            direction_to_source,
            return_nearest,
            return_predecessors,
            _checked(progress),
        )
        more = ([nearest] if return_nearest else []) + ([predecessors] if return_predecessors else [])
        return (result, *more) if more else result

    @overload
    def path(
        self,
        source: Any,
        target: Any,
        *,
        straighten: bool = False,
        return_length: Literal[False] = False,
    ) -> _arrays.Floats: ...

    @overload
    def path(
        self, source: Any, target: Any, *, straighten: bool = False, return_length: Literal[True]
    ) -> tuple[_arrays.Floats, float]: ...

    def path(
        self, source: Any, target: Any, *, straighten: bool = False, return_length: bool = False
    ) -> Any:
        """A shortest path from one point to another.

        Parameters
        ----------
        source, target : point
        straighten : bool
            Whether the path is shortened to a locally shortest one. With face weights or
            directional costs, this raises `ValueError`, as cheapest paths are not straight.
        return_length : bool
            Whether its length is returned, too.

        Returns
        -------
        (k, 3) array of float64
            The ends, the vertices on the path, and where it crosses edges; (0, 3) if there is none.
        float
            The length, or infinity; if wanted.
        """
        points, length = self._solver.path(
            *_arrays.one_point(source, "source"), *_arrays.one_point(target, "target"), straighten
        )
        return (points, length) if return_length else points

    # Changes

    def set_weights(self, faces: npt.ArrayLike, weights: npt.ArrayLike) -> None:
        """Change the weights of some faces.

        If the next call of `distances` has most sources of the last one, it only finds those
        distances anew that have changed, with the same result as a fresh search. No other thread
        may use the solver meanwhile.

        Parameters
        ----------
        faces : (k,) array of int
            Faces.
        weights : (k,) array of float
            Their new weights: not negative; infinity forbids a face.

        Raises
        ------
        ValueError
            If the solver was made with neither face weights nor barriers, or with directional costs
            or `max_slope`, or a face or a weight cannot be right; nothing has changed then.
        """
        numbers = _arrays.integers(faces, "faces", (-1,)).astype(np.int64, copy=False)
        values = _arrays.numbers(weights, "weights", (len(numbers),))
        self._solver.set_weights(np.ascontiguousarray(numbers), values)

    def set_barriers(self, edges: npt.ArrayLike, closed: npt.ArrayLike) -> None:
        """Lift barriers, or put them back, like doors that are opened and closed.

        Only edges that were barriers when the solver was made can change. Searches are repaired as
        after `set_weights`. `save` keeps those that are closed.

        Parameters
        ----------
        edges : (k, 2) array of int
            Edges, by their two vertices.
        closed : bool or (k,) array of bool
            Whether they are barriers from now on.
        """
        ends = _arrays.integers(edges, "edges", (-1, 2)).astype(np.int64, copy=False)
        wanted = np.asarray(closed)
        if wanted.dtype.kind != "b" and wanted.size > 0:  # NumPy finds 'no' true
            raise ValueError(f"closed must be bool, and is {wanted.dtype}")
        are_closed = np.ascontiguousarray(np.broadcast_to(wanted.astype(bool), len(ends)))
        self._solver.set_barriers(np.ascontiguousarray(ends), are_closed)

    # Lists of pairs

    def prepare_pairs(self, landmarks: int = 16, *, progress: Optional[Progress] = None) -> None:
        """Prepare for many pairs, until weights or barriers change.

        Distances from some landmarks are kept. They guide `path`, `pair_distances` and `paths` to
        each target, past most of the mesh: with face weights, and for exact distances, these then
        take a small part of the time. Distances stay the same, up to rounding. No other thread may
        use the solver meanwhile.

        Parameters
        ----------
        landmarks : int
            Their number: each takes two searches of the whole mesh, and 8 bytes per point of it.
            Exact distances need a graph of about 800 bytes per vertex, too.
        progress : callable, optional
            Called with how many nodes were reached, and of how many, from 0 on for each search.
        """
        self._solver.prepare_pairs(_at_least(1, landmarks, "landmarks"), _checked(progress))

    def prepare_intervals(
        self, epsilon: float = 0.02, *, progress: Optional[Progress] = None
    ) -> None:
        """Prepare for very many intervals, until weights or barriers change.

        Labels are kept of all vertices. Then `pair_distances` with ``return_intervals`` reads the
        intervals of pairs of vertices from them in microseconds, without a search; `max_distance`
        limits them only if the lower end is beyond it. Not for exact distances, barriers or
        directional costs. No other thread may use the solver meanwhile.

        Parameters
        ----------
        epsilon : float
            The quotient of the ends of an interval is larger by a factor of up to ``1 + epsilon``.
        progress : callable, optional
            Called with how many nodes were reached, and of how many, from 0 on for each search.
        """
        self._solver.prepare_intervals(_number(epsilon, "epsilon"), _checked(progress))

    def pair_distances(
        self,
        sources: Any,
        targets: Any = None,
        *,
        return_intervals: bool = False,
        max_distance: Optional[float] = None,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> _arrays.Floats:
        """Distances from the first source to the first target, and so on.

        Pairs with the same source share a search, unless `prepare_pairs` was called and there are
        few of them or distances are not exact. So it is best if there are fewer different sources
        than targets.

        Parameters
        ----------
        sources : points; or, without targets, (n, 2) array of int
            Sources; or the vertices of both ends.
        targets : points, optional
            As many targets.
        return_intervals : bool
            Whether intervals that contain the distances on the surface are returned instead; see
            `prepare_intervals`.
        max_distance : float, optional
            Targets that are farther are not reached.
        threads : int, optional
            As many as the solver has by default. Their number changes no result.
        progress : callable, optional
            Called with the number of sources that are done, and of all.

        Returns
        -------
        (n,) array of float64
            In the order of the pairs; infinity where there is no path.
        or (n, 2) array of float64
            Lower and upper ends. Without a bound (see `error_bound`), lower ends are 0.
        """
        starts, ends = _arrays.pairs(sources, targets)
        number = 0 if threads is None else _number_of_threads(threads)
        return self._solver.pair_distances(
            *starts, *ends, return_intervals, _distance(max_distance), number, _checked(progress)
        )

    @overload
    def paths(
        self,
        sources: Any,
        targets: Any = None,
        *,
        straighten: bool = False,
        return_lengths: Literal[False] = False,
        max_distance: Optional[float] = None,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> list[_arrays.Floats]: ...

    @overload
    def paths(
        self,
        sources: Any,
        targets: Any = None,
        *,
        straighten: bool = False,
        return_lengths: Literal[True],
        max_distance: Optional[float] = None,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> tuple[list[_arrays.Floats], _arrays.Floats]: ...

    def paths(
        self,
        sources: Any,
        targets: Any = None,
        *,
        straighten: bool = False,
        return_lengths: bool = False,
        max_distance: Optional[float] = None,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> Any:
        """A shortest path from the first source to the first target, and so on.

        Other parameters are those of `pair_distances` and `path`.

        Returns
        -------
        list of (k, 3) arrays of float64
            The points of each path; (0, 3) if there is none.
        (n,) array of float64
            Their lengths, or infinity; if wanted.
        """
        starts, ends = _arrays.pairs(sources, targets)
        number = 0 if threads is None else _number_of_threads(threads)
        found, lengths = self._solver.paths(
            *starts, *ends, straighten, _distance(max_distance), number, _checked(progress)
        )
        return (found, lengths) if return_lengths else found

    # Matrices

    def distance_matrix(
        self,
        sources: Any,
        targets: Any = None,
        *,
        max_distance: Optional[float] = None,
        k: Optional[int] = None,
        direction_to_source: bool = False,
        symmetric: bool = False,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> Any:
        """Distances from each source to each target: a row per source.

        Parameters
        ----------
        sources : point or points
        targets : point or points, optional
            What the columns belong to; all vertices by default.
        max_distance : float, optional
            Only distances up to this one are found. The matrix is sparse.
        k : int, optional
            Only the k smallest distances of each row are found, the nearest first. The matrix is
            sparse.
        direction_to_source : bool
            Whether the distances are those from the targets to the sources.
        symmetric : bool
            Whether each distance is replaced by the smaller one of both directions, which can
            differ within the bound, and by rounding errors. Targets must be the same as sources;
            not with `k`, nor with directional costs. What wants an exactly symmetric matrix, as
            `scipy.spatial.distance.squareform`, needs it.
        threads : int, optional
            As many as the solver has by default. Their number changes no result.
        progress : callable, optional
            Called with the number of rows that are done, and of all.

        Returns
        -------
        (len(sources), len(targets)) array of float64
            Infinity where there is no path; or a `scipy.sparse.csr_array` of the same shape, which
            stores zeros, and nothing for what is not reached. Older SciPy has `csr_matrix` only.
        """
        request, _ = _arrays.points(sources, "source")
        columns = None if targets is None else _arrays.points(targets, "target")[0]
        number_nearest = None if k is None else _at_least(1, k, "k")
        limit = None if max_distance is None else _distance(max_distance)
        make_sparse = None if limit is None and k is None else _sparse_arrays()
        number = 0 if threads is None else _number_of_threads(threads)
        result = self._solver.matrix(
            *request,
            columns,
            limit,
            number_nearest,
            direction_to_source,
            symmetric,
            number,
            _checked(progress),
        )
        if make_sparse is None:
            return result
        width = self.number_of_vertices if columns is None else len(columns[0])
        return make_sparse(result, shape=(len(request[0]), width), copy=False)

    def iter_blocks(
        self,
        sources: Any,
        targets: Any = None,
        *,
        block_size: int = 256,
        max_distance: Optional[float] = None,
        k: Optional[int] = None,
        direction_to_source: bool = False,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> Iterator[tuple[slice, Any]]:
        """The matrix by blocks of rows, for what does not fit memory, and for Dask, joblib or MPI.

        Parameters are those of `distance_matrix`, but for `symmetric`, which concerns all rows at
        once, and the number of rows of a block. Yields pairs of a `slice` of the rows and the
        block, an array or a sparse array.
        """
        size = _at_least(1, block_size, "block_size")
        (elements, coordinates), _ = _arrays.points(sources, "source")
        columns = None if targets is None else _as_arguments(_arrays.points(targets, "target")[0])
        number_of_rows = len(elements)
        _checked(progress)

        def block(first: int) -> tuple[slice, Any]:
            def tell(number_done: int, _: int) -> None:
                if progress is not None:
                    progress(first + number_done, number_of_rows)

            rows = slice(first, min(first + size, number_of_rows))
            part = (elements[rows], None if coordinates is None else coordinates[rows])
            return rows, self.distance_matrix(
                _as_arguments(part),
                columns,
                max_distance=max_distance,
                k=k,
                direction_to_source=direction_to_source,
                threads=threads,
                progress=None if progress is None else tell,
            )

        return map(block, range(0, number_of_rows, size))

    # What follows from distances

    def voronoi(
        self,
        sources: Any,
        *,
        direction_to_source: bool = False,
        progress: Optional[Progress] = None,
    ) -> _arrays.Integers:
        """The nearest source of each face: that of most of its vertices.

        Returns an (m,) array of int64: positions among the sources, or -1 if none reaches the face.
        """
        (elements, coordinates), _ = _arrays.points(sources, "source")
        return self._solver.voronoi(
            elements, coordinates, direction_to_source, _checked(progress)
        )

    def voronoi_borders(
        self,
        sources: Any,
        *,
        initial_distances: Optional[npt.ArrayLike] = None,
        chord_error: Optional[float] = None,
    ) -> Cells:
        """The exact borders between the cells of sources, which depend on the surface only.

        Like `logarithmic_map`, it depends neither on `epsilon` nor on costs or barriers.

        Parameters
        ----------
        sources : points
        initial_distances : array of float, optional
            A distance to add for each source, (k,): 0 by default.
        chord_error : float, optional
            The largest distance of an arc from its polyline: a thousandth of the mean length of
            edges by default.

        Returns
        -------
        Cells
            The areas of the cells, their borders as polylines, the two sources of each border, which
            cells are neighbors, and the dual triangulation.

        Raises
        ------
        ValueError
            Also if areas do not add up because of rounding, as where vertices nearly coincide. The
            message names the face.
        """
        return self._cells(sources, False, initial_distances, chord_error)

    def cut_locus(
        self,
        source: Any,
        *,
        initial_distances: Optional[npt.ArrayLike] = None,
        chord_error: Optional[float] = None,
    ) -> Cells:
        """The points that several shortest paths lead to from a source, or from several ones.

        Parameters are those of `voronoi_borders`.

        Returns
        -------
        Cells
            As of `voronoi_borders`; the two sources of a border can be the same.
        """
        return self._cells(source, True, initial_distances, chord_error)

    def _cells(
        self,
        sources: Any,
        within_cells: bool,
        initial_distances: Optional[npt.ArrayLike],
        chord_error: Optional[float],
    ) -> Cells:
        (elements, coordinates), _ = _arrays.points(sources, "source")
        size = len(elements)
        initial = np.zeros(size) if initial_distances is None else initial_distances
        distances = _arrays.numbers(initial, "initial_distances", (size,)).tolist()
        error = None if chord_error is None else _number(chord_error, "chord_error")
        return Cells(*self._solver.cells(elements, coordinates, within_cells, distances, error))

    @overload
    def farthest_points(
        self,
        number: int,
        sources: Any = (),
        *,
        return_radius: Literal[False] = False,
        progress: Optional[Progress] = None,
    ) -> _arrays.Integers: ...

    @overload
    def farthest_points(
        self,
        number: int,
        sources: Any = (),
        *,
        return_radius: Literal[True],
        progress: Optional[Progress] = None,
    ) -> tuple[_arrays.Integers, float]: ...

    def farthest_points(
        self,
        number: int,
        sources: Any = (),
        *,
        return_radius: bool = False,
        progress: Optional[Progress] = None,
    ) -> Any:
        """Vertices that are spread evenly: each as far as possible from those before.

        Parameters
        ----------
        number : int
            How many; there are fewer if all vertices are chosen.
        sources : vertex or vertices, optional
            What to keep away from. Without them, the first point is vertex 0.
        return_radius : bool
            Whether the largest distance of any vertex from them is returned, too.

        Returns
        -------
        (number,) array of int64
        float
            The covering radius, if wanted.
        """
        number = _at_least(0, number, "the number of points")
        (elements, coordinates), _ = _arrays.points(sources, "source")
        if coordinates is not None:
            raise ValueError("sources of farthest points must be vertices")
        points, radius = self._solver.farthest_points(number, elements, _checked(progress))
        return (points, radius) if return_radius else points

    def gradient(self, values: npt.ArrayLike) -> _arrays.Floats:
        """The gradient, in each face, of a function with the given values, (n,), at the vertices.

        Returns an (m, 3) array of float64: zeros where a value is infinite or not a number. That of
        a distance has a length of about 1, and points away from the source.
        """
        return self._solver.gradient(self._values(values))

    @overload
    def isolines(self, values: npt.ArrayLike, levels: float) -> list[_arrays.Floats]: ...

    @overload
    def isolines(
        self, values: npt.ArrayLike, levels: Union[Sequence[float], npt.NDArray[Any]]
    ) -> list[list[_arrays.Floats]]: ...

    def isolines(self, values: npt.ArrayLike, levels: npt.ArrayLike) -> Any:
        """Lines where a function with the given values, (n,), at the vertices has a level.

        Returns a list of polylines for one level, and a list of such lists for several. A polyline
        is a (k, 3) array of float64; that of a closed one begins and ends with the same point.
        """
        function = self._values(values)
        if np.ndim(levels) == 0:
            return self._solver.isolines(function, float(_arrays.numbers(levels, "the level", ())))
        wanted = _arrays.numbers(levels, "levels", (-1,))
        wrong = np.flatnonzero(~np.isfinite(wanted))
        if len(wrong) > 0:
            raise ValueError(f"level {wrong[0]} is {wanted[wrong[0]]}; it must be finite")
        return [self._solver.isolines(function, level) for level in wanted.tolist()]

    # Curves

    def distances_from_curve(
        self,
        points: Any,
        *,
        closed: bool = False,
        signed: bool = False,
        progress: Optional[Progress] = None,
    ) -> _arrays.Floats:
        """Exact distances of all vertices from the nearest point of a curve.

        Parameters
        ----------
        points : point or points
            The vertices of the curve. Consecutive ones that have no face in common are joined by a
            shortest path.
        closed : bool
            Whether the last point is joined to the first one.
        signed : bool
            Whether distances are negative to the left of the curve, seen from outside. The curve
            has to be closed, or to end at borders, and to separate its two sides.
        progress : callable, optional

        Returns
        -------
        (n,) array of float64
            Infinity for vertices that are not reached. Weights, directional costs, `max_slope` and
            barriers do not count.
        """
        (elements, coordinates), _ = _arrays.points(points, "point")
        return _native.distances_from_curve(
            self._solver, elements, coordinates, closed, signed, _checked(progress)
        )

    def distances_from_region(
        self, faces: npt.ArrayLike, *, progress: Optional[Progress] = None
    ) -> _arrays.Floats:
        """Exact distances of all vertices from a set of faces, (k,); `0` in these.

        Weights, directional costs, `max_slope` and barriers do not count.
        """
        numbers = _arrays.integers(faces, "faces", (-1,))
        return _native.distances_from_region(self._solver, numbers.tolist(), _checked(progress))

    @overload
    def offset_curves(
        self,
        points: Any,
        distances: float,
        *,
        closed: bool = False,
        progress: Optional[Progress] = None,
    ) -> list[_arrays.Floats]: ...

    @overload
    def offset_curves(
        self,
        points: Any,
        distances: Union[Sequence[float], npt.NDArray[Any]],
        *,
        closed: bool = False,
        progress: Optional[Progress] = None,
    ) -> list[list[_arrays.Floats]]: ...

    def offset_curves(
        self,
        points: Any,
        distances: Any,
        *,
        closed: bool = False,
        progress: Optional[Progress] = None,
    ) -> Any:
        """Curves at exact distances from a curve or a point, such as tool paths.

        Parameters
        ----------
        points, closed
            As for `distances_from_curve`.
        distances : float or (k,) array of float
            The distances, larger than 0.
        progress : callable, optional

        Returns
        -------
        list of (k, 3) arrays of float64, or list of such lists
            The polylines at one distance, or at each one. What is nearer to the curve is on their
            left. That of a closed one begins and ends with the same point.

        Raises
        ------
        ValueError
            Also if steps are so small that faces would be divided into too many parts. The message
            names the face.
        """
        (elements, coordinates), _ = _arrays.points(points, "point")
        wanted = np.atleast_1d(_arrays.numbers(distances, "distances", np.shape(distances)[:1]))
        lines: dict[float, list[_arrays.Floats]] = {d: [] for d in wanted.tolist()}
        for distance, line in _native.offsets_of_curve(
            self._solver, elements, coordinates, closed, list(lines), _checked(progress)
        ):
            lines[distance].append(line)
        result = [lines[d] for d in wanted.tolist()]
        return result[0] if np.ndim(distances) == 0 else result

    # Straight walks

    @overload
    def trace(
        self,
        start: Any,
        direction: npt.ArrayLike,
        length: Optional[float] = None,
        *,
        return_end: Literal[False] = False,
    ) -> _arrays.Floats: ...

    @overload
    def trace(
        self,
        start: Any,
        direction: npt.ArrayLike,
        length: Optional[float] = None,
        *,
        return_end: Literal[True],
    ) -> tuple[_arrays.Floats, _arrays.Floats, float]: ...

    def trace(
        self,
        start: Any,
        direction: npt.ArrayLike,
        length: Optional[float] = None,
        *,
        return_end: bool = False,
    ) -> Any:
        """A walk straight ahead on the surface: a straightest geodesic, the exponential map.

        It leaves the same angle on both sides of a vertex, and ends at the border. Like all that is
        below, it depends on the surface only: not on `epsilon`, costs or barriers.

        Parameters
        ----------
        start : point
        direction : (3,) or (2,) array of float
            A vector in space, whose part along the surface counts, or one in the frame of the
            point, as `logarithmic_map` returns it; not zero.
        length : float, optional
            By default, that of `direction`.
        return_end : bool
            Whether the direction at the end and the length are returned, too.

        Returns
        -------
        (k, 3) array of float64
            The start, where the walk crosses edges, and the end.
        (3,) array of float64
            The direction at the end, of length 1; zeros if the walk could not begin; if wanted.
        float
            The length: shorter than was asked for if the walk has ended at the border; if wanted.
        """
        vector = _vector(direction, "direction")
        steps = float(np.linalg.norm(vector)) if length is None else _number(length, "length")
        points, end, walked, _ = self._walks.trace(
            *_arrays.one_point(start, "start"), vector, steps
        )
        return (points, end, walked) if return_end else points

    def logarithmic_map(self, source: Any) -> _arrays.Floats:
        """The direction and the length of an exact shortest path to each vertex, (n, 2) float64.

        They are vectors in the frame of the source. At a vertex, `tangent_frames` tells its axes,
        and angles around it are scaled to add up to a full turn. `trace` leads from such a vector
        to the vertex, if the path passes no other one. Vertices that are not reached have an
        infinite one.
        """
        return self._walks.logarithmic_map(*_arrays.one_point(source, "source"))

    def parallel_transport(
        self, source: Any, target: Any, vector: npt.ArrayLike
    ) -> _arrays.Floats:
        """A tangent vector at one point, carried to another along an exact shortest path.

        The vector has three numbers, in space, or two, in the frame of the source; the result has
        as many, in space or in the frame of the target. It keeps its angle to the path.
        """
        return self._walks.transport(
            *_arrays.one_point(source, "source"),
            *_arrays.one_point(target, "target"),
            _vector(vector, "vector"),
        )

    def extend_vectors(self, points: Any, vectors: npt.ArrayLike) -> _arrays.Floats:
        """The vector of the nearest of several points, carried to each vertex, (n, 2) float64.

        `vectors` has a row for each point, (k, 2), in its frame, and the result one for each
        vertex: parallel transport along an exact shortest path. It is zero at vertices that are not
        reached.
        """
        (elements, coordinates), _ = _arrays.points(points, "point")
        values = _arrays.numbers(vectors, "vectors", (len(elements), 2))
        return self._walks.extend_vectors(elements, coordinates, values)

    @overload
    def karcher_mean(
        self,
        points: Any,
        weights: Optional[npt.ArrayLike] = None,
        *,
        return_deviation: Literal[False] = False,
    ) -> Any: ...

    @overload
    def karcher_mean(
        self,
        points: Any,
        weights: Optional[npt.ArrayLike] = None,
        *,
        return_deviation: Literal[True],
    ) -> tuple[Any, float]: ...

    def karcher_mean(
        self,
        points: Any,
        weights: Optional[npt.ArrayLike] = None,
        *,
        return_deviation: bool = False,
    ) -> Any:
        """The point with the smallest mean of squared distances from points, in a neighborhood.

        Parameters
        ----------
        points : points
        weights : (k,) array of float, optional
            Equal by default.
        return_deviation : bool
            Whether the square root of that mean is returned, too.

        Returns
        -------
        point
            As sources and targets can be.
        float
            The deviation; if wanted.
        """
        (elements, coordinates), _ = _arrays.points(points, "point")
        shares = (
            np.ones(len(elements))
            if weights is None
            else _arrays.numbers(weights, "weights", (len(elements),))
        )
        mean, deviation, _ = self._walks.mean(elements, coordinates, shares)
        return (mean, deviation) if return_deviation else mean

    def tangent_frames(self) -> tuple[_arrays.Floats, _arrays.Floats, _arrays.Floats]:
        """Axes and normals at the vertices, (n, 3) float64 each: x axes, y axes, and normals."""
        return self._walks.frames()

    # Loops

    @overload
    def shorten_loop(
        self, points: Any, *, return_length: Literal[False] = False
    ) -> _arrays.Floats: ...

    @overload
    def shorten_loop(
        self, points: Any, *, return_length: Literal[True]
    ) -> tuple[_arrays.Floats, float]: ...

    def shorten_loop(self, points: Any, *, return_length: bool = False) -> Any:
        """A closed geodesic that a closed curve can be moved to on the surface.

        Parameters
        ----------
        points : points
            Those of the curve; the last one is joined with the first one. Where two that follow
            each other have no face in common, a shortest path joins them.
        return_length : bool
            Whether its length is returned, too.

        Returns
        -------
        (k, 3) array of float64
            The loop; its last point is its first one. A single point if the curve contracts.
        float
            The length; if wanted.
        """
        (elements, coordinates), _ = _arrays.points(points, "point")
        loop, length = self._walks.shorten_loop(elements, coordinates)
        return (loop, length) if return_length else loop

    @overload
    def shorten_curve(
        self, points: Any, *, return_length: Literal[False] = False
    ) -> _arrays.Floats: ...

    @overload
    def shorten_curve(
        self, points: Any, *, return_length: Literal[True]
    ) -> tuple[_arrays.Floats, float]: ...

    def shorten_curve(self, points: Any, *, return_length: bool = False) -> Any:
        """A geodesic that a curve can be moved to on the surface, with the same ends.

        It is locally shortest, and not always the shortest one: see `path` for that. Arguments and
        results are those of `shorten_loop`, but the last point is not joined with the first one.
        """
        (elements, coordinates), _ = _arrays.points(points, "point")
        curve, length = self._walks.shorten_curve(elements, coordinates)
        return (curve, length) if return_length else curve

    @overload
    def shortest_loop_through(
        self, point: Any, *, return_length: Literal[False] = False
    ) -> _arrays.Floats: ...

    @overload
    def shortest_loop_through(
        self, point: Any, *, return_length: Literal[True]
    ) -> tuple[_arrays.Floats, float]: ...

    def shortest_loop_through(self, point: Any, *, return_length: bool = False) -> Any:
        """A shortest loop through a point around a handle or a hole: one that does not contract.

        Parameters
        ----------
        point : point
        return_length : bool
            Whether its length is returned, too.

        Returns
        -------
        (k, 3) array of float64
            The loop, from the point back to it; (0, 3) if all loops contract.
        float
            The length, or infinity; if wanted.
        """
        loop, length = self._walks.shortest_loop_through(*_arrays.one_point(point, "point"))
        return (loop, length) if return_length else loop

    @functools.cached_property
    def _walks(self) -> _native.Walks:
        return _native.Walks(self._solver)

    # Files

    def save(self, file: File) -> None:
        """Write the mesh, the parameters, and a graph that takes long to build, to a file.

        A file that has the name is replaced when the new one is complete. Raises `OSError` if it
        cannot be written.
        """
        _files.replace(_files.name_of(file), self._solver.save)

    @classmethod
    def load(cls: type[Self], file: File, *, threads: Optional[int] = None) -> Self:
        """Read what `save` has written.

        Raises `OSError` if there is no such file, and `ValueError` if it is none of a solver,
        damaged, or longer.
        """
        return cls._with(_native.Solver.load(_files.name_of(file), _number_of_threads(threads)))

    def __getstate__(self) -> tuple[bytes, int, dict[str, Any]]:
        return self._solver.to_bytes(), self._solver.threads, self._attributes()

    def __setstate__(self, state: tuple[bytes, int, dict[str, Any]]) -> None:
        contents, threads, attributes = state
        self._solver = _native.Solver.from_bytes(contents, threads)
        self.__dict__.update(attributes)

    def __copy__(self: Self) -> Self:
        result = self._with(self._solver)  # which does not change
        result.__dict__.update(self._attributes())
        return result

    # Properties

    @property
    def number_of_vertices(self) -> int:
        """The number of vertices, n."""
        return self._solver.number_of_vertices

    @property
    def number_of_faces(self) -> int:
        """The number of faces, m."""
        return self._solver.number_of_faces

    @property
    def vertices(self) -> _arrays.Floats:
        """A copy of the coordinates, (n, 3) float64."""
        return self._solver.vertices

    @property
    def faces(self) -> _arrays.Integers:
        """A copy of the faces, (m, 3) int64."""
        return self._solver.faces

    @property
    def epsilon(self) -> Optional[float]:
        """The bound that was asked for: `None` along edges, `0` for exact distances."""
        return self._solver.epsilon

    @property
    def error_bound(self) -> float:
        """The bound that holds: infinity along edges, and where costs do not allow one.

        It is for exact arithmetic: arcs are stored with a relative precision of 1.2e-7.
        """
        return self._solver.error_bound

    @property
    def memory(self) -> int:
        """Bytes of the graph and of workspaces that are kept, beside about 150 per vertex."""
        return self._solver.memory

    def __repr__(self) -> str:
        parts = [f"{self.number_of_vertices} vertices", f"{self.number_of_faces} faces"]
        parts.append("along edges" if self.epsilon is None else f"epsilon={self.epsilon:g}")
        if self._solver.has_face_weights:
            parts.append("with face weights")
        if self._solver.cost_model is not None:
            parts.append(f"with {NAMES[self._solver.cost_model]}")
        if self._solver.max_slope < np.inf:
            parts.append(f"max_slope={self._solver.max_slope:g}")
        if self._solver.has_barriers:
            parts.append("with barriers")
        return f"<approximate_geodesics.Solver: {', '.join(parts)}>"

    # Help

    @classmethod
    def _with(cls: type[Self], native: _native.Solver) -> Self:
        result = cls.__new__(cls)
        result._solver = native
        return result

    def _attributes(self) -> dict[str, Any]:
        """Those that a derived class has added."""
        own = ("_solver", "_locator", "_walks")
        return {name: value for name, value in self.__dict__.items() if name not in own}

    def _values(self, values: npt.ArrayLike) -> _arrays.Floats:
        if isinstance(values, np.ma.MaskedArray):  # what is masked has no value
            values = np.ma.filled(values.astype(float), np.nan)  # type: ignore[no-untyped-call]
        return _arrays.numbers(values, "values", (self.number_of_vertices,))


def _native_costs(
    costs: Union[DirectionalCost, CostFunctionLike, None],
    vertices: _arrays.Floats,
    faces: npt.NDArray[Any],
) -> Optional[tuple[int, list[float], _arrays.Floats]]:
    if costs is None:
        return None
    if not isinstance(costs, DirectionalCost):
        if not callable(costs):
            raise TypeError(
                f"costs are of type {type(costs).__name__}; they must be a DirectionalCost, or a "
                "function of faces and directions"
            )
        costs = CostFunction(costs)
    return costs._native(vertices, faces)


def _checked(progress: Optional[Progress]) -> Optional[Progress]:
    if progress is not None and not callable(progress):
        raise TypeError(f"progress is {progress!r}; it must be callable, or None")
    return progress


def _number_of_threads(threads: Optional[int]) -> int:
    return 0 if threads is None else _at_least(1, threads, "threads")  # 0: one per core


def _limit_of_points(number: Optional[int]) -> int:
    return 0 if number is None else _at_least(1, number, "maximum_number_of_points")  # 0: default


def _at_least(smallest: int, value: Any, name: str) -> int:
    try:
        result = _arrays.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; it must be an integer") from None
    if result < smallest:
        raise ValueError(f"{name} is {value}; it must be at least {smallest}")
    return result


def _number(value: Any, name: str) -> float:
    if isinstance(value, (str, bytes, bytearray, bool, np.bool_)):
        raise TypeError(f"{name} is {value!r}; it must be a number")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}; it must be a number") from None


def _vector(values: npt.ArrayLike, name: str) -> _arrays.Floats:
    size = 2 if np.shape(values) == (2,) else 3  # in the frame of a point, or in space
    return _arrays.numbers(values, name, (size,))


def _bound(epsilon: Optional[float]) -> Optional[float]:
    return None if epsilon is None else _number(epsilon, "epsilon")


def _distance(max_distance: Optional[float]) -> float:
    if max_distance is None:
        return float("inf")
    result = _number(max_distance, "max_distance")
    if not result >= 0:
        raise ValueError(f"max_distance is {max_distance}; it must not be negative")
    return result


def _max_slope(max_slope: Optional[float]) -> float:
    if max_slope is None:
        return float("inf")
    result = _number(max_slope, "max_slope")
    if not result >= 0:
        raise ValueError(f"max_slope is {max_slope}; it must be a number that is not negative")
    return result


def _as_arguments(points: _arrays.Points) -> Any:
    elements, coordinates = points
    return elements if coordinates is None else points


def _sparse_arrays() -> Any:
    """SciPy's class, which only those need who ask for it."""
    try:
        import scipy.sparse
    except ImportError:
        raise ImportError("max_distance and k make sparse matrices, which need SciPy") from None
    return getattr(scipy.sparse, "csr_array", scipy.sparse.csr_matrix)
