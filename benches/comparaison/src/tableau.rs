//! Every family of scenes and kind of rays: ours beside all others, in two tables and a plot.

use std::error::Error;

use lancer_rayon::Hierarchie;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::concours::{Scalaire, Terrain, exiger_accord, exiger_memes_bits, places, temps};
use crate::concurrent::Camp;
use crate::page;
use commun::familles::{Famille, Genre};
use commun::horloge::nanosecondes;

const NOMBRES: [usize; 5] = [12, 48, 192, 1000, 10_000];

/// Of these the table has rows; the plot has them all.
const AU_TABLEAU: [usize; 5] = [12, 14, 30, 1000, 10_000];

/// How much of a picture: bands of 4,800 rays.
const BANDES: usize = 8;

/// So many rays may meet another object for others: where two objects touch, or where they meet the one again that
/// they have just left.
const TOLERANCE: f64 = 0.005;

/// The times of one kind of rays in one scene.
pub(crate) struct Cellule {
    famille: Famille,
    n: usize,
    scalaire: &'static str,
    genre: Genre,
    temps: Vec<(&'static str, Camp, f64)>,
}

impl Cellule {
    /// The least of these.
    fn ns(&self, camps: &[Camp]) -> f64 {
        let les_leurs = self.temps.iter().filter(|(_, camp, _)| camps.contains(camp));
        les_leurs.map(|(.., ns)| *ns).fold(f64::NAN, f64::min)
    }

