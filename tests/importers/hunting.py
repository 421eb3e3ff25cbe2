"""A wheelset in exudyn on two instances of the FMU, hunting: from which speed on does it not die out?

`wheelrail simulate` integrates the same model on the same unit; both run at growing speed behind a small
lateral ramp of the track. Argument: the file for a table of growth rates and differences. WHEELRAIL_FMU
names the archive, WHEELRAIL the program.

In exudyn the wheelset is a free rigid body, its axle boxes hang on spring-dampers of exudyn, and the force
of the two wheels comes from a connector with a user function. exudyn's integrator (Runge-Kutta, explicit)
asks for it four times a step, which the unit, being without memory, answers in model exchange.
"""

import csv
import os
import shutil
import subprocess
import sys
import tempfile
from ctypes import c_double, c_uint32
from math import cos, pi

import exudyn as exu
import fmpy
import numpy as np
from exudyn.itemInterface import (
    CartesianSpringDamper, LoadForceVector, MarkerBodyRigid, ObjectGround, RigidBodySpringDamper, SensorNode,
)  # fmt: skip
from exudyn.rigidBodyUtilities import RigidBodyInertia
from fmpy.fmi2 import FMU2Model

ARCHIVE, PROGRAM = os.environ["WHEELRAIL_FMU"], os.environ["WHEELRAIL"]

# The wheelset, SI units; springs and dampers are those of one axle box along x, y and z.
MASS, INERTIA, AXLE_INERTIA, HALF_MARKER_DISTANCE = 1500.0, 900.0, 100.0, 0.75
LOAD_ON_RAILS, HALF_BOX_DISTANCE = 100e3, 1.0
STIFFNESS, DAMPING = np.array([1e6, 5e5, 1e6]), np.array([0.0, 0.0, 2e4])
# Cones on a real rail head: one contact at each wheel, so that small amplitudes have one frequency.
PROFILE = "conical:0.1"
RAMP, RAMP_START, RAMP_LENGTH = 1e-3, 1.0, 5.0

SPEEDS = (60.0, 70.0, 80.0)
# Steps: Runge-Kutta of fourth order in exudyn, semi-implicit Euler, of first order, in the program.
DURATION, STEP, PROGRAM_STEP = 1.2, 4e-4, 2e-5
RECORD = 2e-3
INPUTS = ("y", "z", "roll", "yaw", "vx", "vy", "vz", "roll_rate", "yaw_rate", "pitch_rate")
OUTPUTS = ("force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z")


def track(distance):
    """Lateral position of the track's centre line."""
    share = min(max((distance - RAMP_START) / RAMP_LENGTH, 0.0), 1.0)
    return RAMP * 0.5 * (1.0 - cos(pi * share))


class Wheel:
    """One wheel on its rail: an instance for model exchange, asked at every stage of the integrator."""

    def __init__(self, description, folder, sign):
        self.sign = sign
        self.model = FMU2Model(
            guid=description.guid, unzipDirectory=folder, instanceName=f"wheel {sign:+.0f}",
            modelIdentifier=description.modelExchange.modelIdentifier,
        )  # fmt: skip
        variables = {v.name: v.valueReference for v in description.modelVariables}
        self.model.instantiate()
        self.model.setupExperiment(startTime=0.0)
        self.model.setInteger([variables["side"]], [1 if sign > 0 else 2])
        self.model.setString([variables["wheel.profile"]], [PROFILE])
        self.model.setReal([variables["wheel.y"]], [sign * HALF_MARKER_DISTANCE])
        self.model.enterInitializationMode()
        self.model.exitInitializationMode()
        self.model.enterContinuousTimeMode()
        names = [f"wheel.{name}" for name in INPUTS] + ["rail[1].y"]
        self.inputs = (c_uint32 * len(names))(*(variables[name] for name in names))
        self.outputs = (c_uint32 * 6)(*(variables[f"wheel.{name}"] for name in OUTPUTS))
        self.values, self.wrench = (c_double * len(names))(), (c_double * 6)()

    def force(self, motion, rail_y):
        """Force on the wheel and moment about its marker."""
        self.values[:] = (*motion, rail_y)
        self.model.fmi2SetReal(self.model.component, self.inputs, len(self.inputs), self.values)
        self.model.fmi2GetReal(self.model.component, self.outputs, 6, self.wrench)
        wrench = np.array(self.wrench)
        return wrench[:3], wrench[3:]

    def close(self):
        self.model.terminate()
        self.model.freeInstance()


