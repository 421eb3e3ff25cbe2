"""Inputs and parameters as keywords, outputs as attributes. Made by make_keywords.py: do not change it by hand."""

from __future__ import annotations

import os
from typing import Any, Literal, TypedDict

import numpy.typing as npt

from ._result import Result

__all__ = [
    "ElementInputs",
    "ElementParameters",
    "ElementResult",
    "WheelSetInputs",
    "WheelSetParameters",
    "WheelSetResult",
]


class ElementInputs(TypedDict, total=False):
    """Inputs of `wheelrail.Element.evaluate`, arrays that broadcast."""

    x: npt.ArrayLike
    """Longitudinal position of the wheel marker in the track frame [m]."""
    y: npt.ArrayLike
    """Lateral position of the wheel marker in the track frame, from the track centre line; the start value is that of a right wheel: set it (negative) when side is left [m]."""
    z: npt.ArrayLike
    """Vertical position of the wheel marker, down from the plane of the rail tops, so about minus the nominal radius; nominal.wheel_z is where the wheel just touches [m]."""
    roll: npt.ArrayLike
    """Roll angle of the axle, about x [rad]."""
    yaw: npt.ArrayLike
    """Yaw angle of the axle, about the rolled z axis [rad]."""
    pitch: npt.ArrayLike
    """Pitch angle of the wheel, about the axle [rad]."""
    vx: npt.ArrayLike
    """Longitudinal velocity of the wheel marker [m/s]."""
    vy: npt.ArrayLike
    """Lateral velocity of the wheel marker [m/s]."""
    vz: npt.ArrayLike
    """Vertical velocity of the wheel marker, down [m/s]."""
    roll_rate: npt.ArrayLike
    """Rate of the roll angle [rad/s]."""
    yaw_rate: npt.ArrayLike
    """Rate of the yaw angle [rad/s]."""
    pitch_rate: npt.ArrayLike
    """Rate of the pitch angle, negative when the wheel rolls forward [rad/s]."""
    load: npt.ArrayLike
    """Vertical force, down, that the wheel puts on all rails together, creep forces included; only with vertical.mode load; at 0 and below the wheel is lifted [N]."""
    rail1_y: npt.ArrayLike
    """Lateral deviation of rail 1 from its design position [m]."""
    rail1_z: npt.ArrayLike
    """Vertical deviation of rail 1 from its design position, down [m]."""
    rail1_roll: npt.ArrayLike
    """Roll angle of rail 1 about its marker, beyond its inclination [rad]."""
    rail1_vy: npt.ArrayLike
    """Lateral velocity of the marker of rail 1 [m/s]."""
    rail1_vz: npt.ArrayLike
    """Vertical velocity of the marker of rail 1, down [m/s]."""
    rail1_roll_rate: npt.ArrayLike
    """Rate of the roll angle of rail 1 [rad/s]."""
    rail1_pitch_rate: npt.ArrayLike
    """Angular velocity of roller 1 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    rail2_y: npt.ArrayLike
    """Lateral deviation of rail 2 from its design position [m]."""
    rail2_z: npt.ArrayLike
    """Vertical deviation of rail 2 from its design position, down [m]."""
    rail2_roll: npt.ArrayLike
    """Roll angle of rail 2 about its marker, beyond its inclination [rad]."""
    rail2_vy: npt.ArrayLike
    """Lateral velocity of the marker of rail 2 [m/s]."""
    rail2_vz: npt.ArrayLike
    """Vertical velocity of the marker of rail 2, down [m/s]."""
    rail2_roll_rate: npt.ArrayLike
    """Rate of the roll angle of rail 2 [rad/s]."""
    rail2_pitch_rate: npt.ArrayLike
    """Angular velocity of roller 2 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    track_s: npt.ArrayLike
    """Station along the track of the origin of the track frame: a patch at position x in the track frame is at track.s + x; of a roller the arc that is on top, growing by its radius times pitch_rate [m]."""
    friction: npt.ArrayLike
    """Coefficient of friction between wheel and rail; only with friction.distribution uniform [-]."""
    friction_tread_coefficient: npt.ArrayLike
    """Coefficient of friction on the tread of the rails; only with friction.distribution regions [-]."""
    friction_gauge_face_coefficient: npt.ArrayLike
    """Coefficient of friction on the gauge faces of the rails; only with friction.distribution regions [-]."""


