"""A whole vehicle in a curve: four WheelSet.fmu under two bogies and a car body, how fast that is, and what its results owe to the step.

Run: python vehicle.py [WheelSet.fmu] [figure.svg]   (needs fmpy and numpy, for a figure matplotlib)

Seven rigid bodies of six degrees of freedom on linear springs and dampers, each in the frame of the track at its own station; contact forces are those of the units. The
linearly implicit trapezoidal rule takes the exact derivatives of the units, renewed where a wheelset has moved: creep forces damp in milliseconds what a step of milliseconds need not follow.

Masses, wheel base and distance of bogies are those of vehicle 1 of the Manchester benchmarks (S. Iwnicki, Vehicle System Dynamics Supplement 31 (1998)), as is the longitudinal stiffness of its
primary suspension; all else is usual for such a coach and not taken from there.
"""

import os
import sys
import time

# Threads for matrices as small as these cost more than they save.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

from fmpy_unit import Port, Unit

GRAVITY, RADIUS = 9.81, 0.46
SPEED = 30.0
# Straight, transition, curve to the right; cant over the distance of the contacts [m, 1/m, rad].
STRAIGHT, TRANSITION, CURVATURE, CANT = 20.0, 60.0, 1 / 600, 0.12 / 1.5
DURATION = 6.0
# Half distances of bogies, axles, and springs across; heights of the centres over the rails and of the springs [m].
BOGIES, AXLES, ACROSS = 9.5, 1.28, 1.0
BODY_HEIGHT, FRAME_HEIGHT, SECONDARY_HEIGHT = 1.8, 0.6, 0.9
# Mass [kg] and moments of inertia about x, y and z [kg m2].
BODY = (32000.0, 57e3, 2.0e6, 2.0e6)
FRAME = (2615.0, 1.7e3, 1.5e3, 3.1e3)
WHEELSET = (1813.0, 1.1e3, 112.0, 1.1e3)
# Stiffness and damping along x, y and z of one axle box and one side of a bogie [N/m, N s/m]; of the roll bar and the traction rod of a bogie [N m/rad, N/m].
PRIMARY = ((31.391e6, 4e6, 1.2e6), (15e3, 2e3, 4e3))
SECONDARY = ((0.16e6, 0.16e6, 0.43e6), (1e3, 32e3, 20e3))
ROLL_BAR, ROD = 0.94e6, 5e6
# Way across the track after which the derivatives of the contact forces of a wheelset are renewed [m].
MOVED = 3e-4
# Time between two rows of results [s].
SAMPLED = 0.01
POSITIONS = ("x", "y", "z", "roll", "pitch", "yaw")
RATES = ("vx", "vy", "vz", "roll_rate", "pitch_rate", "yaw_rate")
FORCES = [f"wheelset.{kind}.{axis}" for kind in ("force", "moment") for axis in "xyz"]
WHEELSETS = range(3, 7)


class Track:
    """Heading, lateral place and cant of a track at a station, seen from a straight line, and their derivatives by the station; transitions are half waves of a sine."""

    def __init__(self):
        self.stations = np.arange(-60.0, STRAIGHT + SPEED * DURATION + 120.0, 0.01)
        share = np.clip((self.stations - STRAIGHT) / TRANSITION, 0.0, 1.0)
        ramp = 0.5 * (1 - np.cos(np.pi * share))
        slope = np.where((share > 0) & (share < 1), 0.5 * np.pi * np.sin(np.pi * share) / TRANSITION, 0.0)
        bend = np.where((share > 0) & (share < 1), 0.5 * np.pi**2 * np.cos(np.pi * share) / TRANSITION**2, 0.0)
        step = self.stations[1] - self.stations[0]
        along = lambda values: np.concatenate(([0.0], np.cumsum(0.5 * step * (values[1:] + values[:-1]))))
        heading = along(CURVATURE * ramp)
        # Each with its first and second derivative.
        self.lines = np.array(
            [
                [along(heading), heading, CURVATURE * ramp],
                [CANT * ramp, CANT * slope, CANT * bend],
                [heading, CURVATURE * ramp, CURVATURE * slope],
            ]
        )

    def at(self, stations):
        """Lateral place, cant, heading; of each value, first, second derivative at all stations."""
        place = (stations - self.stations[0]) / 0.01
        i = place.astype(int)
        before = self.lines[:, :, i]
        return before + (place - i) * (self.lines[:, :, i + 1] - before)


