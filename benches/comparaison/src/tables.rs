//! What is written about the cells: ours beside all others, in a table, a file and a plot.

use std::error::Error;

use banc::concurrents::Camp;
use banc::familles::Genre;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::cellules::Cellule;
use crate::page;

/// Whom a ratio compares.
pub(crate) struct Question {
    nom: &'static str,
    scalaire: &'static str,
    ici: &'static [Camp],
    autres: &'static [Camp],
}

impl Question {
    /// Their time over ours.
    fn rapport(&self, cellule: &Cellule) -> f64 {
        cellule.ns(self.autres) / cellule.ns(self.ici)
    }

    /// Their time over ours in every cell with these rays, or with any, that has both.
    fn rapports<'a>(
        &self,
        cellules: &'a [Cellule],
        genre: Option<Genre>,
    ) -> Vec<(f64, &'a Cellule)> {
        let celles = cellules.iter().filter(|c| c.scalaire == self.scalaire);
        let celles = celles.filter(|c| genre.is_none_or(|genre| c.genre == genre));
        celles.map(|c| (self.rapport(c), c)).filter(|(x, _)| x.is_finite()).collect()
    }
}

const SEUL: &[Camp] = &[Camp::Seul];
const LOT: &[Camp] = &[Camp::Lot];
const DEPUIS: &[Camp] = &[Camp::Depuis];
const TOUT: &[Camp] = &[Camp::Seul, Camp::Lot, Camp::Depuis];
const AUTRES: &[Camp] = &[Camp::Parry, Camp::Embree, Camp::EmbreeSeize];

/// The kinds of rays that have a column in the summary.
const AU_RESUME: [Genre; 5] =
    [Genre::Tuiles, Genre::Miroirs, Genre::Diffus, Genre::SansOrdre, Genre::Ombres];

/// A table of the pages: what a row of it compares, and the rows.
pub(crate) struct Tableau {
    titre: &'static str,
    questions: &'static [Question],
}

/// Ours beside theirs.
pub(crate) const AUPRES_DES_AUTRES: Tableau = Tableau {
    titre: "A / ours",
    questions: &[
        Question {
            nom: "one by one: the better of parry and Embree",
            scalaire: "f32",
            ici: SEUL,
            autres: &[Camp::Parry, Camp::Embree],
        },
        Question {
            nom: "one by one, ours from its hit",
            scalaire: "f32",
            ici: DEPUIS,
            autres: &[Camp::Parry, Camp::Embree],
        },
        Question {
            nom: "fastest of all ways: parry, Embree ×1, ×16",
            scalaire: "f32",
            ici: TOUT,
            autres: AUTRES,
        },
        Question { nom: "one by one: parry", scalaire: "f64", ici: SEUL, autres: &[Camp::Parry] },
        Question {
            nom: "fastest of all ways: parry",
            scalaire: "f64",
            ici: TOUT,
            autres: &[Camp::Parry],
        },
    ],
};

/// Ours one by one beside our batch.
pub(crate) const EN_LOT: Tableau = Tableau {
    titre: "A / B",
    questions: &[
        Question { nom: "one by one / in a batch", scalaire: "f32", ici: LOT, autres: SEUL },
        Question { nom: "one by one / in a batch", scalaire: "f64", ici: LOT, autres: SEUL },
    ],
};

/// Ours one by one, without and with the hit that a ray leaves.
pub(crate) const D_UNE_TOUCHE: Tableau = Tableau {
    titre: "A / B",
    questions: &[
        Question { nom: "one by one / from its hit", scalaire: "f32", ici: DEPUIS, autres: SEUL },
        Question { nom: "one by one / from its hit", scalaire: "f64", ici: DEPUIS, autres: SEUL },
    ],
};

/// The questions of the two halves of the plot.
const DESSINEES: [Question; 2] = [
    Question {
        nom: "one by one: the better of parry and Embree, over ours",
        scalaire: "f32",
        ici: SEUL,
        autres: &[Camp::Parry, Camp::Embree],
    },
    Question {
        nom: "the fastest of all their ways over the fastest of ours",
        scalaire: "f32",
        ici: TOUT,
        autres: AUTRES,
    },
];

