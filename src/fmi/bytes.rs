//! A saved state as bytes: versioned, and checked when it is read.
//!
//! ```text
//! tag, format, GUID                 what it is, and of which variables
//! purpose, life, prepared, evaluated
//!                                   one byte each; evaluated is 2 where outputs are held
//! experiment, time
//! nominal heights
//! inputs and parameters             in the order of the variables
//! derivatives of inputs             their number, then reference, three numbers each
//! last step                         one byte whether it is kept; its length, pairs of force and velocity
//! energy residual
//! whole numbers of the last event
//! of each element:
//! fallbacks
//! rails with a mass                 one byte whether they have been moved on; deflection, velocity, error of the last step
//! contact                           one byte whether it remembers; how many numbers, and these
//! wear                              one byte whether there is any; clock; wheel and rails:
//!                                   one byte whether it is there, number of cells, totals and
//!                                   sums since the last update, three numbers
//! outputs                           where they are held, in the order of the variables
//! checksum                          CRC-32 of all before
//! ```
//!
//! Numbers are little-endian; a text has its length before it. Outputs follow from the inputs, but
//! those of steps whose contacts remember, which are held.

mod layout;
mod reader;
mod writer;

pub use reader::read;
pub use writer::write;

#[cfg(test)]
mod tests {
    use super::layout::TAG;
    use super::*;
    use crate::element::Element;
    use crate::fmi::instance::Instance;
    use crate::fmi::interface::Interface;
    use crate::fmi::life_cycle::Purpose;
    use crate::fmi::logger::Logger;
    use crate::fmi::snapshot::Snapshot;
    use crate::variables::Described;
    use crate::wheelset::Wheelset;

    fn saved<S: Described>() -> Snapshot<S> {
        let (purpose, starts) = (Purpose::CoSimulation, Box::default());
        let mut instance = Instance::<S>::new(Interface::V2, purpose, Vec::new(), starts, false);
        instance.setup_experiment(None, 0.5, Some(2.0)).unwrap();
        instance.enter_initialization().unwrap();
        instance.exit_initialization(&Logger::silent()).unwrap();
        instance.step(0.5, 0.25, &Logger::silent()).unwrap();
        let key = instance.save(std::ptr::null_mut()).unwrap();
        instance.saved(key).unwrap().clone()
    }

    fn comes_back<S: Described>() {
        let state = saved::<S>();
        let read = read::<S>(&write(&state)).unwrap();
        assert_eq!(read.values, state.values);
        assert_eq!((read.state, read.experiment), (state.state, state.experiment));
        assert_eq!(read.time.to_bits(), 0.75_f64.to_bits());
        assert_eq!(read.memories, state.memories);
    }

    #[test]
    fn what_is_written_is_read() {
        comes_back::<Element>();
        comes_back::<Wheelset>();
    }

    #[test]
    fn every_damaged_byte_and_every_cut_is_found() {
        let bytes = write(&saved::<Element>());
        for i in 0..bytes.len() {
            assert!(read::<Element>(&bytes[..i]).is_err(), "cut after {i}");
            for bit in 0..8 {
                let mut damaged = bytes.clone();
                damaged[i] ^= 1 << bit;
                assert!(read::<Element>(&damaged).is_err(), "bit {bit} of byte {i}");
            }
        }
        let longer = [&*bytes, &[0]].concat();
        assert!(read::<Element>(&longer).is_err());
    }

    #[test]
    fn bytes_with_a_good_checksum_and_bad_values_are_refused() {
        let mut state = saved::<Element>();
        state.values.input.friction = -1.0;
        assert!(read::<Element>(&write(&state)).unwrap_err().to_string().contains("damaged"));
        state = saved();
        state.time = f64::NAN;
        assert!(read::<Element>(&write(&state)).is_err());
        state = saved();
        state.values.nominal = f64::INFINITY;
        assert!(read::<Element>(&write(&state)).is_err());
    }

    #[test]
    fn the_message_tells_foreign_from_old_bytes() {
        let bytes = write(&saved::<Element>());
        let message = |bytes: &[u8]| read::<Element>(bytes).unwrap_err().to_string();
        assert!(message(b"something else").contains("no state"));
        let mut other = bytes.clone();
        other[TAG.len()] = 9;
        assert!(message(&other).contains("format 9"));
        let mut other = bytes.clone();
        other[TAG.len() + 8] ^= 1;
        let end = other.len() - 4;
        let checksum = crc32fast::hash(&other[..end]);
        other[end..].copy_from_slice(&checksum.to_le_bytes());
        assert!(message(&other).contains("GUID"));
        assert!(
            message(&write(&saved::<Wheelset>()))
                .contains("is of WheelSet, this unit is WheelRail")
        );
        let error = read::<Wheelset>(&bytes).unwrap_err().to_string();
        assert!(error.contains("is of WheelRail, this unit is WheelSet"), "{error}");
    }
}
