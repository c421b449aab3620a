//! Many rays at once: an image is 240,000 of them.
//!
//! The search and the conclusion are those of a single ray, written for sixteen rays side by side
//! and in plain loops, which the compiler turns into the widest instructions of the machine. All of
//! them round a sum, a product, a quotient and a root alike, so that the answers are the same to
//! the bit. What the loops call is `inline(always)`: a call would leave the instruction set.

use core::fmt;

use fearless_simd::{Level, dispatch};

use crate::faisceau::{Faisceau, Places, Selection, TRIER};
use crate::objet::Forme;
use crate::{Intersection, NoIntersection, ObjetRay, Rayon, Reel, Vecteur, premiere_intersection};

/// Rays in a group. Loops of eight would be unrolled before the compiler could widen them.
pub(crate) const VOIES: usize = 16;

/// Rays in a block, which share a beam: a tile of 8 × 8.
const BLOC: usize = 4 * VOIES;

/// Rays that share a selection of objects, as long as that finds room for them.
const LOT: usize = 64 * BLOC;

/// As many objects as culling needs to save more than it costs.
const ELAGAGE: usize = 10;

/// As many rays of a group as it takes to conclude a hit of theirs side by side.
const ENSEMBLE: u32 = 3;

type Touche<R> = Result<Intersection<R>, NoIntersection>;

/// The first object that each ray enters: [`premiere_intersection`](crate::premiere_intersection)
/// of every ray, to the bit, several times as fast.
///
/// Neighbours in `rayons` should be neighbours in the picture, in tiles of 8 × 8 better than in
/// rows: objects that sixty-four rays in a row all miss cost next to nothing. Rays in no order at
/// all are still faster than one by one. Give it some hundred rays a call, and where there are many
/// objects some thousand: which objects matter is chosen for 4,096 at a time. Nothing is allocated
/// and no thread is started; parts of a picture may be given to several.
///
/// # Errors
/// If `rayons` and `touches` are not of the same length; nothing is written then.
///
/// ```
/// use lancer_rayon::{
///     NoIntersection, ObjetGeo, Rayon, SphereGeo, Texture, Vecteur, premieres_intersections,
/// };
///
/// let boule = ObjetGeo::from(SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?);
/// let vers = |x| Rayon::new(Vecteur::NUL, Vecteur::new(x, 0.0, -1.0));
/// let rayons = [vers(0.0)?, vers(0.1)?, vers(0.5)?];
///
/// let mut touches = [Err(NoIntersection); 3];
/// premieres_intersections(&[boule.vers_ray()], &rayons, &mut touches)?;
/// assert_eq!(touches.map(|touche| touche.is_ok()), [true, true, false]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias = "batch")]
#[doc(alias = "packet")]
#[doc(alias = "cast_rays")]
pub fn premieres_intersections<R: Reel>(
    objets: &[ObjetRay<R>],
    rayons: &[Rayon<R>],
    touches: &mut [Result<Intersection<R>, NoIntersection>],
) -> Result<(), LongueursDifferentes> {
    Reglage::ordinaire().premieres_intersections(objets, rayons, touches)
}

/// There is not one place for an answer to each ray.
///
/// ```
/// use lancer_rayon::{LongueursDifferentes, NoIntersection, Rayon, premieres_intersections};
///
/// let rayons: [Rayon; 0] = [];
/// let mut touches = [Err(NoIntersection); 3];
/// let refus = premieres_intersections(&[], &rayons, &mut touches);
/// assert_eq!(refus, Err(LongueursDifferentes { rayons: 0, touches: 3 }));
/// ```
#[doc(alias = "length_mismatch")]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LongueursDifferentes {
    /// How many rays.
    #[doc(alias = "rays")]
    pub rayons: usize,
    /// Places for how many answers.
    #[doc(alias = "hits")]
    pub touches: usize,
}

impl fmt::Display for LongueursDifferentes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rays, but places for {} answers", self.rayons, self.touches)
    }
}

impl core::error::Error for LongueursDifferentes {}

