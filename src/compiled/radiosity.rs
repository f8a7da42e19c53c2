//! Settings of radiosity, with what they come to after each diffuse bounce.
//!
//! Source: radiosity facts, sections 1 and 3 (measured).

/// Fewest rays of a sample.
const FEWEST_RAYS: u32 = 5;

/// POV-Ray's amount by which rays are kept above the limit below which they end.
const ABOVE_LIMIT: f64 = 1e-10;

/// How light between surfaces is gathered. A depth is the number of diffuse surfaces between a point and the camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Radiosity {
    /// Rays of a sample at depth 0.
    pub count: u32,
    /// Directions that rays take in turn, at least `count`.
    pub directions: u32,
    /// Error up to which records are reused.
    pub error_bound: f64,
    /// Factor of it in the pretrace.
    pub low_error_factor: f64,
    /// Records wanted at a point of depth 0.
    pub nearest_count: u32,
    /// Records from which on the pretrace goes no finer; 0 for never.
    pub enough_for_pretrace: u32,
    /// Least and largest mean distance of what a record sees, in distances from the camera.
    pub reuse: [f64; 2],
    /// Steps of the first and the last pass of the pretrace, in sizes of the picture.
    pub pretrace: [f64; 2],
    /// Diffuse bounces.
    pub recursion_limit: u32,
    /// Factor of all gathered light.
    pub brightness: f64,
    /// How much of its colour gathered light loses, 0 to 1.
    pub gray_threshold: f32,
    /// Brightest a sample ray may be in any channel.
    pub max_sample: Option<f32>,
    /// Weight below which sample rays, and what they become, end.
    pub adc_bailout: f64,
    /// The picture, too, takes samples until as many records as wanted are near.
    pub always_sample: bool,
    /// Samples are taken about the normal with its bumps.
    pub normal: bool,
    /// Sample rays pass through media and fog.
    pub media: bool,
    /// Sample rays see subsurface light.
    pub subsurface: bool,
    /// Ambient light does not count while this is on.
    pub replaces_ambient: bool,
    /// Share of sample rays that see what says nothing else, and the sky.
    pub importance: f32,
}

impl Radiosity {
    /// Factor of errors and distances at a depth: deeper light may be coarser.
    pub fn coarseness(&self, depth: u32) -> f64 {
        f64::from(1u32 << depth.min(31))
    }

    /// How far a record with that mean distance counts in the picture.
    pub fn reach(&self, depth: u32, mean_distance: f32) -> f64 {
        f64::from(mean_distance) * self.error_bound * self.coarseness(depth)
    }

    /// Rays of a sample.
    pub fn rays(&self, depth: u32) -> u32 {
        (self.count >> depth.min(31)).max(FEWEST_RAYS).min(self.directions)
    }

    /// Records that are enough at a point.
    pub fn wanted(&self, depth: u32) -> f64 {
        let most = [self.nearest_count, 2].get(depth as usize).copied().unwrap_or(1);
        f64::from(self.nearest_count.min(most))
    }

    /// Level at which sample rays start from a point.
    pub fn start_level(&self, depth: u32) -> u32 {
        3 * (depth + 1) / 2 + 1
    }

    /// Levels of rays that have come over so many bounces, in a scene that has `most` for camera rays.
    pub fn max_level(&self, bounce: u32, most: u32) -> u32 {
        if bounce == 0 { most } else { most.max(self.start_level(bounce - 1)) }
    }

    /// Weight of sample rays that start from a point; `None` for those that end at once.
    ///
    /// Single precision may bring a weight below the limit that it should be kept above, which ends chains of bounces at
    /// some limits, and does not at others.
    pub fn weight(&self, depth: u32) -> Option<f32> {
        let weight = (0.5 * self.brightness).powi(depth as i32 + 1).max(self.adc_bailout + ABOVE_LIMIT) as f32;
        (f64::from(weight) >= self.adc_bailout).then_some(weight)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(brightness: f64, adc_bailout: f64) -> Radiosity {
        Radiosity {
            count: 35,
            directions: 1600,
            error_bound: 1.8,
            low_error_factor: 0.5,
            nearest_count: 5,
            enough_for_pretrace: 0,
            reuse: [0.015, 0.2],
            pretrace: [0.08, 0.04],
            recursion_limit: 2,
            brightness,
            gray_threshold: 0.0,
            max_sample: None,
            adc_bailout,
            always_sample: false,
            normal: false,
            media: false,
            subsurface: false,
            replaces_ambient: true,
            importance: 1.0,
        }
    }

    #[test]
    fn bounces_end_where_single_precision_ends_them() {
        let bounces =
            |brightness, bailout| (0..20).take_while(|j| settings(brightness, bailout).weight(*j).is_some()).count();
        assert_eq!([bounces(1.0, 0.01), bounces(0.5, 0.01)], [6, 3]);
        assert_eq!([bounces(1.0, 0.001), bounces(1.0, 0.1)], [20, 20]);
    }

    #[test]
    fn deeper_samples_are_smaller() {
        let radiosity = settings(1.0, 0.01);
        assert_eq!([0, 1, 2, 3, 9].map(|j| radiosity.rays(j)), [35, 17, 8, 5, 5]);
        assert_eq!([0, 1, 2, 3].map(|j| radiosity.wanted(j)), [5.0, 2.0, 1.0, 1.0]);
        assert_eq!([0, 1, 2, 3].map(|j| radiosity.start_level(j)), [2, 4, 5, 7]);
        assert_eq!([radiosity.max_level(0, 5), radiosity.max_level(3, 1), radiosity.max_level(1, 5)], [5, 5, 5]);
    }
}
