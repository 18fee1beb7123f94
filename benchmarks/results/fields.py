"""Fields of a table, each a figure of a run: {hertz: peak_pressure vs reference: +.2%}

Between the braces: the run, as it stands after `fmc run`; the figure, alone, as `FIGURE vs reference` (its deviation from the
reference of the case's check), `FIGURE vs NUMBER` or `FIGURE reference` (the reference itself), and where wanted `/ NUMBER` or
`* NUMBER`; `iterations` is 6 (23), outer and
inner ones; and a format of Python's, with %, and with , between thousands, or `yes`.
"""

import re

FIELD = re.compile(r"\{([^{}:]+): ([^{}:]+)(?:: ([^{}]+))?\}")
QUANTITY = re.compile(r"(\w+)(?: (reference))?(?: vs (reference|[-\d.e]+))?(?: ([*/]) ([-\d.e]+))?")


def filled(text, results):
    """The text with the figures in place of its fields."""
    return FIELD.sub(lambda field: _figure(results, *field.groups()), text)


def runs(text):
    """Names of the runs that a text asks for."""
    return {field[1] for field in FIELD.finditer(text)}


def _figure(results, run, quantity, form):
    if quantity == "iterations" and "contact_iterations" in results.run(run):
        outer, inner = (results.run(run)[key] for key in ("iterations", "contact_iterations"))
        return f"{number(outer, ',')} ({number(inner, ',')})" if inner else number(outer, ",")
    asked = QUANTITY.fullmatch(quantity)
    if asked is None:
        raise ValueError(f"'{quantity}' of '{run}' is no quantity")
    figure, is_reference, reference, operator, factor = asked.groups()
    value = results.reference(run, figure) if is_reference else results.figure(run, figure)
    if reference:
        value = value / (results.reference(run, figure) if reference == "reference" else float(reference)) - 1
    if operator:
        value = value * float(factor) if operator == "*" else value / float(factor)
    return number(value, form or ".4g")


def number(value, form):
    """As the pages write it: 1 467, −0.20 %, 2e-13; with the format `yes`, yes or NO."""
    if form == "yes":
        return "yes" if value else "NO"
    text = format(value, form).replace(",", " ").replace("%", " %")
    text = re.sub(r"e\+00|(?<=e)\+0*|(?<=e-)0+", "", text)
    return re.sub(r"(?<!e)-", "−", text)
