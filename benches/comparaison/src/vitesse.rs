//! How long each takes for the 240,000 rays of a picture, in tiles.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use lancer_rayon::{Hierarchie, est_occulte};
use plotters::prelude::*;

use crate::commun::scenes::melange;
use crate::concours::{Concours, Concurrent, Temps, places};
use crate::exactitude::COULEURS;
use crate::horloge::{
    MORCEAU, chronometrer, chronometrer_lot, moindres, nanosecondes, petit_tampon,
};
use crate::page;
use crate::pairs::Parry;
use crate::rayons::{self, en_tuiles};

const TAILLES: [usize; 7] = [3, 12, 48, 192, 1000, 10_000, 100_000];

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
    let concurrents = if n < TROP { &Concurrent::TOUS[..] } else { &Concurrent::ARBRES };
    concours.verifier(concurrents)?;
    let temps = concours.temps(concurrents)?;
    Ok(Course { scalaire: std::any::type_name::<R>(), n, temps })
}

/// Who stands in the table, in this order.
const COLONNES: [Concurrent; 8] = [
    Concurrent::LotListe,
    Concurrent::LotHierarchie,
    Concurrent::Liste,
    Concurrent::Hierarchie,
    Concurrent::ParryListe,
    Concurrent::ParryArbre,
    Concurrent::Obvhs,
    Concurrent::AnnexeEnum,
];

pub(crate) fn table_complete(courses: &[Course]) -> String {
    let noms = COLONNES.map(Concurrent::nom).join(" | ");
    let mut table = vec![
        format!("| scalar | N | {noms} | parry / one by one | parry / batch | annex A / batch |"),
        format!("|---|--:|{}", "--:|".repeat(COLONNES.len() + 3)),
    ];
    table.extend(courses.iter().map(|Course { scalaire, n, temps }| {
        let ns = COLONNES.map(|qui| nanosecondes(temps.de(qui))).join(" | ");
        format!("| {scalaire} | {n} | {ns} | {} |", rapports(temps).join(" | "))
    }));
    table.join("\n")
}

/// The best of parry over our rays one by one and over our batch, and annex A over our batch.
fn rapports(temps: &Temps) -> [String; 3] {
    let [parry, annexe, lot] = [temps.parry(), temps.annexe(), temps.lot()];
    [parry / temps.seuls(), parry / lot, annexe / lot]
        .map(|rapport| if rapport.is_nan() { "–".into() } else { format!("{rapport:.1}") })
}

/// What shadows cost: ours in a list and in a hierarchy one by one, in a hierarchy as a batch of first hits
/// compared with the distance of the lamp, and parry one by one in a loop and in its `Bvh`.
pub(crate) fn ombres() -> Result<String, Box<dyn Error>> {
    let mut table = vec![
        "| scalar | N | list | hierarchy | first hits in a batch | parry, loop | parry, Bvh | parry / one by one |"
            .to_owned(),
        format!("|---|--:|{}", "--:|".repeat(6)),
    ];
    for n in [12, 48, 192, 1000, 10_000] {
        table.push(ombres_de::<f32>(n)?);
        table.push(ombres_de::<f64>(n)?);
    }
    Ok(table.join("\n"))
}