/// How the batch goes about it, for tests and measurements: no answer depends on it.
#[doc(hidden)]
#[derive(Debug, Clone, Copy)]
pub struct Reglage {
    niveau: Level,
    elaguer: bool,
}

impl Reglage {
    /// What [`premieres_intersections`] does.
    #[inline]
    pub fn ordinaire() -> Self {
        Self { niveau: Level::try_detect().unwrap_or(Level::baseline()), elaguer: true }
    }

    /// The same without culling.
    pub fn sans_elagage(self) -> Self {
        Self { elaguer: false, ..self }
    }

    /// Each instruction set of this machine, the best first, by name.
    pub fn tous() -> impl Iterator<Item = (&'static str, Self)> {
        let ordinaire = Self::ordinaire();
        let niveau = ordinaire.niveau;
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let niveaux = [
            ("AVX-512", niveau.as_avx512().map(Level::Avx512)),
            ("AVX2", niveau.as_avx2().map(Level::Avx2)),
            ("SSE4.2", niveau.as_sse4_2().map(Level::Sse4_2)),
            ("SSE2", niveau.as_sse2().map(Level::Sse2)),
        ];
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        let niveaux = [("the only one", Some(niveau))];
        niveaux
            .into_iter()
            .filter_map(move |(nom, niveau)| Some((nom, Self { niveau: niveau?, ..ordinaire })))
    }

    /// [`premieres_intersections`](crate::premieres_intersections) in this way.
    ///
    /// # Errors
    /// The same.
    pub fn premieres_intersections<R: Reel>(
        self,
        objets: &[ObjetRay<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Result<Intersection<R>, NoIntersection>],
    ) -> Result<(), LongueursDifferentes> {
        if rayons.len() != touches.len() {
            return Err(LongueursDifferentes { rayons: rayons.len(), touches: touches.len() });
        }
        let peu_de_rayons = rayons.len() < VOIES / 2;
        if peu_de_rayons {
            for (rayon, touche) in rayons.iter().zip(touches) {
                *touche = premiere_intersection(objets, rayon);
            }
        } else if !self.elaguer || objets.len() < ELAGAGE {
            self.repondre(objets, rayons, touches, None);
        } else if objets.len() <= TRIER {
            self.avec_places::<R, TRIER>(objets, rayons, touches);
        } else if rayons.len() < LOT / 2 {
            self.avec_places::<R, 256>(objets, rayons, touches);
        } else {
            self.avec_places::<R, 1024>(objets, rayons, touches);
        }
        Ok(())
    }

    /// With room for a selection of P objects.
    fn avec_places<R: Reel, const P: usize>(
        self,
        objets: &[ObjetRay<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) {
        let mut places = Places::<R, P>::VIDES;
        self.repondre(objets, rayons, touches, Some(places.selection()));
    }

    fn repondre<'a, R: Reel>(
        self,
        objets: &'a [ObjetRay<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
        selection: Option<Selection<'_, 'a, R>>,
    ) {
        dispatch!(self.niveau, _simd => repondre(objets, rayons, touches, selection));
    }
}

