//! How long each takes for the 240,000 rays of a picture, in tiles.

use std::error::Error;

use plotters::prelude::*;

use crate::commun::scenes::melange;
use crate::concours::{Concours, Concurrent, Temps};
use crate::exactitude::COULEURS;
use crate::horloge::nanosecondes;
use crate::page;
use crate::pairs::Parry;
use crate::rayons::en_tuiles;

const TAILLES: [usize; 6] = [3, 12, 48, 192, 1000, 10_000];

/// From here on a loop that looks closely at every object would run for minutes.
const TROP: usize = 10_000;

/// The times of one scene.
pub(crate) struct Course {
    scalaire: &'static str,
    n: usize,
    temps: Temps,
}

pub(crate) fn courses() -> Result<Vec<Course>, Box<dyn Error>> {
    let mut courses = Vec::new();
    for n in TAILLES {
        courses.push(course::<f32>(n)?);
        courses.push(course::<f64>(n)?);
    }
    Ok(courses)
}

fn course<R: Parry>(n: usize) -> Result<Course, Box<dyn Error>> {
    let concours = Concours::<R>::new(melange(n), en_tuiles());
    let grandes = [Concurrent::Lot, Concurrent::Rayons, Concurrent::ParryArbre];
    let concurrents = if n < TROP { &Concurrent::TOUS[..] } else { &grandes };
    concours.verifier(concurrents)?;
    let temps = concours.temps(concurrents);
    Ok(Course { scalaire: std::any::type_name::<R>(), n, temps })
}

pub(crate) fn table_complete(courses: &[Course]) -> String {
    let mut table = vec![
        "| scalar | N | batch | ray by ray | parry, loop | parry, Bvh | annex A, enum \
         | annex A, dyn | parry / batch | annex A / batch |"
            .to_owned(),
        format!("|---|--:|{}", "--:|".repeat(8)),
    ];
    table.extend(courses.iter().map(|Course { scalaire, n, temps }| {
        let [lot, rayons, annexe, dynamique, liste, arbre] =
            Concurrent::TOUS.map(|qui| nanosecondes(temps.de(qui)));
        let [parry, litteral] = rapports(temps);
        format!(
            "| {scalaire} | {n} | {lot} | {rayons} | {liste} | {arbre} | {annexe} | {dynamique} \
             | {parry} | {litteral} |",
        )
    }));
    table.join("\n")
}

pub(crate) fn table_courte(courses: &[Course]) -> String {
    let mut table = vec![
        "| scalar | N | batch | ray by ray | annex A | parry | annex A / batch | parry / batch |"
            .to_owned(),
        format!("|---|--:|{}", "--:|".repeat(6)),
    ];
    table.extend(courses.iter().map(|Course { scalaire, n, temps }| {
        let ns = [
            temps.de(Concurrent::Lot),
            temps.de(Concurrent::Rayons),
            temps.annexe(),
            temps.parry(),
        ];
        let [parry, annexe] = rapports(temps);
        format!("| {scalaire} | {n} | {} | {annexe} | {parry} |", ns.map(nanosecondes).join(" | "),)
    }));
    table.join("\n")
}

/// The better of parry's two and of annex A's two over the batch.
fn rapports(temps: &Temps) -> [String; 2] {
    let lot = temps.de(Concurrent::Lot);
    [temps.parry(), temps.annexe()].map(|ns| {
        let rapport = ns / lot;
        if rapport.is_nan() { "–".into() } else { format!("{rapport:.1}") }
    })
}

pub(crate) fn graphique(courses: &[Course]) -> Result<(), Box<dyn Error>> {
    type Ligne = (&'static str, &'static str, RGBColor, fn(&Temps) -> f64);
    let [ici, litteral, parry, lot] = COULEURS;
    let par_rayon: fn(&Temps) -> f64 = |temps| temps.de(Concurrent::Rayons);
    let en_lot: fn(&Temps) -> f64 = |temps| temps.de(Concurrent::Lot);
    // The f32 after the f64 of the same, as a thin line in its broad pale one: they often coincide.
    let lignes: [Ligne; 7] = [
        ("annex A", "f64", litteral, Temps::annexe),
        ("parry", "f64", parry, Temps::parry),
        ("parry", "f32", parry, Temps::parry),
        ("ray by ray", "f64", ici, par_rayon),
        ("ray by ray", "f32", ici, par_rayon),
        ("batch", "f64", lot, en_lot),
        ("batch", "f32", lot, en_lot),
    ];
    let chemin = page::chemin("docs/images/temps.svg");
    let surface = SVGBackend::new(&chemin, (900, 520)).into_drawing_area();
    surface.fill(&WHITE)?;
    let mut graphe = ChartBuilder::on(&surface)
        .margin(12)
        .margin_right(24)
        .x_label_area_size(42)
        .y_label_area_size(70)
        .build_cartesian_2d((2.5..12_000.0).log_scale(), (3.0..40_000.0).log_scale())?;
    graphe
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("N, objects of the scene")
        .y_desc("ns per ray")
        .x_label_formatter(&|x| format!("{x:.0}"))
        .y_label_formatter(&|y| format!("{y:.0}"))
        .label_style(("sans-serif", 14))
        .draw()?;
    for (nom, scalaire, couleur, ns) in lignes {
        let style = match scalaire {
            "f32" => couleur.stroke_width(2),
            _ => couleur.mix(0.4).stroke_width(6),
        };
        let de_ce_type = courses.iter().filter(|course| course.scalaire == scalaire);
        let points = de_ce_type.map(|course| (course.n as f64, ns(&course.temps)));
        let points: Vec<_> = points.filter(|(_, ns)| ns.is_finite()).collect();
        graphe
            .draw_series(LineSeries::new(points, style))?
            .label(format!("{nom} {scalaire}"))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], style));
    }
    graphe
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(("sans-serif", 14))
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .draw()?;
    surface.present()?;
    Ok(())
}
