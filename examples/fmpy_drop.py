"""A wheel rolling at 20 m/s is lowered onto the rail: the FMU in FMPy. Run: python fmpy_drop.py WheelRail.fmu"""

import sys

import fmpy
import numpy as np

# FMPy says which inputs the table leaves out: they keep their start values.
height = [("time", float), ("wheel.z", float)]
lowered = np.array([(0.0, -0.4599), (0.1, -0.4597)], dtype=height)
result = fmpy.simulate_fmu(
    sys.argv[1] if len(sys.argv) > 1 else "target/release/WheelRail.fmu",
    start_values={"wheel.vx": 20.0, "wheel.pitch_rate": -20.0 / 0.46, "wheel.profile": "S1002"},
    input=lowered, output=["wheel.force.z", "patch_count"], stop_time=0.1, output_interval=0.01,
)  # fmt: skip
for time, force, patches in result:
    print(f"{time:.2f} s: {abs(force) / 1e3:7.2f} kN on {patches} patch(es)")
