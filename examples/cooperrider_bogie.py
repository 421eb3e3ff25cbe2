"""Critical speed and limit cycle of Cooperrider's bogie: with the creep law it was published with, and on WheelSet.fmu.

Run: python cooperrider_bogie.py [WheelSet.fmu] [figure.svg]   (needs fmpy and numpy, for a figure matplotlib)

The bogie frame moves sideways, yaws and rolls, both wheelsets move sideways and yaw, between a car body that runs straight ahead: seven degrees of freedom. Its centred run loses
stability where a pair of eigenvalues crosses the imaginary axis (Hopf). Numbers and equations: N. K. Cooperrider, Journal of Engineering for Industry 94 (1972) 752, as Ch. Kaas-Petersen
gives them, Acta Mechanica 61 (1986) 89; the critical speed of 68.66 is that of the page "Railway bogie" of bifurcation.de, which calls it mph: with these numbers in SI units it is m/s.

Below that speed a large swing goes on where a small one dies out. It is followed down from a high speed, with flanges that are springs behind a dead band as in the publication, to the speed at
which it dies out.
"""

import sys

import numpy as np

from fmpy_unit import Port, Unit

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
# Friction limit of a wheel; stiffness of a flange behind its dead band: from memory of Kaas-Petersen, not checked.
LIMIT = 10e3
FLANGE, CLEARANCE = 14.60e6, 9.1e-3
# Step of a run, a thousandth of a millimetre off at 4 Hz; length of a run at one speed, and the part of it over which the swing is measured [s].
STEP, DURATION, MEASURED = 4e-3, 6.0, 0.5
# A swing that is smaller than this is dying out [m].
DEAD = 5e-3


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


def published_forces(speed):
    """Lateral force and yaw moment of a wheelset by its y, yaw and rates of both: Vermeulen and Johnson's law; both wheels slip alike."""

    def forces(y, yaw, vy, yaw_rate):
        along = CONTACTS * yaw_rate / speed + CONICITY * y / RADIUS
        across = vy / speed - yaw
        size = np.hypot(along / LONG, across / LATERAL)
        share = GPAB * size / LIMIT
        slope = GPAB * (1 - share / 3 + share**2 / 27) if share < 3 else LIMIT / size
        return -2 * slope * across / LATERAL, -2 * CONTACTS * slope * along / LONG

    return forces


def unit_of(archive, **models):
    """WheelSet.fmu on cones and crowned rails, under given wheel loads: height and roll of the axle follow."""
    start = {"flange_back_distance": 2 * CONTACTS - 0.14, "track.gauge": 2 * CONTACTS - 0.07, "vertical.mode": "load", "wheelset.z": -RADIUS, **models}
    for side in ("right", "left"):
        start |= {f"{side}.wheel.profile": f"conical:{CONICITY}", f"{side}.rail[1].profile": f"arc:{CROWN}"}
        start |= {f"{side}.wheel.nominal_radius": RADIUS, f"{side}.wheel.load": LOAD, f"{side}.rail[1].inclination": 0.0}
    return Unit(archive, start)


def contact_of(unit):
    """As `published_contact`, by the exact derivatives of the unit."""

    def contact(speed):
        unit.set({"wheelset.vx": speed, "wheelset.pitch_rate": -speed / RADIUS})
        forces = ["wheelset.force.y", "wheelset.moment.z"]
        return unit.derivatives(forces, ["wheelset.y", "wheelset.yaw"]), unit.derivatives(forces, ["wheelset.vy", "wheelset.yaw_rate"])

    return contact


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


def forces_of(unit):
    """As `published_forces`, by the unit."""

    def at(speed):
        port = Port(unit, ["wheelset.y", "wheelset.yaw", "wheelset.vy", "wheelset.yaw_rate", "wheelset.vx", "wheelset.pitch_rate"])
        found = Port(unit, ["wheelset.force.y", "wheelset.moment.z"])

        def forces(y, yaw, vy, yaw_rate):
            port.set([y, yaw, vy, yaw_rate, speed, -speed / RADIUS])
            return found.get()

        return forces

    return at