class Vehicle:
    """Matrices of inertia, stiffness and damping of body, frames and wheelsets, 0, 1 and 2, 3 to 6, six coordinates each."""

    def __init__(self):
        self.stations = np.array([0.0, BOGIES, -BOGIES, *(b + a for b in (BOGIES, -BOGIES) for a in (AXLES, -AXLES))])
        self.heights = np.array([BODY_HEIGHT, FRAME_HEIGHT, FRAME_HEIGHT, *(RADIUS for _ in WHEELSETS)])
        bodies = [BODY, FRAME, FRAME, *(WHEELSET for _ in WHEELSETS)]
        self.mass = np.concatenate([[m, m, m, *inertia] for m, *inertia in bodies])
        self.stiffness, self.damping = np.zeros((42, 42)), np.zeros((42, 42))
        for bogie, frame in ((0, 1), (1, 2)):
            for side in (-ACROSS, ACROSS):
                self.join(0, frame, (self.stations[frame], side, SECONDARY_HEIGHT), *SECONDARY)
                for wheelset in WHEELSETS[2 * bogie : 2 * bogie + 2]:
                    self.join(frame, wheelset, (self.stations[wheelset], side, RADIUS), *PRIMARY)
            self.join(0, frame, (self.stations[frame], 0.0, SECONDARY_HEIGHT), (ROD, 0.0, 0.0), (0.0, 0.0, 0.0))
            row = np.zeros(42)
            row[3], row[6 * frame + 3] = 1.0, -1.0
            self.stiffness += ROLL_BAR * np.outer(row, row)
        # What draws the body along at the speed of its station.
        self.stiffness[0, 0] += 1e6
        self.damping[0, 0] += 1e5
        for w in WHEELSETS:
            spin = WHEELSET[2] * -SPEED / RADIUS
            self.damping[6 * w + 3, 6 * w + 5] -= spin
            self.damping[6 * w + 5, 6 * w + 3] += spin
        self.weight = np.zeros(42)
        self.weight[2::6] = self.mass[2::6] * GRAVITY
        self.load = sum(m for m, *_ in bodies) * GRAVITY / 8

    def join(self, first, second, place, stiffness, damping):
        """A spring with a damper between two bodies at a place, x along, y to the right, height over the rails."""
        rows = np.zeros((3, 42))
        for body, sign in ((first, 1.0), (second, -1.0)):
            x, y, z = place[0] - self.stations[body], place[1], self.heights[body] - place[2]
            own = np.hstack([np.eye(3), [[0, z, -y], [-z, 0, x], [y, -x, 0]]])
            rows[:, 6 * body : 6 * body + 6] += sign * own
        self.stiffness += rows.T @ np.diag(stiffness) @ rows
        self.damping += rows.T @ np.diag(damping) @ rows

    def on(self, track, station):
        """Coordinates of the track frames of all bodies, seen from a straight line, with their first and second derivative by the station; and cant and its derivative, curvature and twist at each."""
        found = np.zeros((3, 7, 6))
        lateral, cant, heading = track.at(station + self.stations)
        found[:, :, 1] = lateral + self.heights * cant
        found[:, :, 3], found[:, :, 5] = cant, heading
        return found.reshape(3, 42), (cant[0], heading[1], cant[1])


class Run:
    """The vehicle on its units, from rest on straight track."""

    def __init__(self, archive, models):
        self.vehicle, self.track = Vehicle(), Track()
        start = {"wheelset.vx": SPEED, "wheelset.pitch_rate": -SPEED / RADIUS, **models}
        self.units = [Unit(archive, start) for _ in WHEELSETS]
        turns = ["track.curvature", "track.twist"]
        self.given = [Port(unit, [f"wheelset.{name}" for name in POSITIONS + RATES] + turns) for unit in self.units]
        self.found = [Port(unit, FORCES) for unit in self.units]
        self.height = self.units[0].get("nominal.wheelset_z")
        self.in_units = 0.0
        self.position, self.rate = np.zeros(42), np.zeros(42)
        self.by_position, self.by_rate = np.zeros((42, 42)), np.zeros((42, 42))
        self.station, self.renewed_at, self.renewed_for = 0.0, np.full(7, np.inf), None

    def put_inputs(self, bends):
        _, curvature, twist = bends
        motion = np.column_stack([self.position.reshape(7, 6), self.rate.reshape(7, 6), curvature, twist])
        motion[:, 2] += self.height
        motion[:, 4] = 0.0
        motion[:, 6] += SPEED
        motion[:, 10] -= SPEED / RADIUS
        for port, w in zip(self.given, WHEELSETS):
            port.set(motion[w])

    def renew(self, h):
        """Takes the derivatives of wheelsets anew that have moved on their rails."""
        stale = [w for w in WHEELSETS if abs(self.position[6 * w + 1] - self.renewed_at[w]) > MOVED]
        for w in stale:
            own = slice(6 * w, 6 * w + 6)
            for matrix, names in ((self.by_position, POSITIONS), (self.by_rate, RATES)):
                matrix[own, own] = self.units[w - 3].derivatives(FORCES, [f"wheelset.{name}" for name in names])
            self.renewed_at[w] = self.position[6 * w + 1]
        if stale or h != self.renewed_for:
            self.stiffness = self.vehicle.stiffness - self.by_position
            damping = self.vehicle.damping - self.by_rate
            self.inverse = np.linalg.inv(np.diag(self.vehicle.mass) + 0.5 * h * damping + 0.25 * h * h * self.stiffness)
            self.renewed_for = h

    def step(self, h):
        vehicle = self.vehicle
        line, bends = vehicle.on(self.track, self.station + 0.5 * h * SPEED)
        begin = time.process_time()
        self.put_inputs(bends)
        contact = np.zeros(42)
        for port, w in zip(self.found, WHEELSETS):
            contact[6 * w : 6 * w + 6] = port.get()
        self.renew(h)
        self.in_units += time.process_time() - begin
        force = contact + vehicle.weight - vehicle.mass * SPEED**2 * line[2]
        force -= vehicle.stiffness @ (self.position + line[0]) + vehicle.damping @ (self.rate + SPEED * line[1])
        # Weight across a canted track.
        force[1::6] += vehicle.mass[1::6] * GRAVITY * bends[0]
        change = h * (self.inverse @ (force - 0.5 * h * (self.stiffness @ self.rate)))
        self.position = self.position + h * (self.rate + 0.5 * change)
        self.rate = self.rate + change
        self.station += h * SPEED

    def close(self):
        for unit in self.units:
            unit.close()


