"""Writes resources/profiles/S1002_worn.txt: S1002 with a hollow tread and a thinned flange.

An example of the two-column format, not a measured wheel. S1002 is taken from the formulas of
EN 13715; wear is a smooth hollow of 0.8 mm in the tread and up to 1 mm off the flank.

Run from anywhere: python3 fmu/make_worn_profile.py
"""

from math import exp, sqrt
from pathlib import Path

B = (0.0, -3.358537058e-02, 1.565681624e-03, -2.810427944e-05, 5.844240864e-08,
     -1.562379023e-08, 5.309217349e-15, -5.957839843e-12, 2.646656573e-13)
C = (-4.320221063e03, -1.038384026e03, -1.065501873e02, -6.051367875e00, -2.054332446e-01,
     -4.169739389e-03, -4.687195829e-05, -2.252755540e-07)


def polynomial(coefficients, y):
    return sum(c * y**i for i, c in enumerate(coefficients))


def s1002(y):
    """Height z [mm], down, at y [mm], to the field side, of the new wheel."""
    if y > 32.15796:
        return 1.364323640 - y / 15
    if y > -26:
        return polynomial(B, y)
    if y > -35:
        return polynomial(C, y)
    if y > -38.426669071:
        return 16.446 - sqrt(13**2 - (y + 26.210665) ** 2)
    if y > -39.764473993:
        return -93.576667419 - 2.747477419 * y
    if y > -49.662510381:
        return 8.834924130 + sqrt(20**2 - (y + 58.558326413) ** 2)
    if y > -62.764705882:
        return 16 + sqrt(12**2 - (y + 55) ** 2)
    return 9.519259302 + sqrt(20.5**2 - (y + 49.5) ** 2)


def worn(y):
    """Point of the worn wheel that comes from y [mm] of the new one."""
    hollow = 0.8 * exp(-(((y + 2) / 16) ** 2))
    thinned = exp(-(((y + 38) / 4) ** 2))
    return y - thinned, s1002(y) - hollow


def main():
    # Close points where the flank is steep.
    ys = [-69.5 + 0.5 * i for i in range(59)] + [-40 + 0.1 * i for i in range(51)]
    ys += [-34.5 + 0.5 * i for i in range(190)]
    raised = worn(0.0)[1]
    lines = [
        "# S1002 with a hollow tread and a thinned flange: an example, not a measured wheel.",
        "# Made by fmu/make_worn_profile.py from the formulas of EN 13715. Licence: MIT OR Apache-2.0.",
        "# Right wheel, nominal rolling circle at the origin: y to the field side, z down.",
        "# y_mm z_mm",
    ]
    for y, z in map(worn, ys):
        lines.append(f"{y:.5f} {z - raised:.5f}")
    path = Path(__file__).parent / "resources" / "profiles" / "S1002_worn.txt"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
