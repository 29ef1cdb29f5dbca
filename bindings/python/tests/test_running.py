"""Threads, signals and progress."""

import copy
import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import approximate_geodesics as ag
from meshes import sphere


@pytest.fixture(scope="module")
def solver():
    return ag.Solver(*sphere(6), epsilon=0.1)  # 40,962 vertices


CALLS = {
    "matrix": lambda solver, **options: solver.distance_matrix(range(40000), [1], **options),
    "sparse": lambda solver, **options: solver.distance_matrix(
        range(40000), max_distance=1.5, **options
    ),
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_an_interrupt_ends_a_run_and_leaves_the_solver_usable(solver, call):
    before = solver.distances(0)
    sent = []

    def send():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.3, send)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        call(solver)
    assert time.monotonic() - sent[0] < 5  # a run takes minutes
    np.testing.assert_array_equal(solver.distances(0), before)


def test_an_interrupt_ends_exact_searches_amid_a_row():
    solver = ag.Solver(*sphere(6), epsilon=0)
    for threads in (1, 2):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            solver.distance_matrix(range(1000), threads=threads)  # which would take minutes
    assert solver.distances(0, max_distance=0.1)[0] == 0


def test_an_interrupt_ends_the_location_of_points(solver):
    points = np.random.default_rng(2).normal(size=(2000000, 3))
    expected = solver.locate(points[0])
    assert interrupt_after(0.3, lambda: solver.locate(points)) < 5  # all take half a minute
    np.testing.assert_array_equal(solver.locate(points[0])[1], expected[1])


def interrupt_after(seconds, call):
    """How long it takes an interrupt to end a call."""
    sent = []

    def send():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, send)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        call()
    return time.monotonic() - sent[0]


def test_an_interrupt_ends_rows_and_graphs_that_take_long(solver):
    vertices, faces = sphere(6)
    slow = ag.Solver(vertices, faces, 0.05, face_weights=np.ones(len(faces)))
    hiking = ag.HikingTime()
    for call in (
        lambda: slow.distance_matrix([0, 1, 2]),
        lambda: slow.distance_matrix([0, 1, 2], k=40000),
        lambda: ag.Solver(vertices, faces, 0.0005),
        lambda: ag.Solver(vertices, faces, 0.0001, costs=hiking),
    ):
        assert interrupt_after(0.3, call) < 2  # and not many seconds


def test_an_interrupt_ends_searches_on_grids():
    grid = ag.Grid(np.ones((600, 600)), epsilon=0.1)
    assert interrupt_after(0.3, lambda: grid.distances((0, 0))) < 2  # it takes some seconds
    assert grid.distances((0, 0), max_distance=2)[0, 1] == 1


def test_an_interrupt_ends_walks_loops_and_curves(solver):
    points = np.random.default_rng(3).integers(0, solver.number_of_vertices, 20000)
    solver.trace(0, [1, 0, 0])  # which reads the mesh
    for call in (
        lambda: solver.trace(0, [1, 0, 0], 1e7),
        lambda: solver.shorten_loop(points),
        lambda: solver.distances_from_curve(points),
        lambda: solver.offset_curves(points, 0.1),
    ):
        assert interrupt_after(0.05, call) < 2  # and not minutes; the walk ends soon
    assert len(solver.trace(0, [1, 0, 0])) > 2


PROGRAMS = {
    "amid a run": "solver.distance_matrix(range(40000), [1])",
    "amid the construction": "ag.Solver(*sphere(6), epsilon=0.0005)",
    "amid calls": "while True: solver.distances(0)",
    "with progress": "solver.distance_matrix(range(40000), [1], progress=lambda *numbers: None)",
}


@pytest.mark.parametrize("work", PROGRAMS.values(), ids=PROGRAMS)
def test_the_interpreter_can_end_while_a_daemon_thread_runs(work):
    program = f"""
import threading, time
import approximate_geodesics as ag
from meshes import sphere
solver = ag.Solver(*sphere(6), epsilon=0.1)
def run():
    {work}
for _ in range(3):
    threading.Thread(target=run, daemon=True).start()
time.sleep(0.3)
"""
    end = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=60,
        cwd=os.path.dirname(__file__),
    )
    assert (end.returncode, end.stderr) == (0, "")


