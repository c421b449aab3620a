//! The promises of `docs/precision.md`, one by one: which part of what is promised a case takes. Random cases
//! (`tests/precision/promesses.rs`), a search that climbs (`adversaire.rs`) and the tables of the pages
//! (`benches/comparaison`) all ask them.

use lancer_rayon::pour_les_tests::{self, PAS_ARRONDI, PUISSANCE_PERDUE};
use lancer_rayon::{
    Intersection, Nombre, ObjetRay, Rayon, Reel, Texture, Vecteur, premiere_intersection,
};

use crate::arrondi;
use crate::mesure::{
    absolu, absolu_fois, au_bord, lieu_permis, plus_grand, poids, rayon_non_perdu,
};
use crate::oracle::{
    ORACLE_ARRONDI, Passage, Verite, dehors, ecart_de_snell, ecart_du_cosinus, ecart_du_miroir,
    ecarts_du_lieu, hauteur, norme_au_carre_moins_un, verite, verite_du,
};
use crate::passages::{flou_du_point, flou_propre};
use crate::regimes::Genre;
use crate::tolerances::{profondeurs, promesses as permis, u};

/// What is asked: where this ray enters or leaves the first of these objects, or which of both it enters first; and the
/// direction in which the ray leaves the first: x, y, z, a height over the tangent plane, and whether that height
/// counts.
#[derive(Debug)]
pub struct Essai<R> {
    pub objets: Vec<ObjetRay<R>>,
    pub rayon: Rayon<R>,
    pub passage: Passage,
    pub vers: [R; 5],
}

/// Which part of what is promised a case takes. Above 1 the promise is broken.
pub type Part<R> = fn(&Essai<R>) -> f64;

/// Less than any case takes, where there is nothing to judge.
pub const RIEN: f64 = f64::NEG_INFINITY;

/// The promise is broken, and has no degrees.
pub const ROMPUE: f64 = 2.0;

/// A row of the table.
pub struct Promesse<R> {
    pub nom: &'static str,
    pub part: Part<R>,
    /// The shapes for whose hits it holds, and those for whose ways out it holds.
    pub genres: [&'static [Genre]; 2],
    /// How many times the error the bound may be in the median: for ordinary cases, and for each extreme.
    pub aisance: [f64; 2],
    /// Whether a search that climbs looks for the point where the answer changes.
    pub decide: bool,
}

impl<R> Promesse<R> {
    /// Whether it holds for this passage of such a shape.
    pub fn parle(&self, passage: Passage, genre: Genre) -> bool {
        self.genres[passage as usize].contains(&genre)
    }
}

/// All promises that one object and one ray decide.
pub fn toutes<R: Reel>() -> [Promesse<R>; 17] {
    const TOUS: &[Genre] = &Genre::TOUS;
    const RONDS: &[Genre] = &[Genre::Sphere];
    const PLATS: &[Genre] = &[Genre::Plan];
    const BOITES: &[Genre] = &[Genre::Boite];
    const BORNES: &[Genre] = &[Genre::Sphere, Genre::Boite];
    let promesse = |nom, part, genres| {
        let aisance = [f64::INFINITY; 2];
        Promesse { nom, part, genres, aisance, decide: false }
    };
    let decision = |nom, part, genres| Promesse { decide: true, ..promesse(nom, part, genres) };
    let aisee = |aisance, promesse| Promesse { aisance, ..promesse };
    [
        promesse("distance", distance, [TOUS; 2]),
        promesse("distance near 0", distance_pres_de_0, [PLATS, &[]]),
        decision("hit or miss", self::decision, [TOUS; 2]),
        promesse("length of the normal", longueur_de_la_normale, [TOUS; 2]),
        promesse("direction of the normal", direction_de_la_normale, [TOUS; 2]),
        promesse("the side to which the normal points", de_face, [TOUS; 2]),
        aisee([16.0, f64::INFINITY], promesse("margin", marge, [TOUS; 2])),
        promesse("infinite margins", marge_infinie, [RONDS; 2]),
        promesse("where a hit lies", lieu, [TOUS; 2]),
        promesse("where on its face", lieu_sur_la_face, [BOITES; 2]),
        promesse("secondary ray", secondaire, [TOUS, BORNES]),
        promesse("mirror", reflechi, [TOUS, &[]]),
        promesse("refraction", refracte, [TOUS; 2]),
        promesse("sun", soleil, [TOUS, &[]]),
        aisee([1.5; 2], promesse("erreur", erreur, [TOUS; 2])),
        decision("est_certain", est_certain, [TOUS, &[]]),
        decision("a glance", coup_d_oeil, [TOUS, &[]]),
    ]
}

/// Fails if a promise is broken by this ray, taken without its δ and its end, or by the rays that go from its passages
/// towards `vers`.
pub fn exiger<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, vers: Vecteur<R>) {
    let rayon = Rayon::new(rayon.source(), rayon.direction()).unwrap();
    let [x, y, z] = vers.into();
    for passage in Passage::TOUS {
        let vers = [x, y, z, R::ZERO, R::ZERO];
        let essai = Essai { objets: vec![*objet], rayon, passage, vers };
        for promesse in toutes() {
            if promesse.parle(passage, Genre::de(objet)) {
                let part = (promesse.part)(&essai);
                assert!(part <= 1.0, "{}: {part} of what is promised, {essai:?}", promesse.nom);
            }
        }
    }
}