class ElementParameters(TypedDict, total=False):
    """Parameters and starting inputs of `wheelrail.Element`."""

    side: Literal["right", "left"]
    """Side of the track on which the wheel runs; with left, set the start of wheel.y too (negative)."""
    wheel_profile: str | os.PathLike[str]
    """Wheel profile: a built-in name or a file; a relative file name is looked for in resources/profiles, then in the working directory; slices (.slcw) or a table of sections where it varies around."""
    wheel_nominal_radius: float
    """Radius of the nominal rolling circle [m]."""
    wheel_young_modulus: float
    """Young's modulus of the wheel [Pa]."""
    wheel_poisson_ratio: float
    """Poisson's ratio of the wheel [-]."""
    rail1_profile: str | os.PathLike[str]
    """Profile of rail 1: a built-in name or a file, found like wheel.profile; slices (.slcs) or a table of sections where it varies along the track."""
    rail2_profile: str | os.PathLike[str]
    """Profile of rail 2: a built-in name or a file, found like wheel.profile; slices (.slcs) or a table of sections where it varies along the track."""
    rail1_enabled: bool
    """Whether rail 1 takes part."""
    rail2_enabled: bool
    """Whether there is a second rail: a check rail, a switch tongue."""
    rail2_mirrored: bool
    """Whether the inclined profile of rail 2 is turned left to right, as that of a check rail, which faces the flange back."""
    rail1_placement: Literal["gauge", "position", "origin"]
    """What says where rail 1 stands: the gauge or rail[1].position."""
    rail2_placement: Literal["gauge", "position", "origin"]
    """What says where rail 2 stands: rail[2].position or the gauge."""
    rail1_position_y: float
    """Lateral position in the track frame of the marker or the origin of rail 1 in design position; without effect with placement gauge; the start value is that of a right wheel: set it (negative) when side is left [m]."""
    rail1_position_z: float
    """Vertical position in the track frame of that point of rail 1 in design position, down [m]."""
    rail2_position_y: float
    """Lateral position in the track frame of the marker (placement position), the highest point of its head, or the origin of rail 2 in design position; the start value is that of a check rail of a right wheel with a flangeway of 41 mm: set it (negative) when side is left [m]."""
    rail2_position_z: float
    """Vertical position in the track frame of that point of rail 2 in design position, down [m]."""
    rail1_inclination: float
    """Inclination of rail 1 towards the track centre as a tangent: 1:40 is 0.025 [-]."""
    rail1_roller_radius: float
    """Radius of roller 1 at its highest point, 0.1 m at least; its axle is across the track at x = 0 of the track frame, wherever track.s is; 0 for a straight rail [m]."""
    rail2_inclination: float
    """Inclination of rail 2 towards the track centre as a tangent: 1:40 is 0.025 [-]."""
    rail2_roller_radius: float
    """Radius of roller 2 at its highest point, 0.1 m at least; its axle is across the track at x = 0 of the track frame, wherever track.s is; 0 for a straight rail [m]."""
    rail1_corrugation_amplitude: float
    """Half the height from trough to crest of a wave of rail 1 along the station; 0 for none [m]."""
    rail1_corrugation_wavelength: float
    """Wavelength of that wave; a whole number of them has to go around a roller [m]."""
    rail1_corrugation_phase: float
    """Phase of that wave at station 0: with 0 there is a crest [rad]."""
    rail2_corrugation_amplitude: float
    """Half the height from trough to crest of a wave of rail 2 along the station; 0 for none [m]."""
    rail2_corrugation_wavelength: float
    """Wavelength of that wave; a whole number of them has to go around a roller [m]."""
    rail2_corrugation_phase: float
    """Phase of that wave at station 0: with 0 there is a crest [rad]."""
    rail1_corrugation_file: str | os.PathLike[str]
    """File with heights of rail 1 along the station, columns station_m and height_mm (up positive), found like wheel.profile, on top of the wave; empty for none."""
    rail2_corrugation_file: str | os.PathLike[str]
    """File with heights of rail 2 along the station, columns station_m and height_mm (up positive), found like wheel.profile, on top of the wave; empty for none."""
    wheel_out_of_round_amplitude: float
    """Half the difference from least to greatest radius of a wave around the wheel; 0 for none [m]."""
    wheel_out_of_round_phase: float
    """Phase of that wave at the point that is lowest at pitch 0: with 0 the radius is greatest there [rad]."""
    wheel_flat_length: float
    """Length of a flat of the wheel along the nominal rolling circle; 0 for none [m]."""
    wheel_flat_angle: float
    """Angle by which the wheel has to roll forward from pitch 0 until it stands on the middle of the flat [rad]."""
    wheel_flat_depth: float
    """Greatest depth of a worn flat; 0 for length squared over 16 radii; a fresh one is as deep as its chord [m]."""
    wheel_out_of_round_order: int
    """Number of waves around the wheel."""
    wheel_out_of_round_file: str | os.PathLike[str]
    """File with deviations of the radius around the wheel, columns angle_deg and radius_mm, found like wheel.profile, on top of the wave; empty for none."""
    wheel_flat_shape: Literal["fresh", "worn"]
    """Shape of the flat."""
    rail_young_modulus: float
    """Young's modulus of the rails [Pa]."""
    rail_poisson_ratio: float
    """Poisson's ratio of the rails [-]."""
    track_gauge: float
    """Track gauge: distance of the gauge faces at the gauge depth [m]."""
    track_gauge_depth: float
    """Depth below the rail top at which the gauge is measured [m]."""
    profile_smoothing: float
    """Wavelength at which the smoothing of profiles from files halves an amplitude; 0 interpolates; a negative number (-1) leaves it to the noise found in the points of each file [m]."""
    vertical_mode: Literal["penetration", "load"]
    """What is given of the vertical motion of the wheel; with load, wheel.z has no effect and there is no normal damping."""
    motion: Literal["given", "rolling"]
    """What turns the wheel; with rolling, pitch_rate has no effect and the wheel rolls freely on its nominal radius."""
    track_foundation_model: Literal["rigid", "massless", "mass"]
    """What all rails under a wheel rest on, each side by itself; mass goes with the steps of co-simulation and with vertical.mode penetration."""
    track_foundation_stiffness_y: float
    """Lateral stiffness of the rails of a side against the ground; only with track.foundation.model massless and mass, as all of track.foundation [N/m]."""
    track_foundation_stiffness_z: float
    """Vertical stiffness of the rails of a side against the ground [N/m]."""
    track_foundation_damping_y: float
    """Lateral damping of the rails of a side against the ground; only with mass [N.s/m]."""
    track_foundation_damping_z: float
    """Vertical damping of the rails of a side against the ground; only with mass [N.s/m]."""
    track_foundation_mass: float
    """Mass that moves with the rails of a side; only with mass [kg]."""
    track_foundation_longest_step: float
    """Longest step in which rails with a mass are moved on: fmi2DoStep makes as many equal ones as it takes, at most 1000 [s]."""
    normal_model: Literal["hertz", "piotrowski_kik", "piotrowski_kik_corrected", "strips", "boundary_element"]
    """Normal contact model."""
    normal_shape_fit: Literal["hertz", "paper"]
    """Ratio of length to width that the area of piotrowski_kik_corrected gets; other models do not use it."""
    normal_virtual_penetration: float
    """Virtual over true penetration [-]."""
    normal_damping: float
    """Normal contact damping at the reference stiffness [N.s/m]."""
    normal_strips: int
    """Strips: for the model strips over all zones of a rail, at least 8; for the others across each zone, one more where it is odd."""
    normal_elements_along: int
    """Boundary elements along the extent of a contact; other models do not use it."""
    normal_elements_across: int
    """Boundary elements across the extent of a contact; other models do not use it."""
    creepage_model: Literal["kinematic", "flat", "curved"]
    """How creepage varies over a patch."""
    creepage_minimum_speed: float
    """Floor of the speed to which creepages refer [m/s]."""
    tangential_model: Literal["none", "linear", "fastsim", "fastrip", "tables", "fastsim_corrected", "boundary_element", "marches"]
    """Tangential contact model."""
    tangential_history: Literal["steady", "transient"]
    """Whether tractions are those of steady rolling, or follow from those of the steps before."""
    tangential_elements_along: int
    """Elements along each strip of fastsim, fastsim_corrected and fastrip; other models do not use it."""
    tangential_bound: Literal["elliptic", "parabolic"]
    """Shape of the traction bound along a strip of fastsim and fastsim_corrected; other models have their own."""
    tangential_flexibilities: Literal["three", "blended"]
    """How the flexibilities of the simplified theory enter in fastsim, fastsim_corrected and fastrip; other models do not use them."""
    friction_distribution: Literal["uniform", "regions", "profile"]
    """How friction is spread over the surface of the rails."""
    friction_profile: str | os.PathLike[str]
    """File with friction over the surface of the rails and along the track, found like wheel.profile: friction, and where they are needed rail, station_m, inclination_deg or place_mm; with friction.distribution profile, empty for none."""
    friction_falling_law: Literal["exponential", "rational", "linear"]
    """How friction falls with the slip velocity; where friction.distribution is not uniform, on the tread."""
    friction_gauge_face_falling_law: Literal["exponential", "rational", "linear"]
    """As friction.falling.law, on the gauge face; not with friction.distribution uniform."""
    friction_changeover_inclination: float
    """Inclination of a right rail's surface where the tread changes over to the gauge face: negative towards the gauge face; not with friction.distribution uniform [rad]."""
    friction_changeover_width: float
    """Difference of inclination over which it does, linearly [rad]."""
    friction_gauge_face_falling_share: float
    """As friction.falling.share, on the gauge face; not with friction.distribution uniform [-]."""
    friction_gauge_face_falling_decay: float
    """As friction.falling.decay, on the gauge face; not with friction.distribution uniform [s/m]."""
    friction_gauge_face_reduction_initial: float
    """As friction.reduction.initial, on the gauge face; not with friction.distribution uniform [-]."""
    friction_gauge_face_reduction_share: float
    """As friction.reduction.share, on the gauge face; not with friction.distribution uniform [-]."""
    friction_gauge_face_reduction_decay: float
    """As friction.reduction.decay, on the gauge face; not with friction.distribution uniform [-]."""
    friction_falling_share: float
    """Friction at infinite slip velocity over that without sliding; 1 is constant friction [-]."""
    friction_falling_decay: float
    """Rate at which friction begins to fall with the slip velocity, over what falls; 0 is constant friction [s/m]."""
    friction_reduction_initial: float
    """Initial slope of the creep forces over that of clean bodies, for contaminated rails [-]."""
    friction_reduction_share: float
    """What is left of friction.reduction.initial at great creepages [-]."""
    friction_reduction_decay: float
    """Rate at which the reduction goes from the one to the other with the creepage over that of saturation [-]."""
    friction_temperature_share: float
    """Friction of a hot patch over that of a cold one; 1 is friction that does not depend on temperature [-]."""
    friction_temperature_onset: float
    """Mean rise of temperature in the patch, above that of the bodies, from which on friction falls [K]."""
    friction_temperature_range: float
    """Further rise over which it falls to friction.temperature.share, linearly [K]."""
    friction_temperature_conductivity: float
    """Conductivity of heat of wheel and rails [W/(m.K)]."""
    friction_temperature_heat_capacity: float
    """Heat capacity of wheel and rails for each volume; of steel 450 J/(kg K) [J/(m3.K)]."""
    rail_shear_yield: float
    """Yield stress of the rails in shear, for patch[1].surface_fatigue_index [Pa]."""
    wear_model: Literal["off", "frictional_work", "usfd", "british_rail", "zobory", "archard"]
    """Wear law of wheel and rails, experimental: coefficients not checked against their sources, set those of your own measurements; profiles wear in the steps of co-simulation, in model exchange only off is admitted."""
    wear_distribution: Literal["interpenetration", "strips"]
    """How the wear of a patch is spread across it."""
    wear_acceleration_factor: float
    """Factor on every worn volume [-]."""
    wear_update_interval: float
    """Time between updates of the profiles [s]."""
    wear_smoothing: float
    """Wavelength along the profile of which the smoothing of the wear depth keeps half the amplitude; the worn volume stays; 0 for none [m]."""
    wear_rail_distance: float
    """Running distance of the wheel over which the volume worn off a rail is spread [m]."""
    wear_wheel_density: float
    """Density of the wheel [kg/m3]."""
    wear_wheel_frictional_work_coefficient: float
    """Law frictional_work: mass worn off per frictional work [kg/J]."""
    wear_wheel_usfd_mild: float
    """Law usfd: mass per work in the mild regime; 1e-9 kg/J is 1 ug/(m mm2) per N/mm2 [kg/J]."""
    wear_wheel_usfd_severe: float
    """Law usfd: mass per area and distance in the severe regime; 1e-3 kg/m3 is 1 ug/(m mm2) [kg/m3]."""
    wear_wheel_usfd_catastrophic: float
    """Law usfd: growth of that with T-gamma per area in the catastrophic regime [kg/J]."""
    wear_wheel_usfd_limit1: float
    """Law usfd: T-gamma per area where the severe regime begins [Pa]."""
    wear_wheel_usfd_limit2: float
    """Law usfd: T-gamma per area where the catastrophic regime begins [Pa]."""
    wear_wheel_british_rail_mild: float
    """Law british_rail: worn area times wheel diameter per distance and T-gamma in the mild regime; 1e-12 m3/J is 1 mm3/(km N) [m3/J]."""
    wear_wheel_british_rail_severe: float
    """Law british_rail: worn area times diameter per distance on the plateau; 1e-12 m2 is 1 mm3/km [m2]."""
    wear_wheel_british_rail_catastrophic: float
    """Law british_rail: growth of that with T-gamma beyond the plateau [m3/J]."""
    wear_wheel_british_rail_offset: float
    """Law british_rail: what is taken off beyond the plateau [m2]."""
    wear_wheel_british_rail_limit1: float
    """Law british_rail: T-gamma where the plateau begins [N]."""
    wear_wheel_british_rail_limit2: float
    """Law british_rail: T-gamma where the plateau ends [N]."""
    wear_wheel_zobory_mild: float
    """Law zobory: mass per work below the limit [kg/J]."""
    wear_wheel_zobory_severe: float
    """Law zobory: mass per work above the limit [kg/J]."""
    wear_wheel_zobory_limit: float
    """Law zobory: frictional power density that divides the regimes [W/m2]."""
    wear_wheel_archard_mild: float
    """Law archard: wear coefficient below the lower and above the upper slip velocity [-]."""
    wear_wheel_archard_severe: float
    """Law archard: wear coefficient between the two slip velocities [-]."""
    wear_wheel_archard_seizure: float
    """Law archard: wear coefficient where the pressure is beyond its limit [-]."""
    wear_wheel_archard_hardness: float
    """Law archard: hardness of the wheel [Pa]."""
    wear_wheel_archard_pressure_share: float
    """Law archard: limit of the pressure over the hardness [-]."""
    wear_wheel_archard_speed1: float
    """Law archard: slip velocity above which wear is severe [m/s]."""
    wear_wheel_archard_speed2: float
    """Law archard: slip velocity above which wear is mild again [m/s]."""
    wear_rail_density: float
    """Density of the rails [kg/m3]."""
    wear_rail_frictional_work_coefficient: float
    """Law frictional_work: mass worn off per frictional work [kg/J]."""
    wear_rail_usfd_mild: float
    """Law usfd: mass per work in the mild regime; 1e-9 kg/J is 1 ug/(m mm2) per N/mm2 [kg/J]."""
    wear_rail_usfd_severe: float
    """Law usfd: mass per area and distance in the severe regime; 1e-3 kg/m3 is 1 ug/(m mm2) [kg/m3]."""
    wear_rail_usfd_catastrophic: float
    """Law usfd: growth of that with T-gamma per area in the catastrophic regime [kg/J]."""
    wear_rail_usfd_limit1: float
    """Law usfd: T-gamma per area where the severe regime begins [Pa]."""
    wear_rail_usfd_limit2: float
    """Law usfd: T-gamma per area where the catastrophic regime begins [Pa]."""
    wear_rail_british_rail_mild: float
    """Law british_rail: worn area times wheel diameter per distance and T-gamma in the mild regime; 1e-12 m3/J is 1 mm3/(km N) [m3/J]."""
    wear_rail_british_rail_severe: float
    """Law british_rail: worn area times diameter per distance on the plateau; 1e-12 m2 is 1 mm3/km [m2]."""
    wear_rail_british_rail_catastrophic: float
    """Law british_rail: growth of that with T-gamma beyond the plateau [m3/J]."""
    wear_rail_british_rail_offset: float
    """Law british_rail: what is taken off beyond the plateau [m2]."""
    wear_rail_british_rail_limit1: float
    """Law british_rail: T-gamma where the plateau begins [N]."""
    wear_rail_british_rail_limit2: float
    """Law british_rail: T-gamma where the plateau ends [N]."""
    wear_rail_zobory_mild: float
    """Law zobory: mass per work below the limit [kg/J]."""
    wear_rail_zobory_severe: float
    """Law zobory: mass per work above the limit [kg/J]."""
    wear_rail_zobory_limit: float
    """Law zobory: frictional power density that divides the regimes [W/m2]."""
    wear_rail_archard_mild: float
    """Law archard: wear coefficient below the lower and above the upper slip velocity [-]."""
    wear_rail_archard_severe: float
    """Law archard: wear coefficient between the two slip velocities [-]."""
    wear_rail_archard_seizure: float
    """Law archard: wear coefficient where the pressure is beyond its limit [-]."""
    wear_rail_archard_hardness: float
    """Law archard: hardness of the rails [Pa]."""
    wear_rail_archard_pressure_share: float
    """Law archard: limit of the pressure over the hardness [-]."""
    wear_rail_archard_speed1: float
    """Law archard: slip velocity above which wear is severe [m/s]."""
    wear_rail_archard_speed2: float
    """Law archard: slip velocity above which wear is mild again [m/s]."""
    wear_wheel_file: str | os.PathLike[str]
    """File to which fmi2Terminate writes the worn profile of the wheel, two columns y_mm, z_mm that can be read as wheel.profile; relative to the working directory; empty for none."""
    wear_rail1_file: str | os.PathLike[str]
    """File to which fmi2Terminate writes the worn profile of rail 1, as wear.wheel.file."""
    wear_rail2_file: str | os.PathLike[str]
    """File to which fmi2Terminate writes the worn profile of rail 2, as wear.wheel.file."""
    coupling_monitor: bool
    """Whether contact.stiffness, contact.damping and the longest steps are computed when they are read, and coupling.energy_residual at each step of co-simulation."""
    coupling_mass: float
    """Mass of the wheelset that the host moves, for coupling.creep_limit alone; of a wheel alone that of the wheelset whose other wheel does the same [kg]."""
    coupling_inertia: float
    """Its moment of inertia about the yaw axis [kg.m2]."""
    coupling_axle_inertia: float
    """Its moment of inertia about the axle [kg.m2]."""
    coupling_lever: float
    """Distance of the wheel marker from its centre [m]."""
    x: float
    """Longitudinal position of the wheel marker in the track frame [m]."""
    y: float
    """Lateral position of the wheel marker in the track frame, from the track centre line; the start value is that of a right wheel: set it (negative) when side is left [m]."""
    z: float
    """Vertical position of the wheel marker, down from the plane of the rail tops, so about minus the nominal radius; nominal.wheel_z is where the wheel just touches [m]."""
    roll: float
    """Roll angle of the axle, about x [rad]."""
    yaw: float
    """Yaw angle of the axle, about the rolled z axis [rad]."""
    pitch: float
    """Pitch angle of the wheel, about the axle [rad]."""
    vx: float
    """Longitudinal velocity of the wheel marker [m/s]."""
    vy: float
    """Lateral velocity of the wheel marker [m/s]."""
    vz: float
    """Vertical velocity of the wheel marker, down [m/s]."""
    roll_rate: float
    """Rate of the roll angle [rad/s]."""
    yaw_rate: float
    """Rate of the yaw angle [rad/s]."""
    pitch_rate: float
    """Rate of the pitch angle, negative when the wheel rolls forward [rad/s]."""
    load: float
    """Vertical force, down, that the wheel puts on all rails together, creep forces included; only with vertical.mode load; at 0 and below the wheel is lifted [N]."""
    rail1_y: float
    """Lateral deviation of rail 1 from its design position [m]."""
    rail1_z: float
    """Vertical deviation of rail 1 from its design position, down [m]."""
    rail1_roll: float
    """Roll angle of rail 1 about its marker, beyond its inclination [rad]."""
    rail1_vy: float
    """Lateral velocity of the marker of rail 1 [m/s]."""
    rail1_vz: float
    """Vertical velocity of the marker of rail 1, down [m/s]."""
    rail1_roll_rate: float
    """Rate of the roll angle of rail 1 [rad/s]."""
    rail1_pitch_rate: float
    """Angular velocity of roller 1 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    rail2_y: float
    """Lateral deviation of rail 2 from its design position [m]."""
    rail2_z: float
    """Vertical deviation of rail 2 from its design position, down [m]."""
    rail2_roll: float
    """Roll angle of rail 2 about its marker, beyond its inclination [rad]."""
    rail2_vy: float
    """Lateral velocity of the marker of rail 2 [m/s]."""
    rail2_vz: float
    """Vertical velocity of the marker of rail 2, down [m/s]."""
    rail2_roll_rate: float
    """Rate of the roll angle of rail 2 [rad/s]."""
    rail2_pitch_rate: float
    """Angular velocity of roller 2 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    track_s: float
    """Station along the track of the origin of the track frame: a patch at position x in the track frame is at track.s + x; of a roller the arc that is on top, growing by its radius times pitch_rate [m]."""
    friction: float
    """Coefficient of friction between wheel and rail; only with friction.distribution uniform [-]."""
    friction_tread_coefficient: float
    """Coefficient of friction on the tread of the rails; only with friction.distribution regions [-]."""
    friction_gauge_face_coefficient: float
    """Coefficient of friction on the gauge faces of the rails; only with friction.distribution regions [-]."""


