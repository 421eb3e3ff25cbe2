"""A wheel with mass over time on the packed FMU: the contact never gives back more energy than it took, whatever the integrator.

WHEELRAIL_FMU names the archive; a table goes to WHEELRAIL_REPORT, if that is set. The wheel moves along x, y and z and turns about its axle;
gravity, contact and, where it says so, a brake act on it. Every run starts above the rail with nothing stored in the contact, so that the
work of the contact on the wheel is never positive.
"""

import csv
import os
import unittest
from ctypes import POINTER, c_double, cast

import numpy as np
from fmpy.sundials import CVodeSolver

from unit import Unit

ARCHIVE = os.environ["WHEELRAIL_FMU"]
REPORT = os.environ.get("WHEELRAIL_REPORT")

MASS = 700.0  # kg, half of a wheelset with its share of an axle box
INERTIA = 60.0  # kg m2 about the axle
GRAVITY = 9.81  # m/s2
LOAD = 5e4  # N, weight of the vehicle on the wheel
RADIUS = 0.46  # m

# Below it creep forces are those of a damper. With its start value of 1 mm/s a standing wheel is held by one that settles in 10 ns and saturates
# at 3 um/s: less than what integrators leave of a velocity, so that they chatter.
MINIMUM_SPEED = 0.1  # m/s

# Lateral shift and height above first touch [m], velocity [m/s] with which the wheel rolls, brake moment [N m], duration [s].
SCENES = {
    "dropped": (-3e-3, 1e-4, (0.0, 0.0, 0.0), 0.0, 0.1),
    "rolled": (1e-3, 2e-5, (20.0, 0.02, 0.0), 0.0, 0.1),
    "braked to lock": (-2e-3, 2e-5, (10.0, 0.0, 0.0), 2e4, 0.2),
    "flange impact": (2e-3, 2e-5, (20.0, 0.3, 0.0), 0.0, 0.05),
}
HERTZ, PIOTROWSKI_KIK, CORRECTED, STRIPS = 1, 2, 3, 4
FASTSIM, FASTRIP, TABLES, FASTSIM_CORRECTED = 3, 4, 5, 6
# Normal and tangential model; all that are fast enough for real time and bounded by friction.
MODELS = {
    "hertz": (HERTZ, FASTSIM),
    "piotrowski_kik": (PIOTROWSKI_KIK, FASTSIM),
    "piotrowski_kik_corrected": (CORRECTED, FASTSIM),
    "strips": (STRIPS, FASTSIM),
    "piotrowski_kik + fastrip": (PIOTROWSKI_KIK, FASTRIP),
    "piotrowski_kik + tables": (PIOTROWSKI_KIK, TABLES),
    "piotrowski_kik + fastsim_corrected": (PIOTROWSKI_KIK, FASTSIM_CORRECTED),
    "strips + tables": (STRIPS, TABLES),
}
# Those that are run with fixed steps too: ten times as many evaluations.
FIXED_STEPS = ["hertz", "piotrowski_kik"]

INPUTS = ["wheel.y", "wheel.z", "wheel.vx", "wheel.vy", "wheel.vz", "wheel.pitch_rate"]
OUTPUTS = ["wheel.force.x", "wheel.force.y", "wheel.force.z", "wheel.moment.y"]

# Share of the work taken by the contact that integrators may be off: relative tolerance 1e-6, fixed steps of 20 us.
GAIN = 2e-5


