#!/usr/bin/env bash
# b_{n,k} on r = 1 here and by Arb, side by side, with ratios. Needs gcc and Arb's headers (Debian: apt-get install
# libflint-dev libflint-arb-dev), and python3 (or $PYTHON), for which python-flint is installed if it is missing. Both sides: the
# fastest of several batches, in nanoseconds. Fails if the answers differ: the values are compared here at a point with python-flint,
# and by each bench with the crate's own balls.
set -eu
cd "$(dirname "$0")/../.."
. benches/common.sh
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
compile_with_arb "$build/arb" benches/peers/arb.c
python=${PYTHON:-python3}
if ! "$python" -c "import flint" 2>/dev/null; then
    "$python" -m venv "$build/venv"
    python=$build/venv/bin/python
    "$python" -m pip install --quiet python-flint==0.9.0
fi
cargo bench --quiet --bench enclosures -- 'b|signs' --warm-up-time 0.5 --measurement-time 1.5 | grep '^signs:' || true
"$build/arb" >"$build/times"
find_grazing
"$GRAZING" evaluate 100 37 --s 12345/67891 --bits 256 >"$build/here"
"$python" - "$build" "${CARGO_TARGET_DIR:-target}" <<'PY'
import glob, json, sys
from flint import arb, ctx, fmpq
build, target = sys.argv[1:]
ctx.prec = 300
sine = lambda k: arb.sin_pi_fmpq(fmpq(k * 12345, 67891))
b = -2 * sine(37) * sine(63) / arb.cos_pi_fmpq(fmpq(100 * 12345, 67891))
here = arb(open(build + "/here").readline().split()[-1])
assert abs(b - here) < arb("1e-70"), (b, here)
flint = {}
for line in open(build + "/times"):
    kind, bits, ns, value = line.split()
    flint[kind, int(bits)] = float(ns)
    if kind == "single":
        assert abs(b - arb(value)) < arb("1e-13"), (b, value)
times = {}
for path in glob.glob(target + "/criterion/*/*/new/sample.json"):
    group, name = json.load(open(path.replace("sample", "benchmark")))["title"].split("/", 1)
    sample = json.load(open(path))
    times[group, name] = min(t / i for t, i in zip(sample["times"], sample["iters"]))
rows = []
interval = times["single b", "f64 interval"]
plain = times["single b", "plain f64, as printed"]
rows.append(("f64 interval / plain f64, one b", interval, plain, interval / plain, "<= 5"))
rows.append(("Arb 53 bits / f64 interval, one b", interval, flint["single", 53], flint["single", 53] / interval, ">= 10"))
for bits in (128, 256, 1024, 4096):
    ns = times["all b, n = 100", f"{bits} bits"] / 99
    rows.append((f"Arb / here, all b, per k, {bits} bits", ns, flint["all", bits], flint["all", bits] / ns, ">= 2"))
ns = times["single b", "256 bits"]
rows.append(("here / Arb, one b, 256 bits", ns, flint["single", 256], ns / flint["single", 256], "<= 1"))
signs = {name: ns for (group, name), ns in times.items() if group.startswith("all signs")}
ladder, intervals = signs["the ladder"], signs["f64 intervals alone"]
rows.append(("ladder / f64 intervals, all signs", ladder, intervals, ladder / intervals, "<= 1.2"))
print(f"{'':38} {'here ns':>11} {'other ns':>11} {'ratio':>7}  wanted")
for name, here, other, ratio, wanted in rows:
    print(f"{name:38} {here:11.1f} {other:11.1f} {ratio:7.2f}  {wanted}")
PY
