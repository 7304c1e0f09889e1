"""Makes the table of docs/benchmarks.md, and docs/benchmarks.csv with all rows, of what benches/all.sh measured.

Usage: all.py FOLDER CRITERION [-] PAGE: the folder of the steps' outputs, criterion's, and the page whose table is replaced; with `-` the
table is printed and the page is left alone. A step that failed, or whose tools are missing, has a row that says so.
"""

import csv
import datetime
import glob
import json
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "peers"))
from computer import load, machine  # noqa: E402

BEGIN, END = "<!-- table: written by `benches/all.sh` -->", "<!-- end of table -->"
folder, criterion, page = Path(sys.argv[1]), sys.argv[2], sys.argv[-1]
rows = []


def digits(x):
    """Three significant digits, without an exponent."""
    if x == 0:
        return "0"
    text = f"{x:.3g}"
    return f"{float(text):.0f}" if "e" in text else text


def seconds(x):
    return f"{digits(x)} s" if x >= 1 else f"{digits(1e3 * x)} ms" if x >= 1e-3 else nanoseconds(1e9 * x)


def nanoseconds(x):
    return f"{digits(x / 1e6)} ms" if x >= 1e6 else f"{digits(x / 1e3)} µs" if x >= 1e3 else f"{digits(x)} ns"


def row(what, here, beside="", ratio=None, command=""):
    rows.append((what, here, beside, digits(ratio) if ratio is not None else "", f"`{command}`" if command else ""))


def step(name, command):
    """The output of a step, or None, and a row that says that it is missing."""
    path = folder / name
    if path.exists():
        return path.read_text()
    rows.append((name, "not measured", "", "", f"`{command}`"))
    return None


def bench():
    """Medians of criterion's benchmarks, in nanoseconds, by (group, name), and how many elements each had."""
    found = {}
    for path in glob.glob(criterion + "/**/new/estimates.json", recursive=True):
        about = json.load(open(path.replace("estimates", "benchmark")))
        name = "/".join(part for part in (about["function_id"], about["value_str"]) if part)
        elements = (about.get("throughput") or {}).get("Elements", 1)
        found[about["group_id"], name] = json.load(open(path))["median"]["point_estimate"] / elements
    return found


def commands():
    text = step("commands", "benches/all.sh")
    times = {}
    for line in (text or "").splitlines():
        what, clock, user, system, command = line.split("|")
        if clock == "failed":
            row(what, "failed", command=command)
            continue
        spent = float(user) + float(system)
        times[what] = spent
        beside, ratio = "", None
        if what == "the same by enclosures":
            before = next(iter(times.values()))
            beside, ratio = "exact decision", spent / before if before else None
        row(what, f"{seconds(spent)}, {seconds(float(clock))} on the clock", beside, ratio, command)


def benches():
    if step("benches", "cargo bench") is None:
        return
    found = bench()

    def pair(what, ours, other, beside, command):
        if ours in found and other in found:
            row(what, nanoseconds(found[ours]), f"{beside}: {nanoseconds(found[other])}", found[other] / found[ours], command)

    one = "decide one period"
    for n in ("500", "8000"):
        if (one, n) in found:
            row(f"deciding one period n = {n}, over n", nanoseconds(found[one, n]), command="cargo bench --bench theorem2")
    rows_of = "Theorem 2's intervals for n = 3..=2000"
    pair("an interval of Theorem 2", (rows_of, "by modular inverses"), (rows_of, "by the Farey tree"), "by the Farey tree",
         "cargo bench --bench theorem2")
    for n in ("64", "128"):
        pair(f"a leaf of the cover of n = {n}, checked", ("covers", f"check/{n}"), ("covers", f"find/{n}"), "found",
             "cargo bench --bench covers")
    point = "a point of a branch"
    pair("a point of the period-4 branch, with multipliers, at short steps", (point, "period 4, steps up to 0.001"),
         (point, "period 4, steps up to 0.1"), "at long ones", "cargo bench -p grazing-scenes --bench branches")
    many = "many motions"
    for system in ("of one system", "of 256 systems"):
        pair(f"motions together, {system}, per motion and period", (many, f"together, {system}"), (many, f"one by one, {system}"),
             "one by one", "cargo bench -p grazing-scenes --bench simulation")
    clock = "clocks/1000 periods"
    pair("a thousand periods in radians of the drive", (clock, "2 pi"), (clock, "frequency = 4"), "in seconds, at 4 Hz",
         "cargo bench -p grazing-study --bench effects")


