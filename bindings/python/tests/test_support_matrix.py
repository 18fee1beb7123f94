"""The support matrix is what the library answers."""

from support_matrix import PAGE, filled


def test_the_page_has_the_answers_of_the_library():
    text = PAGE.read_text(encoding="utf-8")
    assert filled(text) == text, "make support"
