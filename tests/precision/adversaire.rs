//! A directed search for what breaks the promises of `docs/precision.md`. For each promise it climbs on the bits of the
//! stored numbers of an object and a ray, towards the largest error as a part of the bound. Random cases come nowhere
//! near what it finds.
//!
//! By default each climb is short. This gives each promise 60 seconds and prints its worst case:
//!
//! ```sh
//! LANCER_RAYON_ADVERSAIRE=60 cargo test --release --test precision adversaire -- --nocapture
//! ```

use std::time::{Duration, Instant};

use commun::oracle::Passage;
use commun::promesses::{
    Essai, Part, Promesse, RIEN, distance_pres_de_0, effleurement, enfoncement, erreur, ordre,
    reflechi, refracte, soleil, toutes, virage,
};
use commun::regimes::{
    self, Cas, Genre, deux_puissance, direction, entre, presque, regimes, repere, signe,
    vers_la_sortie,
};
use commun::tolerances::u;
use commun::{Bits, arrondi, empreinte, en_f32_et_f64};
use fastrand::Rng;
use lancer_rayon::{
    BoiteGeo, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo, Texture, Vecteur,
    premiere_intersection,
};

/// How many steps in a row without a gain make the climb start again elsewhere.
const PATIENCE: u32 = 50;

/// How many cases a climb judges, unless it is told how long to take.
const ASSEZ: u32 = 10_000;

/// How many of the best cases are kept as starting points.
const SOMMETS: usize = 20;

/// What a number is: a length may be scaled with all other lengths, a row of a matrix may not.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Role {
    Longueur,
    Matrice,
    Vers,
}

/// The numbers that the climb moves: those of each object and of the ray, and the direction in which the object is
/// left, which is x, y, z, a height over the tangent plane, and whether that height counts.
#[derive(Debug, Clone)]
struct Candidat<R> {
    genres: Vec<Genre>,
    nombres: Vec<(Role, R)>,
    passage: Passage,
}

impl<R: Bits> Candidat<R> {
    fn new(objets: &[ObjetRay<R>], rayon: &Rayon<R>, vers: [R; 5]) -> Self {
        let mut nombres = Vec::new();
        let mut ajouter = |role, valeurs: &[R]| nombres.extend(valeurs.iter().map(|&x| (role, x)));
        let v = |v: Vecteur<R>| <[R; 3]>::from(v);
        for objet in objets {
            match objet {
                ObjetRay::Sphere(s) => {
                    ajouter(Role::Longueur, &v(s.centre()));
                    ajouter(Role::Longueur, &[s.rayon()]);
                }
                ObjetRay::Plan(p) => {
                    ajouter(Role::Longueur, &[p.distance()]);
                    ajouter(Role::Matrice, repere(p.normale()).as_flattened());
                }
                ObjetRay::Boite(b) => {
                    ajouter(Role::Longueur, &v(b.centre()));
                    ajouter(Role::Longueur, &b.demi_longueurs().map(|l| l + l));
                    ajouter(Role::Matrice, b.normales().map(v).as_flattened());
                }
            }
        }
        ajouter(Role::Longueur, &v(rayon.source()));
        ajouter(Role::Vers, &v(rayon.direction()));
        ajouter(Role::Vers, &vers);
        let genres = objets.iter().map(Genre::de).collect();
        Self { genres, nombres, passage: Passage::Entree }
    }