def patterns():
    if (text := step("patterns", "cargo bench --bench patterns")) is None:
        return
    found = bench()
    for group, name in (("N = 2, exact signs", "graph"), ("N = 4", "enclosed")):
        all_of = {int(key[1].rsplit("/", 1)[1]): ns for key, ns in found.items()
                  if key[0] == group and key[1].startswith(f"{name}, all patterns to period/")}
        if all_of:
            last = max(all_of)
            row(f"a pattern of a map of {group}, {name}, all of them to period {last}", nanoseconds(all_of[last]),
                command="cargo bench --bench patterns")
    if lists := re.findall(r": ([\d.]+) ms against ([\d.]+) ms, (\d+) times", text):
        listed, word, times = lists[len(lists) // 2]
        row("one word", f"{word} ms", f"listing every pattern to period 14: {listed} ms", float(times), "cargo bench --bench patterns")


def effects():
    if step("effects", "grazing accuracy --of effects") is None:
        return
    for name in ("effects.csv", "machine-effects.csv"):
        found = list(csv.DictReader(open(folder / "effects.d" / name)))
        bare = float(found[0]["time_ns"])
        for effect in found:
            kept = name.startswith("machine") or re.search("^bare|^forcing|wall|cubic|formula|soft", effect["effect"])
            if kept:
                ns = float(effect["time_ns"])
                row(f"{effect['effect']}: a period, {float(effect['impacts']):.3g} impacts", nanoseconds(ns), found[0]["effect"],
                    ns / bare, "grazing accuracy --of effects")


def peers():
    if text := step("arb", "benches/peers/arb.sh"):
        for what, here, other, ratio, wanted in re.findall(r"^(\S.*?)  +([\d.]+) +([\d.]+) +([\d.]+)  (.*)$", text, re.M):
            row(f"{what} (wanted {wanted.replace('<=', '≤').replace('>=', '≥')})", f"{digits(float(here))} ns",
                f"{digits(float(other))} ns", float(ratio), "benches/peers/arb.sh")
    if text := step("operations", "benches/peers/operations.sh"):
        kind, others = "", []
        for line in text.splitlines():
            cells = line.split()
            if line and not line[0].isspace() and "ns" not in cells and len(cells) <= 2:
                kind = line.strip()
            elif "bits" in cells:
                others = [cell for cell in cells[3:] if cell not in ("ns", "ratio")]
            elif len(cells) > 3 and cells[1] in ("53", "256", "4096"):
                widths = [line[27 + 21 * i:48 + 21 * i].split() for i in range(len(others))]
                beside = ", ".join(f"{other} {digits(float(pair[0]))}" for other, pair in zip(others, widths) if pair)
                ratios = " ".join(digits(float(pair[1])) for pair in widths if pair)
                rows.append((f"{kind}, {cells[1]} bits: {cells[0]}", f"{digits(float(cells[2]))} ns", f"{beside} (ns)" if beside else "",
                             ratios, "`benches/peers/operations.sh`"))
    if text := step("farey", "benches/peers/farey.sh"):
        for name, ns, plain, flint in re.findall(r"^(\S.*?)  +([\d.]+) +([\d.]+) +([\d.]+)$", text, re.M):
            if not name.startswith("FLINT"):
                row(f"a term of F_10000: {name}", f"{ns} ns", "FLINT", float(flint), "benches/peers/farey.sh")
    if text := step("theorem2", "benches/peers/theorem2.sh"):
        for last, *times in re.findall(r"^ *(\d+)" + r" +([\d.]+)" * 5 + "$", text, re.M):
            here, walk, ratio, intervals, other = map(float, times)
            beside = f"C, the same walk: {seconds(walk)}; the intervals alone: {seconds(intervals)}"
            rows.append((f"Theorem 2, decided for n = 3 to {last}", seconds(here), beside, f"{digits(ratio)} {digits(other)}",
                         "`benches/peers/theorem2.sh`"))
        row("the exponent of that in N", text.split()[-3], f"C: {text.split()[-2]}; {text.split()[-1]}", command="benches/peers/theorem2.sh")
    if text := step("simulation", "benches/peers/simulation.sh"):
        found = {cells[0]: float(cells[-1]) for cells in (line.split(",") for line in text.splitlines()[1:])}
        for other in found.keys() - {"grazing"}:
            row("the paper's scene at µ = 0.003, per period", f"{digits(1e3 * found['grazing'])} ns",
                f"{other}: {digits(1e3 * found[other])} ns", found[other] / found["grazing"], "benches/peers/simulation.sh")
    if text := step("branch", "benches/peers/branch.sh"):
        row("the period-4 branch by AUTO-07p", "", text.splitlines()[0].removeprefix("AUTO-07p: "), command="benches/peers/branch.sh")
    if not (folder / "machines").exists():
        return rows.append(("machines", "not measured", "", "", "`cargo bench -p grazing-scenes --bench machines`"))
    for line in (folder / "machines").read_text().splitlines():
        cells = line.split(",")
        if len(cells) == 8 and cells[0] in ("1", "10", "200") and cells[1] in ("3", "300"):
            row(f"a machine of {cells[0]} modes, the fastest {cells[1]} times the drive: a mode and its quarter period", f"{cells[4]} ns",
                command="cargo bench -p grazing-scenes --bench machines")


def shown(cells):
    """Whether a row stands on the page: all do in the CSV, of our own benches and of lengths beside others only there."""
    return not cells[4].startswith("`cargo bench") and not re.search("balls, (53|4096)|b, per k, (128|1024)|term of .*Walk", cells[0])


def table(rows):
    """The rows on the page, below the command that measured them; of effects the ratio to the first of their table."""
    lines, last = ["| what | here | beside | ratio |", "| --- | ---: | --- | ---: |"], ""
    for cells in filter(shown, rows):
        what, here, beside, ratio, command = cells
        if command.startswith("`grazing -q") or "accuracy" not in command and "peers" not in command:
            what = f"{what}: {command}"
        elif command != last:
            lines.append(f"| **{command}** | | | |")
            last = command
        what = re.sub(r": a period, ([\d.]+) impacts", "", what)
        beside = "" if beside in ("bare", "machine, bare") else beside
        lines.append("| " + " | ".join((what, here.split(", ")[0], beside, ratio)) + " |")
    return [line.replace("  |", " |") for line in lines]


def coq():
    if text := step("coq", "sh proofs/coq/build.sh"):
        what, clock, user, system, command = text.strip().split("|")
        row(what, "failed" if clock == "failed" else f"{seconds(float(user) + float(system))}, {seconds(float(clock))} on the clock", command=command)


for part in (commands, benches, patterns, effects, peers, coq):
    part()
version = subprocess.run(["rustc", "--version"], capture_output=True, text=True).stdout.split()[1]
begun = (folder / "load").read_text().strip()
lines = [
    f"{datetime.date.today().isoformat()}; {machine()}; Rust {version}; load {begun} at the beginning and {load()} at the end.", "",
]
lines += table(rows)
if "-" in sys.argv:
    print("\n".join(lines))
else:
    with open(Path(page).with_suffix(".csv"), "w") as file:
        csv.writer(file, lineterminator="\n").writerows([("what", "here", "beside", "ratio", "command"), *rows])
    text = Path(page).read_text()
    before, rest = text.split(BEGIN)
    Path(page).write_text(f"{before}{BEGIN}\n\n" + "\n".join(lines) + f"\n\n{END}{rest.split(END)[1]}")
