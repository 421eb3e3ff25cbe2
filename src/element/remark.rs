//! What is odd about an evaluation, in words: the cause, the place with its numbers, and the remedy.
//! The C interface, Python and the command line all tell these.

use std::fmt;

use super::start_warning::StartWarning;

/// Something that is not refused, but worth knowing before one wonders at the forces.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// The place in which a wheel stands.
    Place(StartWarning),
    /// The wheel is so deep in a rail that the outlines tell no force.
    Sunk {
        /// Depth below the top of the rail [m].
        depth: f64,
    },
    /// The rails do not carry the given load.
    LoadMissed {
        /// The load [N].
        load: f64,
        /// What they carry [N].
        carried: f64,
    },
    /// Contacts or zones found no room, or a solver fell back to a simpler model.
    Fallback {
        /// How often [-].
        count: u64,
    },
    /// The wheel slides all over, far from rolling.
    Slides {
        /// Number of the rail.
        rail: usize,
        /// Share of the greater one of the two speeds that they differ by [-].
        slip: f64,
        /// Rate of the pitch angle at which it rolls freely, on a rail that does not turn [rad/s].
        rolling: Option<f64>,
    },
    /// A contact at the end of a profile: an edge of which the profile tells nothing.
    ProfileEnd {
        /// Number of the rail.
        rail: usize,
        /// Whether the rail's profile ends there; otherwise the wheel's.
        of_rail: bool,
        /// Place on that profile [m].
        y: f64,
        /// Greatest pressure of the patch [Pa].
        pressure: f64,
        /// Whether boundary elements were asked, which are no reference there.
        is_reference: bool,
    },
    /// Wheel and rail are of materials so unlike that the pressure makes creep forces, which are left
    /// out.
    UnlikeMaterials {
        /// K, see [`MaterialPair`](crate::material::MaterialPair) [-].
        coupling: f64,
        /// Whether the models would have it, but pressure and tractions did not settle; otherwise the
        /// models leave it out.
        did_not_settle: bool,
    },
    /// More friction than there is between any two bodies.
    Friction {
        /// Number of the rail.
        rail: usize,
        /// The coefficient [-].
        coefficient: f64,
    },
    /// An input that was given has no effect with the parameters as they are.
    NoEffect {
        /// Its name without that of the wheel.
        input: &'static str,
        /// The parameter that says so.
        parameter: &'static str,
        /// The item it has.
        chosen: &'static str,
        /// The item with which the input counts.
        with: &'static str,
    },
}

impl Remark {
    /// How many kinds there are.
    pub const KINDS: usize = 14;

    /// The kind, as a number below [`KINDS`](Self::KINDS): each is told once.
    pub fn kind(&self) -> usize {
        match self {
            Self::Place(StartWarning::BesideTheRails { .. }) => 0,
            Self::Place(StartWarning::InTheAir { .. }) => 1,
            Self::Place(StartWarning::InsideARail { .. }) => 2,
            Self::Place(StartWarning::InRail2 { .. }) => 3,
            Self::Sunk { .. } => 4,
            Self::LoadMissed { .. } => 5,
            Self::Fallback { .. } => 6,
            Self::Slides { .. } => 7,
            Self::ProfileEnd { of_rail, .. } => 8 + usize::from(*of_rail),
            Self::NoEffect { .. } => 10,
            Self::Place(StartWarning::BeginsAtOnce { .. }) => 11,
            Self::UnlikeMaterials { .. } => 12,
            Self::Friction { .. } => 13,
        }
    }

    /// Whether it is counted in [`Output::fallback_count`](super::Output::fallback_count).
    pub fn is_a_fallback(&self) -> bool {
        matches!(self, Self::Sunk { .. } | Self::LoadMissed { .. } | Self::Fallback { .. })
    }