/// Lot by lot, and in it block by block from the rays to the answers, so that a block stays in the
/// nearest memory.
#[inline(always)]
fn repondre<'a, R: Reel>(
    objets: &'a [ObjetRay<R>],
    mut rayons: &[Rayon<R>],
    mut touches: &mut [Touche<R>],
    mut selection: Option<Selection<'_, 'a, R>>,
) {
    let mut bloc = [const { Groupe::VIDE }; BLOC / VOIES];
    let mut taille = LOT;
    while !rayons.is_empty() {
        let n = rayons.len().min(taille);
        let (ici, suite) = rayons.split_at(n);
        let mut selection = selection.as_mut();
        if let Some(choix) = &mut selection
            && !choix.choisir(objets, ici)
        {
            if n > BLOC {
                // Fewer rays see fewer objects.
                taille = (n / 2).next_multiple_of(BLOC);
                continue;
            }
            selection = None;
        }
        let (touches_ici, touches_suite) = touches.split_at_mut(n);
        for (rayons, touches) in ici.chunks(BLOC).zip(touches_ici.chunks_mut(BLOC)) {
            let bloc = &mut bloc[..rayons.len().div_ceil(VOIES)];
            for (groupe, rayons) in bloc.iter_mut().zip(rayons.chunks(VOIES)) {
                groupe.charger(rayons);
            }
            if let Some(choix) = &mut selection
                && let Some(faisceau) = Faisceau::du_bloc(rayons, bloc)
            {
                let (objets, evites) = choix.face_a(&faisceau);
                for (objet, evite) in objets.iter().zip(evites) {
                    if let Some(objet) = objet
                        && !evite
                    {
                        objet.proposer_a(bloc);
                    }
                }
            } else {
                for objet in objets {
                    objet.proposer_a(bloc);
                }
            }
            for (i, groupe) in bloc.iter().enumerate() {
                let (debut, fin) = (i * VOIES, rayons.len().min((i + 1) * VOIES));
                groupe.conclure(&rayons[debut..fin], &mut touches[debut..fin]);
            }
        }
        (rayons, touches) = (suite, touches_suite);
    }
}

/// Sixteen rays, coordinate by coordinate, with the first object of each so far.
pub(crate) struct Groupe<'a, R> {
    s: [[R; VOIES]; 3],
    d: [[R; VOIES]; 3],
    t: [R; VOIES],
    premier: [Option<&'a ObjetRay<R>>; VOIES],
}

impl<'a, R: Reel> Groupe<'a, R> {
    pub(crate) const VIDE: Self = Self {
        s: [[R::ZERO; VOIES]; 3],
        d: [[R::ZERO; VOIES]; 3],
        t: [R::INFINI; VOIES],
        premier: [None; VOIES],
    };

    /// Puts these rays here, at most sixteen; the last stands in for those that are missing.
    #[inline(always)]
    pub(crate) fn charger(&mut self, rayons: &[Rayon<R>]) {
        if let Some(rayons) = rayons.first_chunk() {
            self.copier(rayons);
        } else if let Some(dernier) = rayons.last() {
            let mut complets = [*dernier; VOIES];
            complets[..rayons.len()].copy_from_slice(rayons);
            self.copier(&complets);
        }
    }

    #[inline(always)]
    fn copier(&mut self, rayons: &[Rayon<R>; VOIES]) {
        for (voie, rayon) in rayons.iter().enumerate() {
            let (s, d) = (rayon.source(), rayon.direction());
            [self.s[0][voie], self.s[1][voie], self.s[2][voie]] = s.into();
            [self.d[0][voie], self.d[1][voie], self.d[2][voie]] = d.into();
        }
        (self.t, self.premier) = ([R::INFINI; VOIES], [None; VOIES]);
    }

    /// S and D of one ray.
    #[inline(always)]
    pub(crate) fn rayon(&self, voie: usize) -> (Vecteur<R>, Vecteur<R>) {
        let ([sx, sy, sz], [dx, dy, dz]) = (&self.s, &self.d);
        let s = Vecteur::new(sx[voie], sy[voie], sz[voie]);
        (s, Vecteur::new(dx[voie], dy[voie], dz[voie]))
    }

    /// Roots and quotients are computed only if one ray at least comes near the object.
    #[inline(always)]
    fn proposer(&mut self, objet: &'a ObjetRay<R>, forme: &impl Forme<R>) {
        let mut pres = false;
        for voie in 0..VOIES {
            let (s, d) = self.rayon(voie);
            pres |= forme.possible(s, d);
        }
        if !pres {
            return;
        }
        // Computed for all and kept for some, in a loop of its own: a branch would not be widened.
        let mut t = [R::INFINI; VOIES];
        for (voie, t) in t.iter_mut().enumerate() {
            let (s, d) = self.rayon(voie);
            let entree = forme.t(s, d);
            *t = if forme.possible(s, d) { entree } else { R::INFINI };
        }
        for (voie, &t) in t.iter().enumerate() {
            let avant = t < self.t[voie];
            self.t[voie] = if avant { t } else { self.t[voie] };
            self.premier[voie] = if avant { Some(objet) } else { self.premier[voie] };
        }
    }

