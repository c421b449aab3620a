//! Raw bytes read as objects, rays and paths.
//!
//! A number is raw bits, a small number, or a number that came before or its neighbour, and places are often those of
//! earlier objects. Without that, nothing would ever coincide.

use lancer_rayon::{
    BoiteGeo, ErreurGeo, ObjetGeo, ObjetRay, PlanGeo, Rayon, Rotation, SphereGeo, Texture, Vecteur,
};

use commun::Bits;
use commun::chemins::{Pas, Suite};
use commun::conversion::voisin;

/// How many of each there are at most, so that an input takes milliseconds.
const OBJETS: usize = 200;
const RAYONS: usize = 150;
const PAS: usize = 48;

/// What the bytes say.
pub struct Lecture<R> {
    pub objets: Vec<ObjetGeo<R>>,
    pub rayons: Vec<Rayon<R>>,
    /// A ray, whether it is known to be inside something, and how it goes on.
    pub chemins: Vec<(Rayon<R>, bool, Vec<Pas<R>>)>,
    pub limites: Vec<R>,
    pub points: Vec<Vecteur<R>>,
}

pub struct Octets<'a, R> {
    reste: &'a [u8],
    vus: Vec<R>,
}

impl<'a, R: Bits> Octets<'a, R> {
    pub fn new(reste: &'a [u8]) -> Self {
        Self { reste, vus: vec![R::LIMITE, R::UN / R::LIMITE] }
    }

    /// Reads until the bytes end or there is enough.
    pub fn lire(mut self) -> Lecture<R> {
        let (rayons, limites) = (vec![], self.vus.clone());
        let mut lu = Lecture { objets: vec![], rayons, chemins: vec![], limites, points: vec![] };
        while self.lire_un(&mut lu).is_some() {
            let pas: usize = lu.chemins.iter().map(|(_, _, pas)| 1 + pas.len()).sum();
            if lu.objets.len() >= OBJETS || lu.rayons.len() >= RAYONS || pas >= PAS {
                break;
            }
        }
        lu.objets.truncate(OBJETS);
        // Each limit costs as much as all rays.
        lu.limites.reverse();
        lu.limites.truncate(4);
        lu
    }

    fn lire_un(&mut self, lu: &mut Lecture<R>) -> Option<()> {
        let dernier = lu.objets.last().copied();
        match self.octet()? % 13 {
            0 => lu.objets.extend(self.objet(Texture(lu.objets.len() as u32))?),
            1 => {
                let (v, k, r) = (self.vecteur()?, self.reel()?, self.rotation()?);
                let change = lu.objets.pop()?.translation(v).and_then(|o| o.rotation(r));
                let change = change.and_then(|o| o.homothetie(k));
                lu.objets.push(change.unwrap_or(dernier?));
            }
            2 => lu.rayons.extend(Rayon::new(self.vecteur()?, self.vecteur()?)),
            3 => {
                // A ray to a point, since a random ray hardly ever touches an object.
                let (de, vers) = (self.vecteur()?, self.vecteur()?);
                let rayon = Rayon::entre(de, vers).ok();
                // +∞ between points that are farther apart than any number.
                assert!(rayon.is_none_or(|rayon| rayon.fin() > R::ZERO), "{rayon:?}");
                lu.limites.extend(rayon.map(|rayon| rayon.fin()));
                lu.rayons.extend(rayon);
            }
            4 => {
                // A row of them, so that few bytes make many objects.
                let (n, v) = (self.octet()?, self.vecteur()?);
                let ecart = |i| v * R::depuis_f64(f64::from(i));
                lu.objets.extend((1..=n).filter_map(|i| dernier?.translation(ecart(i)).ok()));
            }
            5 => lu.points.push(self.vecteur()?),
            6 => lu.limites.push(self.reel()?),
            7 => lu.points.push(self.lieu(&lu.objets)?.0),
            8 => {
                let contre = self.contre(&lu.objets)?;
                lu.objets.extend(contre);
            }
            9 | 10 => {
                // From a place of an object towards another place, or in any direction.
                let (de, vers) = (self.lieu(&lu.objets)?, self.lieu(&lu.objets)?.0);
                let vers = if self.octet()? % 4 == 0 { self.vecteur()? } else { vers - de.0 };
                if let Some((rayon, dedans)) = self.depart(de, vers)? {
                    lu.rayons.push(rayon);
                    let pas = self.chemin(&lu.objets)?;
                    lu.chemins.push((rayon, dedans, pas));
                }
            }
            11 => {
                let (de, vers) = (self.vecteur()?, self.lieu(&lu.objets)?.0);
                let pas = self.chemin(&lu.objets)?;
                lu.chemins.extend(Rayon::new(de, vers - de).ok().map(|rayon| (rayon, false, pas)));
            }
            _ => {
                let rayon = lu.rayons.last().copied();
                let (genre, vers) = (self.octet()?, self.vecteur()?);
                let rangee = (0..u32::from(genre) / 2).filter_map(|i| {
                    let ecart = vers * R::depuis_f64(f64::from(i) / 1024.0);
                    let source = rayon?.source();
                    let source = if genre % 2 == 0 { source } else { source + ecart };
                    Rayon::new(source, rayon?.direction() + ecart).ok()
                });
                lu.rayons.extend(rangee);
            }
        }
        Some(())
    }

