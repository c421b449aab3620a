//! The figures of `docs/conventions.md`, which draw what the library answers.
//!
//! `cargo run --bin figures` writes them again, and `tests/fichiers/figures.rs` compares the committed ones
//! with this code, byte for byte. Sines and roots come only from `lancer_rayon`, so that every machine draws the same
//! bytes.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};
use std::fmt::{self, Display, Write};

use lancer_rayon::{
    BoiteGeo, Face, NoIntersection, ObjetRay, PlanGeo, Rayon, Rotation, SphereGeo, Texture,
    Vecteur, premiere_intersection,
};

/// Where the figures stand.
const DOSSIER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../images");

type Resultat<T> = Result<T, Box<dyn Error>>;

fn main() -> Resultat<()> {
    for (nom, svg) in figures()? {
        std::fs::write(format!("{DOSSIER}/{nom}"), svg)?;
    }
    Ok(())
}

/// Each figure with the name of its file.
pub(crate) fn figures() -> Resultat<[(&'static str, String); 4]> {
    Ok([
        ("rotations.svg", rotations()?),
        ("demi-espace.svg", demi_espace()?),
        ("sphere.svg", sphere()?),
        ("boite.svg", boite()?),
    ])
}

const ENCRE: &str = "#222222";
const GRIS: &str = "#767676";
const FOND: &str = "#e6eaf0";
const ACCENT: &str = "#b3541e";
/// For x, y and z.
const AXES: [&str; 3] = ["#b3261e", "#1b7a3d", "#2456a6"];
const NOMS: [&str; 3] = ["x", "y", "z"];
const UNITES: [Vecteur; 3] =
    [Vecteur::new(1.0, 0.0, 0.0), Vecteur::new(0.0, 1.0, 0.0), Vecteur::new(0.0, 0.0, 1.0)];
const TIRETS: &str = r#" stroke-dasharray="5 4""#;
const PLEIN: &str = "";

type Pixel = [f64; 2];

/// A number with at most one digit after the point, and no −0.
struct Court(f64);

impl Display for Court {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", (self.0 * 10.0).round() / 10.0 + 0.0)
    }
}

/// A number as a reader writes it: a true minus, two digits.
fn nombre(x: f64) -> String {
    ((x * 100.0).round() / 100.0 + 0.0).to_string().replace('-', "−")
}

fn triple(v: Vecteur) -> String {
    format!("({}, {}, {})", nombre(v.x), nombre(v.y), nombre(v.z))
}

struct Dessin(String);

