"""A host refuses a state that its bodies cannot have: the search turns back. Any other exception ends it, and is the caller's."""

import numpy as np
import pytest
from fmc_contact import Contact, NotConvergedError, check_host, errors, find_equilibrium
from fmc_contact.search import Refused

COORDS = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1.0], [1, 1.0], [1, 2.0], [0, 2.0]])
SQUARES = [[0, 1, 2, 3], [4, 5, 6, 7]]
FREE = np.arange(12, 16)
SPRINGS = 100 * np.kron(np.kron(np.eye(2), np.eye(4) - 0.25), np.eye(2))
LIFT = np.where(np.arange(16) >= 12, np.tile([0.0, 5.0], 8), 0.0)
# Springs that stiffen: the first whole step is 0.1, and the equilibrium is where 50 e + 1e6 e³ = 5.
STIFFENING = 1e6
LIMIT = 0.05


class Host:
    """Its nodes may not move farther than a limit; beyond it ``answer`` says what happens."""

    def __init__(self, answer, limit=LIMIT):
        self.answer, self.limit, self.refused = answer, limit, 0

    def __call__(self, x):
        moved = (x - COORDS).ravel()
        residual, matrix = SPRINGS @ moved + STIFFENING * moved**3 - LIFT, SPRINGS + np.diag(3 * STIFFENING * moved**2)
        if np.abs(moved).max() > self.limit:
            self.refused += 1
            return self.answer(residual, matrix)
        return residual, matrix


def raised(error):
    def answer(residual, matrix):
        raise error

    return answer


def found(host, contact=None, **options):
    return find_equilibrium(host, contact or Contact(COORDS, SQUARES, "quad"), COORDS, FREE, **options)


REFUSALS = {
    "Refused": raised(Refused("a node is too far away")),
    "an error of the package": raised(errors.InvertedCellError("cell 3 is inverted")),
    "a residual that is not finite": lambda residual, matrix: (residual * np.nan, matrix),
}


@pytest.mark.parametrize("kind", REFUSALS)
def test_a_refused_state_shortens_the_step(kind):
    host = Host(REFUSALS[kind])
    lift = (found(host).x - COORDS)[6:, 1]
    assert host.refused > 0
    assert 50 * lift + STIFFENING * lift**3 == pytest.approx(5.0, rel=1e-8)


@pytest.mark.parametrize(("kind", "text"), [("Refused", "a node is too far away"), ("an error of the package", "cell 3 is inverted")])
def test_where_no_state_is_left_the_reason_of_the_host_is_told(kind, text):
    with pytest.raises(NotConvergedError, match=text):
        found(Host(REFUSALS[kind], limit=0.001))
    with pytest.raises(NotConvergedError, match=f"no equilibrium after 0 linear solves: {text}"):
        found(Host(REFUSALS[kind], limit=-1.0))
    with pytest.raises(NotConvergedError, match=text):
        check_host(Host(REFUSALS[kind], limit=-1.0), Contact(COORDS, SQUARES, "quad"), COORDS, FREE)


def test_the_reason_is_told_where_the_search_stays_at_a_residual():
    """Ten times the load, and a limit far below where it leads."""
    refuse = Host(raised(Refused("a node is too far away")), limit=0.01)

    def host(x):
        residual, matrix = refuse(x)
        return residual - 9 * LIFT, matrix

    text = r"the residual is .* of the forces after \d+ linear solves; .*; the host refused a state: a node is too far away"
    with pytest.raises(NotConvergedError, match=text):
        found(host)


class OutOfLicencesError(Exception):
    pass


@pytest.mark.parametrize("error", [OutOfLicencesError("no licence"), RuntimeError("no licence"), KeyboardInterrupt("no licence")])
def test_any_other_exception_ends_the_search_and_leaves_the_contact_as_it_was(error):
    contact = Contact(COORDS, SQUARES, "quad", friction_coefficient=0.3)
    contact.friction.begin_step(COORDS)
    before = contact.multipliers.values.copy(), contact.options["stiffness"]
    host = Host(raised(error))
    with pytest.raises(type(error), match="no licence"):
        found(host, contact)
    assert host.refused == 1
    assert (contact.multipliers.values == before[0]).all() and contact.options["stiffness"] == before[1]
    # And it serves again.
    assert found(Host(REFUSALS["Refused"]), contact).residuals[-1] < 1e-9