def run(archive, h, models, duration=DURATION):
    """Times, lateral shifts, yaw angles and guiding forces of the wheelsets; seconds of one processor that a second of the vehicle takes, and the share of the units in it."""
    one = Run(archive, models)
    # It comes to rest on straight track, with wheels pressed on their rails as deep as they will be.
    one.position[2::6] = 1e-4
    for _ in range(round(1.0 / 1e-3)):
        one.step(1e-3)
        one.station = 0.0
    one.in_units = 0.0
    guiding = [Port(unit, [f"{side}.guiding_force" for side in ("right", "left")]) for unit in one.units]
    rows, begin = [], time.process_time()
    for k in range(round(duration / h) + 1):
        moved = [one.position[6 * w + i] for i in (1, 5) for w in WHEELSETS]
        one.step(h)
        if k % round(SAMPLED / h) == 0:
            # The units hold the inputs of the beginning of the step.
            rows.append([k * h, *moved, *np.concatenate([port.get() for port in guiding])])
    elapsed = time.process_time() - begin
    one.close()
    return np.array(rows), elapsed / duration, one.in_units / elapsed


MODELS = {
    "by default": {},
    "piotrowski_kik + fastsim": {"normal.model": "piotrowski_kik", "tangential.model": "fastsim", "creepage.model": "flat"},
}
STEPS = (5e-4, 1e-3, 2e-3, 2.5e-3, 1 / 300)


def means(columns):
    """Means over 2 m, as guiding forces are judged by (EN 14363)."""
    window = np.ones(round(2.0 / (SPEED * SAMPLED)))
    return np.array([np.convolve(column, window / len(window), "valid") for column in columns.T]).T


def differences(rows, finest):
    """Greatest differences of shifts, yaw angles and means of guiding forces from those of another run, over the greatest of these."""
    pairs = [(rows[:, part], finest[:, part]) for part in (slice(1, 5), slice(5, 9))]
    pairs.append((means(rows[:, 9:]), means(finest[:, 9:])))
    return [np.abs(found - wanted).max() / np.abs(wanted).max() for found, wanted in pairs]


def draw(rows, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (above, below) = plt.subplots(2, 1, figsize=(8, 6), sharex=True, layout="constrained")
    station = SPEED * rows[:, 0]
    for w, color in enumerate(("#0072b2", "#d55e00", "#009e73", "#cc79a7")):
        above.plot(station, 1e3 * rows[:, 1 + w], color=color, label=f"wheelset {w + 1}")
        below.plot(station, 1e-3 * rows[:, 10 + 2 * w], color=color)
        below.plot(station, 1e-3 * rows[:, 9 + 2 * w], color=color, linestyle="--")
    above.set(ylabel="lateral shift [mm]", title="A coach runs into a curve of 600 m at 30 m/s")
    below.set(xlabel="station [m]", ylabel="guiding force Y [kN]; dashed: right wheels")
    for axes in (above, below):
        axes.grid(color="#e0e0e0")
    above.legend()
    figure.savefig(path)


if __name__ == "__main__":
    archive = sys.argv[1] if len(sys.argv) > 1 else "target/release/WheelSet.fmu"
    for title, models in MODELS.items():
        results = {h: run(archive, h, models) for h in STEPS}
        finest = results[STEPS[0]][0]
        for h, (rows, factor, share) in results.items():
            off = ", ".join(f"{100 * value:.2f}" for value in differences(rows, finest))
            print(f"{title}, {1e3 * h:.1f} ms: {factor:.2f} s for a second, {100 * share:.0f} % of it in the units; shift, yaw and guiding force off by {off} %")
        shifts, forces = 1e3 * finest[-1, 1:5], 1e-3 * finest[-1, 9:17]
        print("  in the curve: shifts", np.round(shifts, 3), "mm; guiding forces, right and left,", np.round(forces, 2), "kN")
        if len(sys.argv) > 2 and not models:
            draw(finest, sys.argv[2])