    /// The case that the constructors make of this candidate, whose numbers are then those that they stored.
    fn construire(&mut self) -> Option<Essai<R>> {
        fn prendre<R: Reel, const N: usize>(reste: &[(Role, R)], ou: &mut usize) -> [R; N] {
            let valeurs = core::array::from_fn(|i| reste[*ou + i].1);
            *ou += N;
            valeurs
        }
        fn rotation<R: Reel>(nombres: &mut [(Role, R)], ou: &mut usize) -> Option<Rotation<R>> {
            let debut = *ou;
            let m: [[R; 3]; 3] = core::array::from_fn(|_| prendre(nombres, ou));
            let r = Rotation::depuis_matrice(m).ok()?;
            for (nombre, x) in nombres[debut..*ou].iter_mut().zip(r.matrice().as_flattened()) {
                nombre.1 = *x;
            }
            Some(r)
        }
        let mut ou = 0;
        let mut objets = Vec::with_capacity(2);
        let nombres = &mut self.nombres;
        for (&genre, numero) in self.genres.iter().zip(0..) {
            let texture = Texture(numero);
            let objet: ObjetGeo<R> = match genre {
                Genre::Sphere => {
                    let centre: [R; 3] = prendre(nombres, &mut ou);
                    let [r] = prendre(nombres, &mut ou);
                    SphereGeo::new(centre.into(), r, texture).ok()?.into()
                }
                Genre::Plan => {
                    let [d] = prendre(nombres, &mut ou);
                    PlanGeo::new(rotation(nombres, &mut ou)?, d, texture).ok()?.into()
                }
                Genre::Boite => {
                    let centre: [R; 3] = prendre(nombres, &mut ou);
                    let dimensions: [R; 3] = prendre(nombres, &mut ou);
                    let r = rotation(nombres, &mut ou)?;
                    BoiteGeo::new(centre.into(), dimensions.into(), r, texture).ok()?.into()
                }
            };
            objets.push(objet.vers_ray());
        }
        let s: [R; 3] = prendre(nombres, &mut ou);
        let debut = ou;
        let d: [R; 3] = prendre(nombres, &mut ou);
        let rayon = Rayon::new(s.into(), d.into()).ok()?;
        let d: [R; 3] = rayon.direction().into();
        for (nombre, x) in nombres[debut..].iter_mut().zip(d) {
            nombre.1 = x;
        }
        Some(Essai { objets, rayon, passage: self.passage, vers: prendre(nombres, &mut ou) })
    }

    fn bouger(&mut self, alea: &mut Rng) {
        let fois = [1, 1, 1, 1, 2, 2, 3, 5][alea.usize(0..8)];
        for _ in 0..fois {
            self.bouger_une_fois(alea);
        }
    }

    fn bouger_une_fois(&mut self, alea: &mut Rng) {
        let (i, j) = (alea.usize(0..self.nombres.len()), alea.usize(0..self.nombres.len()));
        let (role, x) = self.nombres[i];
        let y = self.nombres[j].1;
        let nouveau = match alea.u8(0..24) {
            0..6 => depuis_mot(x.bits() ^ 1 << alea.u32(0..mantisse::<R>())),
            6 => depuis_mot(x.bits() ^ 1 << alea.u32(0..mots::<R>())),
            7..13 => {
                let portee = alea.u32(0..8);
                let pas = alea.u64(1..=1 << portee);
                let bits = x.bits();
                depuis_mot(if alea.bool() {
                    bits.wrapping_add(pas)
                } else {
                    bits.wrapping_sub(pas)
                })
            }
            13..17 => {
                let peu = deux_puissance(alea, -60.0, 0.0) * signe(alea);
                R::depuis_f64(x.vers_f64() * (1.0 + peu))
            }
            17 => {
                self.nombres[j].1 = x;
                y
            }
            18 => {
                let portee = [2, 2, 8, 64, 1_100][alea.usize(0..5)];
                R::depuis_f64(x.vers_f64() * f64::from(alea.i32(-portee..=portee)).exp2())
            }
            19 => {
                let k = f64::from(alea.i32(-60..=60)).exp2();
                for (role, x) in &mut self.nombres {
                    if *role == Role::Longueur {
                        *x = R::depuis_f64(x.vers_f64() * k);
                    }
                }
                return;
            }
            20 => y,
            21 => -x,
            22 => remarquable(alea),
            _ if role == Role::Matrice => {
                let debut = (0..=i).rev().find(|&k| self.nombres[k].0 != role).map_or(0, |k| k + 1);
                let m = tour::<R>(alea).matrice();
                for (nombre, x) in self.nombres[debut..].iter_mut().zip(m.as_flattened()) {
                    nombre.1 = *x;
                }
                return;
            }
            _ => R::depuis_f64(x.vers_f64() + y.vers_f64() * deux_puissance(alea, -60.0, 0.0)),
        };
        self.nombres[i].1 = nouveau;
    }

    /// Which object is hit, if one is.
    fn reponse(&mut self) -> Option<Option<Texture>> {
        let cas = self.construire()?;
        Some(premiere_intersection(&cas.objets, &cas.rayon).ok().map(|touche| touche.texture()))
    }

