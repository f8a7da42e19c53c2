//! What the figures were measured on.

use std::path::Path;
use std::process::{Command, Stdio};

/// The machine, as far as it tells.
#[derive(Clone, Debug)]
pub struct Machine {
    /// The model.
    pub processor: String,
    /// How many threads run at the same time.
    pub cores: usize,
    /// Operating system with its version.
    pub system: String,
    /// What else it did in the last minute, as a mean number of running threads.
    pub load: Option<f64>,
}

impl Machine {
    /// This one, now.
    pub fn here() -> Self {
        let read = |file: &str| std::fs::read_to_string(file).unwrap_or_default();
        let field = |text: &str| text.split_once(':').map(|(_, value)| value.trim().to_owned());
        let processor = read("/proc/cpuinfo").lines().find(|line| line.starts_with("model name")).and_then(field);
        let release = read("/proc/sys/kernel/osrelease");
        Self {
            processor: processor.unwrap_or_else(|| format!("unknown {} processor", std::env::consts::ARCH)),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            system: format!("{} {}", std::env::consts::OS, release.trim()).trim().to_owned(),
            load: read("/proc/loadavg").split_whitespace().next().and_then(|load| load.parse().ok()),
        }
    }
}

/// The line in which POV-Ray gives its version.
///
/// # Errors
/// Why there is none, mostly because it is not installed.
pub fn povray_version(program: &Path) -> Result<String, String> {
    let asked = Command::new(program).arg("--version").stdin(Stdio::null()).output();
    let output = asked.map_err(|error| format!("{}: {error}", program.display()))?;
    let text = [output.stderr, output.stdout].concat();
    let text = String::from_utf8_lossy(&text);
    let line = text.lines().map(str::trim).find(|line| line.starts_with("POV-Ray"));
    line.map(str::to_owned).ok_or_else(|| format!("{}: does not tell a version of POV-Ray", program.display()))
}
