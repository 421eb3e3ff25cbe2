"""Flange climb: the greatest Y/Q that a flange holds over the angle of attack, beside Nadal's limit.

Run: python flange_climb.py [WheelSet.fmu] [figure.svg]   (needs fmpy and numpy, for a figure matplotlib)

The wheelset rolls at 10 m/s under 60 kN on each wheel and is pushed sideways up the right flange at an angle of attack; height and roll follow the loads. Its yaw angle turns the wheel
against the rail. Y/Q on the way up goes through a greatest value, beyond which nothing holds the wheel: the limit of derailment. Nadal's formula, (tan δ - μ)/(1 + μ tan δ)
at the flange's angle δ, is that limit where friction is all lateral: at large angles of attack, of a wheel that turns by itself. On a solid axle the flange, whose radius is greater than
that of the tread, spends friction along the track too and holds more.
"""

import math
import shutil
import sys
from ctypes import byref

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.logging import addLoggerProxy

SPEED, LOAD = 10.0, 60e3
FRICTIONS = (0.2, 0.3, 0.4)
ANGLES = (0.0, 1.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0)
SHIFTS = np.arange(6.0e-3, 9.5e-3, 2.5e-5)


class Unit:
    """WheelSet.fmu under given loads."""

    def __init__(self, archive):
        description = fmpy.read_model_description(archive)
        self.variables = {v.name: v for v in description.modelVariables}
        self.folder = fmpy.extract(archive)
        identifier = description.coSimulation.modelIdentifier
        self.slave = FMU2Slave(guid=description.guid, unzipDirectory=self.folder, modelIdentifier=identifier, instanceName="climb")
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(lambda *_: None)
        addLoggerProxy(byref(self.callbacks))
        self.slave.instantiate(callbacks=self.callbacks)
        self.slave.setupExperiment(startTime=0.0)
        mode = self.variables["vertical.mode"]
        items = {item.name: int(item.value) for item in mode.declaredType.items}
        self.slave.setInteger([mode.valueReference], [items["load"]])
        self.set({"right.wheel.load": LOAD, "left.wheel.load": LOAD, "wheelset.vx": SPEED, "wheelset.pitch_rate": -SPEED / 0.46})
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def set(self, values):
        self.slave.setReal([self.variables[name].valueReference for name in values], list(values.values()))

    def get(self, *names):
        return self.slave.getReal([self.variables[name].valueReference for name in names])

    def close(self):
        self.slave.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)


def nadal(angle, friction):
    return (math.tan(angle) - friction) / (1 + friction * math.tan(angle))


def limit(unit, angle_of_attack, friction, is_free):
    """The greatest Y/Q of the right wheel on its way up, and the contact angle there [rad]; of a wheel that is free to turn, or on a solid axle."""
    # A right flange that runs against its rail has its leading edge to the right: positive yaw.
    unit.set({"wheelset.yaw": angle_of_attack, "right.friction.coefficient": friction, "left.friction.coefficient": friction})
    best = (0.0, 0.0)
    for shift in SHIFTS:
        unit.set({"wheelset.y": shift, "right.wheel.own_pitch_rate": 0.0})
        if is_free:
            # As fast as it rolls on its flange.
            (radius,) = unit.get("right.patch[1].rolling_radius")
            unit.set({"right.wheel.own_pitch_rate": SPEED / 0.46 - SPEED / radius})
        ratio, angle = unit.get("right.derailment_quotient", "right.patch[1].contact_angle")
        best = max(best, (ratio, -angle))
    return best


def table(archive):
    """Rows of friction, angle of attack [mrad], Y/Q on a solid axle and of a free wheel, contact angle of the latter [degrees] and Nadal's limit at it."""
    unit = Unit(archive)
    rows = []
    for friction in FRICTIONS:
        for attack in ANGLES:
            (solid, _), (free, angle) = [limit(unit, 1e-3 * attack, friction, is_free) for is_free in (False, True)]
            rows.append((friction, attack, solid, free, math.degrees(angle), nadal(angle, friction)))
    unit.close()
    return rows


def draw(rows, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(8, 4.6), layout="constrained")
    for friction, color in zip(FRICTIONS, ("#0072b2", "#d55e00", "#009e73")):
        own = [row for row in rows if row[0] == friction]
        attack = [row[1] for row in own]
        axes.plot(attack, [row[3] for row in own], "o-", color=color, label=f"friction {friction}, wheel turns by itself")
        axes.plot(attack, [row[2] for row in own], "o", markerfacecolor="none", color=color, label="on a solid axle")
        axes.axhline(own[-1][5], color=color, linestyle="--", linewidth=1)
    axes.set(xlabel="angle of attack [mrad]", ylabel="greatest Y/Q [-]", ylim=(0.8, None), title="Flange climb of S1002 on 60E1; dashed: Nadal")
    axes.grid(color="#e0e0e0")
    axes.legend()
    figure.savefig(path)


if __name__ == "__main__":
    rows = table(sys.argv[1] if len(sys.argv) > 1 else "target/release/WheelSet.fmu")
    print("friction  attack [mrad]  Y/Q: axle  wheel  contact angle [deg]  Nadal")
    for friction, attack, solid, free, angle, wanted in rows:
        print(f"{friction:8.1f}  {attack:13.1f}  {solid:9.3f}  {free:.3f}  {angle:19.2f}  {wanted:.3f}")
    if len(sys.argv) > 2:
        draw(rows, sys.argv[2])