fn touche<R: Reel>(cas: &Essai<R>) -> Option<Intersection<R>> {
    cas.passage.de(&cas.objets[0], &cas.rayon).ok()
}

fn la_verite<R: Reel>(cas: &Essai<R>) -> Verite {
    verite_du(cas.passage, &cas.objets[0], &cas.rayon)
}

/// The error of the distance, as a part of K·u·κt.
pub fn distance<R: Reel>(cas: &Essai<R>) -> f64 {
    let objet = &cas.objets[0];
    let Some(touche) = touche(cas) else { return RIEN };
    let verite = la_verite(cas);
    let Some(entree) = verite.entree else { return RIEN };
    let (relatif, absolu) = (entree.k * u::<R>() * entree.kappa_t, absolu(objet, &entree));
    // What underflow adds has a row of its own, since each would hide what a search finds of the other.
    if relatif == f64::INFINITY || absolu > 1e-3 * relatif {
        return RIEN;
    }
    entree.ecart(touche.distance()).abs() / (relatif + absolu)
}

/// The same for a half-space a few subnormals from the source, in units in which these numbers are not subnormal.
pub fn distance_pres_de_0<R: Reel>(cas: &Essai<R>) -> f64 {
    let Ok(touche) = cas.objets[0].intersection(&cas.rayon) else { return RIEN };
    let Some(entree) = verite(&cas.objets[0], &cas.rayon).entree else { return RIEN };
    let echelle = 200_f64.exp2();
    let relatif = entree.k * u::<R>() * (entree.kappa_t * echelle);
    if relatif == f64::INFINITY {
        return RIEN;
    }
    let absolu = absolu_fois(&entree, R::ETA.vers_f64() * echelle);
    entree.ecart_fois(touche.distance(), echelle).abs() / (relatif + absolu)
}

/// By how much the band would have to be wider to hold a wrong answer. A right answer scores the more the nearer it is
/// to the decision.
pub fn decision<R: Reel>(cas: &Essai<R>) -> f64 {
    let verite = la_verite(cas);
    let touche = touche(cas).is_some();
    let facteur = verite.facteur();
    let plus_grand = plus_grand::<R>();
    match verite.entree {
        // A distance that the type cannot hold is a miss.
        Some(entree) if entree.t.vers_f64() > plus_grand => RIEN,
        entree if entree.is_some() == touche => -facteur,
        Some(_) | None => facteur,
    }
}

