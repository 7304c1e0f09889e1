"""Sums up what digits.c prints, as CSV with the columns of digits.csv. Usage: digits.py ROWS."""

import csv
import subprocess
import sys

from computer import gcc, load, machine, quartiles


def version():
    """Arb's, by its header; from FLINT 3 on, FLINT's, of which it is a part."""
    for header, name, macro in [("arb.h", "Arb", "__ARB_VERSION"), ("flint/flint.h", "FLINT", "__FLINT_VERSION")]:
        source = f"#include <{header}>\n" + " ".join(macro + part for part in ("", "_MINOR", "_PATCHLEVEL"))
        done = subprocess.run(["gcc", "-E", "-P", "-"], input=source, capture_output=True, text=True)
        if done.returncode == 0:
            return name + " " + ".".join(done.stdout.split()[-3:])
    return "Arb"


groups = {}
for family, bits, digits, holds, *times in csv.reader(open(sys.argv[1])):
    assert holds == "1", (family, bits)
    groups.setdefault((family, bits), []).append((float(digits), [float(t) for t in times]))
by, where, busy = f"{version()}, {gcc()}", machine(), load()
columns = "family,method,time_ns,q25,q75,digits,least,decided,wrong,outside,inputs,load,by,machine".split(",")
out = csv.writer(sys.stdout, lineterminator="\n")
out.writerow(columns)
for (family, bits), rows in groups.items():
    digits = sorted(d for d, _ in rows)
    decided = sum(d > 0 for d in digits)
    times = quartiles([t for _, all_times in rows for t in all_times])
    out.writerow([family, f"Arb, {bits} bits", *times, digits[len(digits) // 2], digits[0], decided, 0, 0, len(rows), busy, by, where])
