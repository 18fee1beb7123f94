"""The keys of case files, from the structs that read them: benchmarks/src/case/*.rs."""

import re
from pathlib import Path

SOURCES = Path(__file__).parents[1] / "src" / "case"
FILES = ("description", "body", "place", "obstacle", "contact", "time", "load_steps", "expected")
TYPES = {"f64": "number", "String": "text", "bool": "`true`, `false`", "PathBuf": "path", "toml::Table": "table", "ShapeName": "name"}
COMMENT, ATTRIBUTES = r"((?:^[ \t]*///[^\n]*\n)+)", r"((?:^[ \t]*#\[[^\n]*\]\n)*)"
ITEM = re.compile(COMMENT + ATTRIBUTES + r"^pub (struct|enum) (\w+)[^\n]*\n(.*?)^(?:\}|$)", re.S | re.M)
MEMBER = re.compile(COMMENT + ATTRIBUTES + r"^ +(?:pub )?(\w+)(?:: ([^\n]+),$|( \{\n.*?)^ {4}\},|,)", re.S | re.M)
FIGURES = re.compile(r"FigureKind::(\w+) => (?:\{\s*)?&\[(.*?)\]", re.S)


def words(comment):
    """A comment as one line, without its sign."""
    lines = [line.strip().removeprefix("///").strip() for line in comment.strip().splitlines()]
    return " ".join(line for line in lines if line).replace("|", "\\|")


def items():
    """Structs and enums by name: kind, comment, attributes, members (comment, attributes, name, type, inner)."""
    found = {}
    for name in FILES:
        text = (SOURCES / f"{name}.rs").read_text(encoding="utf-8")
        for comment, attributes, kind, item, body in ITEM.findall(text):
            if "Deserialize" in attributes and MEMBER.search(body):
                found[item] = (kind, comment, attributes, MEMBER.findall(body or ""), text)
    return found


def kebab(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", name).lower()


def anchor(title):
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")


def title_of(item, known):
    """The heading of a struct, or of an enum after the first key that takes it; nothing for what has none."""
    if item == "Case":
        return "Top level"
    own = re.match(r"\s*/// (`\[[^`]*`|`\w+`)", known[item][1])
    if own:
        return own[1]
    for other, (_, _, _, members, _) in known.items():
        for _, attributes, name, kind, _ in members:
            if re.search(rf"\b{item}\b", kind):
                name = (re.search(r"rename = \"(\w+)\"", attributes) or ["", name])[1]
                return f"`{name}`" if known[item][0] == "struct" else f"Values of `{name}` in {title_of(other, known)}"
    return f"Values of `{kebab(item).split('-')[-1]}` in `mesh`" if known[item][0] == "enum" else "`parts`"


def value(kind, known, plural=""):
    """What a key takes, in words."""
    if inner := re.fullmatch(r"Option<(.*)>", kind):
        return value(inner[1], known, plural)
    if inner := re.fullmatch(r"Vec<(.*)>|BTreeMap<String, (.*)>", kind):
        return f"list{plural} of {value(inner[1] or inner[2], known, 's')}"
    if inner := re.fullmatch(r"\[(.*); (\w)\]", kind):
        return f"{inner[2]} {value(inner[1], known, 's')}"
    if kind in known:
        word = "table" if known[kind][0] == "struct" or kind == "MeshSource" else "name"
        return f"[{word}{plural}](#{anchor(title_of(kind, known))})"
    return TYPES.get(kind, "integer") + plural


def default(attributes, kind, name, of_struct, known):
    """What holds if a key is absent."""
    _, _, of_all, _, text = of_struct
    if own := re.search(r"default = \"(\w+)\"", attributes):
        found = re.search(rf"fn {own[1]}\(\) -> \w+ \{{\s*([^\s}}]+)\s*\}}", text)[1].removesuffix(".0")
    elif re.search(r"\bdefault\b", of_all):
        found = re.search(rf"impl Default for .*?\b{name}: ([^,}}]+)", text, re.S)[1].strip().replace("_", "")
    elif not re.search(r"\bdefault\b", attributes):
        return "" if kind.startswith("Option") else "required"
    elif kind in known and known[kind][0] == "enum":
        found = next(kebab(name) for _, chosen, name, *_ in known[kind][3] if "#[default]" in chosen)
    else:
        found = {"f64": "0", "u64": "0", "bool": "false"}.get(kind, "")
    return f"`{found}`" if found and found not in ("Vec::new()", "None") else ""


def table_of(item, known):
    """The table of a struct."""
    _, comment, _, members, _ = known[item]
    about = re.sub(r"^`[^`]*`[.:,]? ?", "", words(comment))
    lines = [f"### {title_of(item, known)}", "", *([about[0].upper() + about[1:], ""] if about else [])]
    lines += ["| option | value | default | meaning |", "| --- | --- | --- | --- |"]
    for text, attributes, name, kind, _ in members:
        shown = (re.search(r"rename = \"(\w+)\"", attributes) or ["", name])[1]
        absent = default(attributes, kind, name, known[item], known)
        lines.append(f"| `{shown}` | {value(kind, known)} | {absent} | {words(text)} |")
    return [*lines, ""]


def names_of(item, known):
    """The table of an enum; of shapes with their keys, of sets of figures with these."""
    _, comment, attributes, members, text = known[item]
    if 'tag = "shape"' in attributes:
        about = re.sub(r"^`mesh`: a", "A", words(comment))
        lines = [f"### {title_of(item, known)}", "", about, "", "| request | keys | meaning |", "| --- | --- | --- |"]
        for said, _, name, _, inner in members:
            keys = [f"`{key}`: {lower(words(about))}" for about, _, key, *_ in MEMBER.findall(re.sub(r"^ {4}", "", inner, flags=re.M))]
            lines.append(f"| `shape = \"{kebab(name)}\"` | {'; '.join(keys)} | {words(said)} |")
        return [*lines, ""]
    as_key = str.lower if 'rename_all = "lowercase"' in attributes else kebab
    figures = {name: ", ".join(f"`{key}`" for key in re.findall(r"\"(\w+)\"", keys)) for name, keys in FIGURES.findall(text)}
    head = ["| option | figures | meaning |", "| --- | --- | --- |"] if item == "FigureKind" else ["| option | meaning |", "| --- | --- |"]
    lines = [f"### {title_of(item, known)}", "", words(comment), "", *head]
    for said, _, name, *_ in members:
        lines.append(f"| `{as_key(name)}` | {figures[name] + ' | ' if item == 'FigureKind' else ''}{words(said)} |")
    return [*lines, ""]


def lower(text):
    return text[0].lower() + text[1:].rstrip(".")


def keys(_results):
    """All keys, table by table."""
    known = items()
    tables = [table_of(item, known) if found[0] == "struct" else names_of(item, known) for item, found in known.items()]
    return "\n".join(["", *(line for lines in tables for line in lines)])


def example(_results):
    """A case as it stands in its file, up to its first check."""
    text = (SOURCES.parents[1] / "cases" / "hertz.toml").read_text(encoding="utf-8")
    first = text.split("[[expected]]")
    return f"```toml\n{first[0]}[[expected]]{first[1].rstrip()}\n```\n"
