//! Raw arguments of the host as slices and texts.
#![allow(unsafe_code)]

use std::cell::Cell;
use std::ffi::CStr;
use std::slice;

use crate::fmi::error::FmiError;
use crate::fmi::types::Text;

/// What a host hands over by a pointer to its first element and a count.
pub trait Pointed<Count>: Sized {
    /// The same as Rust has it.
    type Lent<'a>;

    /// What the pointer points to; count 0 accepts null.
    ///
    /// # Safety
    /// FMI 2.0, 2.1.7, and FMI 3.0, 2.2.6: an argument array holds as many elements as its count
    /// says and stays for the call. No other argument overlaps one that is written.
    unsafe fn lend<'a>(self, name: &'static str, count: Count) -> Result<Self::Lent<'a>, FmiError>;
}

/// The count where a function gives one value through a pointer.
#[derive(Clone, Copy, Debug)]
pub struct One;

impl<T: 'static> Pointed<usize> for *const T {
    type Lent<'a> = &'a [T];

    unsafe fn lend<'a>(self, name: &'static str, count: usize) -> Result<&'a [T], FmiError> {
        check_array(name, self, count)?;
        // SAFETY: the caller's promise; null, alignment and size were checked.
        Ok(if count == 0 { &[] } else { unsafe { slice::from_raw_parts(self, count) } })
    }
}

impl<T: 'static> Pointed<usize> for *mut T {
    type Lent<'a> = &'a mut [T];

    unsafe fn lend<'a>(self, name: &'static str, count: usize) -> Result<&'a mut [T], FmiError> {
        check_array(name, self, count)?;
        // SAFETY: the caller's promise; null, alignment and size were checked.
        Ok(if count == 0 { &mut [] } else { unsafe { slice::from_raw_parts_mut(self, count) } })
    }
}

impl<T: 'static> Pointed<One> for *mut T {
    /// A cell: hosts hand over one place for several values that they do not read.
    type Lent<'a> = &'a Cell<T>;

    unsafe fn lend<'a>(self, name: &'static str, _: One) -> Result<&'a Cell<T>, FmiError> {
        check_array(name, self, 1)?;
        // SAFETY: the caller's promise; null and alignment were checked, and a cell is as what is
        // in it.
        Ok(unsafe { &*self.cast::<Cell<T>>() })
    }
}

fn check_array<T>(name: &'static str, start: *const T, count: usize) -> Result<(), FmiError> {
    if count > 0 && start.is_null() {
        return Err(FmiError::NullPointer(name));
    }
    if count > isize::MAX as usize / size_of::<T>() || (count > 0 && !start.is_aligned()) {
        let allowed = "an aligned array of a count that fits into memory";
        return Err(FmiError::BadArgument { name, value: count as f64, allowed });
    }
    Ok(())
}

/// A text of the host.
///
/// # Safety
/// FMI 2.0, 2.1.2, and FMI 3.0, 2.2.3: a text is null or null-terminated, and stays for the call.
pub unsafe fn text<'a>(name: &'static str, start: Text) -> Result<&'a str, FmiError> {
    if start.is_null() {
        return Err(FmiError::NullPointer(name));
    }
    // SAFETY: FMI 2.0, 2.1.2, and FMI 3.0, 2.2.3, see above; null was checked.
    unsafe { CStr::from_ptr(start) }.to_str().map_err(|_| FmiError::NotUnicode(name))
}

/// A text of the host, empty where it is null.
///
/// # Safety
/// As for [`text`].
pub unsafe fn text_or_empty<'a>(name: &'static str, start: Text) -> Result<&'a str, FmiError> {
    // SAFETY: the caller's promise.
    if start.is_null() { Ok("") } else { unsafe { text(name, start) } }
}

/// The name of an instance, empty where it is null.
///
/// # Safety
/// As for [`text`].
pub unsafe fn name<'a>(start: Text) -> &'a CStr {
    // SAFETY: the caller's promise; null was checked.
    if start.is_null() { c"" } else { unsafe { CStr::from_ptr(start) } }
}

/// Texts of the host, as [`text`].
///
/// # Safety
/// As for [`text`].
pub unsafe fn texts<'a>(name: &'static str, texts: &[Text]) -> Result<Vec<&'a str>, FmiError> {
    // SAFETY: the caller's promise.
    texts.iter().map(|&t| unsafe { text(name, t) }).collect()
}
