//! What fails, and how.

/// The documented error codes. Source: RAVE, `TQAError`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[repr(i32)]
pub enum RaveError {
    /// `kQAError`: general failure.
    #[error("general failure")]
    Failure = 1,
    /// `kQAOutOfMemory`: host memory is exhausted.
    #[error("host memory is exhausted")]
    OutOfMemory = 2,
    /// `kQANotSupported`: the engine does not offer the feature.
    #[error("the engine does not offer this")]
    NotSupported = 3,
    /// `kQAOutOfDate`: a newer engine of the same identity is registered.
    #[error("a newer engine of this identity is registered")]
    OutOfDate = 4,
    /// `kQAParamErr`: bad parameter.
    #[error("bad parameter")]
    Parameter = 5,
    /// `kQAGestaltUnknown`: unknown selector.
    #[error("unknown selector")]
    GestaltUnknown = 6,
    /// `kQADisplayModeUnsupported`: it could draw in another display mode.
    #[error("the display mode is not supported")]
    DisplayModeUnsupported = 7,
    /// `kQAOutOfVideoMemory`: the board's memory does not suffice.
    #[error("video memory does not suffice")]
    OutOfVideoMemory = 8,
}

impl RaveError {
    /// All errors, by number.
    pub const ALL: [RaveError; 8] = [
        RaveError::Failure,
        RaveError::OutOfMemory,
        RaveError::NotSupported,
        RaveError::OutOfDate,
        RaveError::Parameter,
        RaveError::GestaltUnknown,
        RaveError::DisplayModeUnsupported,
        RaveError::OutOfVideoMemory,
    ];

    /// The documented number.
    pub fn code(self) -> i32 {
        self as i32
    }

    /// The error of a number; `None` for `kQANoErr` and numbers without a meaning.
    pub fn from_code(code: i32) -> Option<RaveError> {
        RaveError::ALL.into_iter().find(|error| error.code() == code)
    }
}

/// The number of a result: 0, `kQANoErr`, or the error's.
pub fn status_code<T>(result: &Result<T, RaveError>) -> i32 {
    result.as_ref().err().map_or(0, |error| error.code())
}
