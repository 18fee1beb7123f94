"""Pictures of all problems of the suite, drawn from their data: nothing is solved."""

import html
import re

from fmc_suite.picture import svg
from fmc_suite.problem import Problem, names


def errors(results):
    """The errors that the page of results has for each problem: code and error."""
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in results.splitlines() if line.startswith("| ")]
    head = rows[0]
    assert head[0] == "problem", head
    return {row[0]: list(zip(head[1:], row[1:])) for row in rows[1:] if len(row) == len(head)}


def problems(results):
    """A section with every problem: its title, its picture, where the answer comes from, and the errors."""
    known = errors(results)
    legend = "Bodies are filled, and sides that may touch are red. Held points are dots; loaded points have arrows."
    parts = [f'\n## Problems\n\n{legend}\n\n<div class="problems">']
    for name in names():
        problem = Problem.load(name)
        title, source = (html.escape(text) for text in (problem.raw["title"], problem.raw["reference"]["source"]))
        width, height = re.search(r'width="(\d+)" height="(\d+)"', svg(problem)).groups()
        picture = svg(problem).replace('role="img"', f'role="img" aria-label="{title}" viewBox="0 0 {width} {height}"')
        rows = "".join(f"<li>{html.escape(code)}: {html.escape(error)}</li>" for code, error in known[name])
        parts.append(f'<section id="{name}"><h3>{title}</h3>{picture}<p><code>{name}</code>. {source}.</p><ul>{rows}</ul></section>')
    return "\n".join([*parts, "</div>"]) + "\n"
