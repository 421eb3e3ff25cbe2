"""Critical speed of Cooperrider's bogie: with the creep law it was published with, and on WheelSet.fmu.

Run: python cooperrider_bogie.py [WheelSet.fmu]   (needs fmpy and numpy)

The bogie frame moves sideways, yaws and rolls, both wheelsets move sideways and yaw, between a car body that runs straight ahead: seven degrees of freedom. Its centred run loses
stability where a pair of eigenvalues crosses the imaginary axis (Hopf). Numbers and equations: N. K. Cooperrider, Journal of Engineering for Industry 94 (1972) 752, as Ch. Kaas-Petersen
gives them, Acta Mechanica 61 (1986) 89; the critical speed of 68.66 is that of the page "Railway bogie" of bifurcation.de, which calls it mph: with these numbers in SI units it is m/s.
"""

import shutil
import sys
from ctypes import byref

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.logging import addLoggerProxy

PUBLISHED = 68.66
WHEELSET = {"mass": 1022.0, "inertia": 678.0}
FRAME = {"mass": 2918.0, "yaw": 6780.0, "roll": 6780.0}
# Springs and dampers of one side: primary lateral, longitudinal and vertical, secondary lateral and vertical; of both: yaw.
PRIMARY = [1.823e6, 3.646e6, 3.646e6]
SECONDARY = [0.1823e6, 0.3333e6]
SECONDARY_YAW = [2.710e6, 500.0]
SECONDARY_DAMPING = [29.2e3, 20.0e3]
# Half distances: contacts, axles, primary and secondary springs; heights of the frame's centre over the first and under the second.
CONTACTS, AXLES, BOXES, BODY_SPRINGS = 0.716, 1.074, 0.620, 0.680
ABOVE, BELOW = 0.0762, 0.6584
CONICITY, RADIUS = 0.05, 0.4572
# G π a b of the ellipse of contact, and the numbers of Vermeulen and Johnson for it, along and across.
GPAB, LONG, LATERAL = 6.563e6, 0.60252, 0.54219
ELLIPSE = (6.578e-3, 3.934e-3)
# A rail of this crown radius under this load makes that ellipse.
CROWN, LOAD = 0.2115, 65.9e3


def bogie():
    """Matrices of inertia, stiffness and damping without contact, of y and yaw of both wheelsets and y, yaw and roll of the frame."""
    one = WHEELSET["mass"], WHEELSET["inertia"]
    inertia = np.diag([*one, *one, FRAME["mass"], FRAME["yaw"], FRAME["roll"]])
    stiffness, damping = np.zeros((7, 7)), np.zeros((7, 7))

    def add(matrix, factor, **motion):
        names = ["y1", "yaw1", "y2", "yaw2", "y", "yaw", "roll"]
        row = np.array([motion.get(name, 0.0) for name in names])
        matrix += factor * np.outer(row, row)

    lateral, along, vertical = PRIMARY
    for number, ahead in (("1", AXLES), ("2", -AXLES)):
        add(stiffness, 2 * lateral, **{"y" + number: 1, "y": -1, "yaw": -ahead, "roll": -ABOVE})
        add(stiffness, 2 * along * BOXES**2, **{"yaw" + number: 1, "yaw": -1})
    add(stiffness, 4 * vertical * BOXES**2, roll=1)
    for matrix, (sideways, upright) in ((stiffness, SECONDARY), (damping, SECONDARY_DAMPING)):
        add(matrix, 2 * sideways, y=1, roll=-BELOW)
        add(matrix, 2 * upright * BODY_SPRINGS**2, roll=1)
    add(stiffness, SECONDARY_YAW[0], yaw=1)
    add(damping, SECONDARY_YAW[1], yaw=1)
    return inertia, stiffness, damping


def published_contact(speed):
    """What lateral force and yaw moment of a wheelset change by with y and yaw, and with their rates: Vermeulen and Johnson's law at small creepages."""
    along, across = GPAB / LONG, GPAB / LATERAL
    by_place = [[0.0, 2 * across], [-2 * along * CONTACTS * CONICITY / RADIUS, 0.0]]
    by_rate = [[-2 * across / speed, 0.0], [0.0, -2 * along * CONTACTS**2 / speed]]
    return np.array(by_place), np.array(by_rate)


