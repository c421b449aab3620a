//! The day, the commit, the machine and the compiler of a measurement.

use std::process::Command;
use std::sync::OnceLock;

pub struct Circonstances {
    pub jour: String,
    /// Ends with `-dirty` if the checkout holds more than the commit.
    pub commit: String,
    pub processeur: String,
    pub compilateur: String,
}

impl Circonstances {
    /// The names of [`colonnes`](Self::colonnes).
    pub const TITRES: &str = "day,commit,processor,compiler";

    /// As they are when they are first asked for: what a program writes afterwards changes the checkout.
    pub fn presentes() -> &'static Self {
        static PRESENTES: OnceLock<Circonstances> = OnceLock::new();
        PRESENTES.get_or_init(Self::lire)
    }

    fn lire() -> Self {
        let sortie = |programme: &str, arguments: &[&str]| {
            let sortie = Command::new(programme).args(arguments).output().ok();
            let texte = sortie.map(|s| String::from_utf8_lossy(&s.stdout).trim().to_owned());
            texte.unwrap_or_default()
        };
        let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let cpu = cpu.lines().find_map(|ligne| ligne.strip_prefix("model name"));
        let cpu =
            cpu.map_or("an unknown processor", |nom| nom.trim_start_matches(['\t', ' ', ':']));
        let rustc = sortie("rustc", &["--version"]);
        Self {
            jour: sortie("date", &["+%Y-%m-%d"]),
            commit: sortie("git", &["describe", "--always", "--dirty", "--exclude=*"]),
            processeur: cpu.trim().to_owned(),
            compilateur: rustc.split(" (").next().unwrap_or_default().to_owned(),
        }
    }

    /// The last columns of a row of `benches/mesures`.
    pub fn colonnes(&self) -> String {
        let Self { jour, commit, processeur, compilateur } = self;
        format!("{jour},{commit},{processeur},{compilateur}")
    }
}