class ElementResult(Result):
    """What `wheelrail.Element.evaluate` gives, for type checkers."""

    wheel_force_x: Any
    """Longitudinal force on the wheel [N]."""
    wheel_force_y: Any
    """Lateral force on the wheel [N]."""
    wheel_force_z: Any
    """Vertical force on the wheel, down: negative in contact [N]."""
    wheel_moment_x: Any
    """Moment on the wheel about the wheel marker, x component in the track frame [N.m]."""
    wheel_moment_y: Any
    """Moment on the wheel about the wheel marker, y component in the track frame [N.m]."""
    wheel_moment_z: Any
    """Moment on the wheel about the wheel marker, z component in the track frame [N.m]."""
    rail1_force_x: Any
    """Longitudinal force on rail 1 [N]."""
    rail1_force_y: Any
    """Lateral force on rail 1 [N]."""
    rail1_force_z: Any
    """Vertical force on rail 1, down: positive in contact [N]."""
    rail1_moment_x: Any
    """Moment on rail 1 about its marker, x component in the track frame [N.m]."""
    rail1_moment_y: Any
    """Moment on rail 1 about its marker, y component in the track frame [N.m]."""
    rail1_moment_z: Any
    """Moment on rail 1 about its marker, z component in the track frame [N.m]."""
    rail2_force_x: Any
    """Longitudinal force on rail 2 [N]."""
    rail2_force_y: Any
    """Lateral force on rail 2 [N]."""
    rail2_force_z: Any
    """Vertical force on rail 2, down: positive in contact [N]."""
    rail2_moment_x: Any
    """Moment on rail 2 about its marker, x component in the track frame [N.m]."""
    rail2_moment_y: Any
    """Moment on rail 2 about its marker, y component in the track frame [N.m]."""
    rail2_moment_z: Any
    """Moment on rail 2 about its marker, z component in the track frame [N.m]."""
    vertical_wheel_z: Any
    """Height of the wheel marker at which the rails carry wheel.load; wheel.z where the height is given [m]."""
    vertical_load_carried: Any
    """Vertical force, down, that all rails together carry; with vertical.mode load it is wheel.load, but where the rails cannot carry that [N]."""
    foundation_deflection_y: Any
    """Lateral deflection of the rails on track.foundation, in their frame; rail[1].y comes on top [m]."""
    foundation_deflection_z: Any
    """Vertical deflection of the rails on track.foundation, down; rail[1].z comes on top [m]."""
    foundation_velocity_y: Any
    """Lateral velocity of rails with a mass [m/s]."""
    foundation_velocity_z: Any
    """Vertical velocity of rails with a mass, down [m/s]."""
    foundation_step_error: Any
    """Greatest error that a step of the last fmi2DoStep is estimated to have left in the deflection of rails with a mass; a bound rather than a guess, as it is that of a step of first order [m]."""
    patch_count: Any
    """Number of contact patches found; any number acts, the heaviest 8 are reported."""
    fallback_count: Any
    """How often a solver fell back to a simpler model since initialization."""
    solution_normal_residual: Any
    """Largest distance left between surfaces that carry pressure, or overlap left elsewhere, over the greatest overlap, of boundary elements, and of strips before their last Newton step; 0 where normal.model does not tell it [-]."""
    solution_tangential_residual: Any
    """Largest slip that contradicts the friction law, over the largest rigid slip, of boundary elements; of strips the greatest part of their bound by which tractions do; 0 where tangential.model does not tell it [-]."""
    wear_number: Any
    """Wear number (T-gamma): energy dissipated per distance, spin included [J/m]."""
    frictional_power: Any
    """Power turned into heat in all patches [W]."""
    patch1_rail: Any
    """Rail on which patch 1 lies; 0 when there is no such patch."""
    patch2_rail: Any
    """Rail on which patch 2 lies; 0 when there is no such patch."""
    patch3_rail: Any
    """Rail on which patch 3 lies; 0 when there is no such patch."""
    patch4_rail: Any
    """Rail on which patch 4 lies; 0 when there is no such patch."""
    patch5_rail: Any
    """Rail on which patch 5 lies; 0 when there is no such patch."""
    patch6_rail: Any
    """Rail on which patch 6 lies; 0 when there is no such patch."""
    patch7_rail: Any
    """Rail on which patch 7 lies; 0 when there is no such patch."""
    patch8_rail: Any
    """Rail on which patch 8 lies; 0 when there is no such patch."""
    patch1_normal_force: Any
    """Normal force of patch 1, damping included [N]."""
    patch1_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch1_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch1_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch1_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch1_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch1_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch1_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch1_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch1_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch1_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch1_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch1_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch1_length: Any
    """Greatest extent along x [m]."""
    patch1_width: Any
    """Extent across [m]."""
    patch1_area: Any
    """Area [m2]."""
    patch1_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch1_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch1_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch1_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch1_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch1_slip_share: Any
    """Share of the area that slips [-]."""
    patch1_frictional_power: Any
    """Power turned into heat [W]."""
    patch1_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch1_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    patch2_normal_force: Any
    """Normal force of patch 2, damping included [N]."""
    patch2_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch2_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch2_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch2_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch2_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch2_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch2_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch2_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch2_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch2_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch2_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch2_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch2_length: Any
    """Greatest extent along x [m]."""
    patch2_width: Any
    """Extent across [m]."""
    patch2_area: Any
    """Area [m2]."""
    patch2_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch2_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch2_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch2_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch2_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch2_slip_share: Any
    """Share of the area that slips [-]."""
    patch2_frictional_power: Any
    """Power turned into heat [W]."""
    patch2_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch2_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    patch3_normal_force: Any
    """Normal force of patch 3, damping included [N]."""
    patch3_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch3_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch3_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch3_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch3_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch3_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch3_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch3_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch3_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch3_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch3_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch3_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch3_length: Any
    """Greatest extent along x [m]."""
    patch3_width: Any
    """Extent across [m]."""
    patch3_area: Any
    """Area [m2]."""
    patch3_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch3_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch3_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch3_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch3_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch3_slip_share: Any
    """Share of the area that slips [-]."""
    patch3_frictional_power: Any
    """Power turned into heat [W]."""
    patch3_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch3_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    patch4_normal_force: Any
    """Normal force of patch 4, damping included [N]."""
    patch4_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch4_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch4_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch4_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch4_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch4_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch4_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch4_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch4_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch4_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch4_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch4_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch4_length: Any
    """Greatest extent along x [m]."""
    patch4_width: Any
    """Extent across [m]."""
    patch4_area: Any
    """Area [m2]."""
    patch4_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch4_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch4_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch4_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch4_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch4_slip_share: Any
    """Share of the area that slips [-]."""
    patch4_frictional_power: Any
    """Power turned into heat [W]."""
    patch4_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch4_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    patch5_normal_force: Any
    """Normal force of patch 5, damping included [N]."""
    patch5_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch5_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch5_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch5_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch5_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch5_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch5_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch5_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch5_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch5_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch5_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch5_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch5_length: Any
    """Greatest extent along x [m]."""
    patch5_width: Any
    """Extent across [m]."""
    patch5_area: Any
    """Area [m2]."""
    patch5_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch5_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch5_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch5_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch5_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch5_slip_share: Any
    """Share of the area that slips [-]."""
    patch5_frictional_power: Any
    """Power turned into heat [W]."""
    patch5_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch5_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    patch6_normal_force: Any
    """Normal force of patch 6, damping included [N]."""
    patch6_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch6_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch6_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch6_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch6_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch6_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch6_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch6_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch6_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch6_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch6_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch6_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch6_length: Any
    """Greatest extent along x [m]."""
    patch6_width: Any
    """Extent across [m]."""
    patch6_area: Any
    """Area [m2]."""
    patch6_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch6_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch6_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch6_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch6_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch6_slip_share: Any
    """Share of the area that slips [-]."""
    patch6_frictional_power: Any
    """Power turned into heat [W]."""
    patch6_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch6_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    patch7_normal_force: Any
    """Normal force of patch 7, damping included [N]."""
    patch7_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch7_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch7_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch7_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch7_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch7_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch7_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch7_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch7_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch7_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch7_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch7_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch7_length: Any
    """Greatest extent along x [m]."""
    patch7_width: Any
    """Extent across [m]."""
    patch7_area: Any
    """Area [m2]."""
    patch7_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch7_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch7_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch7_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch7_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch7_slip_share: Any
    """Share of the area that slips [-]."""
    patch7_frictional_power: Any
    """Power turned into heat [W]."""
    patch7_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch7_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    patch8_normal_force: Any
    """Normal force of patch 8, damping included [N]."""
    patch8_creep_force_x: Any
    """Longitudinal creep force on the wheel [N]."""
    patch8_creep_force_y: Any
    """Lateral creep force on the wheel, in the contact plane [N]."""
    patch8_spin_moment: Any
    """Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    patch8_contact_angle: Any
    """Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    patch8_position_x: Any
    """Centroid of the normal load in the track frame, x [m]."""
    patch8_position_y: Any
    """Centroid of the normal load in the track frame, y [m]."""
    patch8_position_z: Any
    """Centroid of the normal load in the track frame, z [m]."""
    patch8_wheel_y: Any
    """Lateral coordinate of the centroid on the wheel profile [m]."""
    patch8_rail_y: Any
    """Lateral coordinate of the centroid on the rail profile [m]."""
    patch8_rolling_radius: Any
    """Distance of the contact point from the axle [m]."""
    patch8_penetration: Any
    """Overlap of the undeformed bodies along the contact normal [m]."""
    patch8_max_pressure: Any
    """Greatest contact pressure [Pa]."""
    patch8_length: Any
    """Greatest extent along x [m]."""
    patch8_width: Any
    """Extent across [m]."""
    patch8_area: Any
    """Area [m2]."""
    patch8_creepage_longitudinal: Any
    """Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    patch8_creepage_lateral: Any
    """Lateral creepage, in the contact plane [-]."""
    patch8_creepage_spin: Any
    """Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    patch8_friction_coefficient: Any
    """Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    patch8_temperature: Any
    """Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    patch8_slip_share: Any
    """Share of the area that slips [-]."""
    patch8_frictional_power: Any
    """Power turned into heat [W]."""
    patch8_tgamma_damage: Any
    """T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    patch8_surface_fatigue_index: Any
    """Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""


