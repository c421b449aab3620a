//! Culling: objects that none of many rays can enter, found without asking every ray.
//!
//! Nothing that a ray could enter is ever left out, rounding included: the bounds are derived in
//! `docs/conception.md`, "Culling", and the constants in u here are those of that page.

use crate::lot::{Groupe, VOIES};
use crate::reel::u;
use crate::{ObjetRay, Rayon, Reel, Vecteur};

/// How far rays go apart: from one source among theirs, and from one direction M among theirs, along
/// two axes across it and both ways.
///
/// Of each quantity sixteen maxima, since a single running one cannot be widened.
pub(crate) struct Etendue<R> {
    source: Vecteur<R>,
    m: Vecteur<R>,
    axes: [Vecteur<R>; 2],
    ecarts: [R; VOIES],
    /// The largest D·axis and −D·axis of the two axes.
    cotes: [[R; VOIES]; 4],
    /// The largest −D·M.
    reculs: [R; VOIES],
}

impl<R: Reel> Etendue<R> {
    /// None yet, around the ray in the middle, with one axis from the first ray to the eighth: along
    /// the row, of a tile and of a row of pixels. Any axis is right, this one fits closely.
    #[inline(always)]
    fn autour(rayons: &[Rayon<R>]) -> Self {
        let milieu = rayons[rayons.len() / 2];
        let m = milieu.direction() * (R::UN - u(16.0));
        let cote = rayons[7.min(rayons.len() - 1)].direction() - rayons[0].direction();
        let x = Vecteur::new(R::UN, R::ZERO, R::ZERO);
        let y = Vecteur::new(R::ZERO, R::UN, R::ZERO);
        let axe = en_travers(cote, m).or(en_travers(x, m)).unwrap_or(y);
        Self {
            source: milieu.source(),
            m,
            axes: [axe, m.produit_vectoriel(axe)],
            ecarts: [R::ZERO; VOIES],
            cotes: [[R::ZERO; VOIES]; 4],
            reculs: [-R::INFINI; VOIES],
        }
    }

    #[inline(always)]
    fn ajouter(&mut self, groupe: &Groupe<'_, R>) {
        let Self { source, m, axes: [a, b], ecarts, cotes: [a1, a2, b1, b2], reculs } = self;
        for voie in 0..VOIES {
            let (s, d) = groupe.rayon(voie);
            let ecart = s - *source;
            let ecart = max(max(ecart.x.abs(), ecart.y.abs()), ecart.z.abs());
            ecarts[voie] = max(ecarts[voie], ecart);
            let (da, db) = (d.produit_scalaire(*a), d.produit_scalaire(*b));
            a1[voie] = max(a1[voie], da);
            a2[voie] = max(a2[voie], -da);
            b1[voie] = max(b1[voie], db);
            b2[voie] = max(b2[voie], -db);
            reculs[voie] = max(reculs[voie], -d.produit_scalaire(*m));
        }
    }

    /// The beam of these rays; `None` if they go too far apart for one.
    #[inline(always)]
    fn faisceau(self) -> Option<Faisceau<R>> {
        let avance = -le_plus_grand(self.reculs);
        if avance < R::depuis_f64(0.25) {
            return None;
        }
        let [a, b] = self.axes;
        let [a1, a2, b1, b2] = self.cotes.map(le_plus_grand);
        let plans = [(a, a1), (-a, a2), (b, b1), (-b, b2)];
        let [p1, p2, p3, p4] = plans.map(|(axe, cote)| {
            let p = axe - self.m * ((cote + u(32.0)) / (avance - u(32.0)));
            p * ((R::UN - u(16.0)) / p.longueur_carree().sqrt())
        });
        let ecart = le_plus_grand(self.ecarts);
        let ecarts = Vecteur::new(ecart, ecart, ecart);
        Some(Faisceau {
            source: self.source,
            plans: [p1, p2, p3, p4, -self.m]
                .map(|p| (p, p.somme_des_grandeurs(ecarts) * (R::UN + u(8.0)))),
        })
    }
}

/// A pyramid that many rays stay in: five outward normals P with P·D ≤ 0 for each of them, the four
/// sides and the back; and for each P how far the sources go along it at most.
#[derive(Clone, Copy)]
pub(crate) struct Faisceau<R> {
    source: Vecteur<R>,
    plans: [(Vecteur<R>, R); 5],
}

