"""Where the portions of a study are computed: in this process, on threads of it, or on the workers of a Dask cluster.

All have one job: hand portions out, and give each finished chunk to `keep`, in the thread that called `run`. What is computed where and when has no
effect on a result.
"""

from __future__ import annotations

import asyncio
import concurrent.futures
import contextlib
import os
import queue
import signal
import time
import uuid
import weakref
from collections.abc import Callable

from orbearing.errors import ComputationError
from orbearing.studies.plan import Plan, Portion
from orbearing.studies.table import Chunk

Keep = Callable[[Chunk], None]

AHEAD = 2  # portions for each lane: one that is computed, one that waits on the worker
TRIES = 12  # of one portion whose worker was lost each time
LOOK_SECONDS = 1.0  # between two looks at whether the scheduler still answers
PATIENCE_SECONDS = 30.0  # for a scheduler that does not
AT_FIRST_SECONDS = 60.0  # for the first worker to come


class Lost(ComputationError):
    """The computation cannot go on where it ran; what was kept is sound."""


def cores() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0))


class InProcess:
    """One portion after the other, each on the core's own threads."""

    def __init__(self, jobs: int = 0):
        self.jobs = jobs or cores()

    @property
    def lanes(self) -> int:
        return self.jobs

    def run(self, engine, plan: Plan, keep: Keep) -> None:
        while portion := plan.next(1):
            chunk = engine.compute(portion.ids, portion.settings, portion.values, self.jobs)
            plan.learn(len(chunk.ids), chunk.seconds)
            keep(chunk)


class Threads:
    """As many portions at once as there are threads, each on one of them: none waits for the longest point of another."""

    def __init__(self, jobs: int = 0):
        self.lanes = jobs or cores()

    def run(self, engine, plan: Plan, keep: Keep) -> None:
        with concurrent.futures.ThreadPoolExecutor(self.lanes) as pool:
            running: set[concurrent.futures.Future] = set()
            try:
                while True:
                    while len(running) < self.lanes and (portion := plan.next(self.lanes)):
                        running.add(pool.submit(engine.compute, portion.ids, portion.settings, portion.values, 1))
                    if not running:
                        return
                    done, running = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
                    for future in done:
                        chunk = future.result()
                        plan.learn(len(chunk.ids), chunk.seconds)
                        keep(chunk)
            except BaseException:
                for future in running:
                    future.cancel()
                raise


class WorkerStopped(RuntimeError):
    """A worker was asked to stop while it computed."""


_portions: weakref.WeakKeyDictionary = weakref.WeakKeyDictionary()  # that each worker of this process computes; touched by its event loop alone


def _count(worker, change: int) -> None:
    """Lets the worker's profiler run while it computes no portion."""
    from distributed.core import Status

    computed = _portions[worker] = _portions.get(worker, 0) + change
    profiler = worker.periodic_callbacks.get("profile")
    if profiler is None:
        return
    if computed:
        profiler.stop()
    elif worker.status == Status.running and not profiler.is_running():
        profiler.start()


@contextlib.contextmanager
def unsampled():
    """Pauses the statistical profiler of this thread's worker.

    Dask looks at the Python stack of a worker's threads a hundred times a second. Of a portion it sees one line, the call of the core, and the looks
    of four workers on two cores took 8 % of their time.
    """
    from distributed import get_worker

    worker = get_worker()
    worker.loop.add_callback(_count, worker, 1)
    try:
        yield
    finally:
        worker.loop.add_callback(_count, worker, -1)


def compute_portion(engine, portion: Portion) -> Chunk:
    """What a worker does."""
    try:
        with unsampled():
            return engine.compute(portion.ids, portion.settings, portion.values, 1)
    except KeyboardInterrupt as error:
        # The signal was meant for the worker, which had no ear for it meanwhile.
        os.kill(os.getpid(), signal.SIGTERM)
        raise WorkerStopped("the worker received a request to stop") from error