impl Dessin {
    fn new([largeur, hauteur]: [u32; 2], titre: &str) -> Self {
        Self(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{largeur}\" height=\"{hauteur}\" \
             viewBox=\"0 0 {largeur} {hauteur}\" role=\"img\" font-family=\"sans-serif\" \
             font-size=\"14\">\n<title>{titre}</title>\n\
             <rect width=\"{largeur}\" height=\"{hauteur}\" fill=\"#ffffff\"/>\n"
        ))
    }

    fn fini(mut self) -> String {
        self.0.push_str("</svg>\n");
        self.0
    }

    fn ligne(&mut self, points: &[Pixel], couleur: &str, style: &str) {
        self.forme("polyline", points, &format!(r#"fill="none" stroke="{couleur}"{style}"#));
    }

    fn forme(&mut self, nom: &str, points: &[Pixel], attributs: &str) {
        self.0.push_str(&format!("<{nom} points=\""));
        for (i, [x, y]) in points.iter().enumerate() {
            let espace = if i > 0 { " " } else { "" };
            self.0.push_str(&format!("{espace}{},{}", Court(*x), Court(*y)));
        }
        self.0.push_str(&format!(
            "\" stroke-width=\"1.6\" stroke-linejoin=\"round\" {attributs}/>\n"
        ));
    }

    /// A line with a head at its last point.
    fn fleche(&mut self, points: &[Pixel], couleur: &str, style: &str) {
        let [.., avant, bout] = points else { return };
        let d = Vecteur::new(bout[0] - avant[0], bout[1] - avant[1], 0.0);
        let Some(Vecteur { x, y, .. }) = d.unitaire() else { return };
        let (long, large) = (10.0, 4.0);
        let pied = [bout[0] - long * x, bout[1] - long * y];
        let coins = [
            *bout,
            [pied[0] - large * y, pied[1] + large * x],
            [pied[0] + large * y, pied[1] - large * x],
        ];
        let mut tige = points.to_vec();
        // The line ends at the foot of the head, unless the last piece of an arc is shorter.
        if d.longueur() > long {
            tige.pop();
            tige.push(pied);
        }
        self.ligne(&tige, couleur, style);
        self.forme("polygon", &coins, &format!(r#"fill="{couleur}""#));
    }

    fn rond(&mut self, [x, y]: Pixel, rayon: f64, attributs: &str) {
        let (x, y, rayon) = (Court(x), Court(y), Court(rayon));
        self.0.push_str(&format!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{rayon}\" stroke-width=\"1.6\" {attributs}/>\n"
        ));
    }

    fn point(&mut self, p: Pixel, couleur: &str) {
        self.rond(p, 3.5, &format!(r#"fill="{couleur}""#));
    }

    /// A point on the far side.
    fn point_creux(&mut self, p: Pixel, couleur: &str) {
        self.rond(p, 3.5, &format!(r##"fill="#ffffff" stroke="{couleur}""##));
    }

    /// Text around the anchor `start`, `middle` or `end`, with a rim of white that keeps lines off it.
    fn texte(&mut self, [x, y]: Pixel, ancre: &str, couleur: &str, texte: &str) {
        self.0.push_str(&format!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"{ancre}\" fill=\"{couleur}\" stroke=\"#ffffff\" \
             stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\">{texte}</text>\n",
            Court(x),
            Court(y)
        ));
    }
}

/// Where space stands in a figure. It is seen from afar, along −z of what `vue` makes of it.
struct Repere {
    origine: Pixel,
    echelle: f64,
    vue: Rotation,
}

impl Repere {
    fn pixel(&self, v: Vecteur) -> Pixel {
        let v = self.vue.appliquer(v) * self.echelle;
        [self.origine[0] + v.x, self.origine[1] - v.y]
    }

    fn pixels(&self, points: impl IntoIterator<Item = Vecteur>) -> Vec<Pixel> {
        points.into_iter().map(|v| self.pixel(v)).collect()
    }
}

/// A view from the right and above, which shows z, the axis that comes towards the viewer.
fn de_biais() -> Resultat<Rotation> {
    let lacet = Rotation::main_droite(Vecteur::new(0.0, -0.55, 0.0))?;
    Ok(lacet.puis(Rotation::main_droite(Vecteur::new(0.42, 0.0, 0.0))?))
}

fn decale([x, y]: Pixel, dx: f64, dy: f64) -> Pixel {
    [x + dx, y + dy]
}

/// Where V goes while the rotation about one axis grows to this angle.
fn arc(axe: usize, angle: f64, v: Vecteur, sens: Sens) -> Resultat<Vec<Vecteur>> {
    let pas = 24;
    (0..=pas)
        .map(|i| Ok(sens(UNITES[axe] * (angle * f64::from(i) / f64::from(pas)))?.appliquer(v)))
        .collect()
}

type Sens = fn(Vecteur) -> Result<Rotation, lancer_rayon::ErreurGeo>;

/// The axis that a vector lies along, with its sign.
fn nom_axe(v: Vecteur) -> Resultat<String> {
    for (unite, nom) in UNITES.into_iter().zip(NOMS) {
        if v == unite {
            return Ok(nom.to_owned());
        }
        if v == -unite {
            return Ok(format!("−{nom}"));
        }
    }
    Err(format!("{v:?} is no axis").into())
}

/// C1 and C2.
fn rotations() -> Resultat<String> {
    let mut dessin = Dessin::new([860, 330], "The axes and the sense of each rotation");
    let espace = Repere { origine: [135.0, 165.0], echelle: 95.0, vue: de_biais()? };
    for axe in 0..3 {
        let bout = espace.pixel(UNITES[axe] * 1.15);
        dessin.fleche(&[espace.pixel(Vecteur::NUL), bout], AXES[axe], PLEIN);
        let autour = arc(axe, 5.0, UNITES[(axe + 1) % 3] * 0.2, Rotation::new)?;
        let autour = autour.into_iter().map(|v| v + UNITES[axe] * 0.72);
        dessin.fleche(&espace.pixels(autour), ACCENT, PLEIN);
        let [dx, dy] = [[12.0, 5.0], [0.0, -8.0], [-10.0, 14.0]][axe];
        dessin.texte(decale(bout, dx, dy), "middle", AXES[axe], NOMS[axe]);
    }
    dessin.texte(decale(espace.pixel(Vecteur::NUL), -13.0, 1.0), "middle", ENCRE, "O");
    dessin.texte([135.0, 24.0], "middle", ENCRE, "z comes towards you");

    // Each axis in turn points at the viewer; the next is to the right and the one after it up.
    let de_face = Rotation::depuis_matrice([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])?;
    let vues = [de_face, de_face.inverse(), Rotation::IDENTITE];
    for axe in 0..3 {
        let (droite, haut) = ((axe + 1) % 3, (axe + 2) % 3);
        let x = 360.0 + 195.0 * axe as f64;
        let face = Repere { origine: [x, 165.0], echelle: 74.0, vue: vues[axe] };
        dessin.texte([x, 24.0], "middle", ENCRE, &format!("{} points at you", NOMS[axe]));
        let o = face.pixel(Vecteur::NUL);
        dessin.rond(o, face.echelle, &format!(r#"fill="none" stroke="{FOND}""#));
        for (i, dx, dy) in [(droite, 12.0, 5.0), (haut, 0.0, -7.0)] {
            let bout = face.pixel(UNITES[i] * 1.15);
            dessin.fleche(&[o, bout], AXES[i], PLEIN);
            dessin.texte(decale(bout, dx, dy), "middle", AXES[i], NOMS[i]);
        }
        let tour = |sens: Sens| arc(axe, FRAC_PI_6, UNITES[droite], sens);
        for (sens, couleur, style) in
            [(Rotation::main_droite as Sens, GRIS, TIRETS), (Rotation::new, ACCENT, PLEIN)]
        {
            let arrivee = tour(sens)?;
            let bout = arrivee.last().copied().unwrap_or(Vecteur::NUL);
            dessin.ligne(&[o, face.pixel(bout)], couleur, style);
            dessin.fleche(&face.pixels(arrivee), couleur, PLEIN);
        }
        dessin.rond(o, 6.0, &format!(r##"fill="#ffffff" stroke="{}""##, AXES[axe]));
        dessin.point(o, AXES[axe]);
        dessin.texte(decale(o, -13.0, -9.0), "middle", AXES[axe], NOMS[axe]);

        let trente = Rotation::new(UNITES[axe] * FRAC_PI_6)?.appliquer(UNITES[droite]);
        let quart = Rotation::new(UNITES[axe] * FRAC_PI_2)?;
        let [a, b] = [droite, haut].map(|i| nom_axe(quart.appliquer(UNITES[i])));
        let [depart, suivant] = [NOMS[droite], NOMS[haut]];
        dessin.texte([x, 262.0], "middle", ACCENT, &format!("30°: {depart} → {}", triple(trente)));
        let quart = format!("90°: {depart} → {}, {suivant} → {}", a?, b?);
        dessin.texte([x, 282.0], "middle", ACCENT, &quart);
    }
    dessin.texte([135.0, 262.0], "middle", ACCENT, "solid: Rotation::new");
    dessin.texte([135.0, 282.0], "middle", GRIS, "dashed: Rotation::main_droite");

    let mut suite =
        String::from("x, then y, then z, about axes that stay. Rotation::new((90°, 90°, 90°)): y");
    let mut v = UNITES[1];
    for axe in 0..3 {
        v = Rotation::new(UNITES[axe] * FRAC_PI_2)?.appliquer(v);
        write!(suite, ", about {} → {}", NOMS[axe], nom_axe(v)?)?;
    }
    let ensemble = Rotation::new(Vecteur::new(FRAC_PI_2, FRAC_PI_2, FRAC_PI_2))?;
    if ensemble.appliquer(UNITES[1]) != v {
        return Err("the three turns are not the turn".into());
    }
    dessin.texte([430.0, 314.0], "middle", ENCRE, &suite);
    Ok(dessin.fini())
}

/// C3.
fn demi_espace() -> Resultat<String> {
    let mut dessin = Dessin::new([820, 300], "The sign of d: N·X ≤ −d is solid");
    for (i, d, titre) in [(0, 1.0, "&gt; −d, O is outside"), (1, -1.0, "&lt; −d, O is inside")]
    {
        let cadre = [20.0 + 400.0 * f64::from(i), 40.0];
        let plan = Rotation::new(Vecteur::new(FRAC_PI_2, 0.0, 0.3))?;
        let plan = PlanGeo::new(plan, d, Texture(0))?.vers_ray();
        let (n, pied) = (plan.normale(), plan.normale() * -plan.distance());
        // The direction that lies in the surface and in the picture.
        let long = Rotation::new(Vecteur::new(0.0, 0.0, FRAC_PI_2))?.appliquer(n);
        let vue = Repere {
            origine: [cadre[0] + 150.0, cadre[1] + 110.0 - 45.0 * d],
            echelle: 75.0,
            vue: Rotation::IDENTITE,
        };
        let titre = format!("d = {}: N·O = 0 {titre}", nombre(d));
        dessin.texte([cadre[0] + 180.0, 24.0], "middle", ENCRE, &titre);
        // The frame cuts off what is beyond.
        let bords = [pied - long * 9.0, pied + long * 9.0];
        let solide = [bords[0], bords[1], bords[1] - n * 9.0, bords[0] - n * 9.0];
        let _ = write!(
            dessin.0,
            "<clipPath id=\"cadre{i}\"><rect x=\"{}\" y=\"{}\" width=\"360\" height=\"245\"/></clipPath>\n\
             <g clip-path=\"url(#cadre{i})\">\n",
            cadre[0], cadre[1]
        );
        dessin.forme("polygon", &vue.pixels(solide), &format!(r#"fill="{FOND}""#));
        dessin.ligne(&vue.pixels(bords), ENCRE, PLEIN);
        dessin.0.push_str("</g>\n");

        let (o, pied_px) = (vue.pixel(Vecteur::NUL), vue.pixel(pied));
        dessin.ligne(&[o, pied_px], GRIS, TIRETS);
        dessin.point(o, ENCRE);
        dessin.texte(decale(o, -12.0, 5.0), "end", ENCRE, "O");
        let milieu = vue.pixel(pied * 0.5);
        dessin.texte(
            decale(milieu, -12.0, 5.0),
            "end",
            ENCRE,
            &format!("|d| = {}", nombre(d.abs())),
        );
        let (depart, bout) = (vue.pixel(pied + long * 0.9), vue.pixel(pied + long * 0.9 + n * 0.8));
        dessin.fleche(&[depart, bout], ACCENT, PLEIN);
        dessin.texte(decale(bout, 12.0, 2.0), "start", ACCENT, "N, outward");
        dessin.texte(vue.pixel(pied + long * 1.4 - n * 0.6), "middle", ENCRE, "N·X ≤ −d: solid");
        dessin.texte(vue.pixel(pied + long * 2.3 + n * 0.27), "middle", ENCRE, "N·X = −d");
    }
    Ok(dessin.fini())
}

/// C7 and C8.
fn sphere() -> Resultat<String> {
    let mut dessin = Dessin::new([820, 400], "Which rays touch a sphere");
    let sphere = SphereGeo::new(Vecteur::NUL, 1.0, Texture(0))?.vers_ray();
    let vue = Repere { origine: [400.0, 200.0], echelle: 130.0, vue: Rotation::IDENTITE };
    let c = vue.pixel(sphere.centre());
    dessin.rond(c, sphere.rayon() * vue.echelle, &format!(r#"fill="{FOND}" stroke="{ENCRE}""#));
    let scene = [ObjetRay::from(sphere)];
    let p = |x, y| Vecteur::new(x, y, 0.0);
    let reponse = |rayon: &Rayon| match premiere_intersection(&scene, rayon) {
        Ok(touche) => format!("t = {}", nombre(touche.distance())),
        Err(NoIntersection) => "NoIntersection".to_owned(),
    };

    let rates = [
        (p(-2.8, 1.0), p(1.0, 0.0), 5.2, [0.0, -8.0], "start", "tangent: "),
        (p(0.25, 0.55), p(1.0, 0.12), 1.15, [157.0, -12.0], "start", "from inside: "),
        (p(0.6, -0.8), p(0.6, -0.8), 0.85, [24.0, 20.0], "start", "from the surface, outward: "),
        (p(-0.6, -0.8), p(0.3, 1.0), 0.36, [0.0, 20.0], "end", "from the surface, inward: "),
        (p(1.35, -0.1), p(1.0, 0.0), 1.3, [0.0, -10.0], "start", "moving away: "),
    ];
    for (source, direction, longueur, [dx, dy], ancre, quoi) in rates {
        let rayon = Rayon::new(source, direction)?;
        let s = vue.pixel(rayon.source());
        dessin.fleche(&[s, vue.pixel(rayon.point(longueur))], GRIS, TIRETS);
        dessin.point(s, GRIS);
        dessin.texte(decale(s, dx, dy), ancre, GRIS, &format!("{quoi}{}", reponse(&rayon)));
    }

    let rayon = Rayon::new(p(-2.8, -0.4), p(1.0, 0.0))?;
    let touche = premiere_intersection(&scene, &rayon)?;
    let sa = (sphere.centre() - rayon.source()).produit_scalaire(rayon.direction());
    let (s, a, b) =
        (vue.pixel(rayon.source()), vue.pixel(rayon.point(sa)), rayon.point(touche.distance()));
    // A is halfway between where the ray enters and where it leaves.
    let sortie = vue.pixel(rayon.point(2.0 * sa - touche.distance()));
    dessin.ligne(&[c, a], GRIS, TIRETS);
    dessin.ligne(&[s, sortie], ACCENT, PLEIN);
    dessin.fleche(&[sortie, vue.pixel(rayon.point(4.6))], ACCENT, PLEIN);
    dessin.fleche(&[vue.pixel(b), vue.pixel(b + touche.normale() * 0.6)], AXES[2], PLEIN);
    let n = vue.pixel(b + touche.normale() * 0.6);
    dessin.texte(decale(n, -8.0, 2.0), "end", AXES[2], "N");
    dessin.point(s, ACCENT);
    dessin.texte(decale(s, 0.0, -10.0), "middle", ACCENT, "S");
    dessin.point(vue.pixel(b), ACCENT);
    let entree = format!("entry, SA − AB: {}", reponse(&rayon));
    dessin.texte(decale(vue.pixel(b), -12.0, -10.0), "end", ACCENT, &entree);
    dessin.point_creux(sortie, ACCENT);
    dessin.texte(decale(sortie, 12.0, 18.0), "start", ACCENT, "SA + AB: where it leaves");
    dessin.point(a, ENCRE);
    dessin.texte(decale(a, 0.0, 20.0), "middle", ENCRE, "A");
    dessin.point(c, ENCRE);
    dessin.texte(decale(c, -10.0, -4.0), "end", ENCRE, "C");
    Ok(dessin.fini())
}

/// C11.
fn boite() -> Resultat<String> {
    let mut dessin = Dessin::new([860, 400], "The three faces of a box, before and after a turn");
    let dimensions = Vecteur::new(2.4, 1.4, 1.8);
    let tournee = Rotation::new(Vecteur::new(0.0, 0.0, -FRAC_PI_6))?;
    for (x, titre, rotation) in [
        (210.0, "faces towards +x, +y, +z", Rotation::IDENTITE),
        (640.0, "the same three, −30° about z", tournee),
    ] {
        let boite = BoiteGeo::new(Vecteur::NUL, dimensions, rotation, Texture(0))?.vers_ray();
        let vue = Repere { origine: [x, 205.0], echelle: 95.0, vue: de_biais()? };
        dessin.texte([x, 24.0], "middle", ENCRE, titre);
        let (normales, l) = (boite.normales(), boite.demi_longueurs());
        let coin = |signes: [f64; 3]| {
            (0..3).fold(boite.centre(), |p, i| p + normales[i] * (l[i] * signes[i]))
        };
        let face = |i: usize, cote: f64| {
            [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[a, b]| {
                let mut signes = [cote; 3];
                (signes[(i + 1) % 3], signes[(i + 2) % 3]) = (a, b);
                vue.pixel(coin(signes))
            })
        };
        let centres = Face::TOUTES.map(|face| boite.face(face).0);
        for (i, normale) in normales.into_iter().enumerate() {
            if vue.vue.appliquer(normale).z <= 0.0 {
                return Err("a face that the figure names is hidden".into());
            }
            dessin.forme(
                "polygon",
                &face(i, -1.0),
                &format!(r##"fill="none" stroke="#c0c0c0"{TIRETS}"##),
            );
        }
        for (i, couleur) in AXES.into_iter().enumerate() {
            let attributs = format!(r#"fill="{couleur}" fill-opacity="0.1" stroke="{ENCRE}""#);
            dessin.forme("polygon", &face(i, 1.0), &attributs);
        }
        let c = vue.pixel(boite.centre());
        for i in 0..3 {
            let (cf, co) = (vue.pixel(centres[i]), vue.pixel(centres[i + 3]));
            dessin.ligne(&[co, cf], AXES[i], TIRETS);
            let bout = vue.pixel(centres[i] + normales[i] * 0.75);
            dessin.fleche(&[cf, bout], AXES[i], PLEIN);
            dessin.point(cf, AXES[i]);
            dessin.point_creux(co, AXES[i]);
            let indice = ['₀', '₁', '₂'][i];
            let [n, f, o, m] = [
                [[12.0, 6.0], [8.0, 20.0], [-8.0, -8.0], [4.0, 18.0]],
                [[0.0, -9.0], [10.0, -2.0], [10.0, 14.0], [8.0, 4.0]],
                [[-10.0, 14.0], [10.0, 14.0], [8.0, -6.0], [-9.0, -5.0]],
            ][i];
            let milieu = vue.pixel((boite.centre() + centres[i]) * 0.5);
            let ancre = |dx: f64| if dx < 0.0 { "end" } else { "start" };
            for (p, [dx, dy], nom) in
                [(bout, n, "N"), (cf, f, "Cf"), (co, o, "Co"), (milieu, m, "l")]
            {
                dessin.texte(decale(p, dx, dy), ancre(dx), AXES[i], &format!("{nom}{indice}"));
            }
        }
        dessin.point(c, ENCRE);
        dessin.texte(decale(c, -8.0, 16.0), "end", ENCRE, "C");
    }
    let [x, y, z] = <[f64; 3]>::from(dimensions / 2.0).map(nombre);
    let suite = format!(
        "Nᵢ is row i of M; Cfᵢ = C + lᵢNᵢ, Coᵢ = C − lᵢNᵢ; lᵢ is half a dimension: {x}, {y}, {z}"
    );
    dessin.texte([430.0, 384.0], "middle", ENCRE, &suite);
    Ok(dessin.fini())
}
