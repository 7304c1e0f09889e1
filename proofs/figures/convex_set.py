#!/usr/bin/env python3
"""Writes convex_set.svg: the convex set V and its lattice points, n = 8, m = 3, s = 0.36.

Usage: python3 convex_set.py > convex_set.svg      (standard library only)
An illustration in floating point; nothing in the proof rests on it.
"""
from math import acos, atan, cos, exp, log, pi, sin

N, M, N_PLUS, N_MINUS, S = 8, 3, 3, 5, 0.36
WIDTH, HEIGHT, UNIT_T, UNIT_H = 470, 330, 50, 42
LEFT, MIDDLE = 45, 165
TOP_H = 3.2


def phases(r):
    """alpha, beta of a point (r, S)."""
    turn = 2 * pi * N * S
    alpha = atan((cos(turn) - r**-N) / sin(turn))
    return alpha, alpha + turn - 2 * pi * M


def band(r, t):
    """The lowest and the highest height of V at time t."""
    alpha, beta = phases(r)
    x = t / N
    rho = acos(min(1.0, exp((1 - x) * log(cos(alpha)) + x * log(cos(beta)))))
    chord = (1 - x) * alpha + x * beta
    return (-rho - chord) * N / (2 * pi), (rho - chord) * N / (2 * pi)


def contains(r, t, h):
    low, high = band(r, t)
    return low <= h <= high


def panel(r, dx, title):
    """One drawing; time runs right, height up."""
    def x(t):
        return dx + LEFT + UNIT_T * t

    def y(h):
        return MIDDLE - UNIT_H * h

    times = [N * i / 160 for i in range(161)]
    outline = [(t, band(r, t)[1]) for t in times] + [(t, band(r, t)[0]) for t in reversed(times)]
    path = " ".join(f"{x(t):.1f},{y(h):.1f}" for t, h in outline)
    yield f'<text class="title" x="{x(N / 2):.1f}" y="22">{title}</text>'
    yield f'<polygon class="v" points="{path}"/>'
    yield f'<line class="chord" x1="{x(0)}" y1="{y(0)}" x2="{x(N)}" y2="{y(0)}"/>'
    points = [(k, h) for k in range(1, N) for h in range(-3, 4) if (h - k * M) % N == 0]
    inside = [p for p in points if contains(r, *p)]
    far = [p for p in inside if p[1] <= -2]
    if far:
        k, h = far[0]
        corners = f"{x(0)},{y(0)} {x(N)},{y(0)} {x(k)},{y(h)}"
        yield f'<polygon class="triangle" points="{corners}"/>'
    for k, h in points:
        kind = "in" if (k, h) in inside else "out"
        yield f'<circle class="{kind}" cx="{x(k)}" cy="{y(h)}" r="4"/>'
    for k, h, name, dy in ((N_PLUS, 1, "P₊", -10), (N_MINUS, -1, "P₋", 20)):
        yield f'<text x="{x(k)}" y="{y(h) + dy}">{name}</text>'
    for k in range(N + 1):
        yield f'<text class="tick" x="{x(k)}" y="{y(-TOP_H) + 18:.1f}">{k}</text>'
    for h in range(-3, 4):
        yield f'<text class="tick" x="{dx + 18}" y="{y(h) + 4:.1f}">{h}</text>'
    yield f'<text class="tick" x="{x(N / 2):.1f}" y="{y(-TOP_H) + 36:.1f}">time k</text>'


STYLE = """
text { font: italic 14px serif; text-anchor: middle; fill: #222 }
.title { font-style: normal } .tick { font: 11px sans-serif; fill: #666 }
.v { fill: #cfe0f3; stroke: #33628f; stroke-width: 1.2 }
.chord { stroke: #33628f; stroke-width: 1.6 }
.triangle { fill: none; stroke: #b3541e; stroke-width: 1.2 }
.in { fill: #b3541e } .out { fill: #fff; stroke: #555; stroke-width: 1.3 }
"""


def main():
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * WIDTH} {HEIGHT + 20}">')
    print(f"<style>{STYLE}</style>")
    print(f'<rect width="{2 * WIDTH}" height="{HEIGHT + 20}" fill="#fff"/>')
    panels = ((0.99, 0, "r = 0.99: no lattice point, period 8 exists"),
              (0.9, WIDTH, "r = 0.90: P₋ is in V, no orbit"))
    for r, dx, title in panels:
        print("\n".join(panel(r, dx, title)))
    print("</svg>")


main()