class Cluster:
    """The workers of a Dask cluster, each thread of which computes one portion at a time.

    A worker may be lost at any moment: its portions are computed again on another. Workers may come at any moment. A scheduler that is lost ends the
    computation with Lost.
    """

    def __init__(self, client):
        self.client = client
        self._threads = 0
        self._seen = 0.0
        self._name = f"orbearing-{uuid.uuid4().hex[:8]}"  # results of another study of the same cluster are not ours
        self._submitted = 0

    @property
    def lanes(self) -> int:
        """Threads of all workers there are now."""
        now = time.monotonic()
        if now - self._seen > LOOK_SECONDS:
            self._threads = sum(worker.get("nthreads", 0) for worker in self._scheduler()["workers"].values())
            self._seen = now
        return self._threads

    def _scheduler(self) -> dict:
        """What the scheduler says of itself. Raises Lost where it does not answer."""
        from distributed.comm.core import CommClosedError

        begin = time.monotonic()
        while True:
            try:
                if self.client.status not in ("running", "connecting"):
                    raise Lost(f"the client's connection to the scheduler is {self.client.status}")
                return self.client.sync(self.client.scheduler.identity, callback_timeout=PATIENCE_SECONDS)
            except (OSError, asyncio.TimeoutError, CommClosedError, AttributeError) as error:
                if time.monotonic() - begin > PATIENCE_SECONDS:
                    raise Lost(f"the scheduler does not answer ({error or type(error).__name__})") from error
                time.sleep(LOOK_SECONDS)

    def run(self, engine, plan: Plan, keep: Keep) -> None:
        finished: queue.SimpleQueue = queue.SimpleQueue()
        waiting: dict = {}  # future -> portion, tries
        try:
            self._await_workers()
            while plan.left or waiting:
                while plan.left and len(waiting) < AHEAD * max(self.lanes, 1):
                    self._submit(engine, plan.next(AHEAD * max(self.lanes, 1)), 1, waiting, finished)
                try:
                    future = finished.get(timeout=LOOK_SECONDS)
                except queue.Empty:
                    self._scheduler()
                    continue
                self._take(future, engine, plan, keep, waiting, finished)
        finally:
            self._release(waiting)

    def _await_workers(self) -> None:
        begin = time.monotonic()
        while not self.lanes:
            if time.monotonic() - begin > AT_FIRST_SECONDS:
                raise Lost(f"the scheduler has had no worker for {AT_FIRST_SECONDS:.0f} s; start workers, then continue with --resume")
            time.sleep(0.1)
            self._seen = 0.0

    def _submit(self, engine, portion: Portion, tries: int, waiting: dict, finished: queue.SimpleQueue) -> None:
        self._submitted += 1
        try:
            future = self.client.submit(compute_portion, engine, portion, key=f"{self._name}-{self._submitted}", pure=False)
        except Exception:
            self._scheduler()  # that it is lost says more than where that was met
            raise
        waiting[future] = portion, tries
        future.add_done_callback(finished.put)

    def _take(self, future, engine, plan: Plan, keep: Keep, waiting: dict, finished: queue.SimpleQueue) -> None:
        from distributed.scheduler import KilledWorker

        portion, tries = waiting[future]
        if future.status in ("cancelled", "lost"):
            self._scheduler()
            raise Lost("the scheduler lost the task: it was restarted, or the task was cancelled")
        try:
            # A worker that is lost with its result in memory: the scheduler has it computed again meanwhile.
            chunk = future.result()
        except (KilledWorker, WorkerStopped, OSError, asyncio.TimeoutError, concurrent.futures.CancelledError) as error:
            if not isinstance(error, (KilledWorker, WorkerStopped)):
                self._scheduler()  # a connection that broke: to a worker, or to the scheduler itself
            if tries == TRIES:
                raise Lost(f"{len(portion.ids)} points from number {portion.ids[0]} on lost their worker {TRIES} times") from error
            del waiting[future]
            future.release()
            self._submit(engine, portion, tries + 1, waiting, finished)
            return
        del waiting[future]
        future.release()
        plan.learn(len(chunk.ids), chunk.seconds)
        keep(chunk)

    def _release(self, waiting: dict) -> None:
        """What is not finished is not wanted any more."""
        if waiting and self.client.status == "running":
            try:
                self.client.cancel(list(waiting), force=True)
            except Exception:  # noqa: BLE001  the scheduler may be gone: nothing is left to cancel then
                pass
        waiting.clear()


def executor_of(executor, jobs: int = 0):
    """None: this process; "threads": portions on threads of it; a Dask client: its cluster. Raises ValueError for anything else."""
    if executor is None:
        return InProcess(jobs)
    if executor == "threads":
        return Threads(jobs)
    if hasattr(executor, "submit") and hasattr(executor, "scheduler_info"):
        return Cluster(executor)
    raise ValueError(f"executor: found {executor!r}; required: None, 'threads' or a Dask client")