impl<'a, R: Reel> Faisceau<R> {
    /// The beam of the rays of a block, which are these.
    #[inline(always)]
    pub(crate) fn du_bloc(rayons: &[Rayon<R>], bloc: &[Groupe<'a, R>]) -> Option<Self> {
        let mut etendue = Etendue::autour(rayons);
        for groupe in bloc {
            etendue.ajouter(groupe);
        }
        etendue.faisceau()
    }

    /// The beam of many rays.
    #[inline(always)]
    fn des_rayons(rayons: &[Rayon<R>]) -> Option<Self> {
        let mut etendue = Etendue::autour(rayons);
        let mut groupe = Groupe::VIDE;
        for rayons in rayons.chunks(VOIES) {
            groupe.charger(rayons);
            etendue.ajouter(&groupe);
        }
        etendue.faisceau()
    }

    /// Whether the ball of centre C whose radius has this square lies so far beyond one of the five
    /// planes that no ray of the beam [comes near it](crate::boule::approche), as computed.
    #[inline(always)]
    fn evite(&self, centre: Vecteur<R>, rayon_carre: R) -> bool {
        let sc = centre - self.source;
        let [h1, h2, h3, h4, h5] = self.plans.map(|(p, ecart)| p.produit_scalaire(sc) - ecart);
        let h = max(max(max(h1, h2), max(h3, h4)), h5);
        (h > R::ZERO) & (h * h > rayon_carre + sc.longueur_carree() * u(1024.0))
    }
}

/// As many objects as it takes for a selection of them to be worth a beam.
pub(crate) const TRIER: usize = 64;

/// Room for the selection of P objects.
pub(crate) struct Places<'a, R, const P: usize> {
    nombres: [[R; P]; 4],
    objets: [Option<&'a ObjetRay<R>>; P],
    evites: [bool; P],
}

impl<'a, R: Reel, const P: usize> Places<'a, R, P> {
    pub(crate) const VIDES: Self =
        Self { nombres: [[R::ZERO; P]; 4], objets: [None; P], evites: [false; P] };

    pub(crate) fn selection(&mut self) -> Selection<'_, 'a, R> {
        let Self { nombres: [x, y, z, r2], objets, evites } = self;
        Selection { nombre: 0, centres: [x, y, z], rayons_carres: r2, objets, evites }
    }
}

/// The objects that the rays of a lot may enter, in their order, with the balls around them side by
/// side.
pub(crate) struct Selection<'p, 'a, R> {
    nombre: usize,
    centres: [&'p mut [R]; 3],
    rayons_carres: &'p mut [R],
    objets: &'p mut [Option<&'a ObjetRay<R>>],
    evites: &'p mut [bool],
}

impl<'a, R: Reel> Selection<'_, 'a, R> {
    /// Selects for these rays; false if there was not room for all.
    #[inline(always)]
    pub(crate) fn choisir(&mut self, objets: &'a [ObjetRay<R>], rayons: &[Rayon<R>]) -> bool {
        let faisceau = if objets.len() > TRIER { Faisceau::des_rayons(rayons) } else { None };
        self.nombre = 0;
        for objet in objets {
            let (centre, rayon_carre) = objet.boule();
            if faisceau.is_some_and(|faisceau| faisceau.evite(centre, rayon_carre)) {
                continue;
            }
            let place = self.nombre;
            if place == self.objets.len() {
                return false;
            }
            let [x, y, z] = &mut self.centres;
            [x[place], y[place], z[place]] = centre.into();
            self.rayons_carres[place] = rayon_carre;
            self.objets[place] = Some(objet);
            self.nombre += 1;
        }
        true
    }

    /// Each of them, and whether the beam avoids it.
    #[inline(always)]
    pub(crate) fn face_a(
        &mut self,
        faisceau: &Faisceau<R>,
    ) -> (&[Option<&'a ObjetRay<R>>], &[bool]) {
        let n = self.nombre;
        let [x, y, z] = &self.centres;
        let (x, y, z, r2) = (&x[..n], &y[..n], &z[..n], &self.rayons_carres[..n]);
        for (i, evite) in self.evites[..n].iter_mut().enumerate() {
            *evite = faisceau.evite(Vecteur::new(x[i], y[i], z[i]), r2[i]);
        }
        (&self.objets[..n], &self.evites[..n])
    }
}

/// The unit vector of what `v` has across M, if it has any.
#[inline(always)]
fn en_travers<R: Reel>(v: Vecteur<R>, m: Vecteur<R>) -> Option<Vecteur<R>> {
    (v - m * v.produit_scalaire(m)).unitaire()
}

#[inline(always)]
fn max<R: Reel>(a: R, b: R) -> R {
    if a > b { a } else { b }
}

#[inline(always)]
fn le_plus_grand<R: Reel>(mut x: [R; VOIES]) -> R {
    let mut moitie = VOIES / 2;
    while moitie > 0 {
        for i in 0..moitie {
            x[i] = max(x[i], x[i + moitie]);
        }
        moitie /= 2;
    }
    x[0]
}
