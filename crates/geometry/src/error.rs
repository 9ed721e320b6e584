/// Why a description of a view, a tree or a world cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A size, angle or distance of a view is not finite or out of its range.
    #[error("view: {what} is out of range")]
    View {
        /// The value that cannot be used.
        what: &'static str,
    },
    /// A scale and offset for depths that move the yon plane out of 0 to 1.
    #[error("depth scale and offset move the yon plane out of 0 to 1")]
    DepthScale,
}
