"""The six motions of `grazing accuracy --of simulations`, for other programs.

Masses of 1 with q_i'' = -damping_i q_i' - stiffness_i q_i - cubic q_i^3 - friction tanh(q_i'/width) + force + amplitude_i cos t,
that stay where the gap row.q - (offset + wall cos t) is not negative; an impact turns the gap's velocity z' into -restitution z',
along the row. All numbers are dyadic fractions, so every program has the same ones. The motion starts at t = 0 and is compared after PERIODS
periods 2 pi. Impacts slower than `slowest` are not counted: where a motion chatters to rest there is no end of them.

`python3 motions.py` prints them for benches/peers/motions.c, a line each.
"""

PERIODS = 10


def motion(name, damping, stiffness, row, restitution, offset, cubic=0.0, force=0.0, amplitude=0.0, wall=0.0, start=0.0,
           slowest=0.0, friction=0.0, width=1.0):
    modes = len(row)
    many = lambda x: list(x) if isinstance(x, (list, tuple)) else [x] * modes
    return dict(name=name, modes=modes, damping=many(damping), stiffness=many(stiffness), cubic=cubic, force=force,
                amplitude=many(amplitude), row=list(row), offset=offset, wall=wall, restitution=restitution,
                start=many(start), slowest=slowest, friction=friction, width=width)


# Squares of frequencies from 1.3 to 13, rounded to sixteenths.
SQUARES = [round(16 * 1.69 * 100 ** (i / 9)) / 16 for i in range(10)]
HALVES = [(-0.5) ** i for i in range(10)]
MOTIONS = [
    motion("linear with wall", 1 / 8, 1 / 4, [1.0], 3 / 4, -1 / 2, amplitude=1.0, start=1.0),
    motion("Duffing with wall", 1 / 8, 1 / 4, [1.0], 3 / 4, -1 / 2, cubic=1 / 2, amplitude=1 / 2, start=1.0),
    motion("near grazing", 0.0, 1.0 - 2.0**-6, [1.0], 1.0, -1.0 + 2.0**-11, start=1.0),
    motion("chatter", 1 / 8, 1 / 4, [1.0], 1 / 2, 0.0, force=-1.0, wall=2.0, start=3.0, slowest=2.0**-6),
    motion("steep friction", 1 / 8, 1 / 4, [1.0], 3 / 4, -1 / 2, amplitude=1.0, start=1.0, friction=1 / 4, width=2.0**-6),
    motion("10 modes", [round(64 * 0.08 * s**0.5) / 64 for s in SQUARES], SQUARES, HALVES, 1 / 2, -1 / 2, amplitude=HALVES),
]

if __name__ == "__main__":
    for m in MOTIONS:
        scalars = [m["cubic"], m["friction"], m["width"], m["force"], m["offset"], m["wall"], m["restitution"], m["slowest"]]
        lists = m["damping"] + m["stiffness"] + m["amplitude"] + m["row"] + m["start"]
        print(m["name"] + "|" + " ".join(map(repr, [m["modes"]] + scalars + lists)))