class Wheel:
    """States: y, z, velocity, pitch rate, work of the contact so far."""

    def __init__(self, scene, model, damping):
        shift, height, velocity, self.brake, self.duration = SCENES[scene]
        self.unit = Unit(
            ARCHIVE,
            {
                "normal.model": MODELS[model][0],
                "tangential.model": MODELS[model][1],
                "normal.damping": damping,
                "normal.strips": 11,
                "wheel.y": 0.75 + shift,
                "creepage.minimum_speed": MINIMUM_SPEED,
            },
        )
        touching = self.unit.get("nominal.wheel_z")
        self.unit.ready()
        reference = lambda name: self.unit.variables[name].valueReference
        self.inputs = [reference(name) for name in INPUTS]
        self.outputs = [reference(name) for name in OUTPUTS]
        self.evaluations = 0
        vx, vy, vz = velocity
        self.state = np.array([0.75 + shift, touching - height, vx, vy, vz, -vx / RADIUS, 0.0])

    def change(self, state):
        y, z, vx, vy, vz, rate, _ = state
        self.unit.slave.setReal(self.inputs, list(state[:6]))
        fx, fy, fz, moment = self.unit.slave.getReal(self.outputs)
        self.evaluations += 1
        # A brake holds a wheel that stands; below a hundredth of a turn a second it lets go smoothly.
        brake = -self.brake * np.tanh(rate / 0.06)
        power = fx * vx + fy * vy + fz * vz + moment * rate
        return np.array(
            [vy, vz, fx / MASS, fy / MASS, (fz + LOAD) / MASS + GRAVITY, (moment + brake) / INERTIA, power]
        )

    def gain(self, works):
        """Greatest work of the contact on the wheel, share of what it has taken."""
        return max(works) / max(-min(works), 1e-9)

    def runge_kutta(self, step):
        works = []
        y = self.state.copy()
        for _ in range(round(self.duration / step)):
            a = self.change(y)
            b = self.change(y + 0.5 * step * a)
            c = self.change(y + 0.5 * step * b)
            d = self.change(y + step * c)
            y = y + step / 6.0 * (a + 2.0 * b + 2.0 * c + d)
            works.append(y[6])
        self.state = y
        return self.gain(works)

    def cvode(self):
        count = len(self.state)
        view = lambda pointer: np.ctypeslib.as_array(cast(pointer, POINTER(c_double)), (count,))
        held = self.state.copy()

        def get_x(pointer, _):
            view(pointer)[:] = held

        def set_x(pointer, _):
            held[:] = view(pointer)

        def get_dx(pointer, _):
            view(pointer)[:] = self.change(held)

        def nominals(pointer, _):
            view(pointer)[:] = [1e-4, 1e-4, 1.0, 1e-2, 1e-2, 1.0, 10.0]

        solver = CVodeSolver(
            nx=count, nz=0, get_x=get_x, set_x=set_x, get_dx=get_dx, get_z=lambda *_: None, get_nominals=nominals,
            set_time=lambda _: None, input=None, startTime=0.0, relativeTolerance=1e-6, maxNumSteps=200_000,
        )  # fmt: skip
        works, time = [], 0.0
        while time < self.duration - 1e-9:
            _, _, time = solver.step(time, min(time + 1e-3, self.duration))
            works.append(held[6])
        self.state = held.copy()
        return self.gain(works)


class Energy(unittest.TestCase):
    rows = []

    @classmethod
    def tearDownClass(cls):
        header = ["scene", "model", "damping", "integrator", "evaluations", "gain", "speed", "pitch_rate"]
        if REPORT:
            with open(REPORT, "w", newline="") as file:
                csv.writer(file).writerows([header, *cls.rows])

    def run_one(self, scene, model, damping, integrator):
        wheel = Wheel(scene, model, damping)
        self.addCleanup(wheel.unit.close)
        gain = wheel.cvode() if integrator == "cvode" else wheel.runge_kutta(2e-5)
        y, z, vx, vy, vz, rate, work = wheel.state
        self.rows.append([scene, model, damping, integrator, wheel.evaluations, f"{gain:.1e}", f"{vx:.3f}", f"{rate:.3f}"])
        self.assertTrue(np.isfinite(wheel.state).all(), wheel.state)
        self.assertLess(gain, GAIN, self.rows[-1])
        return wheel

    def test_the_contact_gives_back_no_more_than_it_took(self):
        for scene in SCENES:
            for model in MODELS:
                for integrator in ["cvode", "fixed steps"] if model in FIXED_STEPS else ["cvode"]:
                    with self.subTest(scene=scene, model=model, integrator=integrator):
                        self.run_one(scene, model, 1e5, integrator)

    def test_without_damping_a_dropped_wheel_is_given_back_its_height_and_no_more(self):
        for model in MODELS:
            with self.subTest(model=model):
                self.run_one("dropped", model, 0.0, "cvode")

    def test_a_brake_stops_the_wheel_and_the_rail_slows_the_rest(self):
        wheel = self.run_one("braked to lock", "piotrowski_kik", 1e5, "cvode")
        _, _, vx, _, _, rate, _ = wheel.state
        self.assertLess(abs(rate), 0.5)
        slowing = 0.3 * (LOAD + MASS * GRAVITY) / MASS
        self.assertAlmostEqual(vx, 10.0 - slowing * wheel.duration, delta=0.35 * slowing * wheel.duration)


if __name__ == "__main__":
    unittest.main()