class WheelSetInputs(TypedDict, total=False):
    """Inputs of `wheelrail.WheelSet.evaluate`, arrays that broadcast."""

    x: npt.ArrayLike
    """Longitudinal position of the centre of the wheelset, midway between the wheel markers, in the track frame [m]."""
    y: npt.ArrayLike
    """Lateral position of the centre, from the track centre line [m]."""
    z: npt.ArrayLike
    """Vertical position of the centre, down from the plane of the rail tops, so about minus the nominal radius; nominal.wheelset_z is where the wheelset just touches [m]."""
    roll: npt.ArrayLike
    """Roll angle of the axle, about x: positive lowers the right wheel [rad]."""
    yaw: npt.ArrayLike
    """Yaw angle of the axle, about the rolled z axis: positive sets the right wheel back [rad]."""
    pitch: npt.ArrayLike
    """Pitch angle, about the axle [rad]."""
    vx: npt.ArrayLike
    """Longitudinal velocity of the centre, with which the track frame goes along the track [m/s]."""
    vy: npt.ArrayLike
    """Lateral velocity of the centre [m/s]."""
    vz: npt.ArrayLike
    """Vertical velocity of the centre, down [m/s]."""
    roll_rate: npt.ArrayLike
    """Rate of the roll angle [rad/s]."""
    yaw_rate: npt.ArrayLike
    """Rate of the yaw angle [rad/s]."""
    pitch_rate: npt.ArrayLike
    """Rate of the pitch angle, negative when the wheelset rolls forward [rad/s]."""
    track_curvature: npt.ArrayLike
    """Curvature of the track in plan, positive to the right: the track frame yaws at wheelset.vx times it, and the motion of the wheelset is that in the track frame [1/m]."""
    track_twist: npt.ArrayLike
    """Change of the cant angle over the length of the track, positive where the right rail goes down against the left one [1/m]."""
    track_vertical_curvature: npt.ArrayLike
    """Vertical curvature of the track, positive in a sag [1/m]."""
    right_irregularity_y: npt.ArrayLike
    """Right side: lateral deviation of the rails from their design line at the wheelset, over the station: the rails lie still, other than with right.rail[1].vy [m]."""
    right_irregularity_z: npt.ArrayLike
    """Right side: vertical deviation, down [m]."""
    right_irregularity_y_slope: npt.ArrayLike
    """Right side: derivative of the lateral deviation by the station: the angle at which the rails run [-]."""
    right_irregularity_z_slope: npt.ArrayLike
    """Right side: derivative of the vertical deviation by the station [-]."""
    right_wheel_own_pitch: npt.ArrayLike
    """Right side: pitch angle of the wheel against wheelset.pitch, of wheels that turn independently [rad]."""
    right_wheel_own_pitch_rate: npt.ArrayLike
    """Right side: pitch rate of the wheel against wheelset.pitch_rate [rad/s]."""
    left_irregularity_y: npt.ArrayLike
    """Left side: lateral deviation of the rails from their design line at the wheelset, over the station: the rails lie still, other than with left.rail[1].vy [m]."""
    left_irregularity_z: npt.ArrayLike
    """Left side: vertical deviation, down [m]."""
    left_irregularity_y_slope: npt.ArrayLike
    """Left side: derivative of the lateral deviation by the station: the angle at which the rails run [-]."""
    left_irregularity_z_slope: npt.ArrayLike
    """Left side: derivative of the vertical deviation by the station [-]."""
    left_wheel_own_pitch: npt.ArrayLike
    """Left side: pitch angle of the wheel against wheelset.pitch, of wheels that turn independently [rad]."""
    left_wheel_own_pitch_rate: npt.ArrayLike
    """Left side: pitch rate of the wheel against wheelset.pitch_rate [rad/s]."""
    track_s: npt.ArrayLike
    """Station along the track of the origin of the track frame: a patch at position x in the track frame is at track.s + x; of a roller the arc that is on top, growing by its radius times pitch_rate [m]."""
    right_wheel_load: npt.ArrayLike
    """Right side: Vertical force, down, that the wheel puts on all rails together, creep forces included; only with vertical.mode load; at 0 and below the wheel is lifted [N]."""
    right_rail1_y: npt.ArrayLike
    """Right side: Lateral deviation of rail 1 from its design position [m]."""
    right_rail1_z: npt.ArrayLike
    """Right side: Vertical deviation of rail 1 from its design position, down [m]."""
    right_rail1_roll: npt.ArrayLike
    """Right side: Roll angle of rail 1 about its marker, beyond its inclination [rad]."""
    right_rail1_vy: npt.ArrayLike
    """Right side: Lateral velocity of the marker of rail 1 [m/s]."""
    right_rail1_vz: npt.ArrayLike
    """Right side: Vertical velocity of the marker of rail 1, down [m/s]."""
    right_rail1_roll_rate: npt.ArrayLike
    """Right side: Rate of the roll angle of rail 1 [rad/s]."""
    right_rail1_pitch_rate: npt.ArrayLike
    """Right side: Angular velocity of roller 1 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    right_rail2_y: npt.ArrayLike
    """Right side: Lateral deviation of rail 2 from its design position [m]."""
    right_rail2_z: npt.ArrayLike
    """Right side: Vertical deviation of rail 2 from its design position, down [m]."""
    right_rail2_roll: npt.ArrayLike
    """Right side: Roll angle of rail 2 about its marker, beyond its inclination [rad]."""
    right_rail2_vy: npt.ArrayLike
    """Right side: Lateral velocity of the marker of rail 2 [m/s]."""
    right_rail2_vz: npt.ArrayLike
    """Right side: Vertical velocity of the marker of rail 2, down [m/s]."""
    right_rail2_roll_rate: npt.ArrayLike
    """Right side: Rate of the roll angle of rail 2 [rad/s]."""
    right_rail2_pitch_rate: npt.ArrayLike
    """Right side: Angular velocity of roller 2 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    right_friction: npt.ArrayLike
    """Right side: Coefficient of friction between wheel and rail; only with friction.distribution uniform [-]."""
    right_friction_tread_coefficient: npt.ArrayLike
    """Right side: Coefficient of friction on the tread of the rails; only with friction.distribution regions [-]."""
    right_friction_gauge_face_coefficient: npt.ArrayLike
    """Right side: Coefficient of friction on the gauge faces of the rails; only with friction.distribution regions [-]."""
    left_wheel_load: npt.ArrayLike
    """Left side: Vertical force, down, that the wheel puts on all rails together, creep forces included; only with vertical.mode load; at 0 and below the wheel is lifted [N]."""
    left_rail1_y: npt.ArrayLike
    """Left side: Lateral deviation of rail 1 from its design position [m]."""
    left_rail1_z: npt.ArrayLike
    """Left side: Vertical deviation of rail 1 from its design position, down [m]."""
    left_rail1_roll: npt.ArrayLike
    """Left side: Roll angle of rail 1 about its marker, beyond its inclination [rad]."""
    left_rail1_vy: npt.ArrayLike
    """Left side: Lateral velocity of the marker of rail 1 [m/s]."""
    left_rail1_vz: npt.ArrayLike
    """Left side: Vertical velocity of the marker of rail 1, down [m/s]."""
    left_rail1_roll_rate: npt.ArrayLike
    """Left side: Rate of the roll angle of rail 1 [rad/s]."""
    left_rail1_pitch_rate: npt.ArrayLike
    """Left side: Angular velocity of roller 1 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    left_rail2_y: npt.ArrayLike
    """Left side: Lateral deviation of rail 2 from its design position [m]."""
    left_rail2_z: npt.ArrayLike
    """Left side: Vertical deviation of rail 2 from its design position, down [m]."""
    left_rail2_roll: npt.ArrayLike
    """Left side: Roll angle of rail 2 about its marker, beyond its inclination [rad]."""
    left_rail2_vy: npt.ArrayLike
    """Left side: Lateral velocity of the marker of rail 2 [m/s]."""
    left_rail2_vz: npt.ArrayLike
    """Left side: Vertical velocity of the marker of rail 2, down [m/s]."""
    left_rail2_roll_rate: npt.ArrayLike
    """Left side: Rate of the roll angle of rail 2 [rad/s]."""
    left_rail2_pitch_rate: npt.ArrayLike
    """Left side: Angular velocity of roller 2 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    left_friction: npt.ArrayLike
    """Left side: Coefficient of friction between wheel and rail; only with friction.distribution uniform [-]."""
    left_friction_tread_coefficient: npt.ArrayLike
    """Left side: Coefficient of friction on the tread of the rails; only with friction.distribution regions [-]."""
    left_friction_gauge_face_coefficient: npt.ArrayLike
    """Left side: Coefficient of friction on the gauge faces of the rails; only with friction.distribution regions [-]."""


