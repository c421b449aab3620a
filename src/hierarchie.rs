//! A hierarchy of bounding boxes over a list: the questions of `recherche.rs` where there are
//! many objects, with the same answers; and of a list or a hierarchy those of many rays at once.
//!
//! A leaf holds sixteen objects with a box, and a node of each floor above holds sixteen nodes
//! (`hierarchie/noeud.rs`, `construction.rs`). A ray looks at the nodes that it crosses
//! (`parcours.rs`), a block of rays at those that its beam crosses (`parcours_de_bloc.rs`), each through its
//! probe (`sonde.rs`). Objects without a box are always asked. What may be left out is derived in
//! `docs/preuves.md`, lemmas 6 and 20 to 22.

pub(crate) mod construction;
mod morceaux;
pub(crate) mod noeud;
mod parcours;
pub(crate) mod parcours_de_bloc;
mod pile;
pub(crate) mod repere;
pub(crate) mod sonde;

use core::fmt;

pub use construction::PlacesInsuffisantes;
use fearless_simd::Level;

use crate::compile::compilees;
use crate::hierarchie::construction::{Arbre, construire, mots};
use crate::intersection::{NoIntersection, Touche};
use crate::jugement::Certificat;
use crate::liste::{Choix, Liste, Regle};
use crate::lot::LongueursDifferentes;
use crate::lot::bloc::{BLOC, Bloc, Groupes};
use crate::lot::demande::Demande;
use crate::niveau::{meilleur_niveau, selon_le_niveau};
use crate::objet::ObjetRay;
use crate::rayon::Rayon;
use crate::reel::Reel;
use crate::retenus::{Premier, Rangee};

/// A list of objects with a hierarchy of boxes around them: the answers of the list, to the bit, in
/// a time that grows far more slowly than their number. Half-spaces are asked one by one as in a list.
/// Objects whose boxes all overlap are a heap: a batch asks them as its list does, a single ray takes
/// up to twice as long as its list.
///
/// It is built once and asked as often as the picture has pixels. It borrows the list, which keeps
/// its order, and numbers that the caller lends; it is `Copy`, and threads may share it. After a
/// change of the list, build it again.
///
/// Its boxes are rounded to some 10⁻⁶ of their distance from the middle of the many, in `f32` also of that of the
/// source. Objects closer together than that are all tested: fine detail far from most objects costs time, and
/// never accuracy. A sun, a sky, a ball for a ground cost little (`benches/README.md`).
///
/// ```
/// use lancer_rayon::{
///     Hierarchie, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur, premiere_intersection,
/// };
///
/// let boule = |x| SphereGeo::new(Vecteur::new(f64::from(x), 0.0, -5.0), 0.4, Texture(x));
/// let scene = (0..1_000).map(|x| boule(x).map(ObjetRay::from)).collect::<Result<Vec<_>, _>>()?;
///
/// let mut places = vec![0.0; Hierarchie::places(scene.len())];
/// let hierarchie = Hierarchie::new(&scene, &mut places)?;
///
/// let rayon = Rayon::new(Vecteur::new(700.0, 0.0, 0.0), Vecteur::new(0.0, 0.0, -1.0))?;
/// let touche = hierarchie.premiere_intersection(&rayon)?;
/// assert_eq!((touche.objet(), touche.distance()), (700, 4.6));
/// assert_eq!(Ok(touche), premiere_intersection(&scene, &rayon));
/// assert!(hierarchie.est_occulte(&rayon, 5.0) && !hierarchie.est_occulte(&rayon, 4.0));
///
/// let mut touches = [Err(NoIntersection); 2];
/// hierarchie.premieres_intersections(&[rayon; 2], &mut touches)?;
/// assert_eq!(touches, [Ok(touche); 2]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("bvh", "bounding_volume_hierarchy", "acceleration_structure", "tree", "index"))]
#[derive(Clone, Copy)]
#[must_use]
pub struct Hierarchie<'a, R = f64> {
    /// Without nodes over few objects with a box and over too many objects: these are asked as a list.
    pub(crate) arbre: Arbre<'a, R>,
    /// Detected where it is made; tests set another.
    pub(crate) niveau: Level,
}