def swing(forces, state, duration=DURATION):
    """State after a run from `state`, places and rates, by the classical Runge-Kutta method, and how far the leading wheelset swings at its end [m]."""
    inertia, stiffness, damping = bogie()
    inertia = np.diag(inertia)

    def rates(state):
        place, rate = state[:7], state[7:]
        force = -stiffness @ place - damping @ rate
        for first in (0, 2):
            y, yaw = place[first : first + 2]
            lateral, moment = forces(y, yaw, *rate[first : first + 2])
            force[first] += lateral - FLANGE * np.sign(y) * max(abs(y) - CLEARANCE, 0.0)
            force[first + 1] += moment
        return np.concatenate([rate, force / inertia])

    most = 0.0
    for step in range(round(duration / STEP)):
        a = rates(state)
        b = rates(state + 0.5 * STEP * a)
        c = rates(state + 0.5 * STEP * b)
        d = rates(state + STEP * c)
        state = state + STEP / 6 * (a + 2 * b + 2 * c + d)
        if step * STEP > duration - MEASURED:
            most = max(most, abs(state[0]))
    return state, most


def branch(forces_at, critical):
    """Speeds and swings of the limit cycle from above the `critical` speed down to the last one at which it goes on."""
    state, found = np.zeros(14), []
    state[0] = 5e-3
    for speed in np.arange(np.ceil(critical) + 6.0, 0.0, -1.0):
        state, most = swing(forces_at(speed), state)
        if most < DEAD:
            break
        found.append((speed, most))
    return found


def draw(branches, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(8, 4.2), layout="constrained")
    for (title, critical, found), color in zip(branches, ("#000000", "#0072b2", "#d55e00")):
        speeds, swings = zip(*found)
        axes.plot(speeds, 1e3 * np.array(swings), "o-", color=color, markersize=4, label=title)
        axes.axvline(critical, color=color, linestyle=":")
    axes.axhline(1e3 * CLEARANCE, color="#a0a0a0", linewidth=1)
    axes.set(xlabel="speed [m/s]", ylabel="swing of the leading wheelset [mm]", title="Limit cycle of Cooperrider's bogie; dotted: its centred run loses stability")
    axes.grid(color="#e0e0e0")
    axes.legend()
    figure.savefig(path)


def main(archive, figure=None):
    speed, frequency = critical_speed(published_contact)
    print(f"published                                  {PUBLISHED:8.2f} m/s")
    print(f"Vermeulen and Johnson, these equations     {speed:8.2f} m/s, {frequency:.2f} Hz")
    branches = [("Vermeulen and Johnson", speed, branch(published_forces, speed))]
    for title, models in (
        ("WheelSet.fmu: hertz + linear (Kalker)", {"normal.model": "hertz", "tangential.model": "linear", "creepage.model": "flat"}),
        ("WheelSet.fmu by default", {}),
    ):
        unit = unit_of(archive, **models)
        speed, frequency = critical_speed(contact_of(unit))
        axes = [500 * unit.get(f"right.patch[1].{name}") for name in ("length", "width")]
        unit.close()
        print(f"{title:42} {speed:8.2f} m/s, {frequency:.2f} Hz; ellipse {axes[0]:.3f} x {axes[1]:.3f} mm")
    friction = LIMIT / LOAD
    for title, models in (
        ("hertz + fastsim", {"normal.model": "hertz", "tangential.model": "fastsim", "creepage.model": "flat"}),
        ("hertz + tables", {"normal.model": "hertz", "tangential.model": "tables", "creepage.model": "flat"}),
    ):
        unit = unit_of(archive, **models, **{f"{side}.friction.coefficient": friction for side in ("right", "left")})
        critical, _ = critical_speed(contact_of(unit))
        branches.append((f"WheelSet.fmu, {title}", critical, branch(forces_of(unit), critical)))
        unit.close()
    for title, critical, found in branches:
        print(f"{title}, friction limit {1e-3 * LIMIT:g} kN: centred run stable to {critical:.2f} m/s; swing of the leading wheelset [mm] by speed [m/s]:")
        print("  " + ", ".join(f"{speed:g}: {1e3 * most:.2f}" for speed, most in found))
    if figure:
        draw(branches, figure)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "target/release/WheelSet.fmu", *sys.argv[2:3])