/// How far the object that is answered lies behind the other, as a part of what is promised.
pub fn ordre<R: Reel>(cas: &Essai<R>) -> f64 {
    let Ok(premiere) = premiere_intersection(&cas.objets, &cas.rayon) else { return RIEN };
    let Texture(gagnant) = premiere.texture();
    let [gagnant, autre] = [gagnant as usize, 1 - gagnant as usize].map(|i| {
        let verite = verite(&cas.objets[i], &cas.rayon);
        let sure = i == gagnant as usize || !verite.dans_la_marge;
        let objet = &cas.objets[i];
        verite.entree.filter(|_| sure).map(|e| (e.k * u::<R>(), absolu(objet, &e), e))
    });
    let (Some((k, absolu, gagnant)), Some((k_autre, absolu_autre, autre))) = (gagnant, autre)
    else {
        return RIEN;
    };
    let avance = (&gagnant.t - &autre.t).vers_f64();
    avance / (k * gagnant.kappa_t + absolu + k_autre * autre.kappa_t + absolu_autre)
}

pub fn longueur_de_la_normale<R: Reel>(cas: &Essai<R>) -> f64 {
    let Some(touche) = touche(cas) else { return RIEN };
    let permis = match Genre::de(&cas.objets[0]) {
        Genre::Sphere => permis::UNITAIRE_SPHERE,
        Genre::Plan | Genre::Boite => permis::UNITAIRE_PLATE,
    };
    // |N| − 1 is half of |N|² − 1, up to the square of that.
    0.5 * norme_au_carre_moins_un(touche.normale()).abs() / (permis * u::<R>())
}

pub fn direction_de_la_normale<R: Reel>(cas: &Essai<R>) -> f64 {
    let Some(entree) = la_verite(cas).entree else { return RIEN };
    let Some(touche) = touche(cas) else { return RIEN };
    let permis = entree.direction_permise::<R>(entree.ecart(touche.distance()).abs());
    entree.ecart_de_normale(touche.normale()) / permis
}

pub fn marge<R: Reel>(cas: &Essai<R>) -> f64 {
    let Some(touche) = touche(cas) else { return RIEN };
    let marge = touche.marge().vers_f64();
    if marge == f64::INFINITY {
        return RIEN;
    }
    let p = cas.rayon.point(touche.distance());
    hauteur(&cas.objets[0], touche.normale(), p).abs() / marge
}

/// How far outside its object the point of a hit lies, as a part of what lemma 6 grants.
pub fn lieu<R: Reel>(cas: &Essai<R>) -> f64 {
    let Some(touche) = touche(cas) else { return RIEN };
    let p = cas.rayon.point(touche.distance());
    dehors(&cas.objets[0], p) / lieu_permis(&cas.objets[0], &cas.rayon, touche.distance())
}

/// How far the coordinates of a hit along its face are off.
pub fn lieu_sur_la_face<R: Reel>(cas: &Essai<R>) -> f64 {
    let (Some(touche), ObjetRay::Boite(boite)) = (touche(cas), cas.objets[0]) else {
        return RIEN;
    };
    let (t, (face, p)) = (touche.distance(), boite.lieu(&cas.rayon, &touche));
    let f = (cas.rayon.source().vers_f64() - boite.centre().vers_f64()).longueur();
    let ecarts = ecarts_du_lieu(&boite, &cas.rayon, t, p).into_iter().enumerate();
    let le_long = ecarts.filter(|(axe, _)| *axe != face as usize % 3);
    let pire = le_long.map(|(_, ecart)| ecart.abs()).fold(0.0, f64::max);
    pire / (permis::LIEU_FACE * u::<R>() * (f + t.vers_f64()))
}