    pub fn octet(&mut self) -> Option<u8> {
        let (premier, reste) = self.reste.split_first()?;
        self.reste = reste;
        Some(*premier)
    }

    fn reel(&mut self) -> Option<R> {
        let genre = self.octet()?;
        let vu = self.vus.get(usize::from(genre >> 3)).copied();
        let x = match (genre & 7, vu) {
            (0, Some(vu)) => vu,
            (1, Some(vu)) => -vu,
            (2, Some(vu)) => vu * (R::UN + R::U + R::U),
            (3, Some(vu)) => vu * (R::UN - R::U - R::U),
            (4, _) => R::depuis_f64(f64::from(genre >> 3) - 16.0),
            _ => {
                let (bits, reste) = self.reste.split_first_chunk::<8>()?;
                self.reste = reste;
                R::depuis_bits(u64::from_le_bytes(*bits))
            }
        };
        self.vus.push(x);
        Some(x)
    }

    fn vecteur(&mut self) -> Option<Vecteur<R>> {
        Some(Vecteur::new(self.reel()?, self.reel()?, self.reel()?))
    }

    fn rotation(&mut self) -> Option<Rotation<R>> {
        let angles = self.vecteur()?;
        let rotation = Rotation::new(angles);
        assert!(rotation.is_ok() || !angles.vers_f64().longueur().is_finite());
        Some(rotation.unwrap_or(Rotation::IDENTITE))
    }

    fn objet(&mut self, texture: Texture) -> Option<Result<ObjetGeo<R>, ErreurGeo>> {
        Some(match self.octet()? % 3 {
            0 => SphereGeo::new(self.vecteur()?, self.reel()?, texture).map(ObjetGeo::from),
            1 => PlanGeo::new(self.rotation()?, self.reel()?, texture).map(ObjetGeo::from),
            _ => BoiteGeo::new(self.vecteur()?, self.vecteur()?, self.rotation()?, texture)
                .map(ObjetGeo::from),
        })
    }

    /// A place of an object, such as its centre, a corner, the middle of an edge, or a neighbour of such a place; and
    /// the normal there.
    fn lieu(&mut self, objets: &[ObjetGeo<R>]) -> Option<(Vecteur<R>, Vecteur<R>)> {
        let objet = self.un_objet(objets)?.vers_ray();
        let mut cote = || {
            Some(match self.octet()? % 6 {
                0 | 1 => R::ZERO,
                2 | 3 => R::UN,
                4 => -R::UN,
                _ => self.reel()?,
            })
        };
        let ou = [cote()?, cote()?, cote()?];
        let (point, normale) = match objet {
            ObjetRay::Sphere(sphere) => {
                let n = Vecteur::from(ou).unitaire();
                let n = n.unwrap_or(Vecteur::NUL);
                (sphere.centre() + n * sphere.rayon(), n)
            }
            ObjetRay::Plan(plan) => {
                let (n, ou) = (plan.normale(), Vecteur::from(ou));
                (ou - n * (n.produit_scalaire(ou) + plan.distance()), n)
            }
            ObjetRay::Boite(boite) => {
                let axes = boite.normales().into_iter().zip(boite.demi_longueurs()).zip(ou);
                let point = axes.clone().fold(boite.centre(), |p, ((n, l), x)| p + n * (l * x));
                let face = axes.clone().find(|(_, x)| R::absolu(*x) == R::UN);
                (point, face.map_or(Vecteur::NUL, |((n, _), x)| n * x))
            }
        };
        let ulps = i64::from(self.octet()? % 8) - 3;
        let ulps = if ulps > 1 { 0 } else { ulps };
        Some((<[R; 3]>::from(point).map(|x| voisin(x, ulps)).into(), normale))
    }

