"""Programs of a page, and what the page shows of their output: blocks ``output`` that follow them."""

import re

NUMBER = re.compile(r"-?\d+\.?\d*(?:e[+-]?\d+)?")


def programs(page):
    """Each piece in Python with the output that the page shows for it, or nothing."""
    found = []
    for kind, text in re.findall(r"^```(python|output)\n(.*?)^```", page.read_text(encoding="utf-8"), flags=re.S | re.M):
        if kind == "python":
            found.append([text, ""])
        elif found:
            found[-1][1] += text
    return found


def differs(shown, printed):
    """Where an output differs from the one that a page shows, or nothing.

    Words are equal. Numbers are equal to 1e-5; below 1e-9 of the largest they are rounding.
    """
    words = [re.sub(r"\s+|(?<=\[)\s+|\s+(?=\])", " ", NUMBER.sub("#", text)).replace("[ ", "[").strip() for text in (shown, printed)]
    if words[0] != words[1]:
        return f"{words[0]!r} is shown, {words[1]!r} printed"
    numbers = [[float(one) for one in NUMBER.findall(text)] for text in (shown, printed)]
    least = 1e-9 * max(map(abs, numbers[0]), default=0.0)
    apart = [(a, b) for a, b in zip(*numbers) if abs(a - b) > max(1e-5 * abs(a), least)]
    return f"shown and printed: {apart}" if apart else ""
