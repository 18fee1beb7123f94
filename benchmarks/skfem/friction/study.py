"""Benchmarks of friction: the table and the pictures.

    python study.py [folder [case,case,...]]

Cases are the names of ``CASES``; all of them take some minutes. Writes ``table.md`` and pictures into the folder,
``out/friction`` by default.
"""

import sys
import time
from pathlib import Path

import numpy as np
from arm import Arm
from balls import LARGEST_PUSH, Balls
from balls import loop_area as area_of_balls
from capstan import Capstan
from cylinders import MU, PRESS, Cylinders, loop_area
from fmc_contact import FmcError
from fold import Fold
from pushed_plate import PUBLISHED, Plate
from ring_on_disc import RingOnDisc
from scipy.integrate import trapezoid
from slope import Slope, exact

LAWS = ("depth", "fiber")


def most(counts):
    return f"{np.mean(counts):.1f}, at most {max(counts)}"


def capstan(folder):
    import pictures

    lines = []
    for law in LAWS:
        for coefficient in (0.1, 0.3, 0.5):
            strip = Capstan(coefficient=coefficient, law=law)
            tensions, counts = strip.pull()
            plain, thick = tensions[-1] / strip.exact(), tensions[-1] / strip.exact_of_thick_strip()
            yield f"capstan, μ = {coefficient}, {law}", "T₂/T₁ by e^μπ", "1 ± 0.02", f"{plain:.4f}", most(counts)
            yield "", "by e^μπR/(R + t/2)", "", f"{thick:.4f}", ""
            lines.append((f"μ = {coefficient}, {law}", np.linspace(0, 1, len(tensions) + 1)[1:], tensions))
    pictures.curves(lines, ("way", "T₂ / T₁"), folder / "capstan.svg")


def patch_test(folder):
    for law in LAWS:
        for young, asked in ((1.1e5, "0 ± 0.1 %"), (1100, "-0.4 ± 0.1 %")):
            for coefficient in (0.0, 0.1, 0.2, 0.3):
                forces, counts = Slope(coefficient, young, law).push()
                errors = 100 * (forces[3:] / exact(coefficient) - 1)
                reached = f"{errors.mean():.3f} % ({errors.min():.3f} to {errors.max():.3f})"
                name = f"CGS-4, E = {young:g}, μ = {coefficient}, {law}"
                yield name, "error of F/G, mean over the way", asked, reached, most(counts)


def arm(folder):
    for law in LAWS:
        for factor in (1.25, 10):
            for coefficient, alpha in ((0.3, 0.5), (0.3, 0.9), (0.6, 0.5), (0.6, 0.9), (0.9, 0.9)):
                row = f"arm, μα = {coefficient * alpha:.2f}, k = {factor} E/h, {law}", "Q (1 - μα) / μP₀", "1 ± 3e-3"
                try:
                    forces, counts = Arm(coefficient, alpha, law, factor).pull()
                    yield *row, f"{forces[-1]:.6f}", most(counts)
                except (ArithmeticError, FmcError) as error:
                    yield *row, str(error), "×"


def cattaneo(folder):
    import pictures

    for facets, factor in ((24, 2), (48, 2), (24, 10)):
        states = []
        for dragged, asked in ((0.3, "3 %"), (0.6, "1.5 %"), (0.9, "1 %")):
            pair = Cylinders(facets, factor)
            pair.press()
            counts = []
            for step in range(1, 11):
                counts.append(pair.drag(dragged * step / 10))
                pair.bodies.commit()
            name = f"Cattaneo, a/{facets}, k = {factor} E/h, Q = {dragged} μP"
            states.append((dragged, pair.profile()))
            yield name, "error of q in L2", asked, f"{100 * pair.profile_error(dragged):.2f} %", most(counts)
            yield "", "c/a by exact", "1 ± 0.01", f"{pair.stick_width / np.sqrt(1 - dragged):.4f}", ""
        pictures.tractions(states, folder / f"cattaneo-{facets}-{factor}.svg")