    /// The two neighbours between which the answer changes as one length moves, since decisions go wrong there or
    /// nowhere.
    fn a_la_decision(mut self, alea: &mut Rng) -> Option<[Self; 2]> {
        let longueurs = || (0..self.nombres.len()).filter(|&i| self.nombres[i].0 == Role::Longueur);
        let i = longueurs().nth(alea.usize(0..longueurs().count()))?;
        let ici = self.reponse()?;
        let depart = self.nombres[i].1.bits();
        // With another length the constructors change no other number.
        let mut avec = |bits: u64| {
            self.nombres[i].1 = depuis_mot(bits);
            self.reponse()
        };
        let mut proche = depart;
        let mut loin = (0..mantisse::<R>())
            .flat_map(|k| [proche.wrapping_add(1 << k), proche.wrapping_sub(1 << k)])
            .find(|&bits| avec(bits).is_some_and(|reponse| reponse != ici))?;
        while proche.abs_diff(loin) > 1 {
            let milieu = proche.midpoint(loin);
            if avec(milieu)? == ici { proche = milieu } else { loin = milieu }
        }
        Some([proche, loin].map(|bits| {
            let mut voisin = self.clone();
            voisin.nombres[i].1 = depuis_mot(bits);
            voisin
        }))
    }

    fn bits(&self) -> String {
        let mots: Vec<_> = self.nombres.iter().map(|(_, x)| format!("{:x}", x.bits())).collect();
        format!("{:?} [{}]", self.genres, mots.join(" "))
    }
}

fn mots<R: Reel>() -> u32 {
    if size_of::<R>() == 4 { 32 } else { 64 }
}

fn mantisse<R: Reel>() -> u32 {
    if size_of::<R>() == 4 { 23 } else { 52 }
}

/// The number whose last bits are the last of these.
fn depuis_mot<R: Bits>(bits: u64) -> R {
    R::depuis_bits(if size_of::<R>() == 4 { bits << 32 } else { bits })
}

fn remarquable<R: Reel>(alea: &mut Rng) -> R {
    let un = [R::ZERO, -R::ZERO, R::UN, R::ETA, R::LIMITE, R::UN / R::LIMITE, R::U];
    let x = match alea.usize(0..10) {
        i @ 0..7 => un[i],
        7 => R::depuis_f64(f64::from(alea.i8(-8..=8)) / 2.0),
        _ => peu_de_bits(alea),
    };
    if alea.bool() { x } else { -x }
}

/// A number near 1 whose mantissa has one to three bits.
fn peu_de_bits<R: Reel>(alea: &mut Rng) -> R {
    let mut x = 1.0;
    for _ in 0..alea.usize(0..3) {
        x += signe(alea) * f64::from(-alea.i32(1..=mantisse::<R>() as i32)).exp2();
    }
    R::depuis_f64(x * signe(alea) * f64::from(alea.i32(-3..=3)).exp2())
}

fn tour<R: Reel>(alea: &mut Rng) -> Rotation<R> {
    let angle = |alea: &mut Rng, quarts: bool| {
        let quart = f64::from(alea.i8(-4..=4)) * core::f64::consts::FRAC_PI_2;
        let presque = R::depuis_f64(quart + deux_puissance(alea, -50.0, -10.0));
        let ailleurs = R::depuis_f64(entre(alea, -7.0, 7.0));
        if quarts { R::depuis_f64(quart) } else { [presque, ailleurs][alea.usize(0..2)] }
    };
    let quarts = alea.bool();
    let r = [(); 3].map(|()| angle(alea, quarts));
    Rotation::new(r.into()).unwrap()
}

/// An object and a ray to start from: those of a regime, or numbers of few bits, with the ray towards the centre, a
/// corner or an edge, or along an axis.
fn depart<R: Bits>(genre: Genre, alea: &mut Rng) -> (ObjetRay<R>, Rayon<R>) {
    loop {
        if alea.u8(0..3) > 0 {
            let regimes = regimes::<R>();
            let regime = &regimes[alea.usize(0..regimes.len())];
            if regime.genre == genre {
                let cas = (regime.cas)(alea);
                return (cas.objet, cas.rayon);
            }
        } else if let Some(depart) = depart_de_peu_de_bits(genre, alea) {
            return depart;
        }
    }
}

