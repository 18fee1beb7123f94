"""The support matrix is what the library answers."""

import pytest
from support_matrix import PAGE, filled


def test_the_page_has_the_answers_of_the_library():
    # Without it a search has other solvers, and one row tells of a search that does not converge.
    pytest.importorskip("scipy")
    text = PAGE.read_text(encoding="utf-8")
    assert filled(text) == text, "make support"