    fn un_objet(&mut self, objets: &[ObjetGeo<R>]) -> Option<ObjetGeo<R>> {
        objets.get(usize::from(self.octet()?) % objets.len().max(1)).copied()
    }

    /// An object flush against another: a wall through one of its places, a ball there, or its copy across that place.
    fn contre(&mut self, objets: &[ObjetGeo<R>]) -> Option<Result<ObjetGeo<R>, ErreurGeo>> {
        let (modele, texture) = (self.un_objet(objets)?, Texture(objets.len() as u32));
        let (place, n) = self.lieu(&[modele])?;
        Some(match (self.octet()? % 4, modele) {
            (0, _) => PlanGeo::par_un_point(place, n, texture).map(ObjetGeo::from),
            (1, _) => PlanGeo::par_un_point(place, -n, texture).map(ObjetGeo::from),
            (2, _) => {
                let r = self.reel()?;
                SphereGeo::new(place + n * r, r, texture).map(ObjetGeo::from)
            }
            (_, ObjetGeo::Sphere(s)) => modele.translation((place - s.centre()) * (R::UN + R::UN)),
            (_, ObjetGeo::Boite(b)) => modele.translation((place - b.centre()) * (R::UN + R::UN)),
            (_, ObjetGeo::Plan(_)) => modele.translation(place),
        })
    }

    /// A ray from this place: with an end, with a δ and perhaps some halves of that below the surface, or inside
    /// something; and whether it is known to be inside.
    fn depart(
        &mut self,
        (place, n): (Vecteur<R>, Vecteur<R>),
        vers: Vecteur<R>,
    ) -> Option<Option<(Rayon<R>, bool)>> {
        let genre = self.octet()? % 8;
        let (flou, moities) = match genre {
            0..=2 => {
                // The size suits the objects. The start is on the surface, less deep than δ, as deep or too deep.
                let part = self.octet()? % 32;
                let moities = [0, 1, 2, 5][usize::from(self.octet()? % 4)];
                (vers.longueur() * R::depuis_f64((-f64::from(part)).exp2()), moities)
            }
            3 | 4 => (R::absolu(self.reel()?), 0),
            _ => (R::U, 0),
        };
        let place = place - n * (flou * R::depuis_f64(f64::from(moities) / 2.0));
        let rayon = Rayon::new(place, vers);
        let sachant = match genre {
            0..=3 => rayon.and_then(|rayon| rayon.avec_flou(flou)),
            4 => rayon.and_then(|rayon| rayon.jusqu_a(flou)),
            5 => rayon.map(Rayon::dedans),
            _ => rayon,
        };
        Some(sachant.ok().map(|rayon| (rayon, genre == 5)))
    }

    /// Up to seven steps, each in any direction, or towards a place of an object.
    fn chemin(&mut self, objets: &[ObjetGeo<R>]) -> Option<Vec<Pas<R>>> {
        let nombre = self.octet()? % 8;
        let mut pas = || {
            let genre = self.octet()?;
            let suite = Suite::TOUTES.get(usize::from(genre % 8)).unwrap_or(&Suite::Secondaire);
            let vise = genre & 8 != 0;
            let vers = if vise { self.lieu(objets)?.0 } else { self.vecteur()? };
            let distance = if let Suite::Bifurque = *suite { self.reel()? } else { R::INFINI };
            Some(Pas { suite: *suite, vers, vise, distance })
        };
        (0..nombre).map(|_| pas()).collect()
    }
}