    /// The kind in a few words, for counts.
    pub fn title(&self) -> &'static str {
        match self {
            Self::Place(StartWarning::BesideTheRails { .. }) => "beside the rails",
            Self::Place(StartWarning::InTheAir { .. }) => "in the air",
            Self::Place(StartWarning::InsideARail { .. }) => "inside a rail",
            Self::Place(StartWarning::InRail2 { .. }) => "in rail[2]",
            Self::Place(StartWarning::BeginsAtOnce { .. }) => "force begins with a jump",
            Self::Sunk { .. } => "too deep for a force",
            Self::LoadMissed { .. } => "load not carried",
            Self::Fallback { .. } => "no room, or a simpler model",
            Self::Slides { .. } => "sliding, not rolling",
            Self::ProfileEnd { of_rail: false, .. } => "contact at the end of the wheel's profile",
            Self::ProfileEnd { of_rail: true, .. } => "contact at the end of a rail's profile",
            Self::UnlikeMaterials { .. } => "unlike materials",
            Self::Friction { .. } => "friction beyond all measure",
            Self::NoEffect { .. } => "input without effect",
        }
    }

    /// The words for it; `prefix` stands before the names of variables of this wheel in a wheelset.
    /// They are written where they go, so that nothing is allocated for them.
    pub fn message<'a>(&self, prefix: &'a str) -> impl fmt::Display + 'a {
        Message { remark: *self, prefix }
    }
}

struct Message<'a> {
    remark: Remark,
    prefix: &'a str,
}

impl fmt::Display for Message<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let prefix = self.prefix;
        // The motion of a wheelset is that of its centre.
        let body = if prefix.is_empty() { "wheel" } else { "wheelset" };
        match self.remark {
            Remark::Place(place) => f.write_str(&place.message(prefix)),
            Remark::Sunk { depth } => write!(
                f,
                "the wheel is {:.1} mm below the top of its rail, deeper than the outlines tell a force: it carries nothing there, and is not \
                 lifted; see {prefix}nominal.wheel_z for where it would just touch",
                1e3 * depth
            ),
            Remark::LoadMissed { load, carried } => write!(
                f,
                "{prefix}wheel.load = {load} N, but the rails carry {carried:.0} N where the wheel is: {prefix}vertical.load_carried says how \
                 much; look at wheel.y and the load, or take another normal.model"
            ),
            Remark::Fallback { count } => write!(
                f,
                "a contact found no room, or a solver fell back to a simpler model: fallback_count = {count}"
            ),
            Remark::Slides { rail, slip, rolling } => {
                write!(
                    f,
                    "the wheel slides on {prefix}rail[{rail}] with a slip of {:.0} %",
                    1e2 * slip
                )?;
                match rolling {
                    Some(rate) => write!(
                        f,
                        "; it rolls freely at {body}.pitch_rate = {rate:.5} rad/s, which is -{body}.vx over the rolling radius; motion = rolling \
                         turns it so by its nominal radius"
                    ),
                    None => {
                        write!(f, "; look at {body}.pitch_rate and {prefix}rail[{rail}].pitch_rate")
                    }
                }
            }
            Remark::ProfileEnd { rail, of_rail, y, pressure, is_reference } => {
                write!(f, "the contact with {prefix}rail[{rail}] lies at the end of ")?;
                if of_rail {
                    write!(f, "{prefix}rail[{rail}].profile")?;
                } else {
                    write!(f, "{prefix}wheel.profile")?;
                }
                write!(
                    f,
                    ", y = {:.2} mm: the body is cut off there and bears on an edge, with {:.1} GPa; move the wheel, or give a profile that goes \
                     on",
                    1e3 * y,
                    1e-9 * pressure
                )?;
                if is_reference {
                    f.write_str("; boundary elements are no reference on an edge")?;
                }
                Ok(())
            }
            Remark::UnlikeMaterials { coupling, did_not_settle } => {
                write!(
                    f,
                    "{prefix}wheel and rails are of unlike materials, K = {coupling:.4}: the pressure alone shifts the creepage of free rolling \
                     by some K a/R, a half the length of a patch and R the radius; "
                )?;
                f.write_str(if did_not_settle {
                    "pressure and tractions did not settle together, and that is left out here; fewer elements may settle"
                } else {
                    "that is left out here, boundary elements for both models have it on bodies even along the track"
                })
            }
            Remark::Friction { rail, coefficient } => write!(
                f,
                "the coefficient of friction on {prefix}rail[{rail}] is {coefficient}: dry rails have 0.3 to 0.6; in percent it is a hundred times \
                 too much"
            ),
            Remark::NoEffect { input, parameter, chosen, with } => {
                let of_side = if input.starts_with("wheelset.") { "" } else { prefix };
                write!(
                    f,
                    "{of_side}{input} has no effect with {parameter} = {chosen}: it has with \"{with}\""
                )
            }
        }
    }
}