fn depart_de_peu_de_bits<R: Bits>(genre: Genre, alea: &mut Rng) -> Option<(ObjetRay<R>, Rayon<R>)> {
    let bits = R::LIMITE.vers_f64().log2();
    let k = match alea.u8(0..6) {
        0 => 4.0 - bits,
        1 => bits - 5.0,
        _ => 0.0,
    };
    let k = R::depuis_f64(k.exp2());
    let lieu = |alea: &mut Rng| {
        Vecteur::from([(); 3].map(
            |()| {
                if alea.u8(0..4) == 0 { R::ZERO } else { peu_de_bits(alea) }
            },
        ))
    };
    let c = lieu(alea) * k;
    let taille = |alea: &mut Rng| peu_de_bits::<R>(alea).absolu() * k;
    let objet: ObjetGeo<R> = match genre {
        Genre::Sphere => SphereGeo::new(c, taille(alea), Texture(0)).ok()?.into(),
        Genre::Plan => PlanGeo::new(tour(alea), taille(alea), Texture(0)).ok()?.into(),
        Genre::Boite => {
            let dimensions = Vecteur::new(taille(alea), taille(alea), taille(alea));
            BoiteGeo::new(c, dimensions, tour(alea), Texture(0)).ok()?.into()
        }
    };
    let objet = objet.vers_ray();
    let s = lieu(alea) * (k * R::depuis_f64(8.0));
    let cible = match &objet {
        ObjetRay::Sphere(sphere) => {
            let n = sphere.rayon().vers_f64();
            c + arrondi(direction(alea) * (n * alea.f64()))
        }
        ObjetRay::Plan(_) => c,
        ObjetRay::Boite(boite) => (0..3).fold(c, |p, axe| {
            let ou = [1.0, 1.0, -1.0, -1.0, alea.f64()][alea.usize(0..5)];
            p + boite.normales()[axe] * (boite.demi_longueurs()[axe] * R::depuis_f64(ou))
        }),
    };
    let d = match alea.u8(0..3) {
        0 => {
            let mut d = [(); 3].map(|()| R::depuis_f64(deux_puissance(alea, -1_074.0, 0.0)));
            d[alea.usize(0..3)] = R::UN;
            d.into()
        }
        _ => cible - s,
    };
    Some((objet, Rayon::new(s, d).ok()?))
}

/// A direction in which to leave the object.
fn vers<R: Bits>(alea: &mut Rng) -> [R; 5] {
    let [x, y, z] = match alea.u8(0..3) {
        0 => arrondi(direction(alea)).into(),
        1 => [(); 3].map(|()| peu_de_bits(alea)),
        _ => {
            let mut d = [R::ZERO, R::depuis_f64(deux_puissance(alea, -1_074.0, 0.0)), R::UN];
            alea.shuffle(&mut d);
            d
        }
    };
    let h = match alea.u8(0..4) {
        0 => 0.0,
        1 => signe(alea) * u::<R>() * entre(alea, 0.0, 8.0),
        _ => signe(alea) * deux_puissance(alea, -60.0, 0.0),
    };
    [x, y, z, R::depuis_f64(h), if alea.bool() { R::UN } else { R::ZERO }]
}

fn un_objet<R: Bits>(genre: Genre, alea: &mut Rng) -> Candidat<R> {
    let (objet, rayon) = depart(genre, alea);
    Candidat::new(&[objet], &rayon, vers(alea))
}

/// An object and a second one, which is the first moved a little, or passes through the point of its hit.
fn deux_objets<R: Bits>(alea: &mut Rng) -> Candidat<R> {
    loop {
        let (objet, rayon) = depart::<R>(Genre::TOUS[alea.usize(0..3)], alea);
        let Ok(touche) = objet.intersection(&rayon) else { continue };
        let (p, n, texture) = (touche.point(), arrondi::<R>(direction(alea)), Texture(1));
        let n = if n.produit_scalaire(rayon.direction()) < R::ZERO { n } else { -n };
        let l = (touche.distance() + p.longueur()) * R::depuis_f64(deux_puissance(alea, -8.0, 2.0));
        let autre: Option<ObjetGeo<R>> = match alea.u8(0..4) {
            0 => SphereGeo::new(p - n * l, l, texture).ok().map(Into::into),
            1 => PlanGeo::par_un_point(p, n, texture).ok().map(Into::into),
            2 => {
                let tour = tour::<R>(alea);
                let axe = tour.axes()[alea.usize(0..3)];
                let axe =
                    if axe.produit_scalaire(rayon.direction()) < R::ZERO { axe } else { -axe };
                let centre = p - axe * (l * R::depuis_f64(0.5));
                BoiteGeo::new(centre, Vecteur::new(l, l, l), tour, texture).ok().map(Into::into)
            }
            _ => None,
        };
        let autre = autre.map_or_else(|| presque(&objet, texture, alea), ObjetGeo::vers_ray);
        let objets = if alea.bool() { [objet, autre] } else { [autre, objet] };
        return Candidat::new(&objets, &rayon, [R::ZERO; 5]);
    }
}

