"""The picture of the README: where a wheel touches, its patch, and a map of its wear number.

    python overview.py ../docs/figures/overview.png

Needs pip install "wheelrail[plot]".
"""

from __future__ import annotations

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import wheelrail
from wheelrail import plot

LOAD = 80e3
PLACE = {"y": 0.7562, "yaw": 5e-3, "load": LOAD}
PATCH = {"y": 0.748, "yaw": 1e-3, "load": LOAD}


def main() -> None:
    target = sys.argv[1] if len(sys.argv) > 1 else "overview.png"
    wheel = wheelrail.Element(
        normal_model="strips",
        tangential_model="marches",
        vertical_mode="load",
        motion="rolling",
        vx=20.0,
    )
    figure, axes = plt.subplots(1, 3, figsize=(12.5, 4.0), layout="constrained", width_ratios=[1.15, 1, 1.2])
    found = wheel.contacts(**PLACE)
    plot.contacts(found, axes[0])
    axes[0].set_title(f"{1e3 * (PLACE['y'] - 0.75):.1f} mm to the right", fontsize=10, pad=22)
    fields = [field for contact in wheel.contacts(**PATCH) for field in contact.fields]
    field = max(fields, key=lambda field: field.normal_force)
    plot.patch(field, axes[1], arrows=14)
    axes[1].set_title(f"{1e3 * (0.75 - PATCH['y']):.0f} mm to the left: patch and tractions", fontsize=10, pad=22)
    y, yaw = np.linspace(-6e-3, 7e-3, 105)[:, np.newaxis], np.linspace(-8e-3, 8e-3, 65)
    result = wheel.evaluate(y=0.75 + y, yaw=yaw, load=LOAD, outputs="wear_number")
    image = axes[2].pcolormesh(
        1e3 * y[:, 0], 1e3 * yaw, result["wear_number"].T, norm="log", cmap="viridis", shading="nearest"
    )
    figure.colorbar(image, ax=axes[2], label="wear number [J/m]")
    axes[2].set(xlabel="lateral displacement [mm]", ylabel="yaw [mrad]")
    axes[2].set_title(f"{result['wear_number'].size} places under {LOAD / 1e3:.0f} kN", fontsize=10)
    figure.savefig(target, dpi=110)


if __name__ == "__main__":
    main()
