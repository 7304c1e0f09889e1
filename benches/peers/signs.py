"""Sums up what signs.c prints, as CSV with the columns of signs.csv, and prints Arb's times beside the ladder's.

Usage: signs.py POINTS ROWS SIGNS PEERS: the points with their signs, what signs.c printed of them, signs.csv, the file to write. Fails
if a sign differs.
"""

import csv
import statistics
import sys

from computer import arb, gcc, load, machine, quartiles

points_file, rows_file, signs_file, peers_file = sys.argv[1:]
csv.field_size_limit(10**7)
points = list(csv.DictReader(open(points_file)))
rows = [line.rstrip("\n").rsplit(",", 4) for line in open(rows_file)]
assert len(points) == len(rows), (len(points), len(rows))
ladder = {
    (row["family"], row["distance"]): (int(row["time_ns"]), row["rung"])
    for row in csv.DictReader(open(signs_file))
    if row["method"] == "ladder"
}
groups = {}
for point, (family, distance, sign, bits, ns) in zip(points, rows):
    assert (family, distance) == (point["family"], point["distance"])
    # (B1) has a limit where u_n = 0; the quantity has no value there.
    assert sign in ("?", point["sign"]) or point["sign"] == "singular", point
    decided = sign == point["sign"]
    groups.setdefault((family, distance), []).append((float(ns), int(bits), decided))
by, where, busy = f"{arb()}, {gcc()}", machine(), load()
with open(peers_file, "w") as file:
    out = csv.writer(file, lineterminator="\n")
    out.writerow("family,method,distance,rung,inputs,decided,wrong,time_ns,q25,q75,load,by,machine".split(","))
    for (family, distance), group in groups.items():
        times, decided = quartiles([ns for ns, _, _ in group]), sum(decided for _, _, decided in group)
        out.writerow([family, "Arb", distance, "", len(group), decided, 0, *times, busy, by, where])
print(f"{'':24} {'distance':>9} {'here us':>10} {'decided by':>13} {'Arb us':>10} {'Arb bits':>9} {'ratio':>7}")
for (family, distance), group in groups.items():
    here, rung = ladder[family, distance]
    ns = statistics.median(ns for ns, _, _ in group)
    bits = max(bits for _, bits, _ in group) if all(decided for _, _, decided in group) else "open"
    print(f"{family:24} {distance:>9} {here / 1000:10.2f} {rung:>13} {ns / 1000:10.2f} {bits:>9} {ns / here:7.2f}")