/// Climbs, and fails if it comes beyond 1.
fn grimper<R: Bits>(
    nom: &str,
    depart: impl Fn(&mut Rng) -> Candidat<R>,
    passage: Passage,
    part: Part<R>,
    decide: bool,
) {
    let assez = commun::cas(ASSEZ);
    let duree = std::env::var("LANCER_RAYON_ADVERSAIRE")
        .ok()
        .map(|s| Duration::from_secs_f64(s.parse().expect("a number of seconds")));
    let nom = format!("{nom}, {}", std::any::type_name::<R>());
    // Each row has its own seed.
    let mut alea = Rng::with_seed(empreinte(nom.bytes()));
    let debut = Instant::now();
    let mut evaluations = 0_u32;
    // The best cases of earlier climbs, from which new ones set out.
    let mut sommets: Vec<(f64, Candidat<R>)> = Vec::new();
    let mut ici: Option<(f64, Candidat<R>)> = None;
    let mut pire: Option<(f64, Candidat<R>)> = None;
    let mut en_vain = 0;
    loop {
        evaluations += 1;
        match duree {
            Some(duree) if evaluations.is_multiple_of(64) && debut.elapsed() > duree => break,
            Some(_) => {}
            None if evaluations > assez => break,
            None => {}
        }
        if en_vain > PATIENCE {
            en_vain = 0;
            sommets.extend(ici.take());
            sommets.sort_by(|a, b| b.0.total_cmp(&a.0));
            sommets.truncate(SOMMETS);
            if alea.u8(0..4) > 0 && !sommets.is_empty() {
                // The case is shaken, so that it may find another way up.
                let (_, mut candidat) = sommets[alea.usize(0..sommets.len())].clone();
                for _ in 0..alea.usize(1..6) {
                    candidat.bouger_une_fois(&mut alea);
                }
                if let Some(cas) = candidat.construire() {
                    ici = Some((part(&cas), candidat));
                }
            }
        }
        let avant = ici.as_ref().map_or(RIEN, |(avant, _)| *avant);
        let mut candidat = match &ici {
            Some((_, ici)) => {
                let mut candidat = ici.clone();
                candidat.bouger(&mut alea);
                candidat
            }
            None => Candidat { passage, ..depart(&mut alea) },
        };
        let valeur =
            |candidat: &mut Candidat<R>| candidat.construire().map_or(RIEN, |cas| part(&cas));
        let voisins = if decide && alea.u8(0..4) > 0 {
            candidat.clone().a_la_decision(&mut alea)
        } else {
            None
        };
        let v = match voisins {
            None => valeur(&mut candidat),
            Some([mut ici, mut la]) => {
                let (v_ici, v_la) = (valeur(&mut ici), valeur(&mut la));
                candidat = if v_ici >= v_la { ici } else { la };
                v_ici.max(v_la)
            }
        };
        en_vain = if v > avant { 0 } else { en_vain + 1 };
        if v > RIEN && v >= avant {
            if pire.as_ref().is_none_or(|(pire, _)| v > *pire) {
                pire = Some((v, candidat.clone()));
            }
            ici = Some((v, candidat));
        }
    }
    let (v, mut candidat) = pire.expect("a case to judge");
    let cas = candidat.construire().expect("built before");
    let ou = format!("{} {:?} {:?}", candidat.bits(), cas.objets, cas.rayon);
    if duree.is_some() {
        println!("{nom}: {v:.4} ({:.3e} from 1) of {evaluations} evaluations, {ou}", 1.0 - v);
    }
    assert!(v <= 1.0, "{nom}: {v} of what is promised: {ou}");
}

