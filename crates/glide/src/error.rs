//! What goes wrong, and how it is told.

use std::fmt;

/// A misuse of the API, as the error callback hears it.
///
/// Source: G246: messages have the form "function: text".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The entry point.
    pub function: String,
    /// The argument at fault as the headers name it; empty where it is none in
    /// particular.
    pub argument: &'static str,
    /// What is wrong with it.
    pub text: String,
    /// Whether the original would have ended the program.
    pub fatal: bool,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let gap = if self.argument.is_empty() { "" } else { " " };
        write!(f, "{}: {}{gap}{}", self.function, self.argument, self.text)
    }
}

/// A call's name as the headers spell it.
pub(crate) fn historic_name(name: &str) -> String {
    // The first letter is small; some names have other capitals besides.
    const OTHERS: [(&str, &str); 12] = [
        ("GrAlphaControlsItrgbLighting", "grAlphaControlsITRGBLighting"),
        ("GrTexNccTable", "grTexNCCTable"),
        ("GrAaDrawPoint", "grAADrawPoint"),
        ("GrAaDrawLine", "grAADrawLine"),
        ("GrAaDrawTriangle", "grAADrawTriangle"),
        ("GrAaDrawPolygon", "grAADrawPolygon"),
        ("GuAaDrawTriangleWithClip", "guAADrawTriangleWithClip"),
        ("GuMpInit", "guMPInit"),
        ("GuMpTexCombineFunction", "guMPTexCombineFunction"),
        ("GuMpTexSource", "guMPTexSource"),
        ("GuMpDrawTriangle", "guMPDrawTriangle"),
        ("ConvertAndDownloadRle", "ConvertAndDownloadRle"),
    ];
    if let Some((_, theirs)) = OTHERS.iter().find(|(ours, _)| *ours == name) {
        return (*theirs).to_string();
    }
    match name.strip_prefix('G') {
        Some(rest) => format!("g{rest}"),
        None => name.to_string(),
    }
}

/// Why a context cannot be made.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GlideError {
    /// The engine refused.
    #[error(transparent)]
    Engine(#[from] fillrate_engine::EngineError),
    /// The board's memory is out of range.
    #[error("a board has 1 to 3 texture units of 1 to 4 MB and 1 to 4 MB of frame buffer")]
    Card,
}
