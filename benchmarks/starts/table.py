"""Solves the problems and prints what came out: ``python table.py [WORDS ...] [--limit SECONDS] [--jobs N] [--failed] [--slow]``.

``WORDS`` choose problems: those in whose ``group: name`` all words of one argument occur. Each is solved in a process of its own, which
ends after the limit on the time of the processor.
"""

import argparse
import math
import multiprocessing
import os
import resource
import signal
import sys
import time
import traceback

os.environ.setdefault("OMP_NUM_THREADS", "1")

import groups
from problem import Outcome, run

_FORK = multiprocessing.get_context("fork")


def _solve(group, name, limit, end):
    # A crowded machine makes no problem fail: the limit is on the time of the processor.
    used = math.ceil(sum(resource.getrusage(resource.RUSAGE_SELF)[:2]))
    resource.setrlimit(resource.RLIMIT_CPU, (used + math.ceil(limit), used + math.ceil(limit) + 5))
    try:
        end.send(run(groups.GROUPS[group][name]()))
    except BaseException as error:
        last = traceback.extract_tb(error.__traceback__)[-1]
        place = f"{os.path.basename(last.filename)}:{last.lineno}"
        end.send(Outcome(faults=[f"{type(error).__name__} at {place}: {error}"]))
    finally:
        end.close()


class _Run:
    """A problem in its process."""

    def __init__(self, one, limit):
        self.one, self.begun, self.limit = one, time.perf_counter(), limit
        self.end, other = _FORK.Pipe(duplex=False)
        self.process = _FORK.Process(target=_solve, args=(*one, limit, other))
        self.process.start()
        other.close()

    def outcome(self):
        """What came out, or None as long as it runs."""
        if self.end.poll(0.01):
            try:
                found = self.end.recv()
            except EOFError:
                self.process.join()
                is_late = -self.process.exitcode in (signal.SIGXCPU, signal.SIGKILL)
                found = Outcome(faults=[f"not done within {self.limit:g} s" if is_late else f"the process ended with {self.process.exitcode}"])
        elif time.perf_counter() - self.begun > 20 * self.limit:
            self.process.terminate()
            found = Outcome(faults=[f"not done within {20 * self.limit:g} s of the clock"])
        else:
            return None
        self.process.join()
        return found


def outcomes(problems, limit, jobs):
    """Pairs of a problem and what came out, in the order in which they end."""
    waiting, running = list(problems), []
    while waiting or running:
        while waiting and len(running) < jobs:
            running.append(_Run(waiting.pop(0), limit))
        for one in list(running):
            found = one.outcome()
            if found is not None:
                running.remove(one)
                yield one.one, found


def _numbers(outcome):
    """Found and expected values; of many the last ones."""
    each = [f"{what} {found:.9g}/{value:.9g}" for what, found, value in outcome.numbers]
    return ", ".join(each if len(each) < 4 else ["…", *each[-2:]])


def _counts(each):
    """Counts of all steps; of many their sum and the largest."""
    return "+".join(map(str, each)) if len(each) < 9 else f"{sum(each)} in {len(each)} steps, {max(each)} at most"


def _line(name, outcome):
    counts = " | ".join(_counts(each) for each in (outcome.rigid_steps, outcome.solves, outcome.updates))
    said = outcome.message.replace("\n", " ")
    return f"{'FAIL' if outcome.faults else 'ok  '} | {name} | {_numbers(outcome)} | {counts} | {outcome.seconds:.2f} | {said[:150]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("words", nargs="*", metavar="WORDS")
    parser.add_argument("--limit", type=float, default=60.0, help="seconds of the processor for each problem")
    parser.add_argument("--jobs", type=int, default=1, help="problems at a time")
    parser.add_argument("--failed", action="store_true", help="print failed problems alone")
    parser.add_argument("--slow", action="store_true", help="solve the slow problems too")
    asked = parser.parse_args()
    chosen = [one for one in groups.named(asked.words) if asked.slow or one not in groups.SLOW]
    counts, most = {}, {}
    print("     | problem | found/expected | rigid steps | solves | updates | seconds | what the driver said")
    for (group, name), outcome in outcomes(chosen, asked.limit, asked.jobs):
        good, total = counts.get(group, (0, 0))
        counts[group] = (good + (not outcome.faults), total + 1)
        most[group] = max(most.get(group, 0), *outcome.solves, 0)
        if outcome.faults or not asked.failed:
            print(_line(f"{group}: {name}", outcome), flush=True)
        for fault in outcome.faults:
            print(f"       - {fault[:300]}", flush=True)
    for group, (good, total) in counts.items():
        print(f"{group}: {good} of {total}, {most[group]} solves at most in a step")
    return 0 if all(good == total for good, total in counts.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
