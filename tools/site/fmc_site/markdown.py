"""Markdown to HTML: anchors as GitHub names them, links within the site, code in colours, formulas, tables that scroll alone."""

import html
import re

from markdown_it import MarkdownIt
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name
from pygments.util import ClassNotFound

from .formulas import display, subscripts

FORMATTER = HtmlFormatter(nowrap=True)


def code(text, language):
    """A block of code, in colours where the language is known."""
    try:
        inner = highlight(text, get_lexer_by_name(language or "text"), FORMATTER)
    except ClassNotFound:
        inner = html.escape(text)
    return f'<pre tabindex="0"><code>{inner}</code></pre>\n'


def fence(renderer, tokens, index, options, env):
    language = (tokens[index].info.split() or [""])[0].split(",")[0]
    text = tokens[index].content
    if language == "math":
        return display(text)
    return f'<div class="output">{code(text, "text")}</div>\n' if language == "output" else code(text, language)


def words(renderer, tokens, index, options, env):
    # A number stays with its unit, and with its thousands.
    text = re.sub(r"(?<=\d) (?=%|(?:ms|s|MB|GB)\b|\d{3}\b)", "\u00a0", tokens[index].content)
    return subscripts(html.escape(text, quote=False))


def image(renderer, tokens, index, options, env):
    """A picture; a drawing has a box of its own, in which it may be wider than a telephone, so that its words can be read."""
    made = renderer.image(tokens, index, options, env)
    return f'<span class="picture" tabindex="0">{made}</span>' if tokens[index].attrGet("src").endswith(".svg") else made


class Rendered:
    """A page's HTML, with its headings (level, anchor, text) and its text for the search."""

    def __init__(self, text, source, links):
        self.headings = []
        self.links, self.source = links, source
        parser = MarkdownIt("commonmark", {"html": True}).enable(["table", "strikethrough"])
        parser.add_render_rule("fence", fence)
        parser.add_render_rule("code_block", fence)
        parser.add_render_rule("text", words)
        parser.add_render_rule("image", image)
        tokens = parser.parse(text)
        self.sections = []
        self.prepare(tokens)
        made = parser.renderer.render(tokens, parser.options, {})
        made = made.replace("<table>", '<div class="table" tabindex="0"><table>').replace("</table>", "</table></div>")
        self.html = re.sub(r'(<(?:a|img)\b[^>]*?\b(?:href|src)=")([^"]*)(")', self.of_html, made)

    def prepare(self, tokens):
        """Names headings, and keeps words for the search."""
        seen = {}
        for token, after in zip(tokens, tokens[1:] + tokens[-1:]):
            if token.type == "heading_open":
                words = "".join(child.content for child in after.children if child.type in ("text", "code_inline"))
                name = "".join("-" if c == " " else c for c in words.lower() if c.isalnum() or c in " -_")
                seen[name] = seen.get(name, -1) + 1
                anchor = f"{name}-{seen[name]}" if seen[name] else name
                token.attrSet("id", anchor)
                self.headings.append((int(token.tag[1]), anchor, words))
                self.sections.append([anchor, words, ""])
            elif token.type == "inline" and self.sections:
                words = "".join(c.content if c.type in ("text", "code_inline") else " " for c in token.children)
                self.sections[-1][2] += f" {words}"

    def of_html(self, match):
        """A link or picture of the page, as an address within the site."""
        is_picture = match[1].startswith("<img")
        target = self.links.target(self.source, html.unescape(match[2]), is_picture)
        # Without the references there is nothing to lead to: the words stay.
        return f"{match[1]}{html.escape(target)}{match[3]}" if target else match[1].rsplit(" ", 1)[0] + ' title="make book"'
