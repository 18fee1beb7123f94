"""Sharp tips that are deformed: of three stages with two materials all converge at 45 degrees, all but one at 15."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "newton"))

import tips


def forces(half_angle, material, **options):
    """Of the stages that found an equilibrium."""
    ends = tips.stages(half_angle, material, **options)
    return [end[0] for end in ends if not isinstance(end, str)]


@pytest.mark.parametrize(("half_angle", "wanted"), [(45, (3, 3)), (15, (2, 3))])
def test_stages_converge(half_angle, wanted):
    for material, count in zip(("linear", "neo-Hookean"), wanted):
        found = forces(half_angle, material)
        assert len(found) >= count, (material, found)
        # Stiffer contact, more force, and towards a limit.
        assert all(first < then for first, then in zip(found, found[1:])), (material, found)
        assert found[-1] < 1.15 * found[0], (material, found)


def test_plainly_found_it_is_the_same():
    plain, two_level = (forces(45, "neo-Hookean", two_level=two_level) for two_level in (False, True))
    assert plain == pytest.approx(two_level, rel=1e-7)