impl<R: Reel> fmt::Debug for Hierarchie<'_, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Hierarchie")
            .field("objets", &self.arbre.liste.objets.len())
            .field("noeuds", &self.arbre.noeuds.len())
            .finish()
    }
}

impl Hierarchie<'_> {
    /// How many numbers a hierarchy of so many objects needs, in either type: 7.5 an object, 30
    /// bytes, where there are many. They are scratch memory: what they hold before does not matter,
    /// and after the last question neither.
    ///
    /// It is 0 for fewer than 10 objects, and for 2³¹ − 2²³ or more: these are asked as a list, as
    /// is any list with fewer than 10 spheres and boxes. It is called without a type:
    /// `Hierarchie::places(n)`. Of long boxes that stand askew lend twice as many: see [`new`](Hierarchie::new).
    #[doc(alias("capacity", "memory"))]
    #[must_use]
    pub const fn places(nombre_d_objets: usize) -> usize {
        mots(nombre_d_objets)
    }
}

impl<'a, R: Reel> Hierarchie<'a, R> {
    /// The hierarchy over this list, in the numbers lent, whose values do not matter.
    ///
    /// It takes some 0.1 to 0.2 µs an object (`benches/README.md`). An array on the stack serves as
    /// well as a `Vec`.
    ///
    /// A longer slice pays for **long boxes that stand askew**: poles, planks, beams. They are cut into pieces, of which
    /// each takes up less room than the whole. In twice the places a ray among 10,000 of them takes about half of the
    /// time; where nothing is long the hierarchy is the same. No answer depends on it.
    ///
    /// # Errors
    /// If `places` is shorter than [`places`](Hierarchie::places)`(objets.len())`.
    ///
    /// ```
    /// use lancer_rayon::{BoiteGeo, Hierarchie, ObjetRay, Rotation, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::NUL, 1.0_f32, Texture(0))?);
    /// let mut places = [0.0; Hierarchie::places(20)];
    /// assert!(Hierarchie::new(&[boule; 20], &mut places).is_ok());
    ///
    /// let refus = Hierarchie::new(&[boule; 200], &mut places).unwrap_err();
    /// assert_eq!(refus.to_string(), "478 places lent, but 1710 needed");
    ///
    /// // Poles that lean.
    /// let tour = Rotation::new(Vecteur::new(0.5, 0.3, 0.4))?;
    /// let perche = |x| BoiteGeo::new(Vecteur::new(x, 0.0, 0.0), Vecteur::new(0.1, 9.0, 0.1), tour, Texture(0));
    /// let perches = (0..200).map(|i| perche(i as f32).map(ObjetRay::from)).collect::<Result<Vec<_>, _>>()?;
    /// let mut places = vec![0.0; 2 * Hierarchie::places(perches.len())];
    /// assert!(Hierarchie::new(&perches, &mut places).is_ok());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias = "build")]
    pub fn new(
        objets: &'a [ObjetRay<R>],
        places: &'a mut [f32],
    ) -> Result<Self, PlacesInsuffisantes> {
        let arbre = R::demander::<Batir>((objets, places))?;
        Ok(Self { arbre, niveau: meilleur_niveau() })
    }

    /// A hierarchy without a tree: it asks its list, and needs no places. What a [`Hierarchie`] alone answers,
    /// [`parmi`](Self::parmi), [`premiere_avant`](Self::premiere_avant) and
    /// [`dans_l_ordre`](Self::dans_l_ordre), it answers of a list.
    #[doc(alias("from_slice", "brute_force"))]
    pub fn de_liste(objets: &'a [ObjetRay<R>]) -> Self {
        Self { arbre: Arbre::sans_noeuds(Liste::entiere(objets)), niveau: meilleur_niveau() }
    }