/// The hardest mirror, left in the direction of its own normal.
fn miroir<R: Bits>(alea: &mut Rng) -> Candidat<R> {
    let Cas { objet, rayon } = regimes::miroir(alea);
    let [x, y, z] = rayon.source().into();
    Candidat::new(&[objet], &rayon, [x, y, z, R::ZERO, R::ZERO])
}

/// Glass with an index near the limit of total reflection for this ray, of ordinary glass, near 1, or of any size.
fn de_verre<R: Bits>(objet: ObjetRay<R>, rayon: Rayon<R>, alea: &mut Rng) -> Candidat<R> {
    let passage = if alea.bool() { objet.intersection(&rayon) } else { objet.sortie(&rayon) };
    let limite = passage.ok().and_then(|passage| {
        let (n, d) = (passage.normale().vers_f64(), rayon.direction().vers_f64());
        let sinus = n.produit_vectoriel(d).longueur();
        (sinus > 1e-3).then(|| sinus.recip() * (1.0 - deux_puissance(alea, -54.0, -1.0)))
    });
    let rapport = match (limite, alea.u8(0..5)) {
        (Some(limite), 0..2) => limite,
        (_, 2) => entre(alea, 0.3, 3.0),
        (_, 3) => 1.0 + deux_puissance(alea, -54.0, -2.0) * signe(alea),
        (_, _) => deux_puissance(alea, -9.0, 9.0),
    };
    Candidat::new(&[objet], &rayon, [R::depuis_f64(rapport), R::ZERO, R::ZERO, R::ZERO, R::ZERO])
}

fn boule_de_verre<R: Bits>(alea: &mut Rng) -> Candidat<R> {
    let (objet, rayon) = depart(Genre::Sphere, alea);
    let Cas { objet, rayon } =
        if alea.bool() { vers_la_sortie(Cas { objet, rayon }, alea) } else { Cas { objet, rayon } };
    de_verre(objet, rayon, alea)
}

fn vitre<R: Bits>(alea: &mut Rng) -> Candidat<R> {
    let Cas { objet, rayon } =
        regimes::miroir_sous(deux_puissance(alea, -9.0, 0.0).min(0.999), alea);
    // A ray from above hits the pane, one from below leaves it.
    let rayon =
        if alea.bool() { rayon } else { Rayon::new(-rayon.source(), -rayon.direction()).unwrap() };
    de_verre(objet, rayon, alea)
}

/// A half-space through O or a few subnormals beside it, and a source as near.
fn demi_espace_pres_de_0<R: Bits>(alea: &mut Rng) -> Candidat<R> {
    let petit = |alea: &mut Rng| {
        let x = R::depuis_f64(R::ETA.vers_f64() * f64::from(alea.i8(-20..=20)));
        if alea.bool() { x } else { R::ZERO }
    };
    let plan = PlanGeo::new(tour(alea), petit(alea), Texture(0)).unwrap();
    let s = Vecteur::new(petit(alea), petit(alea), petit(alea));
    let rayon = Rayon::new(s, arrondi(direction(alea))).unwrap();
    Candidat::new(&[ObjetGeo::from(plan).vers_ray()], &rayon, [R::ZERO; 5])
}

/// A ball or a box so large that its place is known less exactly than that of a source beside it, near O.
fn de_pres<R: Bits>(ronde: bool, alea: &mut Rng) -> Candidat<R> {
    let l = R::depuis_f64(deux_puissance(alea, 4.0, 20.0));
    let tour = tour::<R>(alea);
    let n = Vecteur::from(tour.matrice()[1]);
    let objet: ObjetGeo<R> = if ronde {
        SphereGeo::new(-n * l, l, Texture(0)).unwrap().into()
    } else {
        let cotes = Vecteur::new(l + l, l + l, l + l);
        BoiteGeo::new(-n * l, cotes, tour, Texture(0)).unwrap().into()
    };
    let haut = R::depuis_f64(deux_puissance(alea, -12.0, 4.0));
    let vers = arrondi::<R>(direction(alea)) - n;
    let rayon = Rayon::new(n * haut, vers).unwrap();
    Candidat::new(&[objet.vers_ray()], &rayon, [R::ZERO; 5])
}

