"""Amplitude and lag of the creep force on a round and on a wide patch where the creepage oscillates.

Draws them into the file named on the command line: pip install "wheelrail[plot]".
"""

import sys

import numpy as np
import wheelrail
import wheelrail.plot

# L/lambda, and separations across with the curvature of the wheel along, 1/(2 * 0.46 m), and a sixth of it.
ratios = np.geomspace(0.02, 2.0, 10)
y = np.linspace(-0.025, 0.025, 201)
shapes = {"round patch": 1.087, "wide patch": 0.18}
elements = {"normal_elements_along": 20, "normal_elements_across": 20}

found = {}
for shape, curvature in shapes.items():
    for oscillating in ("longitudinal", "lateral"):
        print(f"{shape}, {oscillating} creepage", flush=True)
        found[f"{shape}, {oscillating}"] = wheelrail.frequency.response(
            y, curvature * y**2, ratios, oscillating=oscillating, radius=0.46, load=6e4, **elements
        )

longitudinal = {name: own for name, own in found.items() if name.endswith("longitudinal")}
lateral = {name: own for name, own in found.items() if name.endswith("lateral")}
axes = wheelrail.plot.frequency_response(longitudinal, "fx")
wheelrail.plot.frequency_response(lateral, "fy", axes)
axes[0].set_ylabel("creep force along the creepage\nover that of slow oscillation")
axes[0].figure.savefig(sys.argv[1])
