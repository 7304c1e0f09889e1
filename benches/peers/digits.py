"""Sums up what digits.c prints, as CSV with the columns of digits.csv. Usage: digits.py ROWS."""

import csv
import sys

from computer import arb, gcc, load, machine, quartiles


groups = {}
for family, bits, digits, holds, *times in csv.reader(open(sys.argv[1])):
    assert holds == "1", (family, bits)
    groups.setdefault((family, bits), []).append((float(digits), [float(t) for t in times]))
by, where, busy = f"{arb()}, {gcc()}", machine(), load()
columns = "family,method,time_ns,q25,q75,digits,least,decided,wrong,outside,inputs,load,by,machine".split(",")
out = csv.writer(sys.stdout, lineterminator="\n")
out.writerow(columns)
for (family, bits), rows in groups.items():
    digits = sorted(d for d, _ in rows)
    decided = sum(d > 0 for d in digits)
    times = quartiles([t for _, all_times in rows for t in all_times])
    out.writerow([family, f"Arb, {bits} bits", *times, digits[len(digits) // 2], digits[0], decided, 0, 0, len(rows), busy, by, where])
