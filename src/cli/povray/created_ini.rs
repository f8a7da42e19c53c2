//! The INI file that says what was set: Create_Ini.

use super::reader::Reading;

/// One key and value a line, in the order of keys. Source: command line facts, section 2.
pub(super) fn created_ini(reading: &Reading, threads: usize) -> String {
    let mut assigned = reading.assigned.clone();
    assigned.insert("Work_Threads", vec![threads.to_string()]);
    let mut text = String::new();
    for (key, values) in &assigned {
        values.iter().for_each(|value| text += &format!("{key}={value}\n"));
    }
    text
}
