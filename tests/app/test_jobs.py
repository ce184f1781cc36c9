"""A solve in the background tells its progress, can be stopped, and never speaks for a project that is no more."""

import queue
import threading
from collections.abc import Callable, Iterator

import pytest

from app.commands import ReplaceProject
from app.document import Document
from app.jobs import Failure, SolveJob
from app.solving import Solving
from facemodel.errors import FaceError
from facemodel.project import Project
from facemodel.solve import Progress, Solution, solve_project

PATIENCE = 30.0
"""Seconds after which a test gives up."""


class EventLoop:
    """The owner's thread: calls what was delivered, one by one, when told to."""

    def __init__(self) -> None:
        self.inbox: queue.Queue[Callable[[], None]] = queue.Queue()
        self.foreign = 0

    def deliver(self, function: Callable[[], None]) -> None:
        self.foreign += threading.current_thread() is not threading.main_thread()
        self.inbox.put(function)

    def run_until(self, done: Callable[[], bool]) -> None:
        while not done():
            self.inbox.get(timeout=PATIENCE)()


class Gate:
    """A solver that does each phase only when let, so that a test decides what happens meanwhile."""

    def __init__(self) -> None:
        self.started: queue.Queue[Project] = queue.Queue()
        self.phases = threading.Semaphore(0)
        self.ended: queue.Queue[str] = queue.Queue()

    def solve(self, project: Project, progress: Progress) -> Solution:
        self.started.put(project)
        try:
            for phase in range(2):
                assert self.phases.acquire(timeout=PATIENCE)
                progress(f"phase {phase}", phase / 2)
            solution = solve_project(project, progress)
        except BaseException as end:
            self.ended.put(type(end).__name__)
            raise
        self.ended.put("solved")
        return solution


class Ear:
    """Notes what a job says, and in which thread."""

    def __init__(self, job: SolveJob) -> None:
        self.said: list[tuple[object, ...]] = []
        self.threads: set[threading.Thread] = set()
        job.started.connect(lambda project: self.note("started", project))
        job.progress.connect(lambda text, share: self.note("progress", text, share))
        job.finished.connect(lambda solution, project: self.note("finished", solution, project))
        job.failed.connect(lambda failure: self.note("failed", failure))
        job.cancelled.connect(lambda: self.note("cancelled"))

    def note(self, *what: object) -> None:
        self.said.append(what)
        self.threads.add(threading.current_thread())

    @property
    def names(self) -> list[object]:
        return [what[0] for what in self.said if what[0] != "progress"]

    @property
    def failure(self) -> Failure:
        (failure,) = (what[1] for what in self.said if what[0] == "failed")
        assert isinstance(failure, Failure)
        return failure


def wait_for_workers() -> None:
    for thread in threading.enumerate():
        if thread.name.startswith("solve"):
            thread.join(PATIENCE)


@pytest.fixture
def loop() -> EventLoop:
    return EventLoop()


@pytest.fixture
def gate() -> Gate:
    return Gate()


@pytest.fixture
def job(loop: EventLoop, gate: Gate) -> Iterator[SolveJob]:
    job = SolveJob(gate.solve, loop.deliver)
    yield job
    job.close()
    gate.phases.release(100)


def test_it_solves_elsewhere_and_speaks_here(project: Project, loop: EventLoop, gate: Gate, job: SolveJob) -> None:
    ear = Ear(job)
    gate.phases.release(2)
    job.request(project)
    assert job.running
    loop.run_until(lambda: not job.running)
    assert ear.names == ["started", "finished"]
    assert ear.threads == {threading.main_thread()}
    assert loop.foreign > 2
    shares = [what[2] for what in ear.said if what[0] == "progress" and what[1] not in ("phase 0", "phase 1")]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    _, solution, solved = ear.said[-1]
    assert isinstance(solution, Solution)
    assert solution.basis.names == ("12L", "12R", "20L", "20R", "17", "26")
    assert solved is project


def test_only_the_latest_request_is_answered(
    project: Project, other_project: Project, loop: EventLoop, gate: Gate, job: SolveJob
) -> None:
    ear = Ear(job)
    job.request(project)
    gate.started.get(timeout=PATIENCE)
    job.request(project)
    job.request(other_project)
    gate.phases.release(10)
    loop.run_until(lambda: not job.running)
    assert ear.names == ["started", "started", "started", "finished"]
    assert ear.said[-1][2] is other_project
    assert gate.started.get(timeout=PATIENCE) is other_project
    assert [gate.ended.get(timeout=PATIENCE) for _ in range(2)] == ["Cancelled", "solved"]


