"""Results as HTML, for notebooks: small tables, all text escaped. A verdict is a word, never a colour alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

#: Rows that a table shows; how many there are is said.
MOST_ROWS = 40


def table(caption: str, head: Sequence[str], rows: Iterable[Sequence[Any]], count: int) -> str:
    """A table of the first rows of ``count``."""
    lines = [f"<table><caption>{escape(caption)}</caption>", _row("th", head)]
    lines += [_row("td", cells) for cells, _ in zip(rows, range(MOST_ROWS))]
    if count > MOST_ROWS:
        lines.append(f'<tr><td colspan="{len(head)}">… {count} rows in all</td></tr>')
    return "\n".join([*lines, "</table>"])


def _row(cell: str, cells: Sequence[Any]) -> str:
    return "<tr>" + "".join(f"<{cell}>{escape(text(one))}</{cell}>" for one in cells) + "</tr>"


def text(value: Any) -> str:
    """A cell: nothing for ``None``, signs of cases as (+, −)."""
    if value is None:
        return ""
    if isinstance(value, (tuple, list)):
        return ", ".join(map(text, value))
    return str(value)


def case(signs: tuple[int, int]) -> str:
    """A case as the paper writes it, sign eµ and sign γ."""
    return "(" + ", ".join("+" if sign > 0 else "−" for sign in signs) + ")"


def verdict(kind: str, statement: str, why: str) -> str:
    """An outcome in a line: its kind, what it is of, and why it is no better."""
    more = f": {escape(why)}" if why else ""
    return f"<p><strong>{escape(kind)}</strong> {escape(statement)}{more}</p>"


def preformatted(words: str) -> str:
    """Text as a terminal shows it."""
    return f"<pre>{escape(words)}</pre>"
