//! Rays by kind, as each program counts them.

use crate::measure::Program;

/// Rays of one picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rays {
    /// From the camera.
    pub camera: u64,
    /// Through surfaces.
    pub transmitted: u64,
    /// Mirrored.
    pub reflected: u64,
    /// Towards lights; POV-Ray counts tests of objects instead, which are more.
    pub shadow: u64,
}

impl Rays {
    /// Those that both programs count alike: all but shadow rays.
    pub fn followed(&self) -> u64 {
        self.camera + self.transmitted + self.reflected
    }

    /// Out of the figures of a file's header; `None` where none stand there.
    pub fn from_header(figures: &[(String, f64)]) -> Option<Self> {
        let of = |kind: &str| {
            figures.iter().find(|(name, _)| *name == format!("whitted:{kind}Rays")).map(|(_, n)| *n as u64)
        };
        Some(Self {
            camera: of("camera")?,
            transmitted: of("transmitted")?,
            reflected: of("reflected")?,
            shadow: of("shadow")?,
        })
    }

    /// Out of POV-Ray's statistics, in which kinds of which there are none are left out.
    pub fn from_statistics(said: &str) -> Option<Self> {
        let of = |what: &str| {
            let line = said.lines().find_map(|line| line.trim_start().strip_prefix(what))?;
            line.split_whitespace().next()?.parse::<u64>().ok()
        };
        let all = of("Rays:")?;
        let transmitted = of("Refracted Rays:").unwrap_or(0) + of("Transmitted Rays:").unwrap_or(0);
        let reflected = of("Reflected Rays:").unwrap_or(0);
        Some(Self {
            camera: all.saturating_sub(transmitted + reflected),
            transmitted,
            reflected,
            shadow: of("Shadow Ray Tests:").unwrap_or(0),
        })
    }

    /// What the shadow rays of a program are called.
    pub fn shadow_name(program: Program) -> &'static str {
        match program {
            Program::Whitted => "shadow rays",
            Program::PovRay => "shadow ray tests",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statistics_of_povray_are_understood() {
        let said = "Pixels:            20440   Samples:           64116   Smpls/Pxl: 3.14\n\
                    Rays:             513075   Saved:             71723   Max Level: 12/12\n\
                    Shadow Ray Tests:    478084   Succeeded:                217111\n\
                    Reflected Rays:              266995\nRefracted Rays:              161524\n";
        let rays = Rays { camera: 84_556, transmitted: 161_524, reflected: 266_995, shadow: 478_084 };
        assert_eq!(Rays::from_statistics(said), Some(rays));
        assert_eq!(rays.followed(), 513_075);
        assert_eq!(Rays::from_statistics("Rendered"), None);
    }

    #[test]
    fn headers_are_understood() {
        let figures = ["camera", "reflected", "shadow", "transmitted"].map(|kind| (format!("whitted:{kind}Rays"), 2.0));
        assert_eq!(Rays::from_header(&figures), Some(Rays { camera: 2, transmitted: 2, reflected: 2, shadow: 2 }));
        assert_eq!(Rays::from_header(&figures[1..]), None);
    }
}