/// Nanoseconds in three digits or more; nothing for those who did not run.
pub(crate) fn nanosecondes(ns: f64) -> String {
    match ns {
        _ if ns.is_nan() => String::new(),
        _ if ns < 100.0 => format!("{ns:.1}"),
        _ => format!("{ns:.0}"),
    }
}

/// A ratio in two digits or three; a dash for those who did not run.
fn rapport(x: f64) -> String {
    if x.is_nan() { "–".into() } else { format!("{x:.*}", if x < 10.0 { 2 } else { 0 }) }
}

/// The geometric mean, the least ratio and its cell; nothing without cells.
fn resumer<'a>(rapports: &[(f64, &'a Cellule)]) -> Option<(f64, f64, &'a Cellule)> {
    let (moindre, ou) = rapports.iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let somme: f64 = rapports.iter().map(|(x, _)| x.ln()).sum();
    Some(((somme / rapports.len() as f64).exp(), *moindre, ou))
}

/// Each question over all families: the geometric mean and the least; and how many cells are behind, with all kinds of
/// rays.
pub(crate) fn resume(tableau: &Tableau, cellules: &[Cellule]) -> String {
    let titres = AU_RESUME.map(Genre::nom).join(" | ");
    let mut table = vec![
        format!("| {} | scalar | {titres} | below 1 (least) |", tableau.titre),
        format!("|---|---|{}---|", "--:|".repeat(AU_RESUME.len())),
    ];
    for question in tableau.questions {
        let case = |genre| match resumer(&question.rapports(cellules, Some(genre))) {
            Some((moyenne, moindre, _)) => format!("{} ({})", rapport(moyenne), rapport(moindre)),
            None => "–".to_owned(),
        };
        let cases = AU_RESUME.map(case).join(" | ");
        let tous = question.rapports(cellules, None);
        let derriere = tous.iter().filter(|(x, _)| *x < 1.0).count();
        let le_moindre = rapport(resumer(&tous).map_or(f64::NAN, |(_, moindre, _)| moindre));
        let (Question { nom, scalaire, .. }, sur) = (question, tous.len());
        table
            .push(format!("| {nom} | {scalaire} | {cases} | {derriere} of {sur} ({le_moindre}) |"));
    }
    table.join("\n")
}

/// The plot in five rows: the geometric mean, the least ratio, and where that is.
pub(crate) fn vitesse(cellules: &[Cellule]) -> Vec<String> {
    let titres =
        "rays,single_mean,single_least,single_where,fastest_mean,fastest_least,fastest_where";
    let mut table = vec![titres.to_owned()];
    for (genre, nom) in [
        (Genre::Tuiles, "camera, in tiles"),
        (Genre::Miroirs, "mirrors"),
        (Genre::Diffus, "diffuse light"),
        (Genre::SansOrdre, "in no order"),
        (Genre::Ombres, "shadows"),
    ] {
        let cases = DESSINEES.map(|q| match resumer(&q.rapports(cellules, Some(genre))) {
            Some((moyenne, moindre, ou)) => {
                let (moyenne, moindre) = (rapport(moyenne), rapport(moindre));
                format!("{moyenne},{moindre},{} of {}", ou.famille.nom(), ou.n)
            }
            None => ",,".to_owned(),
        });
        // A name may hold a comma.
        table.push(format!("\"{nom}\",{}", cases.join(",")));
    }
    table
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
    let moities = [GAUCHE, GAUCHE + colonnes * LARGE + ECART];
    for (x, question) in moities.into_iter().zip(DESSINEES) {
        let titre = (x + colonnes * LARGE / 2, 14);
        surface.draw(&Text::new(question.nom, titre, au_milieu(police(14, BLACK))))?;
        for (x, genre) in (x..).step_by(LARGE as usize).zip(Genre::TOUS) {
            let titre = (x + LARGE / 2, TETE - 11);
            surface.draw(&Text::new(genre.nom(), titre, au_milieu(police(12, BLACK))))?;
            for (i, scene) in scenes.iter().enumerate() {
                let cellule =
                    scene.iter().find(|c| c.genre == genre).expect("every kind was timed");
                let r = question.rapport(cellule);
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
