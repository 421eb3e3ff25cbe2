//! Raw arguments of the host as slices, texts and targets.
#![allow(unsafe_code)]

use std::ffi::CStr;
use std::slice;

use crate::fmi::error::FmiError;
use crate::fmi::types::{Status, Text};

/// An array of the host as a slice; count 0 accepts null.
///
/// # Safety
/// FMI 2.0, 2.1.7, and FMI 3.0, 2.2.6: an argument array holds as many elements as its count says
/// and stays for the call.
pub unsafe fn array<'a, T>(
    name: &'static str,
    start: *const T,
    count: usize,
) -> Result<&'a [T], FmiError> {
    check_array(name, start, count)?;
    if count == 0 {
        return Ok(&[]);
    }
    // SAFETY: FMI 2.0, 2.1.7, and FMI 3.0, 2.2.6, see above; null, alignment and size were checked.
    Ok(unsafe { slice::from_raw_parts(start, count) })
}

/// An array of the host to be written; count 0 accepts null.
///
/// # Safety
/// As for [`array`], and no other argument overlaps it.
pub unsafe fn array_mut<'a, T>(
    name: &'static str,
    start: *mut T,
    count: usize,
) -> Result<&'a mut [T], FmiError> {
    check_array(name, start, count)?;
    if count == 0 {
        return Ok(&mut []);
    }
    // SAFETY: FMI 2.0, 2.1.7, and FMI 3.0, 2.2.6, see above; null, alignment and size were checked.
    Ok(unsafe { slice::from_raw_parts_mut(start, count) })
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

/// Texts of the host, as [`text`].
///
/// # Safety
/// As for [`array`] and [`text`].
pub unsafe fn texts<'a>(
    name: &'static str,
    start: *const Text,
    count: usize,
) -> Result<Vec<&'a str>, FmiError> {
    // SAFETY: FMI 2.0, 2.1.2 and 2.1.7: the caller's promise is that of both functions.
    unsafe { array(name, start, count)?.iter().map(|&t| text(name, t)).collect() }
}

/// Writes one value through a pointer of the host.
///
/// # Safety
/// As for [`array_mut`] with one element.
pub unsafe fn write<T>(name: &'static str, target: *mut T, value: T) -> Result<Status, FmiError> {
    // SAFETY: FMI 2.0, 2.1.7, and FMI 3.0, 2.2.6: the caller's promise.
    unsafe { array_mut(name, target, 1)?[0] = value };
    Ok(Status::Ok)
}
