"""Inputs and parameters as keywords. Made by make_keywords.py: do not change it by hand."""

from __future__ import annotations

import os
from typing import Literal, TypedDict

import numpy.typing as npt

__all__ = [
    "ElementInputs",
    "ElementParameters",
    "WheelSetInputs",
    "WheelSetParameters",
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
    """Strips: for the model strips over all zones of a rail, at least 8; for the others across each zone."""
    normal_elements_along: int
    """Boundary elements along the extent of a contact; other models do not use it."""
    normal_elements_across: int
    """Boundary elements across the extent of a contact; other models do not use it."""
    creepage_model: Literal["kinematic", "flat", "curved"]
    """How creepage varies over a patch."""
    creepage_minimum_speed: float
    """Floor of the speed to which creepages refer [m/s]."""
    tangential_model: Literal["none", "linear", "fastsim", "fastrip", "tables", "fastsim_corrected", "boundary_element", "strips", "marches"]
    """Tangential contact model."""
    tangential_elements_along: int
    """Elements along each strip."""
    tangential_points: int
    """Points along each strip of the model strips; other models do not use it."""
    tangential_bound: Literal["elliptic", "parabolic"]
    """Shape of the traction bound along a strip."""
    tangential_flexibilities: Literal["three", "blended"]
    """How the flexibilities of the simplified theory enter."""
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
    """Whether contact.stiffness and contact.damping are computed when they are read, and coupling.energy_residual at each step of co-simulation."""
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
    """Strips: for the model strips over all zones of a rail, at least 8; for the others across each zone."""
    normal_elements_along: int
    """Boundary elements along the extent of a contact; other models do not use it."""
    normal_elements_across: int
    """Boundary elements across the extent of a contact; other models do not use it."""
    creepage_model: Literal["kinematic", "flat", "curved"]
    """How creepage varies over a patch."""
    creepage_minimum_speed: float
    """Floor of the speed to which creepages refer [m/s]."""
    tangential_model: Literal["none", "linear", "fastsim", "fastrip", "tables", "fastsim_corrected", "boundary_element", "strips", "marches"]
    """Tangential contact model."""
    tangential_elements_along: int
    """Elements along each strip."""
    tangential_points: int
    """Points along each strip of the model strips; other models do not use it."""
    tangential_bound: Literal["elliptic", "parabolic"]
    """Shape of the traction bound along a strip."""
    tangential_flexibilities: Literal["three", "blended"]
    """How the flexibilities of the simplified theory enter."""
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
    """Whether contact.stiffness and contact.damping are computed when they are read, and coupling.energy_residual at each step of co-simulation."""
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