class WheelSetParameters(TypedDict, total=False):
    """Parameters and starting inputs of `wheelrail.WheelSet`."""

    flange_back_distance: float
    """Distance of the flange backs of the two wheels; the wheel markers, in the planes of the nominal rolling circles, are 0.07 m farther out on each side [m]."""
    track_irregularity_file: str | os.PathLike[str]
    """File with the irregularities of both rails over the station, found like right.wheel.profile: columns station_m, right_y_mm, right_z_mm, left_y_mm, left_z_mm (y to the right, z down), on top of the inputs; empty for none."""
    wheel_young_modulus: float
    """Young's modulus of the wheel [Pa]."""
    wheel_poisson_ratio: float
    """Poisson's ratio of the wheel [-]."""
    rail_young_modulus: float
    """Young's modulus of the rails [Pa]."""
    rail_poisson_ratio: float
    """Poisson's ratio of the rails [-]."""
    track_gauge: float
    """Track gauge: distance of the gauge faces at the gauge depth [m]."""
    track_gauge_depth: float
    """Depth below the rail top at which the gauge is measured [m]."""
    profile_smoothing: float
    """Wavelength at which the smoothing of profiles from files halves an amplitude; 0 interpolates; a negative number (-1) leaves it to the noise found in the points of each file [m]."""
    vertical_mode: Literal["penetration", "load"]
    """What is given of the vertical motion of the wheel; with load, wheel.z has no effect and there is no normal damping."""
    motion: Literal["given", "rolling"]
    """What turns the wheel; with rolling, pitch_rate has no effect and the wheel rolls freely on its nominal radius."""
    track_foundation_model: Literal["rigid", "massless", "mass"]
    """What all rails under a wheel rest on, each side by itself; mass goes with the steps of co-simulation and with vertical.mode penetration."""
    track_foundation_stiffness_y: float
    """Lateral stiffness of the rails of a side against the ground; only with track.foundation.model massless and mass, as all of track.foundation [N/m]."""
    track_foundation_stiffness_z: float
    """Vertical stiffness of the rails of a side against the ground [N/m]."""
    track_foundation_damping_y: float
    """Lateral damping of the rails of a side against the ground; only with mass [N.s/m]."""
    track_foundation_damping_z: float
    """Vertical damping of the rails of a side against the ground; only with mass [N.s/m]."""
    track_foundation_mass: float
    """Mass that moves with the rails of a side; only with mass [kg]."""
    track_foundation_longest_step: float
    """Longest step in which rails with a mass are moved on: fmi2DoStep makes as many equal ones as it takes, at most 1000 [s]."""
    normal_model: Literal["hertz", "piotrowski_kik", "piotrowski_kik_corrected", "strips", "boundary_element"]
    """Normal contact model."""
    normal_shape_fit: Literal["hertz", "paper"]
    """Ratio of length to width that the area of piotrowski_kik_corrected gets; other models do not use it."""
    normal_virtual_penetration: float
    """Virtual over true penetration [-]."""
    normal_damping: float
    """Normal contact damping at the reference stiffness [N.s/m]."""
    normal_strips: int
    """Strips: for the model strips over all zones of a rail, at least 8; for the others across each zone, one more where it is odd."""
    normal_elements_along: int
    """Boundary elements along the extent of a contact; other models do not use it."""
    normal_elements_across: int
    """Boundary elements across the extent of a contact; other models do not use it."""
    creepage_model: Literal["kinematic", "flat", "curved"]
    """How creepage varies over a patch."""
    creepage_minimum_speed: float
    """Floor of the speed to which creepages refer [m/s]."""
    tangential_model: Literal["none", "linear", "fastsim", "fastrip", "tables", "fastsim_corrected", "boundary_element", "marches"]
    """Tangential contact model."""
    tangential_history: Literal["steady", "transient"]
    """Whether tractions are those of steady rolling, or follow from those of the steps before."""
    tangential_elements_along: int
    """Elements along each strip of fastsim, fastsim_corrected and fastrip; other models do not use it."""
    tangential_bound: Literal["elliptic", "parabolic"]
    """Shape of the traction bound along a strip of fastsim and fastsim_corrected; other models have their own."""
    tangential_flexibilities: Literal["three", "blended"]
    """How the flexibilities of the simplified theory enter in fastsim, fastsim_corrected and fastrip; other models do not use them."""
    friction_distribution: Literal["uniform", "regions", "profile"]
    """How friction is spread over the surface of the rails."""
    friction_falling_law: Literal["exponential", "rational", "linear"]
    """How friction falls with the slip velocity; where friction.distribution is not uniform, on the tread."""
    friction_gauge_face_falling_law: Literal["exponential", "rational", "linear"]
    """As friction.falling.law, on the gauge face; not with friction.distribution uniform."""
    friction_changeover_inclination: float
    """Inclination of a right rail's surface where the tread changes over to the gauge face: negative towards the gauge face; not with friction.distribution uniform [rad]."""
    friction_changeover_width: float
    """Difference of inclination over which it does, linearly [rad]."""
    friction_gauge_face_falling_share: float
    """As friction.falling.share, on the gauge face; not with friction.distribution uniform [-]."""
    friction_gauge_face_falling_decay: float
    """As friction.falling.decay, on the gauge face; not with friction.distribution uniform [s/m]."""
    friction_gauge_face_reduction_initial: float
    """As friction.reduction.initial, on the gauge face; not with friction.distribution uniform [-]."""
    friction_gauge_face_reduction_share: float
    """As friction.reduction.share, on the gauge face; not with friction.distribution uniform [-]."""
    friction_gauge_face_reduction_decay: float
    """As friction.reduction.decay, on the gauge face; not with friction.distribution uniform [-]."""
    friction_falling_share: float
    """Friction at infinite slip velocity over that without sliding; 1 is constant friction [-]."""
    friction_falling_decay: float
    """Rate at which friction begins to fall with the slip velocity, over what falls; 0 is constant friction [s/m]."""
    friction_reduction_initial: float
    """Initial slope of the creep forces over that of clean bodies, for contaminated rails [-]."""
    friction_reduction_share: float
    """What is left of friction.reduction.initial at great creepages [-]."""
    friction_reduction_decay: float
    """Rate at which the reduction goes from the one to the other with the creepage over that of saturation [-]."""
    friction_temperature_share: float
    """Friction of a hot patch over that of a cold one; 1 is friction that does not depend on temperature [-]."""
    friction_temperature_onset: float
    """Mean rise of temperature in the patch, above that of the bodies, from which on friction falls [K]."""
    friction_temperature_range: float
    """Further rise over which it falls to friction.temperature.share, linearly [K]."""
    friction_temperature_conductivity: float
    """Conductivity of heat of wheel and rails [W/(m.K)]."""
    friction_temperature_heat_capacity: float
    """Heat capacity of wheel and rails for each volume; of steel 450 J/(kg K) [J/(m3.K)]."""
    rail_shear_yield: float
    """Yield stress of the rails in shear, for patch[1].surface_fatigue_index [Pa]."""
    wear_model: Literal["off", "frictional_work", "usfd", "british_rail", "zobory", "archard"]
    """Wear law of wheel and rails, experimental: coefficients not checked against their sources, set those of your own measurements; profiles wear in the steps of co-simulation, in model exchange only off is admitted."""
    wear_distribution: Literal["interpenetration", "strips"]
    """How the wear of a patch is spread across it."""
    wear_acceleration_factor: float
    """Factor on every worn volume [-]."""
    wear_update_interval: float
    """Time between updates of the profiles [s]."""
    wear_smoothing: float
    """Wavelength along the profile of which the smoothing of the wear depth keeps half the amplitude; the worn volume stays; 0 for none [m]."""
    wear_rail_distance: float
    """Running distance of the wheel over which the volume worn off a rail is spread [m]."""
    wear_wheel_density: float
    """Density of the wheel [kg/m3]."""
    wear_wheel_frictional_work_coefficient: float
    """Law frictional_work: mass worn off per frictional work [kg/J]."""
    wear_wheel_usfd_mild: float
    """Law usfd: mass per work in the mild regime; 1e-9 kg/J is 1 ug/(m mm2) per N/mm2 [kg/J]."""
    wear_wheel_usfd_severe: float
    """Law usfd: mass per area and distance in the severe regime; 1e-3 kg/m3 is 1 ug/(m mm2) [kg/m3]."""
    wear_wheel_usfd_catastrophic: float
    """Law usfd: growth of that with T-gamma per area in the catastrophic regime [kg/J]."""
    wear_wheel_usfd_limit1: float
    """Law usfd: T-gamma per area where the severe regime begins [Pa]."""
    wear_wheel_usfd_limit2: float
    """Law usfd: T-gamma per area where the catastrophic regime begins [Pa]."""
    wear_wheel_british_rail_mild: float
    """Law british_rail: worn area times wheel diameter per distance and T-gamma in the mild regime; 1e-12 m3/J is 1 mm3/(km N) [m3/J]."""
    wear_wheel_british_rail_severe: float
    """Law british_rail: worn area times diameter per distance on the plateau; 1e-12 m2 is 1 mm3/km [m2]."""
    wear_wheel_british_rail_catastrophic: float
    """Law british_rail: growth of that with T-gamma beyond the plateau [m3/J]."""
    wear_wheel_british_rail_offset: float
    """Law british_rail: what is taken off beyond the plateau [m2]."""
    wear_wheel_british_rail_limit1: float
    """Law british_rail: T-gamma where the plateau begins [N]."""
    wear_wheel_british_rail_limit2: float
    """Law british_rail: T-gamma where the plateau ends [N]."""
    wear_wheel_zobory_mild: float
    """Law zobory: mass per work below the limit [kg/J]."""
    wear_wheel_zobory_severe: float
    """Law zobory: mass per work above the limit [kg/J]."""
    wear_wheel_zobory_limit: float
    """Law zobory: frictional power density that divides the regimes [W/m2]."""
    wear_wheel_archard_mild: float
    """Law archard: wear coefficient below the lower and above the upper slip velocity [-]."""
    wear_wheel_archard_severe: float
    """Law archard: wear coefficient between the two slip velocities [-]."""
    wear_wheel_archard_seizure: float
    """Law archard: wear coefficient where the pressure is beyond its limit [-]."""
    wear_wheel_archard_hardness: float
    """Law archard: hardness of the wheel [Pa]."""
    wear_wheel_archard_pressure_share: float
    """Law archard: limit of the pressure over the hardness [-]."""
    wear_wheel_archard_speed1: float
    """Law archard: slip velocity above which wear is severe [m/s]."""
    wear_wheel_archard_speed2: float
    """Law archard: slip velocity above which wear is mild again [m/s]."""
    wear_rail_density: float
    """Density of the rails [kg/m3]."""
    wear_rail_frictional_work_coefficient: float
    """Law frictional_work: mass worn off per frictional work [kg/J]."""
    wear_rail_usfd_mild: float
    """Law usfd: mass per work in the mild regime; 1e-9 kg/J is 1 ug/(m mm2) per N/mm2 [kg/J]."""
    wear_rail_usfd_severe: float
    """Law usfd: mass per area and distance in the severe regime; 1e-3 kg/m3 is 1 ug/(m mm2) [kg/m3]."""
    wear_rail_usfd_catastrophic: float
    """Law usfd: growth of that with T-gamma per area in the catastrophic regime [kg/J]."""
    wear_rail_usfd_limit1: float
    """Law usfd: T-gamma per area where the severe regime begins [Pa]."""
    wear_rail_usfd_limit2: float
    """Law usfd: T-gamma per area where the catastrophic regime begins [Pa]."""
    wear_rail_british_rail_mild: float
    """Law british_rail: worn area times wheel diameter per distance and T-gamma in the mild regime; 1e-12 m3/J is 1 mm3/(km N) [m3/J]."""
    wear_rail_british_rail_severe: float
    """Law british_rail: worn area times diameter per distance on the plateau; 1e-12 m2 is 1 mm3/km [m2]."""
    wear_rail_british_rail_catastrophic: float
    """Law british_rail: growth of that with T-gamma beyond the plateau [m3/J]."""
    wear_rail_british_rail_offset: float
    """Law british_rail: what is taken off beyond the plateau [m2]."""
    wear_rail_british_rail_limit1: float
    """Law british_rail: T-gamma where the plateau begins [N]."""
    wear_rail_british_rail_limit2: float
    """Law british_rail: T-gamma where the plateau ends [N]."""
    wear_rail_zobory_mild: float
    """Law zobory: mass per work below the limit [kg/J]."""
    wear_rail_zobory_severe: float
    """Law zobory: mass per work above the limit [kg/J]."""
    wear_rail_zobory_limit: float
    """Law zobory: frictional power density that divides the regimes [W/m2]."""
    wear_rail_archard_mild: float
    """Law archard: wear coefficient below the lower and above the upper slip velocity [-]."""
    wear_rail_archard_severe: float
    """Law archard: wear coefficient between the two slip velocities [-]."""
    wear_rail_archard_seizure: float
    """Law archard: wear coefficient where the pressure is beyond its limit [-]."""
    wear_rail_archard_hardness: float
    """Law archard: hardness of the rails [Pa]."""
    wear_rail_archard_pressure_share: float
    """Law archard: limit of the pressure over the hardness [-]."""
    wear_rail_archard_speed1: float
    """Law archard: slip velocity above which wear is severe [m/s]."""
    wear_rail_archard_speed2: float
    """Law archard: slip velocity above which wear is mild again [m/s]."""
    coupling_monitor: bool
    """Whether contact.stiffness, contact.damping and the longest steps are computed when they are read, and coupling.energy_residual at each step of co-simulation."""
    coupling_mass: float
    """Mass of the wheelset that the host moves, for coupling.creep_limit alone; of a wheel alone that of the wheelset whose other wheel does the same [kg]."""
    coupling_inertia: float
    """Its moment of inertia about the yaw axis [kg.m2]."""
    coupling_axle_inertia: float
    """Its moment of inertia about the axle [kg.m2]."""
    right_wheel_profile: str | os.PathLike[str]
    """Right side: Wheel profile: a built-in name or a file; a relative file name is looked for in resources/profiles, then in the working directory; slices (.slcw) or a table of sections where it varies around."""
    right_wheel_nominal_radius: float
    """Right side: Radius of the nominal rolling circle [m]."""
    right_rail1_profile: str | os.PathLike[str]
    """Right side: Profile of rail 1: a built-in name or a file, found like wheel.profile; slices (.slcs) or a table of sections where it varies along the track."""
    right_rail2_profile: str | os.PathLike[str]
    """Right side: Profile of rail 2: a built-in name or a file, found like wheel.profile; slices (.slcs) or a table of sections where it varies along the track."""
    right_rail1_enabled: bool
    """Right side: Whether rail 1 takes part."""
    right_rail2_enabled: bool
    """Right side: Whether there is a second rail: a check rail, a switch tongue."""
    right_rail2_mirrored: bool
    """Right side: Whether the inclined profile of rail 2 is turned left to right, as that of a check rail, which faces the flange back."""
    right_rail1_placement: Literal["gauge", "position", "origin"]
    """Right side: What says where rail 1 stands: the gauge or rail[1].position."""
    right_rail2_placement: Literal["gauge", "position", "origin"]
    """Right side: What says where rail 2 stands: rail[2].position or the gauge."""
    right_rail1_position_y: float
    """Right side: Lateral position in the track frame of the marker or the origin of rail 1 in design position; without effect with placement gauge; the start value is that of a right wheel: set it (negative) when side is left [m]."""
    right_rail1_position_z: float
    """Right side: Vertical position in the track frame of that point of rail 1 in design position, down [m]."""
    right_rail2_position_y: float
    """Right side: Lateral position in the track frame of the marker (placement position), the highest point of its head, or the origin of rail 2 in design position; the start value is that of a check rail of a right wheel with a flangeway of 41 mm: set it (negative) when side is left [m]."""
    right_rail2_position_z: float
    """Right side: Vertical position in the track frame of that point of rail 2 in design position, down [m]."""
    right_rail1_inclination: float
    """Right side: Inclination of rail 1 towards the track centre as a tangent: 1:40 is 0.025 [-]."""
    right_rail1_roller_radius: float
    """Right side: Radius of roller 1 at its highest point, 0.1 m at least; its axle is across the track at x = 0 of the track frame, wherever track.s is; 0 for a straight rail [m]."""
    right_rail2_inclination: float
    """Right side: Inclination of rail 2 towards the track centre as a tangent: 1:40 is 0.025 [-]."""
    right_rail2_roller_radius: float
    """Right side: Radius of roller 2 at its highest point, 0.1 m at least; its axle is across the track at x = 0 of the track frame, wherever track.s is; 0 for a straight rail [m]."""
    right_rail1_corrugation_amplitude: float
    """Right side: Half the height from trough to crest of a wave of rail 1 along the station; 0 for none [m]."""
    right_rail1_corrugation_wavelength: float
    """Right side: Wavelength of that wave; a whole number of them has to go around a roller [m]."""
    right_rail1_corrugation_phase: float
    """Right side: Phase of that wave at station 0: with 0 there is a crest [rad]."""
    right_rail2_corrugation_amplitude: float
    """Right side: Half the height from trough to crest of a wave of rail 2 along the station; 0 for none [m]."""
    right_rail2_corrugation_wavelength: float
    """Right side: Wavelength of that wave; a whole number of them has to go around a roller [m]."""
    right_rail2_corrugation_phase: float
    """Right side: Phase of that wave at station 0: with 0 there is a crest [rad]."""
    right_rail1_corrugation_file: str | os.PathLike[str]
    """Right side: File with heights of rail 1 along the station, columns station_m and height_mm (up positive), found like wheel.profile, on top of the wave; empty for none."""
    right_rail2_corrugation_file: str | os.PathLike[str]
    """Right side: File with heights of rail 2 along the station, columns station_m and height_mm (up positive), found like wheel.profile, on top of the wave; empty for none."""
    right_wheel_out_of_round_amplitude: float
    """Right side: Half the difference from least to greatest radius of a wave around the wheel; 0 for none [m]."""
    right_wheel_out_of_round_phase: float
    """Right side: Phase of that wave at the point that is lowest at pitch 0: with 0 the radius is greatest there [rad]."""
    right_wheel_flat_length: float
    """Right side: Length of a flat of the wheel along the nominal rolling circle; 0 for none [m]."""
    right_wheel_flat_angle: float
    """Right side: Angle by which the wheel has to roll forward from pitch 0 until it stands on the middle of the flat [rad]."""
    right_wheel_flat_depth: float
    """Right side: Greatest depth of a worn flat; 0 for length squared over 16 radii; a fresh one is as deep as its chord [m]."""
    right_wheel_out_of_round_order: int
    """Right side: Number of waves around the wheel."""
    right_wheel_out_of_round_file: str | os.PathLike[str]
    """Right side: File with deviations of the radius around the wheel, columns angle_deg and radius_mm, found like wheel.profile, on top of the wave; empty for none."""
    right_wheel_flat_shape: Literal["fresh", "worn"]
    """Right side: Shape of the flat."""
    right_friction_profile: str | os.PathLike[str]
    """Right side: File with friction over the surface of the rails and along the track, found like wheel.profile: friction, and where they are needed rail, station_m, inclination_deg or place_mm; with friction.distribution profile, empty for none."""
    right_wear_wheel_file: str | os.PathLike[str]
    """Right side: File to which fmi2Terminate writes the worn profile of the wheel, two columns y_mm, z_mm that can be read as wheel.profile; relative to the working directory; empty for none."""
    right_wear_rail1_file: str | os.PathLike[str]
    """Right side: File to which fmi2Terminate writes the worn profile of rail 1, as wear.wheel.file."""
    right_wear_rail2_file: str | os.PathLike[str]
    """Right side: File to which fmi2Terminate writes the worn profile of rail 2, as wear.wheel.file."""
    left_wheel_profile: str | os.PathLike[str]
    """Left side: Wheel profile: a built-in name or a file; a relative file name is looked for in resources/profiles, then in the working directory; slices (.slcw) or a table of sections where it varies around."""
    left_wheel_nominal_radius: float
    """Left side: Radius of the nominal rolling circle [m]."""
    left_rail1_profile: str | os.PathLike[str]
    """Left side: Profile of rail 1: a built-in name or a file, found like wheel.profile; slices (.slcs) or a table of sections where it varies along the track."""
    left_rail2_profile: str | os.PathLike[str]
    """Left side: Profile of rail 2: a built-in name or a file, found like wheel.profile; slices (.slcs) or a table of sections where it varies along the track."""
    left_rail1_enabled: bool
    """Left side: Whether rail 1 takes part."""
    left_rail2_enabled: bool
    """Left side: Whether there is a second rail: a check rail, a switch tongue."""
    left_rail2_mirrored: bool
    """Left side: Whether the inclined profile of rail 2 is turned left to right, as that of a check rail, which faces the flange back."""
    left_rail1_placement: Literal["gauge", "position", "origin"]
    """Left side: What says where rail 1 stands: the gauge or rail[1].position."""
    left_rail2_placement: Literal["gauge", "position", "origin"]
    """Left side: What says where rail 2 stands: rail[2].position or the gauge."""
    left_rail1_position_y: float
    """Left side: Lateral position in the track frame of the marker or the origin of rail 1 in design position; without effect with placement gauge; the start value is that of a right wheel: set it (negative) when side is left [m]."""
    left_rail1_position_z: float
    """Left side: Vertical position in the track frame of that point of rail 1 in design position, down [m]."""
    left_rail2_position_y: float
    """Left side: Lateral position in the track frame of the marker (placement position), the highest point of its head, or the origin of rail 2 in design position; the start value is that of a check rail of a right wheel with a flangeway of 41 mm: set it (negative) when side is left [m]."""
    left_rail2_position_z: float
    """Left side: Vertical position in the track frame of that point of rail 2 in design position, down [m]."""
    left_rail1_inclination: float
    """Left side: Inclination of rail 1 towards the track centre as a tangent: 1:40 is 0.025 [-]."""
    left_rail1_roller_radius: float
    """Left side: Radius of roller 1 at its highest point, 0.1 m at least; its axle is across the track at x = 0 of the track frame, wherever track.s is; 0 for a straight rail [m]."""
    left_rail2_inclination: float
    """Left side: Inclination of rail 2 towards the track centre as a tangent: 1:40 is 0.025 [-]."""
    left_rail2_roller_radius: float
    """Left side: Radius of roller 2 at its highest point, 0.1 m at least; its axle is across the track at x = 0 of the track frame, wherever track.s is; 0 for a straight rail [m]."""
    left_rail1_corrugation_amplitude: float
    """Left side: Half the height from trough to crest of a wave of rail 1 along the station; 0 for none [m]."""
    left_rail1_corrugation_wavelength: float
    """Left side: Wavelength of that wave; a whole number of them has to go around a roller [m]."""
    left_rail1_corrugation_phase: float
    """Left side: Phase of that wave at station 0: with 0 there is a crest [rad]."""
    left_rail2_corrugation_amplitude: float
    """Left side: Half the height from trough to crest of a wave of rail 2 along the station; 0 for none [m]."""
    left_rail2_corrugation_wavelength: float
    """Left side: Wavelength of that wave; a whole number of them has to go around a roller [m]."""
    left_rail2_corrugation_phase: float
    """Left side: Phase of that wave at station 0: with 0 there is a crest [rad]."""
    left_rail1_corrugation_file: str | os.PathLike[str]
    """Left side: File with heights of rail 1 along the station, columns station_m and height_mm (up positive), found like wheel.profile, on top of the wave; empty for none."""
    left_rail2_corrugation_file: str | os.PathLike[str]
    """Left side: File with heights of rail 2 along the station, columns station_m and height_mm (up positive), found like wheel.profile, on top of the wave; empty for none."""
    left_wheel_out_of_round_amplitude: float
    """Left side: Half the difference from least to greatest radius of a wave around the wheel; 0 for none [m]."""
    left_wheel_out_of_round_phase: float
    """Left side: Phase of that wave at the point that is lowest at pitch 0: with 0 the radius is greatest there [rad]."""
    left_wheel_flat_length: float
    """Left side: Length of a flat of the wheel along the nominal rolling circle; 0 for none [m]."""
    left_wheel_flat_angle: float
    """Left side: Angle by which the wheel has to roll forward from pitch 0 until it stands on the middle of the flat [rad]."""
    left_wheel_flat_depth: float
    """Left side: Greatest depth of a worn flat; 0 for length squared over 16 radii; a fresh one is as deep as its chord [m]."""
    left_wheel_out_of_round_order: int
    """Left side: Number of waves around the wheel."""
    left_wheel_out_of_round_file: str | os.PathLike[str]
    """Left side: File with deviations of the radius around the wheel, columns angle_deg and radius_mm, found like wheel.profile, on top of the wave; empty for none."""
    left_wheel_flat_shape: Literal["fresh", "worn"]
    """Left side: Shape of the flat."""
    left_friction_profile: str | os.PathLike[str]
    """Left side: File with friction over the surface of the rails and along the track, found like wheel.profile: friction, and where they are needed rail, station_m, inclination_deg or place_mm; with friction.distribution profile, empty for none."""
    left_wear_wheel_file: str | os.PathLike[str]
    """Left side: File to which fmi2Terminate writes the worn profile of the wheel, two columns y_mm, z_mm that can be read as wheel.profile; relative to the working directory; empty for none."""
    left_wear_rail1_file: str | os.PathLike[str]
    """Left side: File to which fmi2Terminate writes the worn profile of rail 1, as wear.wheel.file."""
    left_wear_rail2_file: str | os.PathLike[str]
    """Left side: File to which fmi2Terminate writes the worn profile of rail 2, as wear.wheel.file."""
    x: float
    """Longitudinal position of the centre of the wheelset, midway between the wheel markers, in the track frame [m]."""
    y: float
    """Lateral position of the centre, from the track centre line [m]."""
    z: float
    """Vertical position of the centre, down from the plane of the rail tops, so about minus the nominal radius; nominal.wheelset_z is where the wheelset just touches [m]."""
    roll: float
    """Roll angle of the axle, about x: positive lowers the right wheel [rad]."""
    yaw: float
    """Yaw angle of the axle, about the rolled z axis: positive sets the right wheel back [rad]."""
    pitch: float
    """Pitch angle, about the axle [rad]."""
    vx: float
    """Longitudinal velocity of the centre, with which the track frame goes along the track [m/s]."""
    vy: float
    """Lateral velocity of the centre [m/s]."""
    vz: float
    """Vertical velocity of the centre, down [m/s]."""
    roll_rate: float
    """Rate of the roll angle [rad/s]."""
    yaw_rate: float
    """Rate of the yaw angle [rad/s]."""
    pitch_rate: float
    """Rate of the pitch angle, negative when the wheelset rolls forward [rad/s]."""
    track_curvature: float
    """Curvature of the track in plan, positive to the right: the track frame yaws at wheelset.vx times it, and the motion of the wheelset is that in the track frame [1/m]."""
    track_twist: float
    """Change of the cant angle over the length of the track, positive where the right rail goes down against the left one [1/m]."""
    track_vertical_curvature: float
    """Vertical curvature of the track, positive in a sag [1/m]."""
    right_irregularity_y: float
    """Right side: lateral deviation of the rails from their design line at the wheelset, over the station: the rails lie still, other than with right.rail[1].vy [m]."""
    right_irregularity_z: float
    """Right side: vertical deviation, down [m]."""
    right_irregularity_y_slope: float
    """Right side: derivative of the lateral deviation by the station: the angle at which the rails run [-]."""
    right_irregularity_z_slope: float
    """Right side: derivative of the vertical deviation by the station [-]."""
    right_wheel_own_pitch: float
    """Right side: pitch angle of the wheel against wheelset.pitch, of wheels that turn independently [rad]."""
    right_wheel_own_pitch_rate: float
    """Right side: pitch rate of the wheel against wheelset.pitch_rate [rad/s]."""
    left_irregularity_y: float
    """Left side: lateral deviation of the rails from their design line at the wheelset, over the station: the rails lie still, other than with left.rail[1].vy [m]."""
    left_irregularity_z: float
    """Left side: vertical deviation, down [m]."""
    left_irregularity_y_slope: float
    """Left side: derivative of the lateral deviation by the station: the angle at which the rails run [-]."""
    left_irregularity_z_slope: float
    """Left side: derivative of the vertical deviation by the station [-]."""
    left_wheel_own_pitch: float
    """Left side: pitch angle of the wheel against wheelset.pitch, of wheels that turn independently [rad]."""
    left_wheel_own_pitch_rate: float
    """Left side: pitch rate of the wheel against wheelset.pitch_rate [rad/s]."""
    track_s: float
    """Station along the track of the origin of the track frame: a patch at position x in the track frame is at track.s + x; of a roller the arc that is on top, growing by its radius times pitch_rate [m]."""
    right_wheel_load: float
    """Right side: Vertical force, down, that the wheel puts on all rails together, creep forces included; only with vertical.mode load; at 0 and below the wheel is lifted [N]."""
    right_rail1_y: float
    """Right side: Lateral deviation of rail 1 from its design position [m]."""
    right_rail1_z: float
    """Right side: Vertical deviation of rail 1 from its design position, down [m]."""
    right_rail1_roll: float
    """Right side: Roll angle of rail 1 about its marker, beyond its inclination [rad]."""
    right_rail1_vy: float
    """Right side: Lateral velocity of the marker of rail 1 [m/s]."""
    right_rail1_vz: float
    """Right side: Vertical velocity of the marker of rail 1, down [m/s]."""
    right_rail1_roll_rate: float
    """Right side: Rate of the roll angle of rail 1 [rad/s]."""
    right_rail1_pitch_rate: float
    """Right side: Angular velocity of roller 1 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    right_rail2_y: float
    """Right side: Lateral deviation of rail 2 from its design position [m]."""
    right_rail2_z: float
    """Right side: Vertical deviation of rail 2 from its design position, down [m]."""
    right_rail2_roll: float
    """Right side: Roll angle of rail 2 about its marker, beyond its inclination [rad]."""
    right_rail2_vy: float
    """Right side: Lateral velocity of the marker of rail 2 [m/s]."""
    right_rail2_vz: float
    """Right side: Vertical velocity of the marker of rail 2, down [m/s]."""
    right_rail2_roll_rate: float
    """Right side: Rate of the roll angle of rail 2 [rad/s]."""
    right_rail2_pitch_rate: float
    """Right side: Angular velocity of roller 2 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    right_friction: float
    """Right side: Coefficient of friction between wheel and rail; only with friction.distribution uniform [-]."""
    right_friction_tread_coefficient: float
    """Right side: Coefficient of friction on the tread of the rails; only with friction.distribution regions [-]."""
    right_friction_gauge_face_coefficient: float
    """Right side: Coefficient of friction on the gauge faces of the rails; only with friction.distribution regions [-]."""
    left_wheel_load: float
    """Left side: Vertical force, down, that the wheel puts on all rails together, creep forces included; only with vertical.mode load; at 0 and below the wheel is lifted [N]."""
    left_rail1_y: float
    """Left side: Lateral deviation of rail 1 from its design position [m]."""
    left_rail1_z: float
    """Left side: Vertical deviation of rail 1 from its design position, down [m]."""
    left_rail1_roll: float
    """Left side: Roll angle of rail 1 about its marker, beyond its inclination [rad]."""
    left_rail1_vy: float
    """Left side: Lateral velocity of the marker of rail 1 [m/s]."""
    left_rail1_vz: float
    """Left side: Vertical velocity of the marker of rail 1, down [m/s]."""
    left_rail1_roll_rate: float
    """Left side: Rate of the roll angle of rail 1 [rad/s]."""
    left_rail1_pitch_rate: float
    """Left side: Angular velocity of roller 1 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    left_rail2_y: float
    """Left side: Lateral deviation of rail 2 from its design position [m]."""
    left_rail2_z: float
    """Left side: Vertical deviation of rail 2 from its design position, down [m]."""
    left_rail2_roll: float
    """Left side: Roll angle of rail 2 about its marker, beyond its inclination [rad]."""
    left_rail2_vy: float
    """Left side: Lateral velocity of the marker of rail 2 [m/s]."""
    left_rail2_vz: float
    """Left side: Vertical velocity of the marker of rail 2, down [m/s]."""
    left_rail2_roll_rate: float
    """Left side: Rate of the roll angle of rail 2 [rad/s]."""
    left_rail2_pitch_rate: float
    """Left side: Angular velocity of roller 2 about its axle, negative when its top goes forward; without effect on a straight rail [rad/s]."""
    left_friction: float
    """Left side: Coefficient of friction between wheel and rail; only with friction.distribution uniform [-]."""
    left_friction_tread_coefficient: float
    """Left side: Coefficient of friction on the tread of the rails; only with friction.distribution regions [-]."""
    left_friction_gauge_face_coefficient: float
    """Left side: Coefficient of friction on the gauge faces of the rails; only with friction.distribution regions [-]."""


class WheelSetResult(Result):
    """What `wheelrail.WheelSet.evaluate` gives, for type checkers."""

    wheelset_force_x: Any
    """Longitudinal force of all contacts on the wheelset [N]."""
    wheelset_force_y: Any
    """Lateral force of all contacts on the wheelset [N]."""
    wheelset_force_z: Any
    """Vertical force of all contacts on the wheelset, down: negative in contact [N]."""
    wheelset_moment_x: Any
    """Moment on the wheelset about its centre, x component in the track frame [N.m]."""
    wheelset_moment_y: Any
    """Moment on the wheelset about its centre, y component in the track frame [N.m]."""
    wheelset_moment_z: Any
    """Moment on the wheelset about its centre, z component in the track frame [N.m]."""
    vertical_wheelset_z: Any
    """Height of the centre at which the rails carry right.wheel.load and left.wheel.load; wheelset.z where the height is given [m]."""
    vertical_roll: Any
    """Roll angle at which they do; wheelset.roll where it is given [rad]."""
    wear_number: Any
    """Wear number (T-gamma) of both sides: energy dissipated per distance, spin included [J/m]."""
    frictional_power: Any
    """Power turned into heat in all patches of both sides [W]."""
    right_guiding_force: Any
    """Right side: Y, lateral force of the wheel on its rails, positive away from the middle of the track [N]."""
    right_vertical_force: Any
    """Right side: Q, vertical force of the wheel on its rails, down [N]."""
    right_derailment_quotient: Any
    """Right side: Y/Q; 0 for a wheel that carries nothing [-]."""
    left_guiding_force: Any
    """Left side: Y, lateral force of the wheel on its rails, positive away from the middle of the track [N]."""
    left_vertical_force: Any
    """Left side: Q, vertical force of the wheel on its rails, down [N]."""
    left_derailment_quotient: Any
    """Left side: Y/Q; 0 for a wheel that carries nothing [-]."""
    track_shifting_force: Any
    """Sum of Y: lateral force of the wheelset on the track, positive to the right [N]."""
    patch_count: Any
    """Number of contact patches found on both sides."""
    fallback_count: Any
    """How often a solver fell back to a simpler model since initialization, on both sides."""
    right_wheel_force_x: Any
    """Right side: Longitudinal force on the wheel [N]."""
    right_wheel_force_y: Any
    """Right side: Lateral force on the wheel [N]."""
    right_wheel_force_z: Any
    """Right side: Vertical force on the wheel, down: negative in contact [N]."""
    right_wheel_moment_x: Any
    """Right side: Moment on the wheel about the wheel marker, x component in the track frame [N.m]."""
    right_wheel_moment_y: Any
    """Right side: Moment on the wheel about the wheel marker, y component in the track frame [N.m]."""
    right_wheel_moment_z: Any
    """Right side: Moment on the wheel about the wheel marker, z component in the track frame [N.m]."""
    right_rail1_force_x: Any
    """Right side: Longitudinal force on rail 1 [N]."""
    right_rail1_force_y: Any
    """Right side: Lateral force on rail 1 [N]."""
    right_rail1_force_z: Any
    """Right side: Vertical force on rail 1, down: positive in contact [N]."""
    right_rail1_moment_x: Any
    """Right side: Moment on rail 1 about its marker, x component in the track frame [N.m]."""
    right_rail1_moment_y: Any
    """Right side: Moment on rail 1 about its marker, y component in the track frame [N.m]."""
    right_rail1_moment_z: Any
    """Right side: Moment on rail 1 about its marker, z component in the track frame [N.m]."""
    right_rail2_force_x: Any
    """Right side: Longitudinal force on rail 2 [N]."""
    right_rail2_force_y: Any
    """Right side: Lateral force on rail 2 [N]."""
    right_rail2_force_z: Any
    """Right side: Vertical force on rail 2, down: positive in contact [N]."""
    right_rail2_moment_x: Any
    """Right side: Moment on rail 2 about its marker, x component in the track frame [N.m]."""
    right_rail2_moment_y: Any
    """Right side: Moment on rail 2 about its marker, y component in the track frame [N.m]."""
    right_rail2_moment_z: Any
    """Right side: Moment on rail 2 about its marker, z component in the track frame [N.m]."""
    right_vertical_wheel_z: Any
    """Right side: Height of the wheel marker at which the rails carry wheel.load; wheel.z where the height is given [m]."""
    right_vertical_load_carried: Any
    """Right side: Vertical force, down, that all rails together carry; with vertical.mode load it is wheel.load, but where the rails cannot carry that [N]."""
    right_foundation_deflection_y: Any
    """Right side: Lateral deflection of the rails on track.foundation, in their frame; rail[1].y comes on top [m]."""
    right_foundation_deflection_z: Any
    """Right side: Vertical deflection of the rails on track.foundation, down; rail[1].z comes on top [m]."""
    right_foundation_velocity_y: Any
    """Right side: Lateral velocity of rails with a mass [m/s]."""
    right_foundation_velocity_z: Any
    """Right side: Vertical velocity of rails with a mass, down [m/s]."""
    right_foundation_step_error: Any
    """Right side: Greatest error that a step of the last fmi2DoStep is estimated to have left in the deflection of rails with a mass; a bound rather than a guess, as it is that of a step of first order [m]."""
    right_patch_count: Any
    """Right side: Number of contact patches found; any number acts, the heaviest 8 are reported."""
    right_fallback_count: Any
    """Right side: How often a solver fell back to a simpler model since initialization."""
    right_solution_normal_residual: Any
    """Right side: Largest distance left between surfaces that carry pressure, or overlap left elsewhere, over the greatest overlap, of boundary elements, and of strips before their last Newton step; 0 where normal.model does not tell it [-]."""
    right_solution_tangential_residual: Any
    """Right side: Largest slip that contradicts the friction law, over the largest rigid slip, of boundary elements; of strips the greatest part of their bound by which tractions do; 0 where tangential.model does not tell it [-]."""
    right_wear_number: Any
    """Right side: Wear number (T-gamma): energy dissipated per distance, spin included [J/m]."""
    right_frictional_power: Any
    """Right side: Power turned into heat in all patches [W]."""
    right_patch1_rail: Any
    """Right side: Rail on which patch 1 lies; 0 when there is no such patch."""
    right_patch2_rail: Any
    """Right side: Rail on which patch 2 lies; 0 when there is no such patch."""
    right_patch3_rail: Any
    """Right side: Rail on which patch 3 lies; 0 when there is no such patch."""
    right_patch4_rail: Any
    """Right side: Rail on which patch 4 lies; 0 when there is no such patch."""
    right_patch5_rail: Any
    """Right side: Rail on which patch 5 lies; 0 when there is no such patch."""
    right_patch6_rail: Any
    """Right side: Rail on which patch 6 lies; 0 when there is no such patch."""
    right_patch7_rail: Any
    """Right side: Rail on which patch 7 lies; 0 when there is no such patch."""
    right_patch8_rail: Any
    """Right side: Rail on which patch 8 lies; 0 when there is no such patch."""
    right_patch1_normal_force: Any
    """Right side: Normal force of patch 1, damping included [N]."""
    right_patch1_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch1_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch1_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch1_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch1_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch1_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch1_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch1_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch1_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch1_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch1_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch1_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch1_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch1_width: Any
    """Right side: Extent across [m]."""
    right_patch1_area: Any
    """Right side: Area [m2]."""
    right_patch1_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch1_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch1_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch1_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch1_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch1_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch1_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch1_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch1_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    right_patch2_normal_force: Any
    """Right side: Normal force of patch 2, damping included [N]."""
    right_patch2_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch2_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch2_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch2_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch2_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch2_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch2_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch2_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch2_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch2_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch2_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch2_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch2_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch2_width: Any
    """Right side: Extent across [m]."""
    right_patch2_area: Any
    """Right side: Area [m2]."""
    right_patch2_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch2_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch2_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch2_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch2_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch2_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch2_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch2_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch2_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    right_patch3_normal_force: Any
    """Right side: Normal force of patch 3, damping included [N]."""
    right_patch3_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch3_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch3_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch3_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch3_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch3_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch3_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch3_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch3_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch3_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch3_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch3_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch3_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch3_width: Any
    """Right side: Extent across [m]."""
    right_patch3_area: Any
    """Right side: Area [m2]."""
    right_patch3_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch3_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch3_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch3_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch3_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch3_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch3_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch3_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch3_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    right_patch4_normal_force: Any
    """Right side: Normal force of patch 4, damping included [N]."""
    right_patch4_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch4_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch4_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch4_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch4_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch4_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch4_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch4_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch4_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch4_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch4_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch4_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch4_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch4_width: Any
    """Right side: Extent across [m]."""
    right_patch4_area: Any
    """Right side: Area [m2]."""
    right_patch4_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch4_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch4_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch4_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch4_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch4_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch4_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch4_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch4_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    right_patch5_normal_force: Any
    """Right side: Normal force of patch 5, damping included [N]."""
    right_patch5_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch5_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch5_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch5_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch5_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch5_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch5_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch5_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch5_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch5_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch5_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch5_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch5_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch5_width: Any
    """Right side: Extent across [m]."""
    right_patch5_area: Any
    """Right side: Area [m2]."""
    right_patch5_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch5_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch5_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch5_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch5_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch5_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch5_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch5_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch5_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    right_patch6_normal_force: Any
    """Right side: Normal force of patch 6, damping included [N]."""
    right_patch6_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch6_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch6_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch6_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch6_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch6_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch6_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch6_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch6_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch6_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch6_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch6_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch6_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch6_width: Any
    """Right side: Extent across [m]."""
    right_patch6_area: Any
    """Right side: Area [m2]."""
    right_patch6_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch6_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch6_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch6_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch6_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch6_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch6_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch6_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch6_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    right_patch7_normal_force: Any
    """Right side: Normal force of patch 7, damping included [N]."""
    right_patch7_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch7_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch7_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch7_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch7_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch7_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch7_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch7_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch7_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch7_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch7_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch7_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch7_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch7_width: Any
    """Right side: Extent across [m]."""
    right_patch7_area: Any
    """Right side: Area [m2]."""
    right_patch7_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch7_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch7_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch7_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch7_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch7_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch7_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch7_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch7_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    right_patch8_normal_force: Any
    """Right side: Normal force of patch 8, damping included [N]."""
    right_patch8_creep_force_x: Any
    """Right side: Longitudinal creep force on the wheel [N]."""
    right_patch8_creep_force_y: Any
    """Right side: Lateral creep force on the wheel, in the contact plane [N]."""
    right_patch8_spin_moment: Any
    """Right side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    right_patch8_contact_angle: Any
    """Right side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    right_patch8_position_x: Any
    """Right side: Centroid of the normal load in the track frame, x [m]."""
    right_patch8_position_y: Any
    """Right side: Centroid of the normal load in the track frame, y [m]."""
    right_patch8_position_z: Any
    """Right side: Centroid of the normal load in the track frame, z [m]."""
    right_patch8_wheel_y: Any
    """Right side: Lateral coordinate of the centroid on the wheel profile [m]."""
    right_patch8_rail_y: Any
    """Right side: Lateral coordinate of the centroid on the rail profile [m]."""
    right_patch8_rolling_radius: Any
    """Right side: Distance of the contact point from the axle [m]."""
    right_patch8_penetration: Any
    """Right side: Overlap of the undeformed bodies along the contact normal [m]."""
    right_patch8_max_pressure: Any
    """Right side: Greatest contact pressure [Pa]."""
    right_patch8_length: Any
    """Right side: Greatest extent along x [m]."""
    right_patch8_width: Any
    """Right side: Extent across [m]."""
    right_patch8_area: Any
    """Right side: Area [m2]."""
    right_patch8_creepage_longitudinal: Any
    """Right side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    right_patch8_creepage_lateral: Any
    """Right side: Lateral creepage, in the contact plane [-]."""
    right_patch8_creepage_spin: Any
    """Right side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    right_patch8_friction_coefficient: Any
    """Right side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    right_patch8_temperature: Any
    """Right side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    right_patch8_slip_share: Any
    """Right side: Share of the area that slips [-]."""
    right_patch8_frictional_power: Any
    """Right side: Power turned into heat [W]."""
    right_patch8_tgamma_damage: Any
    """Right side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    right_patch8_surface_fatigue_index: Any
    """Right side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_wheel_force_x: Any
    """Left side: Longitudinal force on the wheel [N]."""
    left_wheel_force_y: Any
    """Left side: Lateral force on the wheel [N]."""
    left_wheel_force_z: Any
    """Left side: Vertical force on the wheel, down: negative in contact [N]."""
    left_wheel_moment_x: Any
    """Left side: Moment on the wheel about the wheel marker, x component in the track frame [N.m]."""
    left_wheel_moment_y: Any
    """Left side: Moment on the wheel about the wheel marker, y component in the track frame [N.m]."""
    left_wheel_moment_z: Any
    """Left side: Moment on the wheel about the wheel marker, z component in the track frame [N.m]."""
    left_rail1_force_x: Any
    """Left side: Longitudinal force on rail 1 [N]."""
    left_rail1_force_y: Any
    """Left side: Lateral force on rail 1 [N]."""
    left_rail1_force_z: Any
    """Left side: Vertical force on rail 1, down: positive in contact [N]."""
    left_rail1_moment_x: Any
    """Left side: Moment on rail 1 about its marker, x component in the track frame [N.m]."""
    left_rail1_moment_y: Any
    """Left side: Moment on rail 1 about its marker, y component in the track frame [N.m]."""
    left_rail1_moment_z: Any
    """Left side: Moment on rail 1 about its marker, z component in the track frame [N.m]."""
    left_rail2_force_x: Any
    """Left side: Longitudinal force on rail 2 [N]."""
    left_rail2_force_y: Any
    """Left side: Lateral force on rail 2 [N]."""
    left_rail2_force_z: Any
    """Left side: Vertical force on rail 2, down: positive in contact [N]."""
    left_rail2_moment_x: Any
    """Left side: Moment on rail 2 about its marker, x component in the track frame [N.m]."""
    left_rail2_moment_y: Any
    """Left side: Moment on rail 2 about its marker, y component in the track frame [N.m]."""
    left_rail2_moment_z: Any
    """Left side: Moment on rail 2 about its marker, z component in the track frame [N.m]."""
    left_vertical_wheel_z: Any
    """Left side: Height of the wheel marker at which the rails carry wheel.load; wheel.z where the height is given [m]."""
    left_vertical_load_carried: Any
    """Left side: Vertical force, down, that all rails together carry; with vertical.mode load it is wheel.load, but where the rails cannot carry that [N]."""
    left_foundation_deflection_y: Any
    """Left side: Lateral deflection of the rails on track.foundation, in their frame; rail[1].y comes on top [m]."""
    left_foundation_deflection_z: Any
    """Left side: Vertical deflection of the rails on track.foundation, down; rail[1].z comes on top [m]."""
    left_foundation_velocity_y: Any
    """Left side: Lateral velocity of rails with a mass [m/s]."""
    left_foundation_velocity_z: Any
    """Left side: Vertical velocity of rails with a mass, down [m/s]."""
    left_foundation_step_error: Any
    """Left side: Greatest error that a step of the last fmi2DoStep is estimated to have left in the deflection of rails with a mass; a bound rather than a guess, as it is that of a step of first order [m]."""
    left_patch_count: Any
    """Left side: Number of contact patches found; any number acts, the heaviest 8 are reported."""
    left_fallback_count: Any
    """Left side: How often a solver fell back to a simpler model since initialization."""
    left_solution_normal_residual: Any
    """Left side: Largest distance left between surfaces that carry pressure, or overlap left elsewhere, over the greatest overlap, of boundary elements, and of strips before their last Newton step; 0 where normal.model does not tell it [-]."""
    left_solution_tangential_residual: Any
    """Left side: Largest slip that contradicts the friction law, over the largest rigid slip, of boundary elements; of strips the greatest part of their bound by which tractions do; 0 where tangential.model does not tell it [-]."""
    left_wear_number: Any
    """Left side: Wear number (T-gamma): energy dissipated per distance, spin included [J/m]."""
    left_frictional_power: Any
    """Left side: Power turned into heat in all patches [W]."""
    left_patch1_rail: Any
    """Left side: Rail on which patch 1 lies; 0 when there is no such patch."""
    left_patch2_rail: Any
    """Left side: Rail on which patch 2 lies; 0 when there is no such patch."""
    left_patch3_rail: Any
    """Left side: Rail on which patch 3 lies; 0 when there is no such patch."""
    left_patch4_rail: Any
    """Left side: Rail on which patch 4 lies; 0 when there is no such patch."""
    left_patch5_rail: Any
    """Left side: Rail on which patch 5 lies; 0 when there is no such patch."""
    left_patch6_rail: Any
    """Left side: Rail on which patch 6 lies; 0 when there is no such patch."""
    left_patch7_rail: Any
    """Left side: Rail on which patch 7 lies; 0 when there is no such patch."""
    left_patch8_rail: Any
    """Left side: Rail on which patch 8 lies; 0 when there is no such patch."""
    left_patch1_normal_force: Any
    """Left side: Normal force of patch 1, damping included [N]."""
    left_patch1_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch1_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch1_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch1_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch1_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch1_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch1_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch1_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch1_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch1_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch1_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch1_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch1_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch1_width: Any
    """Left side: Extent across [m]."""
    left_patch1_area: Any
    """Left side: Area [m2]."""
    left_patch1_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch1_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch1_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch1_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch1_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch1_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch1_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch1_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch1_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_patch2_normal_force: Any
    """Left side: Normal force of patch 2, damping included [N]."""
    left_patch2_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch2_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch2_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch2_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch2_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch2_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch2_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch2_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch2_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch2_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch2_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch2_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch2_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch2_width: Any
    """Left side: Extent across [m]."""
    left_patch2_area: Any
    """Left side: Area [m2]."""
    left_patch2_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch2_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch2_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch2_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch2_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch2_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch2_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch2_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch2_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_patch3_normal_force: Any
    """Left side: Normal force of patch 3, damping included [N]."""
    left_patch3_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch3_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch3_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch3_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch3_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch3_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch3_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch3_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch3_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch3_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch3_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch3_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch3_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch3_width: Any
    """Left side: Extent across [m]."""
    left_patch3_area: Any
    """Left side: Area [m2]."""
    left_patch3_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch3_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch3_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch3_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch3_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch3_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch3_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch3_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch3_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_patch4_normal_force: Any
    """Left side: Normal force of patch 4, damping included [N]."""
    left_patch4_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch4_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch4_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch4_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch4_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch4_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch4_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch4_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch4_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch4_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch4_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch4_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch4_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch4_width: Any
    """Left side: Extent across [m]."""
    left_patch4_area: Any
    """Left side: Area [m2]."""
    left_patch4_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch4_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch4_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch4_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch4_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch4_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch4_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch4_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch4_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_patch5_normal_force: Any
    """Left side: Normal force of patch 5, damping included [N]."""
    left_patch5_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch5_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch5_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch5_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch5_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch5_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch5_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch5_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch5_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch5_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch5_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch5_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch5_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch5_width: Any
    """Left side: Extent across [m]."""
    left_patch5_area: Any
    """Left side: Area [m2]."""
    left_patch5_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch5_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch5_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch5_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch5_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch5_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch5_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch5_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch5_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_patch6_normal_force: Any
    """Left side: Normal force of patch 6, damping included [N]."""
    left_patch6_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch6_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch6_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch6_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch6_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch6_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch6_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch6_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch6_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch6_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch6_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch6_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch6_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch6_width: Any
    """Left side: Extent across [m]."""
    left_patch6_area: Any
    """Left side: Area [m2]."""
    left_patch6_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch6_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch6_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch6_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch6_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch6_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch6_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch6_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch6_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_patch7_normal_force: Any
    """Left side: Normal force of patch 7, damping included [N]."""
    left_patch7_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch7_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch7_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch7_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch7_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch7_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch7_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch7_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch7_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch7_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch7_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch7_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch7_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch7_width: Any
    """Left side: Extent across [m]."""
    left_patch7_area: Any
    """Left side: Area [m2]."""
    left_patch7_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch7_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch7_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch7_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch7_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch7_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch7_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch7_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch7_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
    left_patch8_normal_force: Any
    """Left side: Normal force of patch 8, damping included [N]."""
    left_patch8_creep_force_x: Any
    """Left side: Longitudinal creep force on the wheel [N]."""
    left_patch8_creep_force_y: Any
    """Left side: Lateral creep force on the wheel, in the contact plane [N]."""
    left_patch8_spin_moment: Any
    """Left side: Moment of the tractions on the wheel about the contact normal, at the position of the patch [N.m]."""
    left_patch8_contact_angle: Any
    """Left side: Roll of the contact frame about the track's x axis, negative on the right tread [rad]."""
    left_patch8_position_x: Any
    """Left side: Centroid of the normal load in the track frame, x [m]."""
    left_patch8_position_y: Any
    """Left side: Centroid of the normal load in the track frame, y [m]."""
    left_patch8_position_z: Any
    """Left side: Centroid of the normal load in the track frame, z [m]."""
    left_patch8_wheel_y: Any
    """Left side: Lateral coordinate of the centroid on the wheel profile [m]."""
    left_patch8_rail_y: Any
    """Left side: Lateral coordinate of the centroid on the rail profile [m]."""
    left_patch8_rolling_radius: Any
    """Left side: Distance of the contact point from the axle [m]."""
    left_patch8_penetration: Any
    """Left side: Overlap of the undeformed bodies along the contact normal [m]."""
    left_patch8_max_pressure: Any
    """Left side: Greatest contact pressure [Pa]."""
    left_patch8_length: Any
    """Left side: Greatest extent along x [m]."""
    left_patch8_width: Any
    """Left side: Extent across [m]."""
    left_patch8_area: Any
    """Left side: Area [m2]."""
    left_patch8_creepage_longitudinal: Any
    """Left side: Longitudinal creepage: wheel minus rail over the reference speed [-]."""
    left_patch8_creepage_lateral: Any
    """Left side: Lateral creepage, in the contact plane [-]."""
    left_patch8_creepage_spin: Any
    """Left side: Spin creepage: relative angular velocity about the contact normal over the reference speed [1/m]."""
    left_patch8_friction_coefficient: Any
    """Left side: Coefficient of friction as slip and heat leave it, the mean over the load [-]."""
    left_patch8_temperature: Any
    """Left side: Mean rise of temperature over the pressure as if all of the patch slid; 0 unless friction.temperature.share is below 1 [K]."""
    left_patch8_slip_share: Any
    """Left side: Share of the area that slips [-]."""
    left_patch8_frictional_power: Any
    """Left side: Power turned into heat [W]."""
    left_patch8_tgamma_damage: Any
    """Left side: T-gamma damage of the rail by one passage, as a share of its life; negative where wear outruns cracks; experimental: not checked against its source [-]."""
    left_patch8_surface_fatigue_index: Any
    """Left side: Surface fatigue index; above 0 the surface ratchets; experimental: not checked against its source [-]."""
