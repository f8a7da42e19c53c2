//! scratch
use whitted::eval::*;
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let path = std::path::Path::new(&path);
    let dirs = vec![std::path::PathBuf::from("/usr/share/povray-3.7/include")];
    let host = Disk::new(path, &dirs, &[], |_, t| eprint!("{t}"));
    let options = Options { include_dirs: dirs, ..Options::default() };
    let t = std::time::Instant::now();
    match evaluate(path, &options, &host, &NoQueries) {
        Ok(r) => {
            for w in r.warnings.iter().take(20) {
                eprint!("{}", w.render(&r.sources, false));
            }
            eprintln!("ok {} objects", r.scene.objects.len());
        }
        Err(f) => {
            for w in f.diagnostics.iter() {
                eprint!("{}", w.render(&f.sources, false));
            }
        }
    }
    eprintln!("{:?}", t.elapsed());
}