/// How far P lies from a sphere that is nearly lost in its distance, as a part of what makes its margin infinite. Only
/// cases where P is hardly rounded count, since elsewhere that rounding alone decides.
pub fn marge_infinie<R: Reel>(cas: &Essai<R>) -> f64 {
    let objet = &cas.objets[0];
    let (Some(touche), ObjetRay::Sphere(sphere)) = (touche(cas), objet) else {
        return RIEN;
    };
    let (r, p) = (sphere.rayon().vers_f64(), cas.rayon.point(touche.distance()));
    let non_perdue = rayon_non_perdu(sphere, &cas.rayon, touche.distance());
    if r < 0.5 * non_perdue || u::<R>() * p.vers_f64().longueur() > r / 256.0 {
        return RIEN;
    }
    if touche.marge() == R::INFINI && r >= non_perdue {
        return ROMPUE;
    }
    let loin = (1.0 + PUISSANCE_PERDUE).sqrt() - 1.0;
    (dehors(objet, p).abs() / (loin * r.max(non_perdue))).min(1.0)
}

/// The score of a promise that holds or not, while it holds: below 1, and higher the nearer it is to failing.
fn tenue(ecart: f64) -> f64 {
    1.0 / (1.0 + ecart)
}

/// The normal of a hit points against the ray, that of a way out along it. No ray leaves before it enters, and a ray
/// that enters also leaves, except below a floor.
pub fn de_face<R: Reel>(cas: &Essai<R>) -> f64 {
    let [entree, sortie] = Passage::TOUS.map(|p| p.de(&cas.objets[0], &cas.rayon).ok());
    let bornee = Genre::de(&cas.objets[0]) != Genre::Plan;
    let en_ordre = match (entree, sortie) {
        (Some(entree), Some(sortie)) => bornee && entree.distance() <= sortie.distance(),
        (Some(_), None) => !bornee,
        (None, _) => true,
    };
    let Some(touche) = touche(cas) else { return if en_ordre { RIEN } else { ROMPUE } };
    let cosinus = touche.normale().produit_scalaire(cas.rayon.direction()).vers_f64();
    let cosinus = if cas.passage == Passage::Sortie { cosinus } else { -cosinus };
    if en_ordre && cosinus > 0.0 { tenue(cosinus / u::<R>()) } else { ROMPUE }
}

/// |f| plus the size of the object, for this ray.
fn grandeur<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>) -> f64 {
    let (bas, haut) =
        objet.etendue().map_or_else(Default::default, |e| (e.bas.vers_f64(), e.haut.vers_f64()));
    (rayon.source().vers_f64() - bas).longueur() + (haut - bas).longueur()
}

