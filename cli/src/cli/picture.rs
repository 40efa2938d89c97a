//! Pictures as files: by their endings, so that no picture is in a file that its viewer refuses.

use regge_terminal::{Stop, output};
use std::ffi::OsStr;
use std::path::Path;

/// How a picture is written.
#[derive(Clone, Copy)]
enum Picture {
    Svg,
    #[cfg(feature = "png")]
    Png,
}

/// Refuses a file whose ending is of no picture that this build can draw.
pub fn check(path: &Path) -> Result<(), Stop> {
    Picture::of(path).map(drop)
}

/// Writes a picture, given as SVG.
pub fn write(path: &Path, svg: String) -> Result<(), Stop> {
    let bytes = match Picture::of(path)? {
        Picture::Svg => svg.into_bytes(),
        #[cfg(feature = "png")]
        Picture::Png => regge_cli::map::png(&svg).map_err(Stop::Failed)?,
    };
    output::write_by(path, |out| out.write_all(&bytes))
}

impl Picture {
    fn of(path: &Path) -> Result<Self, Stop> {
        if output::is_standard(path) {
            return Ok(Self::Svg);
        }
        let shown = path.display();
        let end = path.extension().map(OsStr::to_ascii_lowercase);
        match end.as_deref().and_then(OsStr::to_str) {
            Some("svg") => Ok(Self::Svg),
            #[cfg(feature = "png")]
            Some("png") => Ok(Self::Png),
            #[cfg(not(feature = "png"))]
            Some("png") => Err(Stop::Input(format!(
                "{shown}: this build draws .svg only; cargo build --release -p regge-cli --features png draws .png too",
            ))),
            _ => Err(Stop::Usage(format!(
                "{shown}: a picture ends in .svg or .png"
            ))),
        }
    }
}
