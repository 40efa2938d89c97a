//! From where a surface is seen.

use std::path::Path;

/// Which of the mesh's coordinates points upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// As models for pictures have it: y is up, and z comes towards the viewer.
    Y,
    /// As engineers have it.
    Z,
}

/// The direction from which a surface is seen, far away: no perspective.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Around the vertical axis, in degrees: from the x axis towards y (from z towards x where y is up).
    pub azimuth: f64,
    /// Above the horizon, in degrees.
    pub elevation: f64,
    /// What is up.
    pub up: Up,
}

impl View {
    /// The view that a picture of this file has unless told otherwise: OBJ files have y upwards.
    pub fn of(file: &Path) -> Self {
        let is_model = file
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("obj"));
        Self {
            azimuth: 30.0,
            elevation: 20.0,
            up: if is_model { Up::Y } else { Up::Z },
        }
    }

    /// Reads `AZIMUTH,ELEVATION` with perhaps `,y` or `,z` behind; what is not said is as in this view.
    ///
    /// # Errors
    /// Says what is wrong.
    pub fn changed(self, text: &str) -> Result<Self, String> {
        let parts: Vec<&str> = text.split(',').map(str::trim).collect();
        let (azimuth, elevation, up) = match parts[..] {
            [azimuth, elevation] => (azimuth, elevation, self.up),
            [azimuth, elevation, "y" | "Y"] => (azimuth, elevation, Up::Y),
            [azimuth, elevation, "z" | "Z"] => (azimuth, elevation, Up::Z),
            _ => {
                let reason = "azimuth and elevation in degrees and perhaps what is up are expected: 30,20 or 30,20,y";
                return Err(format!("'{text}': {reason}"));
            }
        };
        let angle = |text: &str| match text.parse::<f64>() {
            Ok(angle) if angle.is_finite() => Ok(angle),
            _ => Err(format!("'{text}' is no angle in degrees")),
        };
        Ok(Self {
            azimuth: angle(azimuth)?,
            elevation: angle(elevation)?,
            up,
        })
    }

    /// A point as the viewer has it: to the right, upwards, towards the viewer.
    pub fn seen(&self, point: &[f64]) -> [f64; 3] {
        let [x, y, z] = match self.up {
            Up::Z => [point[0], point[1], point[2]],
            Up::Y => [point[2], point[0], point[1]],
        };
        let (sin_a, cos_a) = self.azimuth.to_radians().sin_cos();
        let (sin_e, cos_e) = self.elevation.to_radians().sin_cos();
        let out = cos_a * x + sin_a * y;
        [
            cos_a * y - sin_a * x,
            cos_e * z - sin_e * out,
            sin_e * z + cos_e * out,
        ]
    }
}