def test_other_threads_run_meanwhile(solver):
    done, turns = threading.Event(), []

    def run():
        solver.distance_matrix(range(200), [1], threads=1)
        done.set()

    thread = threading.Thread(target=run)
    thread.start()
    while not done.is_set():  # if the run held the lock, there would be one turn at its end
        turns.append(None)
        time.sleep(0.001)
    thread.join()
    assert len(turns) > 10


def test_threads_share_a_solver(solver):
    sources = list(range(0, 40000, 2500))
    expected = [solver.distances(s) for s in sources]
    results = [None] * len(sources)

    def run(first):
        for i in range(first, len(sources), 4):
            results[i] = solver.distances(sources[i])

    threads = [threading.Thread(target=run, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    np.testing.assert_array_equal(results, expected)


def test_progress_grows_and_ends_with_all(solver):
    told = []
    solver.distance_matrix(range(100), [1], progress=lambda *numbers: told.append(numbers))
    assert told == sorted(told) and told[-1] == (100, 100)
    told.clear()
    solver.distances(0, progress=lambda *numbers: told.append(numbers))
    assert told[-1] == (40962, 40962)
    told.clear()
    ag.Solver(*sphere(5), 0.001, progress=lambda *numbers: told.append(numbers))
    assert len(told) > 1 and told == sorted(told) and told[-1] == (10242, 10242)
    told.clear()
    solver.distance_matrix([], progress=lambda done, number: told.append(done / number))
    assert told == []


def test_what_progress_raises_ends_the_run(solver):
    def fail(number_done, number):
        raise LookupError("enough")

    others = (
        lambda solver, **options: solver.distances(0, **options),
        lambda solver, **options: solver.farthest_points(5, **options),
        lambda solver, **options: solver.voronoi([0, 1], **options),
    )
    for call in (*CALLS.values(), *others):
        with pytest.raises(LookupError, match="enough"):
            call(solver, progress=fail)
    assert solver.distances(0)[0] == 0


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"epsilon": 0},
        {"epsilon": 0.1},
        {"epsilon": 0.1, "face_weights": np.linspace(1, 2, 1280)},
        {"epsilon": 0.3, "barriers": [(0, 163)]},
        {"face_weights": np.linspace(1, 2, 1280), "threads": 1},
    ],
)
def test_copies_of_solvers_are_the_same(options, tmp_path):
    vertices, faces = sphere(3)
    if "barriers" in options:
        options = {**options, "barriers": faces[:1, :2]}
    solver = ag.Solver(vertices, faces, **options)
    solver.save(tmp_path / "solver.bin")
    for same in (pickle.loads(pickle.dumps(solver)), ag.Solver.load(tmp_path / "solver.bin")):
        assert repr(same) == repr(solver)
        np.testing.assert_array_equal(same.vertices, vertices)
        np.testing.assert_array_equal(same.faces, faces)
        np.testing.assert_array_equal(same.distances([1, 7]), solver.distances([1, 7]))
        np.testing.assert_array_equal(same.path(3, 99), solver.path(3, 99))


class Named(ag.Solver):
    """What users add to it."""

    def __init__(self, *arguments, name="", **options):
        super().__init__(*arguments, **options)
        self.name = name


def test_copies_keep_what_derived_classes_add():
    solver = Named(*sphere(1), name="ball", threads=1)
    for duplicate in (pickle.loads(pickle.dumps(solver)), copy.copy(solver), copy.deepcopy(solver)):
        assert type(duplicate) is Named and duplicate.name == "ball"
        np.testing.assert_array_equal(duplicate.distances(0), solver.distances(0))


def test_what_a_solver_looks_like():
    text = repr(ag.Solver(*sphere(1), epsilon=0.25, face_weights=np.ones(80)))
    assert text == (
        "<approximate_geodesics.Solver: 42 vertices, 80 faces, epsilon=0.25, with face weights>"
    )
