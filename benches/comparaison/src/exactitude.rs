//! The error of each implementation in each regime, against the oracle: `benches/erreurs.md`.

use std::error::Error;

use fastrand::Rng;
use lancer_rayon::{ObjetGeo, ObjetRay, Rayon, Reel, SphereGeo, Texture, premiere_intersection};
use plotters::prelude::*;

use crate::page;
use crate::rival::Parry;
use commun::conversion::arrondi;
use commun::litteral;
use commun::mesure::{Mesuree, mesurer, plus_grand, quantiles};
use commun::oracle::{Passage, verite};
use commun::promesses::{Essai, RIEN, erreur, marge, secondaire};
use commun::regimes::{Cas, Regime, direction, regimes};

/// Cases of each regime.
const CAS: u32 = 100_000;

/// What answers, by name.
pub(crate) type Repondant<R> = (&'static str, fn(&ObjetRay<R>, &Rayon<R>) -> Mesuree<R>);

pub(crate) fn repondants<R: Parry>() -> [Repondant<R>; 3] {
    [
        ("lancer-rayon", |objet, rayon| {
            let touche = premiere_intersection(std::slice::from_ref(objet), rayon).ok()?;
            Some((touche.distance(), touche.normale()))
        }),
        ("annex A", |objet, rayon| {
            let touche = litteral::premiere_intersection(&[litteral::Objet::from(objet)], rayon);
            touche.map(|(t, n, _)| (t, n))
        }),
        ("parry", |objet, rayon| {
            let touche = R::touche(objet, rayon);
            touche.map(|(t, n, _)| (t, n))
        }),
    ]
}

pub(crate) fn documenter() -> Result<(), Box<dyn Error>> {
    page::remplacer("benches/erreurs.md", "errors", &page::datee(&erreurs()))?;
    page::remplacer("benches/erreurs.md", "bounds", &page::datee(&bornes()))?;
    courbes()
}

/// Below this K, and without a wrong decision, all implementations count as equal.
const PAREILS: f64 = 4.0;

/// The largest K, with wrong decisions in brackets, for each type and variant, in the regimes that tell the variants
/// apart; then our largest K in all regimes.
fn erreurs() -> String {
    let noms = repondants::<f32>().map(|(nom, _)| nom).join(" | ");
    let mut lignes = vec![
        format!("| regime | f32: {noms} | f64: {noms} |"),
        format!("|---|{}", "--:|".repeat(6)),
    ];
    let mut notres = [0.0_f64; 2];
    for (simple, double) in regimes::<f32>().into_iter().zip(regimes::<f64>()) {
        let nom = simple.nom;
        println!("{nom}");
        let (simple, double) = (erreurs_de(&simple), erreurs_de(&double));
        notres = [notres[0].max(simple.2), notres[1].max(double.2)];
        if simple.1 || double.1 {
            lignes.push(format!("| {nom} | {} | {} |", simple.0, double.0));
        }
    }
    let [simple, double] = notres.map(lisible);
    lignes.push(format!(
        "\nOver all regimes, with those left out, the largest K of lancer-rayon is {simple} in `f32` and {double} in `f64`."
    ));
    lignes.join("\n")
}

/// The row of a regime, whether it tells the variants apart, and our largest K.
fn erreurs_de<R: Parry>(regime: &Regime<R>) -> (String, bool, f64) {
    let mut distingue = false;
    let cases = repondants::<R>().map(|(_, repondre)| {
        let mut mesure = mesurer(regime, CAS, 1, repondre);
        let [.., pire] = quantiles(&mut mesure.k);
        distingue |= mesure.fausses > 0 || pire >= PAREILS;
        (format!("{}{}", lisible(pire), entre_crochets(mesure.fausses)), pire)
    });
    let (_, notre) = cases[0];
    (cases.map(|(case, _)| case).join(" | "), distingue, notre)
}

/// Nothing for 0.
fn entre_crochets(nombre: u32) -> String {
    if nombre == 0 { String::new() } else { format!(" ({nombre})") }
}

/// Two digits after the point, or a power of ten where it is large.
fn lisible(x: f64) -> String {
    match x {
        _ if x.is_nan() => "–".into(),
        _ if x.is_infinite() => "∞".into(),
        _ if x < 100.0 => format!("{x:.2}"),
        _ => format!("{x:.0e}"),
    }
}

/// What our own hits say of themselves, margins, `erreur` and `est_certain`, is never less than the truth; and how loose
/// `erreur` is.
fn bornes() -> String {
    let (mut lances, mut aisance) = (0, 0.0);
    for (simple, double) in regimes::<f32>().into_iter().zip(regimes::<f64>()) {
        marges(&simple, &mut lances);
        jugement(&simple, &mut aisance);
        marges(&double, &mut lances);
        jugement(&double, &mut aisance);
    }
    let millions = lances / 1_000_000;
    format!(
        "None of {millions} million secondary rays touched its object again. In every regime the median of `erreur` over the error is\n\
         at most {aisance:.2}."
    )
}

/// No margin is exceeded, and no secondary ray, which `lances` counts, touches its object.
fn marges<R: Reel>(regime: &Regime<R>, lances: &mut u64) {
    let mut alea = Rng::with_seed(2);
    for _ in 0..CAS {
        let Cas { objet, rayon } = (regime.cas)(&mut alea);
        let Ok(touche) = objet.intersection(&rayon) else { continue };
        let vers = [R::ZERO; 5];
        let passage = Passage::Entree;
        let mut essai = Essai { objets: vec![objet], rayon, passage, vers };
        assert!(marge(&essai) <= 1.0, "{}: a margin is exceeded", regime.nom);
        let n = touche.normale().vers_f64();
        for _ in 0..20 {
            // Outward and along the surface only, since from inside the promise excepts the edges of a box.
            let vers = direction(&mut alea);
            let cosinus = vers.produit_scalaire(n);
            let tangente = vers - n * cosinus;
            for vers in [vers - n * (cosinus - cosinus.abs()), tangente] {
                let [x, y, z] = arrondi(vers).into();
                essai.vers = [x, y, z, R::ZERO, R::ZERO];
                let part = secondaire(&essai);
                *lances += u64::from(part > RIEN);
                assert!(part <= 1.0, "{}: touched again", regime.nom);
            }
        }
    }
}

/// No wrong answer is certain. `aisance` becomes how loose `erreur` is in the median, if that is more.
fn jugement<R: Reel>(regime: &Regime<R>, aisance: &mut f64) {
    let mut alea = Rng::with_seed(4);
    let mut aisances = Vec::new();
    for _ in 0..CAS {
        let Cas { objet, rayon } = (regime.cas)(&mut alea);
        let touchee = objet.intersection(&rayon).is_ok();
        let entree = verite(&objet, &rayon).entree;
        let entree = entree.filter(|e| e.t.vers_f64() <= plus_grand::<R>());
        let juste = entree.is_some() == touchee;
        assert!(juste || !objet.est_certain(&rayon), "{}: wrong, but certain", regime.nom);
        let (passage, vers) = (Passage::Entree, [R::ZERO; 5]);
        let part = erreur(&Essai { objets: vec![objet], rayon, passage, vers });
        aisances.extend((part > 0.0).then(|| 1.0 / part));
    }
    let [mediane, ..] = quantiles(&mut aisances);
    *aisance = aisance.max(mediane);
}

/// The error of the distance over the radius, against the distance in radii, for a sphere that is aimed at well inside
/// its outline.
fn courbe<R: Parry>(repondre: fn(&ObjetRay<R>, &Rayon<R>) -> Mesuree<R>) -> Vec<(f64, f64)> {
    let decades = if R::U.vers_f64() > f64::EPSILON { 7 } else { 15 };
    let point = |dixieme: i32| {
        let loin = 10_f64.powf(f64::from(dixieme) / 4.0);
        let mut alea = Rng::with_seed(3);
        let mut ecarts: Vec<f64> = (0..2_000)
            .filter_map(|_| {
                let (d, cote) = (direction(&mut alea), direction(&mut alea));
                let cote = cote - d * cote.produit_scalaire(d);
                let centre = direction(&mut alea) * (loin * 0.5);
                let source = centre - d * (loin + 1.0) + cote * 0.7;
                let boule = SphereGeo::new(arrondi(centre), R::UN, Texture(0)).ok()?;
                let objet = ObjetGeo::from(boule).vers_ray();
                let rayon = Rayon::new(arrondi(source), arrondi(d)).ok()?;
                let entree = verite(&objet, &rayon).entree?;
                // A miss is as wrong as the sphere is large.
                Some(repondre(&objet, &rayon).map_or(2.0, |(t, _)| entree.ecart(t).abs()))
            })
            .collect();
        let [_, presque, _] = quantiles(&mut ecarts);
        (loin, presque.max(1e-18))
    };
    (0..=4 * decades).map(point).collect()
}

fn courbes() -> Result<(), Box<dyn Error>> {
    let simples = repondants::<f32>().map(|(nom, r)| (format!("{nom} f32"), courbe::<f32>(r)));
    let doubles = repondants::<f64>().map(|(nom, r)| (format!("{nom} f64"), courbe::<f64>(r)));
    let chemin = page::chemin("docs/images/erreur-distance.svg");
    let surface = SVGBackend::new(&chemin, (900, 520)).into_drawing_area();
    surface.fill(&WHITE)?;
    let mut graphe = ChartBuilder::on(&surface)
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(70)
        .build_cartesian_2d((1.0..1e15).log_scale(), (1e-18..10.0).log_scale())?;
    graphe
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("distance / radius")
        .y_desc("error of the distance / radius, 99.9 % of 2,000 rays")
        .x_label_formatter(&|x| format!("{x:.0e}"))
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .draw()?;
    for (i, (nom, points)) in simples.into_iter().chain(doubles).enumerate() {
        let couleur = COULEURS[i % 3];
        let epaisseur = if i < 3 { 1 } else { 3 };
        let style = couleur.stroke_width(epaisseur);
        graphe
            .draw_series(LineSeries::new(points, style))?
            .label(nom)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], style));
    }
    graphe
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerRight)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .draw()?;
    surface.present()?;
    Ok(())
}

/// The colours of ours, annex A, parry and our batch, which differ in lightness as well.
pub(crate) const COULEURS: [RGBColor; 4] =
    [RGBColor(0, 90, 181), RGBColor(220, 50, 32), RGBColor(225, 170, 30), RGBColor(20, 20, 20)];