/// A box with an edge through O, and a ray that enters beside that edge and turns along the other face, under which it
/// is at most about two roundings of the box deep.
fn le_long_d_une_face<R: Bits>(alea: &mut Rng) -> Candidat<R> {
    let tour = tour::<R>(alea);
    let [x, y, z] = tour.matrice().map(Vecteur::from);
    let [a, b, c] = [(); 3].map(|()| R::depuis_f64(deux_puissance(alea, -3.0, 3.0)));
    let cotes = Vecteur::new(a + a, b + b, c + c);
    let boite = BoiteGeo::new(y * b - x * a, cotes, tour, Texture(0)).unwrap();
    let sous = R::depuis_f64(u::<R>() * entre(alea, 0.0, 96.0)) * (a + b + c);
    let devant = R::depuis_f64(deux_puissance(alea, -24.0, 0.0));
    let source = x * devant + y * sous + z * peu_de_bits(alea);
    let rayon = Rayon::new(source, -x).unwrap();
    let penche = y * R::depuis_f64(u::<R>() * entre(alea, -4.0, 4.0));
    let [x, y, z] = (penche - x).into();
    Candidat::new(&[ObjetGeo::from(boite).vers_ray()], &rayon, [x, y, z, R::ZERO, R::ZERO])
}

/// A climb for each promise about the hits of this shape, or about the ways out of it.
fn chaque_promesse_de<R: Bits>(genre: Genre, passage: Passage) {
    let depart = |alea: &mut Rng| {
        let (objet, rayon) = depart(genre, alea);
        let Cas { objet, rayon } = match passage {
            Passage::Entree => Cas { objet, rayon },
            Passage::Sortie => vers_la_sortie(Cas { objet, rayon }, alea),
        };
        Candidat::new(&[objet], &rayon, vers(alea))
    };
    for promesse in toutes::<R>().into_iter().filter(|p| p.parle(passage, genre)) {
        let Promesse { nom, part, decide, .. } = promesse;
        grimper(&format!("{nom}, {genre:?}, {passage:?}"), depart, passage, part, decide);
    }
}

fn chaque_promesse_d_une_touche<R: Bits>() {
    Genre::TOUS.into_iter().for_each(|genre| chaque_promesse_de::<R>(genre, Passage::Entree));
}

en_f32_et_f64!(chaque_promesse_d_une_touche);

fn chaque_promesse_d_une_sortie<R: Bits>() {
    Genre::TOUS.into_iter().for_each(|genre| chaque_promesse_de::<R>(genre, Passage::Sortie));
}

en_f32_et_f64!(chaque_promesse_d_une_sortie);

/// Climbs that start where errors are worst.
fn ce_qui_a_ses_propres_departs<R: Bits>() {
    use Passage::{Entree, Sortie};
    let entree = |nom, depart: fn(&mut Rng) -> Candidat<R>, part: Part<R>| {
        grimper(nom, depart, Entree, part, false);
    };
    entree("distance, near 0", demi_espace_pres_de_0, distance_pres_de_0);
    entree("erreur, near 0", demi_espace_pres_de_0, erreur);
    entree("mirror, worst", miroir, reflechi);
    entree("sun, worst", miroir, soleil);
    for passage in [Entree, Sortie] {
        grimper("refraction, ball", boule_de_verre::<R>, passage, refracte, false);
        grimper("refraction, pane", vitre::<R>, passage, refracte, false);
    }
    grimper("order", deux_objets::<R>, Entree, ordre, true);
}

en_f32_et_f64!(ce_qui_a_ses_propres_departs);

/// Lemma 22.
fn ce_qu_un_rayon_sait_de_sa_source<R: Bits>() {
    for genre in Genre::TOUS {
        let depart = |alea: &mut Rng| un_objet::<R>(genre, alea);
        let courbe = genre != Genre::Plan;
        grimper(&format!("turn, {genre:?}"), depart, Passage::Entree, virage, false);
        grimper(&format!("grazed, {genre:?}"), depart, Passage::Entree, effleurement, courbe);
        // For boxes the ray along a face tells more.
        if genre != Genre::Boite {
            grimper(&format!("depth, {genre:?}"), depart, Passage::Entree, enfoncement, false);
        }
    }
    for ronde in [true, false] {
        let depart = |alea: &mut Rng| de_pres::<R>(ronde, alea);
        grimper(&format!("turn, near {ronde}"), depart, Passage::Entree, virage, false);
    }
    grimper("depth, along a face", le_long_d_une_face::<R>, Passage::Entree, enfoncement, false);
}

en_f32_et_f64!(ce_qu_un_rayon_sait_de_sa_source);
