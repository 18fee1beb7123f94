"""Several ranks give what one gives; an error on one is an error on all."""

import re

import numpy as np
import pytest


def solution(ranks, folder, count, *arguments):
    out = folder / "solution.npz"
    run = ranks(count, *arguments[:1], out, *arguments[1:])
    assert run.returncode == 0, run.stdout + run.stderr
    return dict(np.load(out))


def distance(one, other, key):
    return np.abs(one[key] - other[key]).max() / np.abs(other[key]).max()


@pytest.fixture(scope="module")
def alone(ranks, tmp_path_factory):
    """Solutions on one rank, each made once."""
    made = {}

    def get(*arguments):
        if arguments not in made:
            made[arguments] = solution(ranks, tmp_path_factory.mktemp("alone"), 1, *arguments)
        return made[arguments]

    return get


def way(kind, shown):
    """How it is solved: a search wants the whole mesh, and nodes of the contact that one unknown moves, not the middle of a face."""
    return "attached" if shown == "parts" or (kind, shown) == ("hexahedron", "boundary") else "search"


# A search stops at a residual of 1e-12 of the forces, SNES at 1e-10 of the first one.
@pytest.mark.parametrize(
    "count, kind, order, shown",
    [(2, "triangle", 1, "whole"), (3, "triangle", 1, "whole"), (4, "triangle", 1, "whole"), (4, "quad", 1, "whole"),
     (3, "triangle", 1, "boundary"), (2, "triangle", 2, "whole"), (3, "quad", 2, "whole"), (3, "triangle", 3, "whole"),
     (2, "quad", 3, "whole"), (4, "tetra", 1, "whole"),
     (2, "tetra", 1, "boundary"), (3, "hexahedron", 1, "whole"), (2, "hexahedron", 1, "boundary"),
     (4, "triangle", 1, "parts"), (3, "quad", 2, "parts"), (2, "tetra", 1, "parts")],
)  # fmt: skip
def test_ranks_agree(ranks, alone, tmp_path, count, kind, order, shown):
    arguments = ("solve", kind, order, shown, "plain", way(kind, shown))
    one, several = alone(*arguments), solution(ranks, tmp_path, count, *arguments)
    assert distance(several, one, "u") < 1e-10 and distance(several, one, "force") < 1e-10
    assert np.abs(one["force"]).max() > 0.1


@pytest.mark.parametrize("count", [2, 4])
def test_two_spaces_with_friction(ranks, tmp_path, count):
    for stiffness in ("30", "found"):
        one, several = (solution(ranks, tmp_path, n, "two_spaces", stiffness) for n in (1, count))
        assert all(distance(several, one, key) < 1e-9 for key in one)
    along, _, up = one["forces"][1]
    assert up > 1.0 and 0.0 < -along < 0.3 * up * 1.001


def test_a_mesh_in_parts_is_not_searched(ranks, tmp_path):
    run = ranks(2, "solve", tmp_path / "none", "triangle", 1, "parts", "plain", "search")
    assert run.returncode != 0 and "in_parts=False" in run.stderr


@pytest.mark.parametrize("kind, shown", [("triangle", "whole"), ("tetra", "whole"), ("hexahedron", "boundary")])
def test_numbers_of_the_input_do_not_matter(ranks, alone, tmp_path, kind, shown):
    one = alone("solve", kind, 1, shown, "plain", way(kind, shown))
    other = solution(ranks, tmp_path, 2, "solve", kind, 1, shown, "permuted", way(kind, shown))
    assert distance(other, one, "u") < 1e-12 and distance(other, one, "force") < 1e-10


@pytest.mark.parametrize("kind", ["triangle", "quad", "tetra"])
def test_the_search_finds_what_snes_finds(alone, kind):
    search, snes = (alone("solve", kind, 1, "whole", "plain", through) for through in ("search", "attached"))
    assert distance(search, snes, "u") < 1e-9 and distance(search, snes, "force") < 1e-8


@pytest.mark.parametrize("through", ["attached", "newton"])
def test_ways_to_solve_agree(ranks, alone, tmp_path, through):
    from dolfinx.fem.petsc import NonlinearProblem

    if through == "newton" and not hasattr(NonlinearProblem, "F"):
        pytest.skip("this NonlinearProblem has no F: it holds a SNES, which attach is for")
    one = alone("solve", "triangle", 1, "whole", "plain", "search")
    other = solution(ranks, tmp_path, 2, "solve", "triangle", 1, "whole", "plain", through)
    assert distance(other, one, "u") < 1e-10 and distance(other, one, "force") < 1e-9


@pytest.mark.parametrize("kind", ["quad", "hexahedron"])
def test_two_meshes_and_ranks_that_have_none_of_one(ranks, tmp_path, kind):
    one = solution(ranks, tmp_path, 1, "two_meshes", kind)
    several = solution(ranks, tmp_path, 3, "two_meshes", kind)
    for key in one:
        assert distance(several, one, key) < 1e-12
    # Cells, or the boundary alone: the same facets, clipped by other simplices.
    assert (
        distance(one, one, "force0") == 0
        and np.abs(one["force0"] - one["force2"]).max() < 1e-11 * np.abs(one["force0"]).max()
    )
    assert np.abs(one["force0"].sum(axis=0) + one["force1"].sum(axis=0)).max() < 1e-12 * np.abs(one["force0"]).max()


@pytest.mark.parametrize("count", [1, 2, 4])
def test_a_matrix_takes_entries_at_new_places(ranks, count):
    run = ranks(count, "entries")
    assert run.returncode == 0, run.stdout + run.stderr


@pytest.mark.parametrize("kind", ["nan", "inverted", "layout", "length", "callback", "search"])
def test_an_error_reaches_every_rank_and_the_host_lives(ranks, kind):
    run = ranks(3, "fail", kind, limit=60)
    assert run.returncode == 0, run.stdout + run.stderr
    # Ten seconds, of which forms that are compiled for the first time take some.
    assert all(float(seconds) < 10.0 for seconds in re.findall(r"after (\S+) s", run.stdout)), run.stdout
    assert run.stdout.count(" saw ") == 3 and run.stdout.count("goes on") == 3, run.stdout


@pytest.mark.parametrize("what", ["contact", "forces"])
def test_an_error_on_one_rank_ends_the_search_on_all_whenever_it_comes(ranks, what):
    run = ranks(3, "fail_later", what, limit=60)
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout.count("goes on") == 3 and "was told nothing" not in run.stdout, run.stdout
