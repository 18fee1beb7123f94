"""What stands around the text of every page: the bar, the contents, the headings of the page, the neighbours."""

import html

PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<meta name="description" content="Contact mechanics as a plug-in for finite element codes">
<link rel="icon" href="assets/icon.svg">
<link rel="stylesheet" href="assets/style.css">
<script src="assets/site.js"></script>
</head>
<body class="{kind}">
<a class="skip" href="#content">To the text</a>
<header>
<a class="brand" href="index.html">fmc-contact</a>
<nav class="places" aria-label="Main pages"><a href="first-contact.html">Start</a><a href="try.html">Try it</a><a href="gallery.html">Gallery</a><a
 href="suite-results.html">Suite</a><a href="{repository}">Source</a></nav>
<div class="search"><input id="search" type="search" placeholder="Search" aria-label="Search" autocomplete="off"><ol id="found" hidden></ol></div>
<button id="theme" type="button" aria-label="Light or dark">◐</button>
</header>
<div class="columns">
<details class="contents" id="contents"><summary>Contents</summary><nav aria-label="Contents">
{contents}
</nav></details>
<main id="content">
{text}
{neighbours}
</main>
{headings}
</div>
<footer>fmc-contact {version}, MIT or Apache-2.0. Formulas are MathML; no page loads anything from elsewhere.</footer>
</body>
</html>
"""


def listed(pages, here):
    """The contents, one list for each part; this page is marked."""
    parts = []
    for page in pages[1:]:
        if not parts or parts[-1][0] != page.part:
            parts.append((page.part, []))
        mark = ' aria-current="page"' if page == here else ""
        parts[-1][1].append(f'<li><a href="{page.name}.html"{mark}>{html.escape(page.title)}</a></li>')
    titled = [(f"<h2>{html.escape(part)}</h2>" if part else "", entries) for part, entries in parts]
    return "\n".join(f"{title}<ul>{''.join(entries)}</ul>" for title, entries in titled)


def whole(pages, here, rendered, repository, version):
    """The HTML of a page."""
    at = pages.index(here)
    beside = []
    for step, word in ((-1, "Back"), (1, "Next")):
        if here.name != "index" and 0 <= at + step < len(pages):
            other = pages[at + step]
            beside.append(f'<a rel="{word.lower()}" href="{other.name}.html"><small>{word}</small>{html.escape(other.title)}</a>')
    second = [(anchor, words) for level, anchor, words in rendered.headings if level == 2]
    headings = "".join(f'<li><a href="#{html.escape(anchor)}">{html.escape(words)}</a></li>' for anchor, words in second)
    title = rendered.headings[0][2] if rendered.headings else here.title
    return PAGE.format(
        title=html.escape(title if title == "fmc-contact" else f"{title} · fmc-contact"),
        kind="start" if here.name == "index" else "page",
        repository=repository,
        contents=listed(pages, here),
        text=rendered.html,
        neighbours=f'<nav class="neighbours" aria-label="Neighbours">{"".join(beside)}</nav>' if beside else "",
        headings=f'<aside aria-label="On this page"><h2>On this page</h2><ul>{headings}</ul></aside>' if len(second) > 1 else "<aside></aside>",
        version=version,
    )