fn ombres_de<R: Parry>(n: usize) -> Result<String, Box<dyn Error>> {
    let objets = melange::<R>(n);
    let mut places = places(&objets);
    let hierarchie = Hierarchie::new(&objets, &mut places)?;
    let (liste, arbre) = (objets.iter().map(R::objet).collect::<Vec<_>>(), R::arbre(&objets));
    let ombres = rayons::ombres(&hierarchie);
    let (rayons, distances): (Vec<_>, Vec<_>) = ombres.iter().copied().unzip();
    let ombres: Vec<_> = ombres.into_iter().map(|(r, max)| (r, R::rayon(&r), max)).collect();
    let mut tampon = petit_tampon();
    // Who looks at every object gets a part of the rays.
    let pas = (n / 1000).max(1);
    let mut comptes = [0; 5];
    let ns = moindres(&[0, 1, 2, 3, 4], |&qui| {
        let compte = &mut comptes[qui];
        *compte = 0;
        let mut noter = |cache: bool| *compte += usize::from(cache);
        match qui {
            0 => chronometrer(&ombres, pas, |(r, _, max)| noter(est_occulte(&objets, r, *max))),
            1 => chronometrer(&ombres, 1, |(r, _, max)| noter(hierarchie.est_occulte(r, *max))),
            2 => {
                let mut distances = distances.chunks(MORCEAU);
                chronometrer_lot(&rayons, &mut tampon, |rayons, touches| {
                    hierarchie.premieres_intersections(rayons, touches)?;
                    for (touche, max) in touches.iter().zip(distances.next().unwrap_or_default()) {
                        noter(touche.is_ok_and(|touche| touche.distance() < *max));
                    }
                    Ok(())
                })
            }
            3 => chronometrer(&ombres, pas, |(_, r, max)| {
                noter(R::ombre_dans_la_liste(&liste, r, *max));
            }),
            _ => chronometrer(&ombres, 1, |(_, r, max)| {
                noter(R::ombre_dans_l_arbre(&arbre, r, *max));
            }),
        }
    });
    // Rounding moves an outline for parry; ours are the same.
    let [liste, arbre, lot, _, parry] = comptes;
    if arbre.abs_diff(parry) > ombres.len() / 1000 || lot != arbre || pas == 1 && liste != arbre {
        return Err(format!("shadows differ: {comptes:?}").into());
    }
    let rapport = ns[3].min(ns[4]) / ns[0].min(ns[1]);
    let ns: Vec<_> = ns.into_iter().map(nanosecondes).collect();
    Ok(format!("| {} | {n} | {} | {rapport:.1} |", std::any::type_name::<R>(), ns.join(" | ")))
}

/// What a tree costs to build, in time and in memory beside the objects.
pub(crate) fn constructions() -> Result<String, Box<dyn Error>> {
    let mut table = vec![
        "| scalar | N | hierarchy, ns per object | bytes per object | parry's Bvh, ns | obvhs, ns |"
            .to_owned(),
        format!("|---|--:|{}", "--:|".repeat(4)),
    ];
    for n in [1000, 10_000, 100_000] {
        table.push(constructions_de::<f32>(n)?);
        table.push(constructions_de::<f64>(n)?);
    }
    Ok(table.join("\n"))
}

fn constructions_de<R: Parry>(n: usize) -> Result<String, Box<dyn Error>> {
    let objets = melange::<R>(n);
    let mut places = places(&objets);
    let octets = size_of_val(&places[..]) as f64 / n as f64;
    let ns = moindres(&[0, 1, 2], |&qui| {
        let debut = Instant::now();
        match qui {
            0 => assert!(black_box(Hierarchie::new(&objets, &mut places)).is_ok()),
            1 => drop(black_box(R::arbre(&objets))),
            _ => drop(black_box(R::obvhs(&objets))),
        }
        debut.elapsed().as_nanos() as f64 / n as f64
    });
    let [ici, parry, obvhs] = [0, 1, 2].map(|qui| nanosecondes(ns[qui]));
    let scalaire = std::any::type_name::<R>();
    Ok(format!("| {scalaire} | {n} | {ici} | {octets:.0} | {parry} | {obvhs} |"))
}

pub(crate) fn graphique(courses: &[Course]) -> Result<(), Box<dyn Error>> {
    type Ligne = (&'static str, &'static str, RGBColor, fn(&Temps) -> f64);
    let [ici, litteral, parry, lot] = COULEURS;
    // The f32 after the f64 of the same, as a thin line in its broad pale one: they often coincide.
    let lignes: [Ligne; 7] = [
        ("annex A", "f64", litteral, Temps::annexe),
        ("parry", "f64", parry, Temps::parry),
        ("parry", "f32", parry, Temps::parry),
        ("one by one", "f64", ici, Temps::seuls),
        ("one by one", "f32", ici, Temps::seuls),
        ("batch", "f64", lot, Temps::lot),
        ("batch", "f32", lot, Temps::lot),
    ];
    let chemin = page::chemin("docs/images/temps.svg");
    let surface = SVGBackend::new(&chemin, (900, 520)).into_drawing_area();
    surface.fill(&WHITE)?;
    let mut graphe = ChartBuilder::on(&surface)
        .margin(12)
        .margin_right(24)
        .x_label_area_size(42)
        .y_label_area_size(70)
        .build_cartesian_2d((2.5..120_000.0).log_scale(), (3.0..12_000.0).log_scale())?;
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