/// A secondary ray touches what it leaves only inward at the edge of a box, starts no farther away than promised, and
/// goes where it was sent. The score is higher the nearer the ray is to the tangent plane, to the surface and to an
/// edge.
pub fn secondaire<R: Reel>(cas: &Essai<R>) -> f64 {
    let objet = &cas.objets[0];
    let Some(touche) = touche(cas) else { return RIEN };
    let n = touche.normale();
    let [x, y, z, h, penche] = cas.vers;
    let v = Vecteur::new(x, y, z);
    let vers = if penche > R::ZERO {
        let v = v.vers_f64().unitaire().unwrap_or(Vecteur::NUL);
        let n = n.vers_f64();
        arrondi(v - n * n.produit_scalaire(v) + n * h.vers_f64())
    } else {
        v
    };
    let rayon = match touche.secondaire(vers) {
        Ok(rayon) => rayon,
        // There is no direction; or, below, a sphere is lost or a start is out of range.
        Err(erreur) if erreur.champ.starts_with("direction") => return RIEN,
        Err(_) => {
            let loin = touche.point().vers_f64().longueur() + touche.marge().vers_f64();
            return if loin < 0.5 * R::LIMITE.vers_f64() { ROMPUE } else { RIEN };
        }
    };
    let dedans = rayon.direction().produit_scalaire(n) < R::ZERO;
    // An outward ray has no way out of the object either, and an inward ray has one, except beside an edge, where it
    // may start on another face or beyond.
    let bornee = Genre::de(objet) != Genre::Plan;
    let au_fond =
        || dehors(objet, rayon.source()) < -permis::LIEU_F * u::<R>() * grandeur(objet, &rayon);
    if objet.sortie(&rayon).is_ok() != (dedans && bornee) && (!dedans || au_fond()) {
        return ROMPUE;
    }
    if let Ok(encore) = objet.intersection(&rayon)
        && !(dedans && au_bord(objet, &cas.rayon, &touche, rayon.source(), &encore))
    {
        return ROMPUE;
    }
    let (n, depart) = (n.vers_f64(), rayon.source().vers_f64());
    // The direction is turned outward by 12u, up to 8u too long at a right angle to that, and rounded in each
    // coordinate.
    let voulue = vers.vers_f64().unitaire().unwrap_or(Vecteur::NUL);
    let tournee = (rayon.direction().vers_f64() - voulue).longueur() / (20.0 * u::<R>());
    // The step is the margin and 20u of it, and 1.1u of the weights, along an N up to 6.1u too long, and rounds three
    // times. The start rounds in each coordinate, |P| included, and products underflow.
    let p = cas.rayon.point(touche.distance()).vers_f64();
    let de_la_marge = pour_les_tests::PAS_NORMAL + permis::UNITAIRE_PLATE + 3.0;
    let permis = touche.marge().vers_f64() * (1.0 + de_la_marge * u::<R>())
        + u::<R>() * (1.0 + 32.0 * u::<R>()) * (PAS_ARRONDI * poids(n, p) + p.longueur())
        + 8.0 * R::ETA.vers_f64();
    if tournee > 1.0 || (depart - p).longueur() > permis {
        return ROMPUE;
    }
    let cosinus = n.produit_scalaire(rayon.direction().vers_f64()).abs() / u::<R>();
    let (centre, [l0, l1, l2]) = match objet {
        ObjetRay::Sphere(s) => (s.centre().vers_f64(), [s.rayon().vers_f64(); 3]),
        ObjetRay::Plan(p) => (n * -p.distance().vers_f64(), [p.distance().vers_f64().abs(); 3]),
        ObjetRay::Boite(b) => (b.centre().vers_f64(), b.demi_longueurs().map(R::vers_f64)),
    };
    let arrondi = u::<R>() * (depart.longueur() + centre.longueur() + l0.max(l1).max(l2));
    let haut = hauteur(objet, touche.normale(), rayon.source()).abs() / arrondi;
    let bord = match objet {
        ObjetRay::Sphere(_) | ObjetRay::Plan(_) => 0.0,
        ObjetRay::Boite(b) => (0..3)
            .filter(|&axe| {
                b.normales()[axe] != touche.normale() && b.normales()[axe] != -touche.normale()
            })
            .map(|axe| {
                let o = b.normales()[axe].vers_f64().produit_scalaire(depart - centre);
                (o.abs() - [l0, l1, l2][axe]).abs() / arrondi
            })
            .fold(f64::INFINITY, f64::min),
    };
    0.5 * tenue(haut + cosinus) + 0.4 * tenue(bord)
}

/// How far a reflected direction is from that of an exact mirror.
pub fn reflechi<R: Reel>(cas: &Essai<R>) -> f64 {
    let (objet, d) = (&cas.objets[0], cas.rayon.direction());
    let Ok(touche) = objet.intersection(&cas.rayon) else { return RIEN };
    let Ok(reflet) = touche.reflechi(d) else { return RIEN };
    let n = touche.normale();
    let du_miroir = match Genre::de(objet) {
        Genre::Sphere => permis::REFLECHI_SPHERE,
        Genre::Plan | Genre::Boite => permis::REFLECHI_PLAT,
    };
    // A direction that was turned outward is above its plane by less than 20u.
    let rase = n.produit_scalaire(reflet.direction()).vers_f64() < 20.0 * u::<R>();
    let permis = du_miroir + if rase { permis::REFLECHI_REDRESSE } else { 0.0 };
    ecart_du_miroir(d, n, reflet.direction()) / (permis * u::<R>())
}