    /// Theirs over ours.
    fn rapport(&self, question: &Question) -> f64 {
        self.ns(question.autres) / self.ns(question.ici)
    }
}

/// Whom a ratio compares.
struct Question {
    nom: &'static str,
    scalaire: &'static str,
    ici: &'static [Camp],
    autres: &'static [Camp],
}

const SEUL: &[Camp] = &[Camp::Seul];
const LOT: &[Camp] = &[Camp::Lot];
const TOUT: &[Camp] = &[Camp::Seul, Camp::Lot];
const AUTRES: &[Camp] = &[Camp::Parry, Camp::Embree, Camp::EmbreeSeize];

const QUESTIONS: [Question; 7] = [
    Question { nom: "one by one: parry", scalaire: "f32", ici: SEUL, autres: &[Camp::Parry] },
    Question { nom: "one by one: Embree", scalaire: "f32", ici: SEUL, autres: &[Camp::Embree] },
    Question {
        nom: "best: parry, Embree ×1 and ×16", scalaire: "f32", ici: TOUT, autres: AUTRES
    },
    Question { nom: "ours one by one, over our batch", scalaire: "f32", ici: LOT, autres: SEUL },
    Question { nom: "one by one: parry", scalaire: "f64", ici: SEUL, autres: &[Camp::Parry] },
    Question { nom: "best: parry", scalaire: "f64", ici: TOUT, autres: &[Camp::Parry] },
    Question { nom: "ours one by one, over our batch", scalaire: "f64", ici: LOT, autres: SEUL },
];

/// All cells; first everyone's answers, then the times.
pub(crate) fn mesurer() -> Result<Vec<Cellule>, Box<dyn Error>> {
    verifier::<f32>()?;
    verifier::<f64>()?;
    let mut cellules = Vec::new();
    for famille in Famille::TOUTES {
        for &n in famille.nombres(&NOMBRES) {
            courir::<f32>(famille, n, &mut cellules);
            courir::<f64>(famille, n, &mut cellules);
        }
        println!("{} timed", famille.nom());
    }
    Ok(cellules)
}

/// List, hierarchy and batches to the bit in every family, before anything is timed.
fn verifier<R: Scalaire>() -> Result<(), Box<dyn Error>> {
    for famille in Famille::TOUTES {
        for &n in famille.nombres(&NOMBRES) {
            let scene = famille.scene::<R>(n, &page::chemin("docs"));
            let mut places = places(&scene.objets);
            let hierarchie = Hierarchie::new(&scene.objets, &mut places)?;
            let mut terrain = Terrain::new(scene.objets.clone());
            let (_, mut concurrents) = terrain.entrer();
            for genre in Genre::TOUS {
                let ou = format!("{} {n} {} {}", famille.nom(), R::NOM, genre.nom());
                let lances = genre.rayons(&hierarchie, &scene, BANDES);
                let juge = exiger_memes_bits(&hierarchie, &lances).and_then(|()| {
                    let ombres = genre == Genre::Ombres;
                    exiger_accord(&mut concurrents, &lances, ombres, TOLERANCE)
                });
                juge.map_err(|erreur| format!("{ou}: {erreur}"))?;
            }
        }
        println!("{} {}: all agree", famille.nom(), R::NOM);
    }
    Ok(())
}

fn courir<R: Scalaire>(famille: Famille, n: usize, cellules: &mut Vec<Cellule>) {
    let scene = famille.scene::<R>(n, &page::chemin("docs"));
    let mut terrain = Terrain::new(scene.objets.clone());
    let (hierarchie, mut concurrents) = terrain.entrer();
    concurrents.retain(|qui| qui.camp != Camp::Annexe);
    for genre in Genre::TOUS {
        let lances = genre.rayons(&hierarchie, &scene, BANDES);
        let temps = temps(&mut concurrents, &lances, genre == Genre::Ombres);
        cellules.push(Cellule { famille, n, scalaire: R::NOM, genre, temps });
    }
}

/// A ratio in two digits or three; a dash for who did not run.
fn rapport(x: f64) -> String {
    if x.is_nan() { "–".into() } else { format!("{x:.*}", if x < 10.0 { 2 } else { 0 }) }
}

/// Each question over all families: the geometric mean, the least, and how many cells are behind.
pub(crate) fn resume(cellules: &[Cellule]) -> String {
    let titres = Genre::TOUS.map(Genre::nom).join(" | ");
    let mut table = vec![
        format!("| theirs / ours | scalar | {titres} | below 1 |"),
        format!("|---|---|{}--:|", "--:|".repeat(Genre::TOUS.len())),
    ];
    for question in &QUESTIONS {
        let rapports = |genre: Option<Genre>| -> Vec<f64> {
            let celles = cellules.iter().filter(|c| c.scalaire == question.scalaire);
            let celles = celles.filter(|c| genre.is_none_or(|genre| c.genre == genre));
            celles.map(|c| c.rapport(question)).filter(|x| x.is_finite()).collect()
        };
        let case = |genre| {
            let rapports = rapports(Some(genre));
            let moyenne =
                (rapports.iter().map(|x| x.ln()).sum::<f64>() / rapports.len() as f64).exp();
            let moindre = rapports.iter().copied().fold(f64::NAN, f64::min);
            format!("{} ({})", rapport(moyenne), rapport(moindre))
        };
        let tous = rapports(None);
        let derriere = tous.iter().filter(|x| **x < 1.0).count();
        let cases = Genre::TOUS.map(case).join(" | ");
        let Question { nom, scalaire, .. } = question;
        table.push(format!("| {nom} | {scalaire} | {cases} | {derriere} of {} |", tous.len()));
    }
    table.join("\n")
}

/// What each family takes in `f32`, and what the others take.
pub(crate) fn table(cellules: &[Cellule]) -> String {
    let mut table = vec![
        "| family | N | tiles one by one, ns | parry | Embree | tiles in a batch, ns | parry | Embree ×16 \
         | diffuse, ns | others | shadows, ns | others |"
            .to_owned(),
        format!("|---|--:|{}", "--:|".repeat(10)),
    ];
    let simples = cellules.iter().filter(|c| c.scalaire == "f32" && AU_TABLEAU.contains(&c.n));
    let simples: Vec<_> = simples.collect();
    for scene in simples.chunks(Genre::TOUS.len()) {
        let de = |genre| scene.iter().find(|c| c.genre == genre).expect("every kind was timed");
        let [tuiles, diffus, ombres] = [Genre::Tuiles, Genre::Diffus, Genre::Ombres].map(de);
        let mut cases = Vec::new();
        for (cellule, ici, autres) in [
            (tuiles, SEUL, &[&[Camp::Parry][..], &[Camp::Embree]][..]),
            (tuiles, LOT, &[&[Camp::Parry], &[Camp::EmbreeSeize]]),
            (diffus, TOUT, &[AUTRES]),
            (ombres, TOUT, &[AUTRES]),
        ] {
            let ns = cellule.ns(ici);
            cases.push(nanosecondes(ns));
            cases.extend(autres.iter().map(|autres| rapport(cellule.ns(autres) / ns)));
        }
        let Cellule { famille, n, .. } = tuiles;
        table.push(format!("| {} | {n} | {} |", famille.nom(), cases.join(" | ")));
    }
    table.join("\n")
}

/// Every cell in `f32`, blue where we are ahead and red where we are behind.
pub(crate) fn graphique(cellules: &[Cellule]) -> Result<(), Box<dyn Error>> {
    const LARGE: i32 = 52;
    const HAUT: i32 = 16;
    const GAUCHE: i32 = 122;
    const TETE: i32 = 46;
    const ECART: i32 = 14;
    let simples: Vec<_> = cellules.iter().filter(|c| c.scalaire == "f32").collect();
    let scenes: Vec<_> = simples.chunks(Genre::TOUS.len()).collect();
    let colonnes = Genre::TOUS.len() as i32;
    let separees =
        |i: usize| scenes[..=i].windows(2).filter(|s| s[0][0].famille != s[1][0].famille);
    let y = |i: usize| TETE + HAUT * i as i32 + 4 * separees(i).count() as i32;
    let taille = (GAUCHE + 2 * colonnes * LARGE + ECART + 8, y(scenes.len() - 1) + HAUT + 8);
    let chemin = page::chemin("docs/images/familles.svg");
    let surface = SVGBackend::new(&chemin, (taille.0 as u32, taille.1 as u32)).into_drawing_area();
    surface.fill(&WHITE)?;
    let police = |cote: i32, couleur: RGBColor| ("sans-serif", cote).into_font().color(&couleur);
    let au_milieu = |style: TextStyle<'static>| style.pos(Pos::new(HPos::Center, VPos::Center));
    let tous_seuls = Question {
        nom: "one by one: the better of parry and Embree, over ours",
        scalaire: "f32",
        ici: SEUL,
        autres: &[Camp::Parry, Camp::Embree],
    };
    let tous = Question { nom: "the best of all theirs over the best of ours", ..QUESTIONS[2] };
    for (x, question) in [(GAUCHE, tous_seuls), (GAUCHE + colonnes * LARGE + ECART, tous)] {
        let titre = (x + colonnes * LARGE / 2, 14);
        surface.draw(&Text::new(question.nom, titre, au_milieu(police(14, BLACK))))?;
        for (x, genre) in (x..).step_by(LARGE as usize).zip(Genre::TOUS) {
            let titre = (x + LARGE / 2, TETE - 11);
            surface.draw(&Text::new(genre.nom(), titre, au_milieu(police(12, BLACK))))?;
            for (i, scene) in scenes.iter().enumerate() {
                let cellule =
                    scene.iter().find(|c| c.genre == genre).expect("every kind was timed");
                let r = cellule.rapport(&question);
                let (haut, bas) = ((x + 1, y(i) + 1), (x + LARGE - 1, y(i) + HAUT - 1));
                surface.draw(&Rectangle::new([haut, bas], teinte(r).filled()))?;
                let milieu = (x + LARGE / 2, y(i) + HAUT / 2 + 1);
                let encre = if r > 2.6 { WHITE } else { BLACK };
                surface.draw(&Text::new(rapport(r), milieu, au_milieu(police(12, encre))))?;
            }
        }
    }
    for (i, scene) in scenes.iter().enumerate() {
        let nom = format!("{} {}", scene[0].famille.nom(), scene[0].n);
        let style = police(12, BLACK).pos(Pos::new(HPos::Right, VPos::Center));
        surface.draw(&Text::new(nom, (GAUCHE - 8, y(i) + HAUT / 2 + 1), style))?;
    }
    surface.present()?;
    Ok(())
}

/// White at 1, full blue at 4, full red at 1/2.
fn teinte(rapport: f64) -> RGBColor {
    let vers = |loin: [f64; 3], part: f64| {
        let [r, v, b] = loin.map(|x| (255.0 + (x - 255.0) * part.clamp(0.0, 1.0)) as u8);
        RGBColor(r, v, b)
    };
    if rapport < 1.0 {
        vers([214.0, 60.0, 40.0], -rapport.log2())
    } else {
        vers([8.0, 88.0, 170.0], rapport.log2() / 2.0)
    }
}
