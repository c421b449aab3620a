//! Speed against accuracy, one point for each variant: `docs/compromis.md`.

use std::error::Error;

use banc::concurrents::{Camp, Reponse, temps};
use banc::familles::{Famille, Genre};
use fastrand::Rng;
use lancer_rayon::{
    Hierarchie, NoIntersection, ObjetRay, Rayon, premiere_intersection, premieres_intersections,
};
use plotters::prelude::*;

use crate::autres::{Scalaire, distance, exiger_accord, exiger_memes_bits, mondes, places, tous};
use crate::exactitude::{self, COULEURS, repondants};
use crate::page;
use commun::litteral;
use commun::mesure::{mesurer, quantiles};
use commun::oracle::verite;
use commun::regimes::regimes;

type Mesures<R> = ((exactitude::Repondant<R>, f64), Vec<Reponse>);

/// One ray in so many is judged by the oracle.
const PAS: usize = 7;

/// Cases of each regime of the extremes, and what they are drawn from.
const CAS: u32 = 20_000;
const GRAINE: u64 = 1;

#[derive(Clone)]
struct Variante {
    nom: String,
    ns: f64,
    /// Relative errors of the distances of the picture: median, 99.9 %, largest.
    erreurs: [f64; 3],
    /// Rays of the picture that see another object than the true one, or none.
    autres: usize,
    /// The largest error of a distance at the extremes, in u·κt.
    k: f64,
    /// Wrong hits and misses per million cases of the extremes.
    fausses: f64,
}

pub(crate) fn documenter() -> Result<(), Box<dyn Error>> {
    let mut variantes = mesures::<f32>()?;
    variantes.extend(mesures::<f64>()?);
    let mut lignes = vec![
        "| variant | ns per ray | relative error: median | 99.9 % | largest | another object | \
         K at the extremes | wrong hits or misses there, per million |"
            .to_owned(),
        format!("|---|{}", "--:|".repeat(7)),
    ];
    for Variante { nom, ns, erreurs: [mediane, presque, pire], autres, k, fausses } in &variantes {
        let mediane = if *mediane > 0.0 { format!("{mediane:.0e}") } else { "0".into() };
        let k = if *k < 100.0 { format!("{k:.2}") } else { format!("{k:.0e}") };
        lignes.push(format!(
            "| {nom} | {ns:.1} | {mediane} | {presque:.0e} | {pire:.0e} | {autres} | {k} | {fausses:.0} |",
        ));
    }
    page::remplacer("docs/compromis.md", "variants", &page::datee(&lignes.join("\n")))?;
    graphique(&variantes)
}

fn mesures<R: Scalaire>() -> Result<Vec<Variante>, Box<dyn Error>> {
    let scene = Famille::Atelier.scene::<R>(0, GRAINE);
    let mut places = places(&scene.objets);
    let hierarchie = Hierarchie::new(&scene.objets, &mut places)?;
    let mondes = mondes(&scene.objets);
    // The whole picture, in tiles.
    let lances = Genre::Tuiles.rayons(&hierarchie, &scene, 50);
    let rayons = &lances.rayons;
    let mut concurrents = tous(hierarchie, &mondes, &lances, &lances);
    exiger_memes_bits(hierarchie, rayons, &[])?;
    exiger_accord(&concurrents, |_| 3e4 * R::U.vers_f64())?;
    let ns = temps(&mut concurrents);
    let ns: Vec<_> = concurrents.iter().map(|qui| (qui.nom, qui.camp)).zip(ns).collect();
    let reponses = ["list", "annex A, enum", "parry, loop"].map(|nom| {
        let qui = concurrents.iter().find(|qui| qui.nom == nom);
        let reponses = qui.expect("in so short a list all compete").reponses();
        reponses.into_iter().step_by(PAS).collect()
    });
    let juges = rayons.iter().step_by(PAS);
    let verites: Vec<_> = juges.map(|rayon| premiere(&scene.objets, rayon)).collect();

    let noms = repondants::<R>();
    let variante = |(((nom, repondre), temps), reponses): Mesures<R>| {
        let mut autres = 0;
        let mut erreurs = Vec::new();
        for (verite, reponse) in verites.iter().zip(&reponses) {
            match (verite, reponse) {
                (Some((objet, t)), Some(obtenu)) if obtenu.1 == *objet => {
                    erreurs.push((distance(*obtenu) - t).abs() / t);
                }
                (None, None) => {}
                _ => autres += 1,
            }
        }
        let regimes = regimes::<R>();
        let mesures = regimes.iter().map(|r| mesurer(r, CAS, GRAINE, repondre));
        let (fausses, k) = mesures.fold((0, 0.0), |(fausses, k), mesure| {
            (fausses + mesure.fausses, mesure.k.iter().copied().fold(k, f64::max))
        });
        let cas = f64::from(CAS) * regimes.len() as f64;
        Variante {
            nom: format!("{nom} {}", R::NOM),
            ns: temps,
            erreurs: quantiles(&mut erreurs),
            autres,
            k,
            fausses: 1e6 * f64::from(fausses) / cas,
        }
    };
    // The least of this side whose name starts so.
    let ns_de = |(cote, noms): (Camp, &str)| {
        let ceux = ns.iter().filter(|((nom, camp), _)| *camp == cote && nom.starts_with(noms));
        ceux.map(|(_, ns)| *ns).fold(f64::NAN, f64::min)
    };
    let ns_de_trois =
        [(Camp::Seul, "list"), (Camp::Annexe, "annex A"), (Camp::Parry, "parry")].map(ns_de);
    let mut variantes: Vec<_> =
        noms.into_iter().zip(ns_de_trois).zip(reponses).map(variante).collect();
    exiger_exact_aux_extremes::<R>()?;
    // The same bits in less time.
    let memes =
        [("hierarchy", ns_de((Camp::Seul, "single"))), ("batch", ns_de((Camp::Lot, "batch")))];
    for (nom, ns) in memes {
        let liste = variantes[0].clone();
        variantes.push(Variante { nom: format!("{nom} {}", R::NOM), ns, ..liste });
    }
    variantes[0].nom = format!("list {}", R::NOM);
    Ok(variantes)
}