/// How far a refracted direction is from that of Snell's law. Where a wrong answer says whether light passes, how near
/// that decision is counts. `vers` begins with the ratio of the indices.
pub fn refracte<R: Reel>(cas: &Essai<R>) -> f64 {
    let (d, rapport) = (cas.rayon.direction(), cas.vers[0]);
    let eta = rapport.vers_f64();
    if !(eta > 0.0 && eta <= pour_les_tests::RAPPORT_MAXIMAL) {
        return RIEN;
    }
    let Some(touche) = touche(cas) else { return RIEN };
    let n = touche.normale();
    let suite = touche.refracte(d, rapport);
    let passe = match &suite {
        Ok(suite) => Some(suite.direction()),
        Err(erreur) if erreur.champ == "refraction" => None,
        Err(_) => return RIEN,
    };
    let (cosinus2, ecart) = ecart_de_snell(d, n, rapport, cas.passage, passe);
    let u = u::<R>() * (1.0 + eta);
    match (passe, ecart) {
        (Some(_), Some(ecart)) => ecart * cosinus2.sqrt() / (permis::REFRACTE * u),
        (None, _) if cosinus2 <= 0.0 => RIEN,
        // The decision differs from the exact one.
        (Some(_), None) | (None, _) => {
            let [n, d] = [n, d].map(Vecteur::vers_f64);
            let devant = n.produit_scalaire(d).abs() / (n.longueur() * d.longueur());
            cosinus2.abs() / (permis::REFRACTE_TOTALE * u * devant)
        }
    }
}

/// How far N·L is from the cosine of a sun in the direction in which the object is left.
pub fn soleil<R: Reel>(cas: &Essai<R>) -> f64 {
    let Ok(touche) = cas.objets[0].intersection(&cas.rayon) else { return RIEN };
    let [x, y, z, ..] = cas.vers;
    let (n, soleil) = (touche.normale(), Vecteur::new(x, y, z));
    let Ok(ombre) = touche.vers_soleil(soleil) else { return RIEN };
    let cosinus = n.produit_scalaire(ombre.direction());
    ecart_du_cosinus(n, soleil, cosinus).abs() / (permis::SOLEIL * u::<R>())
}

/// The least δ with which a ray that turns where it enters touches the object at once, as a part of the δ that it has;
/// 0 if it turns outside of the object.
pub fn virage<R: Reel>(cas: &Essai<R>) -> f64 {
    let objet = &cas.objets[0];
    let Ok(touche) = objet.intersection(&cas.rayon) else { return RIEN };
    let suite = cas.rayon.bifurque(touche.distance(), cas.rayon.direction());
    let Ok(suite) = suite else { return RIEN };
    if !objet.contient(suite.source()) {
        return 0.0;
    }
    let suffit = |part: f64| {
        let rayon = suite.avec_flou(R::depuis_f64(part * suite.flou().vers_f64()));
        let touche = rayon.ok().and_then(|rayon| objet.intersection(&rayon).ok());
        touche.is_some_and(|touche| touche.distance() == R::ZERO)
    };
    if !suffit(1.0) {
        // A ray that passes by the object, or leaves it by a face as near, need not touch it.
        return if [1.25, 2.0, 1024.0].into_iter().any(suffit) { ROMPUE } else { RIEN };
    }
    let (mut trop_peu, mut assez) = (0.0, 1.0);
    for _ in 0..16 {
        let milieu = (trop_peu + assez) / 2.0;
        if suffit(milieu) { assez = milieu } else { trop_peu = milieu }
    }
    assez
}