    /// The list.
    #[doc(alias("objects", "primitives"))]
    pub fn objets(&self) -> &'a [ObjetRay<R>] {
        self.arbre.liste.objets
    }

    /// The same hierarchy among the objects that `prend` takes, by their indices in the list: its answers are those of
    /// a list of these objects, to the bit, save that each keeps its index.
    ///
    /// Every question knows it, shadows, batches and certificates too. A choice among a choice takes what both take.
    /// `prend` is called for few of the objects that a ray passes by, and for some more than once; a batch of a list calls
    /// it for every object once for 64 rays. It is a variable of its own if the choice outlives a line, and may be
    /// shared by threads (`Sync`).
    ///
    /// Panes throw no shadow, a robot does not see itself, a plan shows one storey. To leave out one object is
    /// [`sans`](Self::sans).
    ///
    /// ```
    /// use lancer_rayon::{Hierarchie, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |z, texture| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(texture));
    /// let scene: Vec<ObjetRay> = vec![boule(-4.0, 0)?.into(), boule(-9.0, 7)?.into()];
    /// let hierarchie = Hierarchie::de_liste(&scene);
    ///
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// let sans_la_premiere = |indice| indice != 0;
    /// let autres = hierarchie.parmi(&sans_la_premiere);
    /// let touche = autres.premiere_intersection(&rayon)?;
    /// assert_eq!((touche.objet(), touche.distance()), (1, 8.0));
    ///
    /// // By any property; and here nothing is left.
    /// let pas_rouge = |indice: usize| scene[indice].texture() != Texture(7);
    /// assert_eq!(autres.parmi(&pas_rouge).premiere_intersection(&rayon), Err(NoIntersection));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("filter", "mask"))]
    #[inline]
    pub fn parmi<'b>(&'b self, prend: &'b (dyn Fn(usize) -> bool + Sync)) -> Hierarchie<'b, R> {
        self.choisir(Regle::Si(prend))
    }

    /// The same hierarchy without the object at this index: [`parmi`](Self::parmi) all others. After another
    /// choice it takes what both take; an index beyond the list leaves out nothing.
    ///
    /// **A lamp of the list**, or the far end of [`vers_touche`](Rayon::vers_touche), does not stand before itself.
    /// A ray that leaves an object needs no such choice: it never hits that object again
    /// ([`secondaire`](Rayon::secondaire)). Each call copies the hierarchy, some 150 bytes.
    ///
    /// ```
    /// use lancer_rayon::{Hierarchie, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |z| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(0));
    /// let scene: [ObjetRay; 2] = [boule(-4.0)?.into(), boule(-9.0)?.into()];
    /// let hierarchie = Hierarchie::de_liste(&scene);
    ///
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// assert_eq!(hierarchie.sans(0).premiere_intersection(&rayon)?.distance(), 8.0);
    /// assert_eq!(hierarchie.sans(0).sans(1).premiere_intersection(&rayon), Err(NoIntersection));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("without", "except", "ignore", "exclude", "skip"))]
    #[inline]
    pub fn sans(&self, objet: usize) -> Hierarchie<'_, R> {
        self.choisir(Regle::Sans(objet))
    }

    #[inline(always)]
    fn choisir<'b>(&'b self, regle: Regle<'b>) -> Hierarchie<'b, R> {
        let mut choisie: Hierarchie<'b, R> = *self;
        choisie.arbre.liste.choix = Some(Choix { regle, parmi: self.arbre.liste.choix.as_ref() });
        choisie
    }

    /// [`premiere_intersection`](fn@crate::premiere_intersection) of the list.
    ///
    /// # Errors
    /// [`NoIntersection`] if the ray enters no object.
    #[doc(alias("cast_ray", "closest_hit", "first_hit", "raycast"))]
    #[inline]
    pub fn premiere_intersection(&self, rayon: &Rayon<R>) -> Touche<R> {
        self.premiere_avant(rayon, R::INFINI)
    }

    /// The first object that the ray enters before this distance: the answer of
    /// [`premiere_intersection`](Self::premiere_intersection) if that is nearer, else a miss. The less there is before
    /// the distance, the sooner.
    ///
    /// # Errors
    /// [`NoIntersection`] if the ray enters no object before; none is before a NaN.
    ///
    /// ```
    /// use lancer_rayon::{Hierarchie, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = SphereGeo::new(Vecteur::new(0.0, 0.0, -4.0), 1.0, Texture(0))?;
    /// let scene: [ObjetRay; 1] = [boule.into()];
    /// let hierarchie = Hierarchie::de_liste(&scene);
    ///
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// assert_eq!(hierarchie.premiere_avant(&rayon, 3.0), Err(NoIntersection)); // at 3, not before
    /// assert_eq!(hierarchie.premiere_avant(&rayon, 3.5)?.distance(), 3.0);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("max_distance", "t_max", "range", "cast_ray"))]
    #[inline]
    pub fn premiere_avant(&self, rayon: &Rayon<R>, distance_max: R) -> Touche<R> {
        R::demander::<Premiere>((self, rayon, distance_max))
    }

    /// The objects that the ray enters before this distance, as many as there are places, in order: the nearest first,
    /// of two at the same distance the earlier in the list. Places that are left over become misses. Tells how many
    /// were filled: if all, there may be more.
    ///
    /// It is what asking every object alone and sorting gives, to the bit, also where two objects touch: to go on from
    /// hit to hit with [`secondaire`](Rayon::secondaire) would lose objects there, or meet some twice. Where a ray leaves an object,
    /// [`sortie`](ObjetRay::sortie) tells. An object in which the ray starts is not entered: such are those that
    /// [`contient`](ObjetRay::contient) is true of.
    ///
    /// ```
    /// use lancer_rayon::{Hierarchie, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |z| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(0));
    /// let scene: [ObjetRay; 3] = [boule(-9.0)?.into(), boule(-4.0)?.into(), boule(-4.5)?.into()];
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    ///
    /// let mut touches = [Err(NoIntersection); 4];
    /// let hierarchie = Hierarchie::de_liste(&scene);
    /// assert_eq!(hierarchie.dans_l_ordre(&rayon, f64::INFINITY, &mut touches), 3);
    /// let objets = touches.iter().flatten().map(|touche| touche.objet());
    /// assert!(objets.eq([1, 2, 0]));
    ///
    /// // The first two alone; and those before 3.2.
    /// assert_eq!(hierarchie.dans_l_ordre(&rayon, f64::INFINITY, &mut touches[..2]), 2);
    /// assert_eq!(hierarchie.dans_l_ordre(&rayon, 3.2, &mut touches), 1);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("all_hits", "multi_hit", "k_nearest", "in_order", "transparency", "picking"))]
    pub fn dans_l_ordre(
        &self,
        rayon: &Rayon<R>,
        distance_max: R,
        touches: &mut [Touche<R>],
    ) -> usize {
        touches.fill(Err(NoIntersection));
        let objets = self.arbre.liste.objets;
        let rangee = Rangee { objets, rayon, limite: distance_max, places: touches };
        R::demander::<DansLOrdre>((self, rangee));
        touches.partition_point(Result::is_ok)
    }

    /// [`est_occulte`](fn@crate::est_occulte) of the list.
    #[doc(alias("any_hit", "occluded", "shadow"))]
    #[inline]
    #[must_use]
    pub fn est_occulte(&self, rayon: &Rayon<R>, distance_max: R) -> bool {
        R::demander::<Occulte>((self, rayon, distance_max))
    }

    /// [`premieres_intersections`](fn@crate::premieres_intersections) of the list.
    ///
    /// Neighbours in `rayons` should be neighbours in the picture, in tiles of 8 × 8.
    ///
    /// # Errors
    /// If `rayons` and `touches` are not of the same length; nothing is written then.
    #[doc(alias("batch", "packet", "cast_rays"))]
    pub fn premieres_intersections(
        &self,
        rayons: &[Rayon<R>],
        touches: &mut [Touche<R>],
    ) -> Result<(), LongueursDifferentes> {
        R::demander::<Premieres>((self, rayons, touches))
    }

    /// [`sont_occultes`](fn@crate::sont_occultes) of the list.
    ///
    /// # Errors
    /// If `ombres` and `occultes` are not of the same length; nothing is written then.
    #[doc(alias("any_hit", "occluded", "shadow", "batch"))]
    pub fn sont_occultes(
        &self,
        ombres: &[(Rayon<R>, R)],
        occultes: &mut [bool],
    ) -> Result<(), LongueursDifferentes> {
        R::demander::<Occultes>((self, ombres, occultes))
    }

    /// [`est_certaine`](fn@crate::est_certaine) of the list, in the mean in 1.0 to 1.3 of the time of the ray.
    /// It is true wherever that is, and of some right answers more: what lies later by its box is not asked.
    #[doc(alias("is_certain", "certify", "certificate"))]
    #[inline]
    #[must_use]
    pub fn est_certaine(&self, rayon: &Rayon<R>, reponse: &Touche<R>) -> bool {
        R::demander::<Certaine>((self, rayon, reponse))
    }
}

