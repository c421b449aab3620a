//! Speed against accuracy, one point for each variant: `docs/compromis.md`.

use std::error::Error;

use fastrand::Rng;
use lancer_rayon::{ObjetGeo, ObjetRay, Rayon, premieres_intersections};
use plotters::prelude::*;
use serde::de::DeserializeOwned;

use crate::commun::litteral;
use crate::commun::mesure::{mesurer, quantiles};
use crate::commun::oracle::verite;
use crate::commun::regimes::regimes;
use crate::concours::{Concours, Concurrent};
use crate::exactitude::{self, COULEURS, repondants};
use crate::horloge::{exiger, une_par_une};
use crate::page;
use crate::pairs::{Parry, Vu};
use crate::scene::Scene;

type Mesures<R> = ((exactitude::Repondant<R>, f64), Vec<Option<Vu<R>>>);

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
    let mut variantes = mesures::<f32>("f32")?;
    variantes.extend(mesures::<f64>("f64")?);
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

fn mesures<R: Parry + DeserializeOwned>(scalaire: &str) -> Result<Vec<Variante>, Box<dyn Error>> {
    let scene: Scene<R> = Scene::lire(&page::chemin("docs/scenes/atelier.ron"))?;
    let objets = scene.objets.iter().copied().map(ObjetGeo::vers_ray).collect();
    let concours = Concours::<R>::new(objets, scene.camera.rayons()?);
    concours.verifier(&Concurrent::TOUS)?;
    let temps = concours.temps(&Concurrent::TOUS)?;
    let juges_de = [Concurrent::Liste, Concurrent::AnnexeEnum, Concurrent::ParryListe];
    let reponses = juges_de.map(|qui| concours.reponses(qui, PAS));
    let juges = concours.rayons.iter().step_by(PAS);
    let verites: Vec<_> = juges.map(|rayon| premiere(&concours.objets, rayon)).collect();

    let noms = repondants::<R>();
    let variante = |(((nom, repondre), temps), reponses): Mesures<R>| {
        let mut autres = 0;
        let mut erreurs = Vec::new();
        for (verite, reponse) in verites.iter().zip(&reponses) {
            match (verite, reponse) {
                (Some((objet, t)), Some((obtenu, _, texture))) if texture.0 == *objet => {
                    erreurs.push((obtenu.vers_f64() - t).abs() / t);
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
            nom: format!("{nom} {scalaire}"),
            ns: temps,
            erreurs: quantiles(&mut erreurs),
            autres,
            k,
            fausses: 1e6 * f64::from(fausses) / cas,
        }
    };
    let ns = [temps.de(Concurrent::Liste), temps.annexe(), temps.parry()];
    let mut variantes: Vec<_> = noms.into_iter().zip(ns).zip(reponses).map(variante).collect();
    exiger_exact_aux_extremes::<R>()?;
    // The same bits in less time.
    let memes = [("hierarchy", temps.de(Concurrent::Hierarchie)), ("batch", temps.lot())];
    for (nom, ns) in memes {
        let liste = variantes[0].clone();
        variantes.push(Variante { nom: format!("{nom} {scalaire}"), ns, ..liste });
    }
    variantes[0].nom = format!("list {scalaire}");
    Ok(variantes)
}

/// The batch errs where the rays one by one do, and nowhere else.
fn exiger_exact_aux_extremes<R: Parry>() -> Result<(), Box<dyn Error>> {
    for regime in regimes::<R>() {
        let mut alea = Rng::with_seed(GRAINE);
        for _ in 0..CAS {
            let cas = (regime.cas)(&mut alea);
            // Several of the same: fewer would not go side by side.
            let (objets, rayons) = ([cas.objet], [cas.rayon; 9]);
            exiger(&une_par_une(&objets, &rayons), &rayons, |rayons, touches| {
                premieres_intersections(&objets, rayons, touches)
            })?;
        }
    }
    Ok(())
}

/// The true first object, by its texture, and its distance; the earlier of two at the same.
fn premiere<R: Parry>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Option<(u32, f64)> {
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
    for v in variantes {
        // A colour a scalar.
        let couleur = COULEURS[usize::from(v.nom.ends_with("f64"))];
        let point = (v.ns, v.erreurs[1]);
        let nom = Text::new(v.nom.clone(), (9, -18), ("sans-serif", 15).into_font());
        let element = EmptyElement::at(point) + Circle::new((0, 0), 6, couleur.filled()) + nom;
        graphe.draw_series([element])?;
    }
    surface.present()?;
    Ok(())
}