class Unit:
    """WheelSet.fmu on cones and crowned rails, under given wheel loads: height and roll of the axle follow."""

    def __init__(self, archive, **models):
        self.messages = []
        description = fmpy.read_model_description(archive)
        self.variables = {v.name: v for v in description.modelVariables}
        self.folder = fmpy.extract(archive)
        identifier = description.coSimulation.modelIdentifier
        self.slave = FMU2Slave(guid=description.guid, unzipDirectory=self.folder, modelIdentifier=identifier, instanceName="bogie")
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(lambda e, name, status, category, text: self.messages.append(text))
        addLoggerProxy(byref(self.callbacks))
        self.slave.instantiate(callbacks=self.callbacks)
        self.slave.setupExperiment(startTime=0.0)
        start = {"flange_back_distance": 2 * CONTACTS - 0.14, "track.gauge": 2 * CONTACTS - 0.07, "vertical.mode": "load", **models}
        for side in ("right", "left"):
            start |= {f"{side}.wheel.profile": f"conical:{CONICITY}", f"{side}.rail[1].profile": f"arc:{CROWN}"}
            start |= {f"{side}.wheel.nominal_radius": RADIUS, f"{side}.wheel.load": LOAD, f"{side}.rail[1].inclination": 0.0}
        self.set(start | {"wheelset.z": -RADIUS})
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def set(self, values):
        for name, value in values.items():
            variable = self.variables[name]
            reference = [variable.valueReference]
            if variable.type == "String":
                self.slave.setString(reference, [value])
            elif variable.type == "Real":
                self.slave.setReal(reference, [value])
            else:
                items = {item.name: int(item.value) for item in variable.declaredType.items}
                self.slave.setInteger(reference, [items[value]])

    def get(self, name):
        return self.slave.getReal([self.variables[name].valueReference])[0]

    def contact(self, speed):
        """As `published_contact`, by the exact derivatives of the unit."""
        self.set({"wheelset.vx": speed, "wheelset.pitch_rate": -speed / RADIUS})
        unknowns = [self.variables[name].valueReference for name in ("wheelset.force.y", "wheelset.moment.z")]

        def by(names):
            columns = [self.slave.getDirectionalDerivative(unknowns, [self.variables[name].valueReference], [1.0]) for name in names]
            return np.array(columns).T

        return by(["wheelset.y", "wheelset.yaw"]), by(["wheelset.vy", "wheelset.yaw_rate"])

    def close(self):
        self.slave.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)


def growth(contact, speed):
    """Greatest real part of the eigenvalues, and the frequency that goes with it [1/s, Hz]."""
    inertia, stiffness, damping = bogie()
    by_place, by_rate = contact(speed)
    for first in (0, 2):
        own = slice(first, first + 2)
        stiffness[own, own] -= by_place
        damping[own, own] -= by_rate
    inverse = np.linalg.inv(inertia)
    system = np.block([[np.zeros((7, 7)), np.eye(7)], [-inverse @ stiffness, -inverse @ damping]])
    values = np.linalg.eigvals(system)
    most = values[np.argmax(values.real)]
    return most.real, abs(most.imag) / (2 * np.pi)


def critical_speed(contact, low=20.0, high=150.0):
    """The speed [m/s] from which on a disturbance grows, and its frequency [Hz]."""
    for speed in np.arange(low, high, 2.0):
        if growth(contact, speed)[0] > 0:
            low, high = speed - 2.0, speed
            break
    while high - low > 1e-6:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if growth(contact, middle)[0] > 0 else (middle, high)
    return high, growth(contact, high)[1]


def main(archive):
    speed, frequency = critical_speed(published_contact)
    print(f"published                                  {PUBLISHED:8.2f} m/s")
    print(f"Vermeulen and Johnson, these equations     {speed:8.2f} m/s, {frequency:.2f} Hz")
    for title, models in (
        ("WheelSet.fmu: hertz + linear (Kalker)", {"normal.model": "hertz", "tangential.model": "linear", "creepage.model": "flat"}),
        ("WheelSet.fmu as it starts", {}),
    ):
        unit = Unit(archive, **models)
        speed, frequency = critical_speed(unit.contact)
        axes = [500 * unit.get(f"right.patch[1].{name}") for name in ("length", "width")]
        unit.close()
        print(f"{title:42} {speed:8.2f} m/s, {frequency:.2f} Hz; ellipse {axes[0]:.3f} x {axes[1]:.3f} mm")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "target/release/WheelSet.fmu")
