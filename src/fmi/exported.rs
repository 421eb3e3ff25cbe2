//! How exported functions are declared: an entry each.
//!
//! ```text
//! unsafe fn fmi2SetReal(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *const f64)
//!     in SETTABLE => |i, _| i.set_real(vr, value);
//! ```
//!
//! The instance comes before the arguments, which are in the order and with the names of the
//! standard. What has a count in brackets is an array of the host, behind the arrow a slice, and with
//! [`One`](super::arguments::One) a cell for what the function gives; nulls are refused by name. In
//! other states than those after `in` the call is refused. Behind the arrow stand the instance, of
//! whichever unit, and its logger, and what is done with them, which gives a status or, where all is
//! well, nothing. All of it runs guarded: see [`guard`](super::guard).

/// The functions of an interface.
macro_rules! functions {
    ($interface:ident; $(
        $(#[$attribute:meta])*
        $safety:ident fn $name:ident($($argument:tt $([$count:expr])?: $type:ty),* $(,)?)
            in $states:expr => |$instance:tt, $logger:tt| $body:expr;
    )*) => {$(
        $crate::fmi::exported::function! { $safety
            [#[doc = concat!("`", stringify!($name), "`.\n\n")] $(#[$attribute])*]
            fn $name(component: $crate::fmi::types::Component, $($argument: $type),*)
                -> $crate::fmi::types::Status
            {
                const CALL: $crate::fmi::guard::Call = $crate::fmi::guard::Call::new(
                    $crate::fmi::interface::Interface::$interface,
                    stringify!($name),
                    $states,
                );
                $crate::fmi::guard::guard(component, CALL, &mut |instance, $logger| {
                    $($(
                        // SAFETY: FMI 2.0, 2.1.7, and FMI 3.0, 2.2.6: an array holds as many
                        // elements as its count says, and one that is written overlaps with none.
                        let $argument = unsafe {
                            $crate::fmi::arguments::Pointed::lend(
                                $argument,
                                stringify!($argument),
                                $count,
                            )?
                        };
                    )?)*
                    let answer: Result<_, $crate::fmi::error::FmiError> =
                        $crate::fmi::any_instance::on_instance!(instance, |$instance| $body);
                    answer.map($crate::fmi::types::Status::from)
                })
            }
        }
    )*};
}
pub(super) use functions;

/// A function as hosts find it in the library; `safe` where it reads no memory of theirs.
macro_rules! function {
    (unsafe [$($attributes:tt)*] $($function:tt)*) => {
        $($attributes)* #[unsafe(no_mangle)] pub unsafe extern "C" $($function)*
    };
    (safe [$($attributes:tt)*] $($function:tt)*) => {
        $($attributes)* #[unsafe(no_mangle)] pub extern "C" $($function)*
    };
}
pub(super) use function;

/// Functions for what the unit does not have: each gives an error that says so. Arguments are given
/// by their types.
macro_rules! absent {
    ($interface:ident, $error:expr, $states:expr; $($name:ident($($type:ty),*);)*) => {
        $crate::fmi::exported::functions! { $interface; $(
            /// Not supported.
            safe fn $name($(_: $type),*) in $states => |_, _| Err::<Status, _>($error);
        )* }
    };
}
pub(super) use absent;