compilees! {
    Batir<'a, R>: (&'a [ObjetRay<R>], &'a mut [f32])
        => Result<Arbre<'a, R>, PlacesInsuffisantes> = construire;
    Premiere<'a, R>: (&'a Hierarchie<'a, R>, &'a Rayon<R>, R) => Touche<R> = premiere;
    DansLOrdre<'a, R>: (&'a Hierarchie<'a, R>, Rangee<'a, R>) => () = dans_l_ordre;
    Occulte<'a, R>: (&'a Hierarchie<'a, R>, &'a Rayon<R>, R) => bool = occulte;
    Certaine<'a, R>: (&'a Hierarchie<'a, R>, &'a Rayon<R>, &'a Touche<R>) => bool = certaine;
    Premieres<'a, R>: (&'a Hierarchie<'a, R>, &'a [Rayon<R>], &'a mut [Touche<R>])
        => Result<(), LongueursDifferentes> = en_lot;
    Occultes<'a, R>: (&'a Hierarchie<'a, R>, &'a [(Rayon<R>, R)], &'a mut [bool])
        => Result<(), LongueursDifferentes> = en_lot;
}

/// [`Hierarchie::premiere_avant`]. As one function of any [`Demande`] this and [`occulte`]
/// would take 1.4 times as long (measured).
fn premiere<R: Reel>(
    (hierarchie, rayon, distance_max): (&Hierarchie<'_, R>, &Rayon<R>, R),
) -> Touche<R> {
    let Hierarchie { arbre, niveau } = hierarchie;
    selon_le_niveau!(*niveau, simd => {
        let premier = arbre.parcourir(simd, rayon, Premier::avant(distance_max));
        premier.touche(arbre.liste.objets, rayon)
    })
}

/// [`Hierarchie::dans_l_ordre`].
fn dans_l_ordre<R: Reel>((hierarchie, rangee): (&Hierarchie<'_, R>, Rangee<'_, R>)) {
    let Hierarchie { arbre, niveau } = hierarchie;
    selon_le_niveau!(*niveau, simd => arbre.parcourir(simd, rangee.rayon, rangee));
}

/// [`Hierarchie::est_occulte`].
fn occulte<R: Reel>((hierarchie, rayon, distance_max): (&Hierarchie<'_, R>, &Rayon<R>, R)) -> bool {
    let Hierarchie { arbre, niveau } = hierarchie;
    selon_le_niveau!(*niveau, simd => {
        let ombre = (*rayon, distance_max);
        arbre.parcourir(simd, &ombre, Premier::avant(distance_max)).rang.is_some()
    })
}

/// [`Hierarchie::est_certaine`]: no object may come before the first, or as soon.
fn certaine<R: Reel>(
    (hierarchie, rayon, reponse): (&Hierarchie<'_, R>, &Rayon<R>, &Touche<R>),
) -> bool {
    let Hierarchie { arbre, niveau } = hierarchie;
    let Some(certificat) = Certificat::new(arbre.liste, rayon, reponse) else { return false };
    selon_le_niveau!(*niveau, simd => {
        arbre.parcourir(simd, &certificat, Premier::avant(certificat.limite())).rang.is_none()
    })
}

/// [`Hierarchie::premieres_intersections`] and [`Hierarchie::sont_occultes`].
fn en_lot<R: Reel, D: Demande<R>>(
    (hierarchie, demandes, reponses): (&Hierarchie<'_, R>, &[D], &mut [D::Reponse]),
) -> Result<(), LongueursDifferentes> {
    let Hierarchie { arbre, niveau } = hierarchie;
    if demandes.len() != reponses.len() {
        return Err(LongueursDifferentes { rayons: demandes.len(), reponses: reponses.len() });
    }
    selon_le_niveau!(*niveau, simd => {
        let mut groupes = Groupes::new_const();
        let mut bloc = Bloc::new(arbre.liste, &mut groupes);
        for (demandes, reponses) in demandes.chunks(BLOC).zip(reponses.chunks_mut(BLOC)) {
            arbre.repondre_au_bloc(simd, &mut bloc, (demandes, reponses));
        }
    });
    Ok(())
}
