"""Formulas in TeX become MathML while the site is built: a reader needs neither scripts nor fonts from elsewhere."""

import re

from latex2mathml.converter import convert


def display(tex):
    """A formula that stands in lines of its own."""
    # The converter knows this environment by its other name.
    made = convert(re.sub(r"\\(begin|end)\{aligned\}", r"\\\1{align*}", tex.strip()), display="block")
    # What the converter does not know, it writes as text.
    unknown = re.search(r"\\[A-Za-z]+|<mi>&amp;</mi>|<mo>&amp;</mo>", made)
    assert not unknown, f"{unknown[0]} in a formula is not known: {tex}"
    return f'<div class="formula" tabindex="0">{made}</div>\n'


def subscripts(text):
    """Names in running text: one letter, a bar, and letters or numbers that stand below."""
    return re.sub(r"(?<!\w)([A-Za-zΑ-Ωα-ω∫Σδ∂][\u0303]?)_(?:\{([^{}]+)\}|([A-Za-z0-9]+))", lambda m: f"{m[1]}<sub>{m[2] or m[3]}</sub>", text)
