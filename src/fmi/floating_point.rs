//! The floating point unit as calculations of this library need it, whatever the host has made of
//! it.
//!
//! Hosts unmask exceptions to find their own faults: a division by zero, or a mere rounding, would
//! end the process with a signal. Others round another way or flush small numbers to zero, which
//! would change the bits of a force. Each call therefore runs with the settings that Rust assumes,
//! and leaves those of the host, flags and all.
#![allow(unsafe_code)]

/// The settings of the host, put back when this is dropped.
#[derive(Debug)]
pub struct OwnSettings {
    of_host: Word,
}

impl OwnSettings {
    /// Takes over the settings of this thread.
    #[inline]
    pub fn apply() -> Self {
        let of_host = read();
        if of_host & SETTINGS != DEFAULT {
            write(DEFAULT);
        }
        Self { of_host }
    }
}

impl Drop for OwnSettings {
    #[inline]
    fn drop(&mut self) {
        // A write costs some nanoseconds, and most hosts have the settings of Rust.
        if self.of_host & SETTINGS != DEFAULT {
            write(self.of_host);
        }
    }
}

#[cfg(target_arch = "x86_64")]
mod register {
    use std::arch::asm;

    /// MXCSR.
    pub type Word = u32;
    /// All of it but the six flags of what has happened.
    pub const SETTINGS: Word = 0xffc0;
    /// All exceptions masked, to nearest, small numbers kept.
    pub const DEFAULT: Word = 0x1f80;

    #[inline]
    pub fn read() -> Word {
        let mut word: Word = 0;
        // SAFETY: stores four bytes at the address of `word`.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut word, options(nostack, preserves_flags)) };
        word
    }

    #[inline]
    pub fn write(word: Word) {
        // SAFETY: loads four bytes from the address of `word`, which came from the register or is
        // its default, so that no reserved bit is set. What calculates stands behind it or before
        // it in program order: the statement may touch memory, as far as the compiler knows.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const word, options(nostack, preserves_flags)) };
    }
}

#[cfg(target_arch = "aarch64")]
mod register {
    use std::arch::asm;

    /// FPCR.
    pub type Word = u64;
    /// Traps, rounding, flushing to zero, other NaN and half precision formats.
    pub const SETTINGS: Word = 0x07ff_9f07;
    /// No traps, to nearest, small numbers kept.
    pub const DEFAULT: Word = 0;

    #[inline]
    pub fn read() -> Word {
        let word: Word;
        // SAFETY: reads a register that every program may read.
        unsafe { asm!("mrs {}, fpcr", out(reg) word, options(nostack, preserves_flags)) };
        word
    }

    #[inline]
    pub fn write(word: Word) {
        // SAFETY: writes what came from the register, or its default.
        unsafe { asm!("msr fpcr, {}", in(reg) word, options(nostack, preserves_flags)) };
    }
}

/// Other processors: left as they are.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod register {
    pub type Word = u32;
    pub const SETTINGS: Word = 0;
    pub const DEFAULT: Word = 0;

    pub fn read() -> Word {
        DEFAULT
    }

    pub fn write(_word: Word) {}
}

use register::{DEFAULT, SETTINGS, Word, read, write};

#[cfg(test)]
#[cfg(target_arch = "x86_64")]
mod tests {
    use super::*;

    #[test]
    fn settings_of_the_host_come_back_with_its_flags() {
        // Upwards, small numbers to zero, and the flag of a rounding.
        let of_host = 0x1f80 | 0x4000 | 0x8000 | 0x20;
        write(of_host);
        let within = {
            let _own = OwnSettings::apply();
            read()
        };
        let after = read();
        write(DEFAULT);
        assert_eq!((within & SETTINGS, after), (DEFAULT, of_host));
    }
}
