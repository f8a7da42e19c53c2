//! A child process and what it cost.

use std::ffi::OsString;
use std::io::Read;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};
use wait4::Wait4;

/// A program with its arguments.
#[derive(Clone, Debug)]
pub struct Invocation {
    /// The program.
    pub program: PathBuf,
    /// What it is told.
    pub arguments: Vec<OsString>,
    /// Where it runs.
    pub folder: PathBuf,
}

/// A run that went well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// User and system time of the whole process, its start and the reading of the scene included.
    pub cpu: Duration,
    /// From start to end on the clock.
    pub wall: Duration,
    /// The most memory that it held at a time, in bytes.
    pub memory: u64,
}

impl Invocation {
    /// Runs it to its end; also returns what it wrote to standard error.
    ///
    /// # Errors
    /// Why there is nothing to measure: it did not start, failed, or took longer than `limit` and was ended.
    pub fn run(&self, limit: Duration) -> Result<(Run, String), String> {
        let start = Instant::now();
        let mut command = Command::new(&self.program);
        command.args(&self.arguments).current_dir(&self.folder);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|error| format!("{}: {error}", self.program.display()))?;
        // Standard error closes when the process ends, which wakes whoever waits for it at once, without polling.
        let (told, ended) = mpsc::channel();
        let mut said = child.stderr.take();
        std::thread::spawn(move || {
            let mut bytes = Vec::new();
            // What was said until it could no longer be read is better than nothing.
            let _ = said.as_mut().map(|pipe| pipe.read_to_end(&mut bytes));
            let _ = told.send(bytes);
        });
        let said = ended.recv_timeout(limit);
        if said.is_err() {
            // It may have ended by itself just now.
            let _ = child.kill();
        }
        let used = child.wait4().map_err(|error| error.to_string())?;
        let wall = start.elapsed();
        let Ok(said) = said else { return Err(format!("took longer than {} s", limit.as_secs_f64())) };
        let said = String::from_utf8_lossy(&said).into_owned();
        if used.status.success() {
            let cpu = used.rusage.utime + used.rusage.stime;
            Ok((Run { cpu, wall, memory: used.rusage.maxrss }, said))
        } else {
            Err(format!("{}: {}", used.status, complaint(&said)))
        }
    }
}

/// The line that says why, of all that was said.
fn complaint(said: &str) -> &str {
    let is_complaint = |line: &&str| line.to_lowercase().contains("error");
    said.lines().find(is_complaint).or_else(|| said.lines().last()).map_or("no message", str::trim)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn shell(script: &str) -> Invocation {
        let arguments = ["-c".into(), script.into()].into();
        Invocation { program: "sh".into(), arguments, folder: ".".into() }
    }

    #[test]
    fn work_costs_time_of_the_processor_and_waiting_does_not() {
        let limit = Duration::from_secs(60);
        let (busy, _) = shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done").run(limit).unwrap();
        assert!(busy.cpu > Duration::from_millis(5), "{busy:?}");
        let (idle, said) = shell("echo so >&2; sleep 0.3").run(limit).unwrap();
        assert!(idle.wall >= Duration::from_millis(300) && idle.cpu < Duration::from_millis(200), "{idle:?}");
        assert_eq!(said, "so\n");
    }

    #[test]
    fn failures_say_why() {
        let limit = Duration::from_secs(60);
        let why = shell("echo 'error: no such scene' >&2; echo bye >&2; exit 3").run(limit).unwrap_err();
        assert!(why.ends_with("error: no such scene"), "{why}");
        let nowhere = Invocation { program: "/nowhere/at/all".into(), arguments: Vec::new(), folder: ".".into() };
        assert!(nowhere.run(limit).unwrap_err().starts_with("/nowhere/at/all: "));
        assert_eq!(shell("exec sleep 9").run(Duration::from_millis(50)).unwrap_err(), "took longer than 0.05 s");
    }
}
