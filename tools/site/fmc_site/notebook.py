"""A notebook as the text of a page: its cells, and what they printed and drew when it was stored."""

import json


def as_markdown(path):
    """Markdown with the outputs between the cells; pictures are in the page itself."""
    parts = []
    for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
        source = "".join(cell["source"])
        parts.append(source if cell["cell_type"] == "markdown" else f"```python\n{source}\n```")
        printed = "".join("".join(output.get("text", "")) for output in cell.get("outputs", []))
        if printed:
            parts.append(f'```output\n{printed.rstrip()}\n```')
        for output in cell.get("outputs", []):
            picture = output.get("data", {}).get("image/png")
            if picture:
                address = "data:image/png;base64," + "".join(picture).replace("\n", "")
                parts.append(f'<p class="output"><img src="{address}" alt="Picture drawn by the cell above"></p>')
    return "\n\n".join(parts) + "\n"
