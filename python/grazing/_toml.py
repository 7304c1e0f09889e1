"""Dicts as TOML text, numbers exactly as they are meant."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any

from ._errors import InputError

_BARE = re.compile(r"[A-Za-z0-9_-]+\Z")


def to_toml(tree: Mapping[str, Any]) -> str:
    """TOML text of a dict, a key per line. A Fraction becomes text ``"p/q"``, a float its shortest decimal: 0.8
    means 4/5 here, as it does in a file."""
    plain, tables = [], []
    for key, value in tree.items():
        if isinstance(value, Mapping):
            tables.append(f"\n[{_key(key)}]\n" + _lines(value, str(key)))
        elif isinstance(value, (list, tuple)) and value and all(isinstance(one, Mapping) for one in value):
            tables += [f"\n[[{_key(key)}]]\n" + _lines(one, f"{key}[{i}]") for i, one in enumerate(value, 1)]
        else:
            plain.append(f"{_key(key)} = {_value(value, str(key))}\n")
    return "".join(plain + tables)


def _lines(table: Mapping[str, Any], path: str) -> str:
    return "".join(f"{_key(key)} = {_value(value, f'{path}.{key}')}\n" for key, value in table.items())


def _key(key: Any) -> str:
    if not isinstance(key, str):
        raise InputError(f"the key {key!r} is not text")
    return key if _BARE.match(key) else _text(key)


def _text(text: str) -> str:
    escaped = "".join(
        "\\" + c if c in '"\\' else c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}" for c in text
    )
    return f'"{escaped}"'


def _value(value: Any, path: str) -> str:
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(k)} = {_value(v, f'{path}.{k}')}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(v, f"{path}[{i}]") for i, v in enumerate(value, 1)) + "]"
    if isinstance(value, Decimal):
        if not value.is_finite():
            raise InputError(f"{path} = {value!r}: is not finite", key=path, value=repr(value))
        return _text(str(value))
    if isinstance(value, Fraction):
        return _text(f"{value.numerator}/{value.denominator}")
    if hasattr(value, "tolist") and getattr(value, "shape", None) is not None:
        return _value(value.tolist(), path)  # NumPy's numbers and arrays
    if isinstance(value, int):
        return str(value) if -(2**63) <= value < 2**63 else _text(str(value))
    if isinstance(value, float):
        if value != value or value in (float("inf"), float("-inf")):
            raise InputError(f"{path} = {value!r}: is not finite", key=path, value=repr(value))
        return repr(value)
    raise InputError(
        f"{path} = {value!r}: a scene has text, numbers, lists and dicts, and this is {type(value).__name__}",
        key=path,
        value=repr(value),
    )