def wheelset_force(wheels, position, velocity, turning, axle, speed, time):
    """Force of both wheels on the wheelset and moment about its centre, in the track frame."""
    # R = R_x(roll) R_z(yaw) R_y(pitch): the axle is (-sin yaw, cos roll cos yaw, sin roll cos yaw).
    yaw, roll = np.arcsin(-axle[0]), np.arctan2(axle[2], axle[1])
    yaw_axis = np.array([0.0, -np.sin(roll), np.cos(roll)])
    rates = np.linalg.solve(np.column_stack([[1.0, 0.0, 0.0], yaw_axis, axle]), turning)
    force, moment = np.zeros(3), np.zeros(3)
    for wheel in wheels:
        arm = wheel.sign * HALF_MARKER_DISTANCE * axle
        place, moving = position + arm, velocity + np.cross(turning, arm)
        motion = (place[1], place[2], roll, yaw, speed + moving[0], moving[1], moving[2], *rates)
        one, about_marker = wheel.force(motion, track(speed * time))
        force += one
        moment += about_marker + np.cross(arm, one)
    return force, moment


def in_exudyn(wheels, speed, start):
    """Times and y against the track; exudyn's frame runs along the track at `speed`, z down as ours."""
    system = exu.SystemContainer()
    mbs = system.AddSystem()
    ground = mbs.AddObject(ObjectGround())
    body = mbs.CreateRigidBody(
        inertia=RigidBodyInertia(MASS, np.diag([INERTIA, AXLE_INERTIA, INERTIA])),
        nodeType=exu.NodeType.RotationRotationVector,
        referencePosition=[0.0, 0.0, start["z"]],
        initialAngularVelocity=[0.0, start["pitch_rate"], 0.0],
    )
    node = mbs.GetObject(body)["nodeNumber"]
    kind = exu.OutputVariableType

    def contact(mbs, time, item, displacement, rotation, velocity, turning, *parameters):
        axle = mbs.GetNodeOutput(node, kind.RotationMatrix).reshape(3, 3)[:, 1]
        position = np.array(displacement) + [0.0, 0.0, start["z"]]
        force, moment = wheelset_force(
            wheels, position, np.array(velocity), np.array(turning), axle, speed, time
        )
        # The speed along the track is held. The connector pulls its second marker by minus its force.
        return np.concatenate([[0.0], -force[1:], -moment])

    def spring(mbs, time, item, displacement, velocity, *parameters):
        from_rest = np.array(displacement) - [0.0, track(speed * time), 0.0]
        return STIFFNESS * from_rest + DAMPING * np.array(velocity)

    # Unit vectors of the connectors are those of the ground.
    centre = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[0.0, 0.0, start["z"]]))
    middle = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))
    mbs.AddObject(
        RigidBodySpringDamper(
            markerNumbers=[centre, middle], stiffness=np.zeros((6, 6)), damping=np.zeros((6, 6)),
            springForceTorqueUserFunction=contact,
        )
    )  # fmt: skip
    for side in (1.0, -1.0):
        frame = MarkerBodyRigid(bodyNumber=ground, localPosition=[0.0, side * HALF_BOX_DISTANCE, start["z"]])
        box = MarkerBodyRigid(bodyNumber=body, localPosition=[0.0, side * HALF_BOX_DISTANCE, 0.0])
        markers = [mbs.AddMarker(frame), mbs.AddMarker(box)]
        mbs.AddObject(CartesianSpringDamper(markerNumbers=markers, springForceUserFunction=spring))
    mbs.AddLoad(LoadForceVector(markerNumber=middle, loadVector=[0.0, 0.0, LOAD_ON_RAILS]))
    sensor = mbs.AddSensor(
        SensorNode(nodeNumber=node, outputVariableType=kind.Position, storeInternal=True)
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(DURATION / STEP)
    settings.timeIntegration.endTime = DURATION
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = RECORD
    assert mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    rows = mbs.GetSensorStoredData(sensor)
    return rows[:, 0], rows[:, 2] - [track(speed * time) for time in rows[:, 0]]


def in_rust(speed, folder):
    """Times and y against the track of `wheelrail simulate`, and the state it starts from."""
    options = {
        "fmu": ARCHIVE, "output": folder, "wheel-profile": PROFILE, "speed": speed,
        "length": speed * DURATION, "ramp": RAMP, "ramp-start": RAMP_START,
        "ramp-length": RAMP_LENGTH, "ramp-shape": "cosine", "step": PROGRAM_STEP,
        "record-every": speed * RECORD, "mass": MASS, "inertia": INERTIA, "axle-inertia": AXLE_INERTIA,
        "axle-load": LOAD_ON_RAILS, "running-circles": 2 * HALF_MARKER_DISTANCE,
        "axle-boxes": 2 * HALF_BOX_DISTANCE, "stiffness": ",".join(map(str, STIFFNESS)),
        "damping": ",".join(map(str, DAMPING)),
    }  # fmt: skip
    arguments = [f"--{name}={value}" for name, value in options.items()]
    subprocess.run([PROGRAM, "simulate", *arguments], check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    time = np.array([float(row["time_s"]) for row in rows])
    y = np.array([1e-3 * (float(row["y_mm"]) - float(row["track_y_mm"])) for row in rows])
    first = rows[0]
    return time, y, {"z": 1e-3 * float(first["z_mm"]), "pitch_rate": float(first["pitch_rate_rad_s"])}


def growth(time, y):
    """Growth rate [1/s] and frequency [Hz] of the oscillation behind the ramp, from its extremes."""
    free = time > (RAMP_START + RAMP_LENGTH) / SPEEDS[0] + 0.2
    time, y = time[free], y[free]
    extremes = [i for i in range(1, len(y) - 1) if (y[i] - y[i - 1]) * (y[i + 1] - y[i]) <= 0.0]
    assert len(extremes) > 5, "too few waves to tell how they grow"
    rate = np.polyfit(time[extremes], np.log(np.abs(y[extremes])), 1)[0]
    return rate, 0.5 * (len(extremes) - 1) / (time[extremes[-1]] - time[extremes[0]])


def compare(description, folder, speed):
    """One row of the table."""
    with tempfile.TemporaryDirectory() as output:
        time, y, start = in_rust(speed, output)
    wheels = [Wheel(description, folder, sign) for sign in (1.0, -1.0)]
    own_time, own_y = in_exudyn(wheels, speed, start)
    for wheel in wheels:
        wheel.close()
    both = own_time <= time[-1]
    difference = np.abs(np.interp(own_time, time, y) - own_y)[both].max() / np.abs(y).max()
    (own_rate, own_frequency), (rate, frequency) = growth(own_time, own_y), growth(time, y)
    return speed, own_rate, rate, own_frequency, frequency, difference, 1e3 * np.abs(y).max()


def main():
    description = fmpy.read_model_description(ARCHIVE)
    folder = fmpy.extract(ARCHIVE)
    columns = (
        "speed_m_s", "growth_exudyn_1_s", "growth_rust_1_s", "frequency_exudyn_hz", "frequency_rust_hz",
        "difference_of_y", "largest_y_mm",
    )  # fmt: skip
    with open(sys.argv[1], "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        for speed in SPEEDS:
            row = compare(description, folder, speed)
            writer.writerow(repr(float(value)) for value in row)
            print(", ".join(f"{name} {value:.5g}" for name, value in zip(columns, row)), flush=True)
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