def mindlin(folder):
    import pictures

    for facets, factor in ((24, 2), (24, 10)):
        pair = Cylinders(facets, factor)
        pair.press()
        loads, places, lost, counts = pair.loop(quarter=10)
        pictures.loop(loads, places, folder / f"loop-{factor}.svg")
        area = -trapezoid(loads[9:] * MU * PRESS, places[9:]) / loop_area(0.8)
        name = f"Mindlin's loop, a/{facets}, k = {factor} E/h"
        yield name, "area by exact", "1 ± 0.005", f"{abs(area):.4f}", most(counts)
        yield "", "dissipated in it, by exact", "", f"{lost[10:].sum() / loop_area(0.8):.4f}", ""
        yield "", "closes to", "1e-5", f"{abs(places[49] - places[9]) / np.ptp(places):.0e}", ""
        yield "", "least dissipation of a step", "not negative", f"{lost.min():.1e}", ""


def proportional(folder):
    for facets in (24, 48):
        for steps in (10, 20, 40):
            error, counts = Cylinders(facets).in_proportion(steps=steps)
            name = f"P and Q in proportion, a/{facets}, {steps} steps"
            yield name, "error of q/p in L2", "4 % in 40 steps", f"{100 * error:.1f} %", most(counts)


def plate(folder):
    for law in LAWS:
        for cells, factor, steps in ((32, 10, 1), (64, 10, 1), (64, 10, 10), (128, 10, 1), (32, 100, 1)):
            if law == "depth" or cells < 64:
                row = f"GRECO's plate, {cells}², k = {factor} E/h, {steps} steps, {law}", "u_x at five places, %", "± 0.5"
                try:
                    u, counts = Plate(cells, factor, law).push(steps)
                    yield *row, " ".join(f"{100 * error:+.2f}" for error in u / PUBLISHED - 1), most(counts)
                except (ArithmeticError, FmcError) as error:
                    yield *row, str(error), "×"


def ring(folder):
    for law in LAWS:
        for sectors, rings in ((16, 2), (24, 3)):
            torques, counts = RingOnDisc(sectors, rings, law).turn()
            name = f"ring on disc, {sectors} sectors, {law}"
            yield name, "torque by exact", "1 ± 0.01", f"{torques[-1]:.5f}", most(counts)


def balls(folder):
    pair = Balls(4)
    pair.press()
    for dragged in (0.15, 0.3, 0.45, 0.6, 0.75, 0.9):
        count, sticks = pair.drag(dragged)
        reached = f"{sticks / (1 - dragged) ** (1 / 3):.4f}"
        yield f"two balls in 3D, a/4, Q = {dragged} μP", "c/a by exact", "1 ± 0.02", reached, str(count)
    for facets in (3, 5, 7):
        pair = Balls(facets)
        pair.press()
        loads, places, lost, counts = pair.loop()
        area = abs(trapezoid(loads[4:] * LARGEST_PUSH, places[4:])) / area_of_balls(0.6)
        yield f"the same to and fro, a/{facets}", "area by exact", "1 ± 0.02", f"{area:.3f}", most(counts)
        yield "", "dissipated in it, by exact", "", f"{lost[5:].sum() / area_of_balls(0.6):.3f}", ""
        yield "", "closes to", "1e-5", f"{abs(places[24] - places[4]) / np.ptp(places):.0e}", ""
        yield "", "least dissipation of a step", "not negative", f"{lost.min():.1e}", ""


def fold(folder):
    for cells in (16, 24):
        (alone, counts), (apart, _) = (Fold(cells, is_apart).pull() for is_apart in (False, True))
        difference = np.abs(alone[:, :2] / apart[:, :2] - 1).max()
        name = f"fold, {cells} cells, self_contact by two bodies"
        yield name, "largest difference of forces", "5e-3", f"{difference:.0e}", most(counts)


CASES = {one.__name__: one for one in (capstan, patch_test, arm, cattaneo, mindlin, proportional, plate, ring, balls, fold)}


def main(folder="out/friction", names=""):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    lines = ["| case | what | asked | reached | iterations a step |", "| --- | --- | --- | --- | --- |"]
    for number, name in enumerate(names.split(",") if names else CASES, 1):
        start = time.perf_counter()
        for row in CASES[name](folder):
            lines.append("| " + " | ".join(row) + " |")
            print(f"[{number}] {time.perf_counter() - start:6.1f} s {lines[-1]}", flush=True)
            (folder / "table.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