/// The batch errs where the rays one by one do, and nowhere else.
fn exiger_exact_aux_extremes<R: Scalaire>() -> Result<(), Box<dyn Error>> {
    for regime in regimes::<R>() {
        let mut alea = Rng::with_seed(GRAINE);
        for _ in 0..CAS {
            let cas = (regime.cas)(&mut alea);
            // Several of the same: fewer would not go side by side.
            let (objets, mut touches) = ([cas.objet], [Err(NoIntersection); 9]);
            premieres_intersections(&objets, &[cas.rayon; 9], &mut touches)?;
            if touches != [premiere_intersection(&objets, &cas.rayon); 9] {
                return Err("the batch differs from its rays one by one".into());
            }
        }
    }
    Ok(())
}

/// The true first object, by its texture, and its distance; the earlier of two at the same.
fn premiere<R: Scalaire>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Option<(u32, f64)> {
    let touches =
        objets.iter().zip(0..).filter_map(|(objet, i)| Some((i, verite(objet, rayon).entree?.t)));
    let premiere = touches.reduce(|a, b| if b.1 < a.1 { b } else { a });
    premiere.map(|(i, t)| (litteral::Objet::from(&objets[i]).1.0, t.vers_f64()))
}

fn graphique(variantes: &[Variante]) -> Result<(), Box<dyn Error>> {
    let chemin = page::chemin("docs/images/compromis.svg");
    let surface = SVGBackend::new(&chemin, (820, 480)).into_drawing_area();
    surface.fill(&WHITE)?;
    let lent = variantes.iter().map(|v| v.ns).fold(0.0, f64::max);
    let mut graphe = ChartBuilder::on(&surface)
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(70)
        .build_cartesian_2d(0.0..1.35 * lent, (1e-17..1e-4).log_scale())?;
    graphe
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("ns per ray, the atelier")
        .y_desc("relative error of the distance, 99.9 %")
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .draw()?;
    // A name lies beside its point, from left to right, where it touches neither the edge of the plot,
    // with its axes and their names, nor a point or another name.
    let mut points: Vec<_> = variantes.iter().map(|v| (v, (v.ns, v.erreurs[1]))).collect();
    points.sort_by(|(a, _), (b, _)| a.ns.total_cmp(&b.ns));
    let coins = points.iter().map(|(_, point)| graphe.backend_coord(point));
    let mut pris: Vec<_> = coins.map(|(x, y)| [x - 6, y - 6, x + 6, y + 6]).collect();
    let (colonnes, lignes) = graphe.plotting_area().get_pixel_range();
    for (v, point) in points {
        // A colour a scalar.
        let couleur = COULEURS[usize::from(v.nom.ends_with("f64"))];
        let (x, y) = graphe.backend_coord(&point);
        let large = 8 * v.nom.len() as i32;
        let etages = (1..9).flat_map(|i| [-18 * i - 6, 18 * i - 8]);
        let etages = etages.flat_map(|dy| [(-large / 2, dy), (0, dy)]);
        let boite = |&(dx, dy): &(i32, i32)| [x + dx, y + dy, x + dx + large, y + dy + 16];
        let libre = |ou: &(i32, i32)| {
            let [a, b, c, d] = boite(ou);
            let dedans =
                colonnes.start < a && c < colonnes.end && lignes.start < b && d < lignes.end;
            dedans && pris.iter().all(|[e, f, g, h]| c <= *e || *g <= a || d <= *f || *h <= b)
        };
        let mut places = [(10, -8), (-10 - large, -8)].into_iter().chain(etages);
        let ou = places.find(libre).ok_or("compromis.svg has no room for a name")?;
        pris.push(boite(&ou));
        let nom = Text::new(v.nom.clone(), ou, ("sans-serif", 15).into_font());
        let element = EmptyElement::at(point) + Circle::new((0, 0), 6, couleur.filled()) + nom;
        graphe.draw_series([element])?;
    }
    surface.present()?;
    Ok(())
}