    /// Writes the answers: for each object that is the first of some ray, those of all its rays.
    #[inline(always)]
    fn conclure(&self, rayons: &[Rayon<R>], touches: &mut [Touche<R>]) {
        let mut conclusions = Conclusions::VIDES;
        let mut restent = 0;
        for (voie, touche) in touches.iter_mut().enumerate() {
            match self.premier[voie] {
                Some(_) => restent |= 1 << voie,
                None => *touche = Err(NoIntersection),
            }
        }
        while let Some(objet) = self.premier[la_premiere(restent)]
            && restent != 0
        {
            let mut siens = self.qui_touche(objet) & restent;
            restent &= !siens;
            if siens.count_ones() < ENSEMBLE {
                conclusions.sure = [false; VOIES];
            } else {
                objet.conclure_pour(self, &mut conclusions);
            }
            let Conclusions { distance, normale: [nx, ny, nz], marge, sure } = &conclusions;
            let texture = objet.texture();
            while siens != 0 {
                let voie = la_premiere(siens);
                siens &= siens - 1;
                if sure[voie] {
                    let normale = Vecteur::new(nx[voie], ny[voie], nz[voie]);
                    let (distance, marge) = (distance[voie], marge[voie]);
                    touches[voie] = Ok(Intersection { distance, normale, texture, marge });
                } else {
                    touches[voie] = Ok(objet.conclure(&rayons[voie], self.t[voie]));
                }
            }
        }
    }

    /// The rays whose first object is this one, a bit for each.
    #[inline(always)]
    fn qui_touche(&self, objet: &ObjetRay<R>) -> u16 {
        let mut siens = 0;
        for (voie, &premier) in self.premier.iter().enumerate() {
            let sien = premier.is_some_and(|premier| core::ptr::eq(premier, objet));
            siens |= u16::from(sien) << voie;
        }
        siens
    }
}

/// The first ray of a set, a bit for each.
#[inline(always)]
fn la_premiere(voies: u16) -> usize {
    voies.trailing_zeros() as usize % VOIES
}

/// Makes the object, which is of this shape, the first of those rays that enter it before their
/// first so far.
///
/// The shape by value: nothing that is written to a group can overlap it, so that the compiler
/// need not read it again for every ray.
#[inline(always)]
pub(crate) fn proposer<'a, R: Reel>(
    bloc: &mut [Groupe<'a, R>],
    objet: &'a ObjetRay<R>,
    forme: impl Forme<R>,
) {
    for groupe in bloc {
        groupe.proposer(objet, &forme);
    }
}

/// What sixteen rays would have if this shape were the first of each.
pub(crate) struct Conclusions<R> {
    distance: [R; VOIES],
    normale: [[R; VOIES]; 3],
    marge: [R; VOIES],
    sure: [bool; VOIES],
}

impl<R: Reel> Conclusions<R> {
    const VIDES: Self = Self {
        distance: [R::ZERO; VOIES],
        normale: [[R::ZERO; VOIES]; 3],
        marge: [R::ZERO; VOIES],
        sure: [false; VOIES],
    };

    #[inline(always)]
    pub(crate) fn remplir(&mut self, groupe: &Groupe<'_, R>, forme: impl Forme<R>) {
        let Self { distance, normale: [nx, ny, nz], marge, sure } = self;
        for voie in 0..VOIES {
            let (source, direction) = groupe.rayon(voie);
            let rayon = Rayon { source, direction };
            let (touche, touche_sure) = forme.conclure(&rayon, groupe.t[voie]);
            distance[voie] = touche.distance;
            [nx[voie], ny[voie], nz[voie]] = touche.normale.into();
            (marge[voie], sure[voie]) = (touche.marge, touche_sure);
        }
    }
}
