//! Speed against accuracy, one point for each variant, for `docs/vitesse.md`; and every way to ask for the picture.

use std::error::Error;

use banc::concurrents::{Camp, Reponse, temps};
use banc::familles::{Famille, Genre};
use fastrand::Rng;
use lancer_rayon::{Monde, NoIntersection, ObjetRay, Rayon, premiere_intersection};
use plotters::prelude::*;

use crate::autres::{
    Scalaire, distance, en_morceaux, exiger_accord, exiger_memes_bits, rivaux, tous,
};
use crate::exactitude::{self, COULEURS, repondants};
use crate::page;
use crate::tables::nanosecondes;
use commun::litteral;
use commun::mesure::{mesurer, quantiles};
use commun::oracle::verite;
use commun::regimes::regimes;

type Mesures<R> = (((&'static str, Camp), exactitude::Repondant<R>), Vec<Reponse>);

/// The true first object of a ray, by its texture, and its distance.
type Verite = Option<(u32, f64)>;

/// How many cases each regime of the extremes has, and the seed of these cases.
const CAS: u32 = 20_000;
const GRAINE: u64 = 1;

#[derive(Clone)]
struct Variante {
    nom: &'static str,
    scalaire: &'static str,
    ns: f64,
    /// Those in the picture, on the numbers of its own scene.
    erreurs: Erreurs,
    /// Wrong hits and misses per million cases of the extremes.
    fausses: f64,
}

/// Relative errors of the distances of rays that see the true object.
#[derive(Clone, Copy)]
struct Erreurs {
    presque: f64,
    pire: f64,
}

impl Erreurs {
    fn de(verites: &[Verite], reponses: &[Reponse]) -> Self {
        let vrais = verites.iter().zip(reponses).filter_map(|(verite, reponse)| {
            let ((objet, t), obtenu) = ((*verite)?, (*reponse)?);
            (obtenu.1 == objet).then(|| (distance(obtenu) - t).abs() / t)
        });
        let mut erreurs: Vec<_> = vrais.collect();
        let [_, presque, pire] = quantiles(&mut erreurs);
        Self { presque, pire }
    }

    /// What one in a thousand exceeds, with the largest in brackets.
    fn texte(self) -> String {
        format!("{:.0e} ({:.1e})", self.presque, self.pire)
    }
}

/// The times and errors of one scalar.
struct Mesuree {
    variantes: Vec<Variante>,
    /// Every way to ask, in nanoseconds a ray.
    temps: Vec<(&'static str, f64)>,
}

pub(crate) fn documenter() -> Result<(), Box<dyn Error>> {
    let [simples, doubles] = [mesures::<f32>()?, mesures::<f64>()?];
    let (table, extrait) = tables(&simples.variantes, &doubles.variantes);
    page::remplacer(crate::VITESSE, crate::VARIANTES, &page::datee(&table))?;
    page::remplacer(crate::README, crate::VARIANTES, &page::datee(&extrait))?;
    page::csv("facons", &facons(&simples.temps, &doubles.temps))?;
    graphique(&[simples.variantes, doubles.variantes].concat())
}

/// Time and errors of every variant, in `f32` and in `f64`; and of all but the list what README has of them.
fn tables(simples: &[Variante], doubles: &[Variante]) -> (String, String) {
    let mut table = vec![
        "| | f32: ms | error (largest) | wrong | f64: ms | error (largest) | wrong |".to_owned(),
        format!("|---|{}", "--:|".repeat(6)),
    ];
    let mut extrait = vec![
        "| | f32: ms | error | f64: ms | error |".to_owned(),
        format!("|---|{}", "--:|".repeat(4)),
    ];
    let cases = |Variante { ns, erreurs, fausses, .. }: &Variante| {
        format!("{} | {} | {fausses:.0}", millisecondes(*ns), erreurs.texte())
    };
    let peu = |Variante { ns, erreurs, .. }: &Variante| {
        format!("{} | {:.0e}", millisecondes(*ns), erreurs.presque)
    };
    for (simple, double) in simples.iter().zip(doubles) {
        table.push(format!("| {} | {} | {} |", simple.nom, cases(simple), cases(double)));
        if simple.nom != "list" {
            extrait.push(format!("| {} | {} | {} |", simple.nom, peu(simple), peu(double)));
        }
    }
    (table.join("\n"), extrait.join("\n"))
}

/// Every way to ask for the picture, in nanoseconds a ray.
fn facons(simples: &[(&str, f64)], doubles: &[(&str, f64)]) -> Vec<String> {
    let mut lignes = vec!["way,f32_ns_per_ray,f64_ns_per_ray".to_owned()];
    for (nom, ns) in simples {
        let double = doubles.iter().find(|(autre, _)| autre == nom);
        let double = double.map_or(f64::NAN, |(_, ns)| *ns);
        // A name may hold a comma.
        lignes.push(format!("\"{nom}\",{},{}", nanosecondes(*ns), nanosecondes(double)));
    }
    lignes
}

/// For the 240,000 rays, from the nanoseconds of one.
fn millisecondes(ns: f64) -> String {
    format!("{:.1}", 0.24 * ns)
}

/// Every variant over the whole picture.
fn mesures<R: Scalaire>() -> Result<Mesuree, Box<dyn Error>> {
    let scene = Famille::Atelier.scene::<R>(0, GRAINE);
    let mut memoire = Vec::new();
    let monde = en_morceaux(&scene.objets, &mut memoire)?;
    let rivaux = rivaux(&scene.objets);
    // The whole picture, in tiles.
    let rayons = Genre::Tuiles.rayons(&monde, &scene, 50);
    let mut concurrents = tous(monde, &rivaux, &rayons, &rayons, Genre::Tuiles);
    exiger_memes_bits(monde, &rayons)?;
    exiger_accord(&concurrents, |_| 3e4 * R::U.vers_f64())?;
    let ns = temps(&mut concurrents);
    let ns: Vec<_> = concurrents.iter().map(|qui| (qui.nom, qui.camp)).zip(ns).collect();
    let reponses = ["list", "annex A, enum", "parry, loop"].map(|nom| {
        let qui = concurrents.iter().find(|qui| qui.nom == nom);
        qui.expect("in so short a list all compete").reponses()
    });
    let verites: Vec<_> = rayons.iter().map(|rayon| premiere(&scene.objets, rayon)).collect();

    // The least time of this side among names that start so.
    let ns_de = |cote: Camp, noms: &str| {
        let ceux = ns.iter().filter(|((nom, camp), _)| *camp == cote && nom.starts_with(noms));
        ceux.map(|(_, ns)| *ns).fold(f64::NAN, f64::min)
    };
    let noms = ["list", "annex A", "parry"];
    let camps = [Camp::Seul, Camp::Annexe, Camp::Parry];
    let variante = |(((nom, camp), (_, repondre)), reponses): Mesures<R>| {
        let regimes = regimes::<R>();
        let mesures = regimes.iter().map(|r| mesurer(r, CAS, GRAINE, repondre));
        let fausses: u32 = mesures.map(|mesure| mesure.fausses).sum();
        let cas = f64::from(CAS) * regimes.len() as f64;
        Variante {
            nom,
            scalaire: R::NOM,
            ns: ns_de(camp, nom),
            erreurs: Erreurs::de(&verites, &reponses),
            fausses: 1e6 * f64::from(fausses) / cas,
        }
    };
    let repondants = repondants::<R>();
    let mut variantes: Vec<_> =
        noms.into_iter().zip(camps).zip(repondants).zip(reponses).map(variante).collect();
    exiger_exact_aux_extremes::<R>()?;
    // The same bits in less time.
    for (nom, ns) in [("tree", ns_de(Camp::Seul, "single")), ("batch", ns_de(Camp::Lot, "batch"))] {
        variantes.push(Variante { nom, ns, ..variantes[0].clone() });
    }
    let temps = ns.into_iter().map(|((nom, _), ns)| (nom, ns)).collect();
    Ok(Mesuree { variantes, temps })
}

/// Checks that the batch answers as the rays one by one do, errors included.
fn exiger_exact_aux_extremes<R: Scalaire>() -> Result<(), Box<dyn Error>> {
    for regime in regimes::<R>() {
        let mut alea = Rng::with_seed(GRAINE);
        for _ in 0..CAS {
            let cas = (regime.cas)(&mut alea);
            // Several are the same, since fewer would not go side by side.
            let (objets, mut touches) = ([cas.objet], [Err(NoIntersection); 9]);
            Monde::de_liste(&objets).premieres_intersections(&[cas.rayon; 9], &mut touches)?;
            if touches != [premiere_intersection(&objets, &cas.rayon); 9] {
                return Err("the batch differs from its rays one by one".into());
            }
        }
    }
    Ok(())
}

/// The exact first hit; the earlier of two at a tie.
fn premiere<R: Scalaire>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Verite {
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
    // A name lies beside its point, from left to right, where it touches neither the edge of the plot nor the axes and
    // their names, nor a point or another name.
    let mut points: Vec<_> = variantes.iter().map(|v| (v, (v.ns, v.erreurs.presque))).collect();
    points.sort_by(|(a, _), (b, _)| a.ns.total_cmp(&b.ns));
    let coins = points.iter().map(|(_, point)| graphe.backend_coord(point));
    let mut pris: Vec<_> = coins.map(|(x, y)| [x - 6, y - 6, x + 6, y + 6]).collect();
    let (colonnes, lignes) = graphe.plotting_area().get_pixel_range();
    for (v, point) in points {
        // A colour per scalar.
        let couleur = COULEURS[usize::from(v.scalaire == "f64")];
        let nom = format!("{} {}", v.nom, v.scalaire);
        let (x, y) = graphe.backend_coord(&point);
        let large = 8 * nom.len() as i32;
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
        let nom = Text::new(nom, ou, ("sans-serif", 15).into_font());
        let element = EmptyElement::at(point) + Circle::new((0, 0), 6, couleur.filled()) + nom;
        graphe.draw_series([element])?;
    }
    surface.present()?;
    Ok(())
}