def test_a_result_that_came_too_late_is_dropped(
    project: Project, other_project: Project, loop: EventLoop, gate: Gate, job: SolveJob
) -> None:
    ear = Ear(job)
    gate.phases.release(2)
    job.request(project)
    assert gate.ended.get(timeout=PATIENCE) == "solved"
    gate.phases.release(2)
    job.request(other_project)
    loop.run_until(lambda: not job.running)
    assert [what[2] for what in ear.said if what[0] == "finished"] == [other_project]


def test_cancel_is_heard_at_once_and_ends_the_solver(
    project: Project, loop: EventLoop, gate: Gate, job: SolveJob
) -> None:
    ear = Ear(job)
    job.request(project)
    gate.started.get(timeout=PATIENCE)
    job.cancel()
    assert ear.names == ["started", "cancelled"]
    assert not job.running
    gate.phases.release(2)
    assert gate.ended.get(timeout=PATIENCE) == "Cancelled"
    job.cancel()
    assert ear.names == ["started", "cancelled"]
    gate.phases.release(2)
    job.request(project)
    loop.run_until(lambda: not job.running)
    assert ear.names == ["started", "cancelled", "started", "finished"]


def test_an_error_meant_for_people_arrives_as_its_sentence(project: Project, loop: EventLoop) -> None:
    def loose(project: Project, progress: Progress) -> Solution:
        raise FaceError("The face is loose.")

    job = SolveJob(loose, loop.deliver)
    ear = Ear(job)
    job.request(project)
    loop.run_until(lambda: not job.running)
    job.close()
    assert ear.failure == Failure("The face is loose.")


@pytest.mark.parametrize("error", [KeyError("lost"), MemoryError(), SystemExit(3), StopIteration()])
def test_an_error_that_nobody_foresaw_arrives_with_its_traceback(
    project: Project, loop: EventLoop, error: BaseException
) -> None:
    def broken(project: Project, progress: Progress) -> Solution:
        raise error

    job = SolveJob(broken, loop.deliver)
    ear = Ear(job)
    job.request(project)
    loop.run_until(lambda: not job.running)
    job.close()
    assert ear.failure.sentence.endswith(".")
    assert type(error).__name__ in ear.failure.details
    assert "in broken" in ear.failure.details


def test_a_failure_that_nobody_waits_for_is_logged(
    project: Project, loop: EventLoop, caplog: pytest.LogCaptureFixture
) -> None:
    let = threading.Event()

    def broken(project: Project, progress: Progress) -> Solution:
        let.wait(PATIENCE)
        raise KeyError("lost")

    job = SolveJob(broken, loop.deliver)
    ear = Ear(job)
    job.request(project)
    job.cancel()
    let.set()
    job.close()
    wait_for_workers()
    assert ear.names == ["started", "cancelled"]
    assert "KeyError: 'lost'" in caplog.text


def test_a_closed_job_brings_nothing_more(project: Project, loop: EventLoop, gate: Gate, job: SolveJob) -> None:
    ear = Ear(job)
    job.request(project)
    gate.started.get(timeout=PATIENCE)
    job.close()
    gate.phases.release(2)
    wait_for_workers()
    assert gate.ended.get(timeout=PATIENCE) == "Cancelled"
    assert loop.inbox.empty()
    assert ear.names == ["started"]


def test_without_an_event_loop_a_request_waits_for_its_answer(project: Project) -> None:
    document = Document(project)
    job = SolveJob(solve_project)
    ear = Ear(job)
    Solving(document, job).solve()
    job.close()
    assert ear.names == ["started", "finished"]
    assert ear.threads == {threading.main_thread()}
    assert document.solution is not None
    assert not document.stale


def test_without_an_event_loop_a_listener_can_cancel(project: Project) -> None:
    job = SolveJob(solve_project)
    ear = Ear(job)
    job.progress.connect(lambda text, share: job.cancel())
    job.request(project)
    job.close()
    assert ear.names == ["started", "cancelled"]


def test_a_document_is_solved_whenever_it_has_to_be(project: Project, other_project: Project) -> None:
    document = Document(project)
    job = SolveJob(solve_project)
    ear = Ear(job)
    solving = Solving(document, job)
    assert solving.wanted
    solving.solve()
    assert not solving.wanted
    document.set_weights({"17": 0.5})
    assert ear.names == ["started", "finished"]
    document.run(ReplaceProject("Other face", document.project, other_project))
    assert ear.names == ["started", "finished"] * 2
    assert not document.stale
    document.undo()
    assert not document.stale
    job.close()


def test_going_back_to_what_is_solved_stops_the_solver(
    project: Project, loop: EventLoop, gate: Gate, job: SolveJob
) -> None:
    document = Document(project)
    document.accept(solve_project(project), project)
    solving = Solving(document, job)
    ear = Ear(job)
    fewer = Project(project.face, project.muscles, project.units[2:], ())
    document.run(ReplaceProject("Fewer units", project, fewer))
    assert job.running
    document.undo()
    assert ear.names == ["started", "cancelled"]
    assert not solving.wanted