/// How deep a ray is on its way through an object that it does not touch, beyond what it knows of its place, as a part
/// of o_B; in a half-space, whose o_B is 0, as a part of that knowledge (lemma 22). The ray turns where another enters
/// the object, into the direction `vers`.
pub fn enfoncement<R: Reel>(cas: &Essai<R>) -> f64 {
    let (objet, [x, y, z, ..]) = (&cas.objets[0], cas.vers);
    let Ok(touche) = objet.intersection(&cas.rayon) else { return RIEN };
    let Ok(suite) = cas.rayon.bifurque(touche.distance(), Vecteur::new(x, y, z)) else {
        return RIEN;
    };
    if objet.intersection(&suite).is_ok() {
        return RIEN;
    }
    let loin = objet.sortie(&suite).map_or(suite.flou(), |sortie| sortie.distance());
    let part = |k: f64| {
        let t = R::depuis_f64(k * loin.vers_f64());
        let p = suite.point(t);
        let su = suite.flou().vers_f64() * (1.0 + 2.0 * u::<R>()) + flou_du_point(t, p);
        let profond = -dehors(objet, p);
        match objet {
            ObjetRay::Plan(_) => profond / su,
            ObjetRay::Sphere(_) | ObjetRay::Boite(_) => (profond - su) / flou_propre(objet),
        }
    };
    [0.0, 0.25, 0.5, 0.75].map(part).into_iter().fold(RIEN, f64::max)
}

/// How deep a ray from outside comes into an object before its entry, or anywhere if it misses, as a part of what the
/// table of lemma 22 grants S+tD and of the rounding in `f64` here.
pub fn effleurement<R: Reel>(cas: &Essai<R>) -> f64 {
    let (objet, rayon) = (&cas.objets[0], &cas.rayon);
    if objet.contient(rayon.source()) {
        return RIEN;
    }
    let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
    // About where the ray is deepest.
    let instants = match (objet.intersection(rayon), objet) {
        (Ok(touche), _) => [touche.distance().vers_f64(); 3],
        (Err(_), ObjetRay::Sphere(boule)) => {
            [(boule.centre().vers_f64() - s).produit_scalaire(d) / d.longueur_carree(); 3]
        }
        (Err(_), ObjetRay::Plan(_)) => [1.0, 1e3, 1e6].map(|k| k * s.longueur()),
        (Err(_), ObjetRay::Boite(boite)) => {
            let (mut entree, mut sortie) = (0.0_f64, f64::INFINITY);
            for (n, l) in boite.normales().into_iter().zip(boite.demi_longueurs()) {
                let n = n.vers_f64();
                let o = n.produit_scalaire(s - boite.centre().vers_f64());
                let v = n.produit_scalaire(d);
                let bord = l.vers_f64() * v.signum();
                entree = entree.max((-bord - o) / v);
                sortie = sortie.min((bord - o) / v);
            }
            [entree, sortie, (entree + sortie) / 2.0]
        }
    };
    instants.map(|t| profondeur_a(objet, rayon, t)).into_iter().fold(RIEN, f64::max)
}

/// How deep S+tD lies in an object that S is outside of, as a part of what `effleurement` grants.
pub fn profondeur_a<R: Reel>(objet: &ObjetRay<R>, rayon: &Rayon<R>, t: f64) -> f64 {
    let (s, d) = (rayon.source().vers_f64(), rayon.direction().vers_f64());
    if !(t >= 0.0 && t < R::INFINI.vers_f64()) {
        return RIEN;
    }
    let p = s + d * t;
    let [x, y, z] = <[f64; 3]>::from(p).map(f64::abs);
    let ([par_t, par_poids, par_taille], poids, taille) = match objet {
        ObjetRay::Sphere(boule) => {
            let (f, r) = ((s - boule.centre().vers_f64()).longueur(), boule.rayon().vers_f64());
            let pres = f < 2.0 * r;
            let ligne =
                if pres { profondeurs::D_UNE_SPHERE } else { profondeurs::D_UNE_SPHERE_LOIN };
            (ligne, 0.0, r)
        }
        ObjetRay::Plan(plan) => (profondeurs::D_UN_PLAN, poids(plan.normale().vers_f64(), p), 0.0),
        // |N_i·f| rounds by ρ, of which Σl is more.
        ObjetRay::Boite(boite) => {
            let l = Vecteur::from(boite.demi_longueurs().map(R::vers_f64));
            (profondeurs::D_UNE_BOITE, 0.0, l.longueur())
        }
    };
    let permis = par_t * t + par_poids * poids + par_taille * taille;
    let permis = u::<R>() * permis + f64::U * (x + y + z + t);
    -dehors(&objet.temoin_f64(), p) / (permis + 8.0 * R::ETA.vers_f64())
}

