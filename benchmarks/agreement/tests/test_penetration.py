"""A penetration that is wanted is reached in every host, in short forms of the cases, and costs no more than twice the iterations."""

import os

import pytest
from fmc_agreement import penetration
from fmc_agreement.penetration import Wanted
from fmc_agreement.runs import SHARED, Case

if "FMC" not in os.environ:
    pytest.skip("the environment variable FMC does not name the command fmc", allow_module_level=True)

IRONING = (
    "bodies.block.mesh.cells=[30,10]",
    "bodies.die.mesh.finest=0.4",
    "load_steps.then=[6]",
    "contact.stiffness=1e5",
)


@pytest.mark.parametrize(
    "wanted",
    [
        Wanted(Case("hertz", None, ("bodies.disc.mesh.finest=0.1134",), hosts=SHARED), 8e-6),
        Wanted(Case("ironing", None, IRONING, hosts=SHARED), 1.5e-6),
    ],
    ids=lambda wanted: wanted.case.name,
)
def test_a_millionth_of_the_radius_in_every_host(tmp_path, wanted):
    rows = penetration.measured(tmp_path, wanted)
    assert [row["host"] for row in rows] == ["reference", "skfem", "dolfinx", "getfem"]
    for row in rows:
        assert penetration.is_met(row), row
        by_law, reached = row["penetration"]
        assert reached <= wanted.penetration < by_law and row["updates"][1] > 0
        # Forces are those of the others, and the law's but for what it penetrates.
        assert row["force"][1] == pytest.approx(rows[0]["force"][1], rel=2e-3)
        assert row["force"][1] == pytest.approx(row["force"][0], rel=2e-2)
    assert penetration.markdown(rows).count("\n") == 2 + len(rows)
