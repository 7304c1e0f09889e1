"""Validates JSON against docs/schemas, and shows that the schemas notice damage.

    python3 tests/schemas.py docs/schemas FILE...

Each FILE is an output of grazing; its key `format` names its schema. Then every key of every object in it is
left out, renamed and given a value of another type, one at a time, and the schema must refuse each. A key may
only be left out where its schema says that it may be absent. Prints a line per failure; exit code 1 if there
is any.
"""

import copy
import json
import pathlib
import sys

from jsonschema import Draft202012Validator
from jsonschema.exceptions import best_match

# Keys that a value may lack: rounded ends, what is only said of two dimensions, of measured forces, friction,
# kinks and wear, of a machine's plane, of more exponents than one, of monitors, and what a restart keeps.
OPTIONAL = {
    "left_rounded", "right_rounded", "growth_plus", "growth_minus", "measured", "friction", "kinks", "wear", "plane",
    "exponents", "monitors", "fixed",
}
# Objects whose keys are names of the user's or of the computation's own, not of the format.
FREE = {"parameters", "effects", "detail", "monitors"}
# Not a value of any key.
WRONG = {"neither": [{}]}
# Entries of a list beyond these are like those before.
MOST = 2


def objects(value, path=()):
    """Each object in a value with the keys that lead to it."""
    if isinstance(value, dict):
        yield path, value
        for key, inner in value.items():
            if key not in FREE:
                yield from objects(inner, path + (key,))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from objects(inner, path + (index,))


def shortened(value):
    if isinstance(value, dict):
        return {key: shortened(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [shortened(inner) for inner in value[:MOST]]
    return value


def parts(whole):
    """The value with short lists; a run once per task, for each has keys of its kind."""
    for task in whole["tasks"] if "tasks" in whole else [None]:
        yield shortened(whole if task is None else {**whole, "tasks": [task]})


def changed(whole, path, change):
    """A copy of `whole` in which `change` was applied to the object at `path`."""
    whole = copy.deepcopy(whole)
    inner = whole
    for key in path:
        inner = inner[key]
    change(inner)
    return whole


def damaged(whole):
    """What was done, and a copy to which it was done."""
    for path, inner in objects(whole):
        for key in inner:
            where = "/".join(map(str, path + (key,)))
            if key not in OPTIONAL:
                yield f"without {where}", changed(whole, path, lambda x: x.pop(key))
            yield f"{where} renamed", changed(whole, path, lambda x: x.update({key + "_": x.pop(key)}))
            yield f"{where} of another type", changed(whole, path, lambda x: x.update({key: WRONG}))


def main(folder, files):
    schemas = {}
    for file in sorted(pathlib.Path(folder).glob("*.json")):
        schema = json.loads(file.read_text())
        Draft202012Validator.check_schema(schema)
        schemas[file.stem] = Draft202012Validator(schema)
    failures, tried, used = [], 0, set()
    for file in files:
        whole = json.loads(pathlib.Path(file).read_text())
        name = whole["format"].replace(" ", "-")
        if name not in schemas:
            failures.append(f"{file}: there is no schema {name}.json")
            continue
        used.add(name)
        error = best_match(schemas[name].iter_errors(whole))
        if error is not None:
            place = "/".join(map(str, error.absolute_path))
            failures.append(f"{file}: {name}: at /{place}: {error.message[:300]}")
            continue
        # What is left of an interrupted output may be whole without its rows.
        if whole.get("verdict") == "interrupted":
            continue
        for part in parts(whole):
            if not schemas[name].is_valid(part):
                failures.append(f"{file}: {name} refuses it with shorter lists")
            for what, damage in damaged(part):
                tried += 1
                if schemas[name].is_valid(damage):
                    failures.append(f"{file}: {name} accepts it {what}")
    failures += [f"no output was given for {name}.json" for name in sorted(set(schemas) - used)]
    print(*failures, sep="\n", end="\n" if failures else "")
    print(f"{len(files)} outputs, {len(used)} schemas, {tried} damaged copies")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