/// The error of the distance, in scene units or in lengths of D, whichever is more, as a part of `erreur`. Where there
/// is no entry, or no way out, `erreur` is +∞. What the oracle itself may have rounded does not count.
pub fn erreur<R: Reel>(cas: &Essai<R>) -> f64 {
    let Some(touche) = touche(cas) else { return RIEN };
    let borne = cas.objets[0].erreur(&cas.rayon, &touche).vers_f64();
    match la_verite(cas).entree {
        // In units in which neither error is subnormal.
        Some(entree) => {
            let echelle = if borne < 1e-200 { 200_f64.exp2() } else { 1.0 };
            let en_longueurs_de_d = entree.ecart_fois(touche.distance(), echelle).abs();
            let mesure = entree.ecart_mesure_fois(&cas.rayon, touche.distance(), echelle).abs();
            let arrondi = touche.distance().vers_f64() * ORACLE_ARRONDI * echelle;
            (mesure.max(en_longueurs_de_d) - arrondi).max(0.0) / (borne * echelle)
        }
        None if borne < f64::INFINITY => ROMPUE,
        None => RIEN,
    }
}

/// `est_certain` of a wrong answer breaks the promise. A right answer scores higher the nearer the decision is.
pub fn est_certain<R: Reel>(cas: &Essai<R>) -> f64 {
    let objet = &cas.objets[0];
    let verite = verite(objet, &cas.rayon);
    let touche = objet.intersection(&cas.rayon).is_ok();
    let plus_grand = plus_grand::<R>();
    match verite.entree {
        // A distance that the type cannot hold is a miss.
        Some(entree) if entree.ecart(plus_grand) < 0.0 => {
            if touche && objet.est_certain(&cas.rayon) { ROMPUE } else { RIEN }
        }
        ref entree if entree.is_some() == touche => tenue(verite.facteur()),
        Some(_) | None if objet.est_certain(&cas.rayon) => ROMPUE,
        Some(_) | None => 1.0,
    }
}

/// A glance that leaves out the true entry breaks the promise. The nearer one of its ends lies to the entry, in u of
/// the entry, the higher the score.
pub fn coup_d_oeil<R: Reel>(cas: &Essai<R>) -> f64 {
    let (objet, rayon) = (cas.objets[0].temoin_f64(), cas.rayon.temoin_f64());
    let vue = pour_les_tests::coup_d_oeil(&objet, &rayon);
    // Beyond the largest number there is no hit.
    let entree = verite(&objet, &rayon).entree.filter(|entree| entree.ecart(f64::MAX) >= 0.0);
    let Some(entree) = entree else {
        return if vue.haut < f64::INFINITY { ROMPUE } else { RIEN };
    };
    if vue.bas == f64::INFINITY {
        return ROMPUE;
    }
    let apres = -entree.ecart(vue.bas);
    let avant = if vue.haut < f64::INFINITY { entree.ecart(vue.haut) } else { f64::INFINITY };
    let (reste, arrondi) = (apres.min(avant), entree.t.vers_f64() * f64::U);
    if reste < 0.0 {
        return ROMPUE;
    }
    // No `f64` holds such an entry.
    if arrondi == 0.0 || arrondi == f64::INFINITY { RIEN } else { tenue(reste / arrondi) }
}
