//! The world that rays ask: a list of objects, with or without a tree, all of it or a choice.

pub(crate) mod reponses;

use core::fmt;
use core::ops::ControlFlow::{self, Break, Continue};

use fearless_simd::Level;

use crate::arbre::Arbre;
use crate::cote_a_cote::niveau::meilleur_niveau;
use crate::monde::reponses::Sujet;
use crate::question::choix::Prises;
use crate::question::liste::{Liste, exiger_des_rangs};
use crate::{
    Choix, Etendue, Intersection, LongueursDifferentes, Lumiere, Nombre, ObjetRay, Parmi,
    PlacesInsuffisantes, Rayon, Reel, Reponse, Sans, Tous, Vecteur,
};

/// What rays ask, one by one or in batches: a list of objects, or a choice of them, with or without
/// a tree of bounding boxes.
///
/// [`new`](Self::new) builds a tree in memory that the caller lends. Its answers are those of the
/// list, to the bit, and their time grows far more slowly than the number of objects.
/// [`de_liste`](Self::de_liste) builds nothing and tests every object. Both answer every question.
///
/// A `Monde` borrows the list, whose order it keeps, and the memory. It is `Copy`, and threads may
/// share it. Make a new one after the list has changed. No question allocates or panics.
///
/// **What makes a tree slow:**
///
/// - Half-spaces have no box. A ray tests each of them, as in a list.
/// - In a heap, where a ray crosses the boxes of most objects, a ray or a batch takes up to some 1.6
///   times as long as with a list (`benches/mesures/tas.csv`).
/// - The box of an object is rounded to some 10⁻⁶ of the distance of that object from the middle of
///   most objects, and in `f32` also of the distance of the source of the ray. A ray tests all
///   objects that stand closer together than that. So fine detail far from most objects costs time,
///   but never accuracy.
/// - With a sun, a sky or a ball for a ground a ray takes up to 1.4 times as long (`docs/vitesse.md`,
///   "List, tree or batch"), as long as that object is no farther than some 10²⁹ times the rest.
///
/// ```
/// use lancer_rayon::{
///     Monde, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur, places,
///     premiere_intersection,
/// };
///
/// let boule = |x| SphereGeo::new(Vecteur::new(f64::from(x), 0.0, -5.0), 0.4, Texture(x));
/// let objets = (0..1_000).map(|x| boule(x).map(ObjetRay::from)).collect::<Result<Vec<_>, _>>()?;
///
/// let mut memoire = vec![0.0; places(objets.len())];
/// let monde = Monde::new(&objets, &mut memoire)?;
///
/// let rayon = Rayon::new(Vecteur::new(700.0, 0.0, 0.0), Vecteur::new(0.0, 0.0, -1.0))?;
/// let touche = monde.premiere_intersection(&rayon)?;
/// assert_eq!((touche.indice(), touche.distance()), (700, 4.6));
/// assert_eq!(Ok(touche), premiere_intersection(&objets, &rayon));
/// assert!(monde.est_occulte(&rayon.jusqu_a(5.0)?) && !monde.est_occulte(&rayon.jusqu_a(4.0)?));
///
/// let mut touches = [Err(NoIntersection); 2];
/// monde.premieres_intersections(&[rayon; 2], &mut touches)?;
/// assert_eq!(touches, [Ok(touche); 2]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("world", "scene", "bvh", "acceleration_structure", "tree", "index"))]
#[derive(Clone, Copy)]
#[must_use]
pub struct Monde<'a, R = f64, C = Tous> {
    objets: &'a [ObjetRay<R>],
    /// It has no nodes over few objects with a box or over too many objects, which are asked as a
    /// list.
    arbre: Arbre<'a, R>,
    /// Detected when the value is made; tests set another.
    pub(crate) niveau: Level,
    choix: C,
}

impl<R: Nombre, C> fmt::Debug for Monde<'_, R, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Monde")
            .field("objets", &self.objets.len())
            .field("noeuds", &self.arbre.noeuds.len())
            .finish_non_exhaustive()
    }
}

/// The first object that the ray enters: its distance, its normal there, its texture and its index
/// in the list (handout §4.1).
///
/// For every other question, for many rays at once and for many objects there is
/// [`Monde`](crate::Monde).
///
/// A hit is an entry. An object that holds the source, inside or on its surface, is not hit (handout
/// §2.3), unless the source lies in it by little more than [the δ of the ray](Rayon::flou); other
/// objects still count. At the same distance the earlier in the list is the first. All of this holds
/// for distances as computed in R: within the bounds of `docs/precision.md` the exact answer may
/// differ.
///
/// # Errors
/// [`NoIntersection`](crate::NoIntersection) if the ray enters no object before its end.
///
/// # Panics
/// If the list has more than 2³² − 1 objects, some 300 GB.
///
/// ```
/// use lancer_rayon::{NoIntersection, Rayon, SphereGeo, Texture, Vecteur, premiere_intersection};
///
/// let boule = |z, texture| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(texture));
/// let scene = [boule(-9.0, 0)?.into(), boule(-4.0, 7)?.into()];
///
/// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
/// let touche = premiere_intersection(&scene, &rayon)?;
/// assert_eq!((touche.distance(), touche.normale()), (3.0, Vecteur::new(0.0, 0.0, 1.0)));
/// assert_eq!((touche.indice(), touche.texture()), (1, Texture(7)));
///
/// let ailleurs = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 1.0, 0.0))?;
/// assert_eq!(premiere_intersection(&scene, &ailleurs), Err(NoIntersection));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias("cast_ray", "closest_hit", "first_hit", "raycast"))]
#[inline]
pub fn premiere_intersection<R: Reel>(objets: &[ObjetRay<R>], rayon: &Rayon<R>) -> Reponse<R> {
    R::lancer_rayon_premiere_d_une_liste(&Liste::entiere(objets), meilleur_niveau(), rayon)
}

impl<'a, R: Reel> Monde<'a, R> {
    /// Builds a tree over this list in the memory that is lent, whatever numbers it holds.
    ///
    /// Building takes some 0.1 to 0.3 µs an object (`benches/mesures/construction.csv`). The memory
    /// is overwritten; more than [`places`](crate::places) numbers make nothing faster.
    ///
    /// # Errors
    /// If fewer numbers are lent than [`places`](crate::places) says.
    ///
    /// # Panics
    /// If the list has more than 2³² − 1 objects, some 300 GB.
    ///
    /// ```
    /// use lancer_rayon::{Monde, ObjetRay, SphereGeo, Texture, Vecteur, places};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::NUL, 1.0_f32, Texture(0))?);
    /// let mut memoire = [0.0; places(20)];
    /// assert!(Monde::new(&[boule; 20], &mut memoire).is_ok());
    ///
    /// let refus = Monde::new(&[boule; 200], &mut memoire).unwrap_err();
    /// assert_eq!(refus.to_string(), "478 places lent, but 1710 needed");
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias = "build")]
    pub fn new(
        objets: &'a [ObjetRay<R>],
        places: &'a mut [f32],
    ) -> Result<Self, PlacesInsuffisantes> {
        // With no place to spare no object is cut.
        let assez = places.len().min(crate::places(objets.len()));
        Self::en_morceaux(objets, &mut places[..assez])
    }

    /// Builds a tree in which **long boxes that stand askew**, such as poles, planks and beams, are
    /// cut into pieces. Each piece takes up less room than the whole, and the numbers lent beyond
    /// [`places`](crate::places) pay for the pieces.
    ///
    /// With twice the places a ray among 10,000 such boxes takes about half to two thirds of the
    /// time, and among 1,000 two thirds to four fifths. Among some hundred neither gains much, and
    /// where nothing is long the tree is that of [`new`](Self::new)
    /// (`benches/mesures/morceaux.csv`). A ray that runs along a long object takes longer, since it
    /// asks the object for each of its pieces, of which there are at most sixteen. No answer depends
    /// on the pieces.
    ///
    /// # Errors
    /// If fewer numbers are lent than [`places`](crate::places) says.
    ///
    /// # Panics
    /// As [`new`](Self::new).
    ///
    /// ```
    /// use lancer_rayon::{BoiteGeo, Monde, ObjetRay, Rotation, Texture, Vecteur, places};
    ///
    /// let tour = Rotation::new(Vecteur::new(0.5, 0.3, 0.4))?;
    /// let cotes = Vecteur::new(0.1, 9.0, 0.1);
    /// let perche = |x| BoiteGeo::new(Vecteur::new(x, 0.0, 0.0), cotes, tour, Texture(0));
    /// let perches = (0..200).map(|i| perche(i as f32).map(ObjetRay::from));
    /// let perches = perches.collect::<Result<Vec<_>, _>>()?;
    /// let mut memoire = vec![0.0; 2 * places(perches.len())];
    /// assert!(Monde::en_morceaux(&perches, &mut memoire).is_ok());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("split", "spatial_splits"))]
    pub fn en_morceaux(
        objets: &'a [ObjetRay<R>],
        places: &'a mut [f32],
    ) -> Result<Self, PlacesInsuffisantes> {
        Ok(Self { arbre: R::lancer_rayon_arbre(objets, places)?, ..Self::de_liste(objets) })
    }

    /// Takes this list as it is: nothing is built, no memory is needed, and every object is tested.
    ///
    /// With fewer than ten spheres and boxes it is as fast as a tree.
    ///
    /// # Panics
    /// If the list has more than 2³² − 1 objects, some 300 GB.
    #[doc(alias("from_slice", "brute_force"))]
    pub fn de_liste(objets: &'a [ObjetRay<R>]) -> Self {
        exiger_des_rangs(objets.len());
        Self { objets, arbre: Arbre::SANS_NOEUDS, niveau: meilleur_niveau(), choix: Tous }
    }
}

impl<'a, R: Reel, C: Choix> Monde<'a, R, C> {
    /// The world as questions take it.
    #[inline]
    pub(crate) fn sujet(&self) -> Sujet<'_, R> {
        self.sujet_de(self.choix.prises_des_parcours())
    }

    #[inline]
    fn sujet_de<'m>(&'m self, prises: Prises<'m>) -> Sujet<'m, R> {
        let liste = Liste { objets: self.objets, prises };
        Sujet { liste, arbre: &self.arbre, niveau: self.niveau }
    }

    #[inline]
    fn avec_choix<D>(self, choisir: impl FnOnce(C) -> D) -> Monde<'a, R, D> {
        let Self { objets, arbre, niveau, choix } = self;
        Monde { objets, arbre, niveau, choix: choisir(choix) }
    }

    /// The list, whatever the choice takes of it.
    #[doc(alias("objects", "primitives"))]
    pub fn objets(&self) -> &'a [ObjetRay<R>] {
        self.objets
    }

    /// The same world with only those objects whose index `prend` takes. The answers are those of a
    /// list of these objects, to the bit, except that each object keeps its index.
    ///
    /// The choice holds for every question, including shadows, batches and certificates. A choice
    /// from a choice takes what both take. `prend` is called only with indices of the list. For
    /// most objects that a ray passes by it is not called, and for some others more than once. A
    /// batch over a list calls it at most once for each object in each block of 64 rays, or for each
    /// ray if there are fewer than six, or if it is a shadow and few of its block have no object yet.
    ///
    /// To leave out one object there is [`sans`](Self::sans). To keep less than about a hundredth
    /// of a large list, build a `Monde` of those objects: a ray walks the whole tree, whatever the
    /// choice takes.
    ///
    /// ```
    /// use lancer_rayon::*;
    ///
    /// let boule = |z, texture| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(texture));
    /// let objets: Vec<ObjetRay> = vec![boule(-4.0, 0)?.into(), boule(-9.0, 7)?.into()];
    /// let monde = Monde::de_liste(&objets);
    ///
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// let autres = monde.parmi(|indice| indice != 0);
    /// let touche = autres.premiere_intersection(&rayon)?;
    /// assert_eq!((touche.indice(), touche.distance()), (1, 8.0));
    ///
    /// // A choice by any property; here nothing is left.
    /// let aucune = autres.parmi(|indice| objets[indice].texture() != Texture(7));
    /// assert_eq!(aucune.premiere_intersection(&rayon), Err(NoIntersection));
    ///
    /// // A choice can be returned from a function, and kept in a struct.
    /// fn opaques<'a>(monde: Monde<'a>, verre: &'a [bool]) -> Monde<'a, f64, impl Choix + Copy + 'a> {
    ///     monde.parmi(|indice| !verre[indice])
    /// }
    /// struct Lumiere<'a, C> {
    ///     ombres: Monde<'a, f64, C>,
    /// }
    /// let lumiere = Lumiere { ombres: opaques(monde, &[true, false]) };
    /// assert!(!lumiere.ombres.est_occulte(&rayon.jusqu_a(5.0)?));
    ///
    /// // Threads may share it.
    /// std::thread::scope(|fils| {
    ///     for _ in 0..2 {
    ///         fils.spawn(|| assert!(lumiere.ombres.est_occulte(&rayon)));
    ///     }
    /// });
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("filter", "mask"))]
    #[inline]
    pub fn parmi<F: Fn(usize) -> bool>(self, prend: F) -> Monde<'a, R, Parmi<C, F>> {
        self.avec_choix(|parmi| Parmi { parmi, prend })
    }

    /// The same world without the object at this index. After another choice it takes what both
    /// take; an index beyond the list leaves out nothing.
    ///
    /// Leave out **a lamp of the list**, or the object at the far end of
    /// [`vers_touche`](crate::Intersection::vers_touche): no distance is exact enough to stop just
    /// before that object, so that it would hide points of its own surface. A ray that leaves an
    /// object needs no such choice: it never hits that object again
    /// ([`secondaire`](crate::Intersection::secondaire)), and
    /// [`premiere_depuis`](Self::premiere_depuis) saves the time to find that out. Each call makes
    /// another type: for a set of objects that is known only at run time take
    /// [`parmi`](Self::parmi).
    ///
    /// ```
    /// use lancer_rayon::{Monde, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |z| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(0));
    /// let objets: [ObjetRay; 2] = [boule(-4.0)?.into(), boule(-9.0)?.into()];
    /// let monde = Monde::de_liste(&objets);
    ///
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    /// assert_eq!(monde.sans(0).premiere_intersection(&rayon)?.distance(), 8.0);
    /// let rien = monde.sans(0).sans(1);
    /// assert_eq!(rien.premiere_intersection(&rayon), Err(NoIntersection));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("without", "except", "ignore", "exclude", "skip"))]
    #[inline]
    pub fn sans(self, indice: usize) -> Monde<'a, R, Sans<C>> {
        self.avec_choix(|parmi| Sans { parmi, sauf: indice })
    }

    /// The first object that the ray enters before its end: what
    /// [`premiere_intersection`](fn@crate::premiere_intersection) says of the list.
    ///
    /// # Errors
    /// [`NoIntersection`](crate::NoIntersection) if the ray enters no object before its end.
    #[doc(alias("cast_ray", "closest_hit", "first_hit", "raycast"))]
    #[inline]
    pub fn premiere_intersection(&self, rayon: &Rayon<R>) -> Reponse<R> {
        premiere(&self.sujet(), rayon)
    }

    /// The first object that each ray enters:
    /// [`premiere_intersection`](Self::premiere_intersection) of every ray, to the bit, and in less
    /// time where rays stay together: the tiles of a picture take a third to a fifth of it.
    ///
    /// Neighbours in `rayons` should start and point alike: pass those of a picture in tiles of 8 × 8
    /// (`docs/vitesse.md`, "The order in a batch"). Pass 64 rays or more per call. Rays that would
    /// take longer together go on one by one, as soon as that shows: in calls of 4,096 a batch
    /// seldom takes more than 1.1 times as long as its rays one by one. Calls of 64 cannot learn from
    /// each other, and take up to some 2.7 times as long (`benches/mesures/falaises.csv`). Nothing
    /// is allocated and no thread is started; the caller may give parts of a picture to several
    /// threads.
    ///
    /// # Errors
    /// If `rayons` and `touches` are not of the same length; nothing is written then.
    ///
    /// ```
    /// use lancer_rayon::{Monde, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?);
    /// let vers = |x| Rayon::new(Vecteur::NUL, Vecteur::new(x, 0.0, -1.0));
    /// let rayons = [vers(0.0)?, vers(0.1)?, vers(0.0)?.jusqu_a(3.0)?];
    ///
    /// let mut touches = [Err(NoIntersection); 3];
    /// Monde::de_liste(&[boule]).premieres_intersections(&rayons, &mut touches)?;
    /// assert_eq!(touches.map(|touche| touche.is_ok()), [true, true, false]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("batch", "packet", "cast_rays", "lidar"))]
    pub fn premieres_intersections(
        &self,
        rayons: &[Rayon<R>],
        touches: &mut [Reponse<R>],
    ) -> Result<(), LongueursDifferentes> {
        R::lancer_rayon_premieres(&self.sujet(), rayons, touches)
    }

    /// Whether anything stands before the end of the ray, where the light is: the shadow of the
    /// handout's later parts.
    ///
    /// It is `premiere_intersection(rayon).is_ok()`, but stops at any object found. Rays
    /// come from [`vers_lumiere`](crate::Intersection::vers_lumiere),
    /// [`vers_soleil`](crate::Intersection::vers_soleil) or [`Rayon::entre`];
    /// [`eclairement`](Self::eclairement) makes them itself. If you make the ray by
    /// [`secondaire`](crate::Intersection::secondaire) instead, measure its end from its source, and
    /// test N·L > 0 first: towards a lamp behind the surface the ray starts inside the object, which
    /// then casts no shadow.
    ///
    /// **A lamp that is an object of the list** is to be [left out](Self::sans).
    ///
    /// **From deep inside an object** no ray hits that object: a point of the floor inside a ball
    /// that is sunk into the floor is not in the shadow of the ball. [`contient`](Self::contient)
    /// tells such points.
    ///
    /// ```
    /// use lancer_rayon::{Monde, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |y, r, texture| SphereGeo::new(Vecteur::new(0.0, y, -5.0), r, Texture(texture));
    /// let objets = [boule(0.0, 1.0, 0)?.into(), boule(4.0, 0.5, 1)?.into()];
    /// let monde = Monde::de_liste(&objets);
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.6, -5.0))?;
    /// let touche = monde.premiere_intersection(&rayon)?;
    /// let eclaire = |lampe| touche.vers_lumiere(lampe).is_ok_and(|ombre| !monde.est_occulte(&ombre));
    /// assert!(eclaire(Vecteur::new(0.0, 3.0, -2.0)));
    /// assert!(!eclaire(Vecteur::new(0.0, 9.0, -5.2))); // behind the small ball
    /// assert!(!eclaire(Vecteur::new(0.0, 0.0, -9.0))); // behind the surface
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("any_hit", "occluded", "shadow"))]
    #[inline]
    #[must_use]
    pub fn est_occulte(&self, rayon: &Rayon<R>) -> bool {
        occulte(&self.sujet(), rayon)
    }

    /// Whether anything stands before the end of each ray: the answers of
    /// [`est_occulte`](Self::est_occulte) for every ray, in less time where neighbours
    /// start and point alike.
    ///
    /// The advice of [`premieres_intersections`](Self::premieres_intersections) on the order and
    /// number of rays holds here too. Rays to one lamp, in the order of the picture, are
    /// neighbours.
    ///
    /// # Errors
    /// If `rayons` and `occultes` are not of the same length; nothing is written then.
    ///
    /// ```
    /// use lancer_rayon::{Monde, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::new(0.0, 3.0, 0.0), 1.0, Texture(0))?);
    /// let vers_le_haut = |x, y| Rayon::entre(Vecteur::new(x, 0.0, 0.0), Vecteur::new(x, y, 0.0));
    /// let ombres = [vers_le_haut(0.0, 9.0)?, vers_le_haut(0.0, 2.0)?, vers_le_haut(4.0, 9.0)?];
    ///
    /// let mut occultes = [false; 3];
    /// Monde::de_liste(&[boule]).sont_occultes(&ombres, &mut occultes)?;
    /// assert_eq!(occultes, [true, false, false]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("any_hit", "occluded", "shadow", "batch"))]
    pub fn sont_occultes(
        &self,
        rayons: &[Rayon<R>],
        occultes: &mut [bool],
    ) -> Result<(), LongueursDifferentes> {
        R::lancer_rayon_occultes(&self.sujet(), &mut None, rayons, occultes)
    }

    /// The first object that a ray from this hit enters: what
    /// [`premiere_intersection`](Self::premiere_intersection) says of the ray, to the bit, but mostly
    /// sooner.
    ///
    /// A ray that leaves a ball or a box starts in the bounding box of that object, so that a tree
    /// asks the object, which the ray never enters. This call skips the object, after a few
    /// operations that tell whether the ray goes away from it. The hit is only a hint and changes no
    /// answer: neither where the ray goes inward, nor where the hit belongs to another list or to an
    /// object that was asked alone. `docs/vitesse.md`, "From a hit", has what this saves.
    ///
    /// # Errors
    /// [`NoIntersection`](crate::NoIntersection) if the ray enters no object before its end.
    ///
    /// ```
    /// use lancer_rayon::{BoiteGeo, Monde, ObjetRay, Rayon, Rotation, Texture, Vecteur};
    ///
    /// let cotes = Vecteur::new(1.0, 1.0, 1.0);
    /// let cube = |x| BoiteGeo::new(Vecteur::X * x, cotes, Rotation::IDENTITE, Texture(0));
    /// let objets: [ObjetRay; 2] = [cube(0.0)?.into(), cube(3.0)?.into()];
    /// let monde = Monde::de_liste(&objets);
    ///
    /// // From the side of one cube to the other.
    /// let rayon = Rayon::new(Vecteur::new(2.0, 0.0, 0.0), -Vecteur::X)?;
    /// let touche = monde.premiere_intersection(&rayon)?;
    /// let reflet = touche.reflechi(rayon.direction())?;
    /// let suivante = monde.premiere_depuis(&touche, &reflet)?;
    /// assert_eq!((touche.indice(), suivante.indice()), (0, 1));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("cast_from", "bounce", "self_intersection", "next_hit"))]
    #[inline]
    pub fn premiere_depuis(&self, touche: &Intersection<R>, rayon: &Rayon<R>) -> Reponse<R> {
        premiere(&self.sujet_depuis(touche, rayon), rayon)
    }

    /// Whether anything stands before the end of a ray from this hit: what
    /// [`est_occulte`](Self::est_occulte) says of the ray, mostly sooner, as
    /// [`premiere_depuis`](Self::premiere_depuis) is. For a lamp or a sun ask
    /// [`eclairement`](Self::eclairement), which makes the ray as well.
    #[doc(alias("any_hit", "occluded", "shadow", "self_intersection"))]
    #[inline]
    #[must_use]
    pub fn est_occulte_depuis(&self, touche: &Intersection<R>, rayon: &Rayon<R>) -> bool {
        occulte(&self.sujet_depuis(touche, rayon), rayon)
    }

    /// The world without the object of this hit, if this ray goes away from it.
    #[inline]
    fn sujet_depuis(&self, touche: &Intersection<R>, rayon: &Rayon<R>) -> Sujet<'_, R> {
        let indice = touche.indice();
        self.sujet_de(match self.objets.get(indice) {
            Some(objet) if objet.s_eloigne(rayon) => self.choix.prises_des_parcours_sans(indice),
            Some(_) | None => self.choix.prises_des_parcours(),
        })
    }

    /// How much of a light falls on a hit: N·L, the cosine between the normal and the direction to
    /// the light, by which a diffuse surface is lit (Lambert). It is 0 where the surface faces away
    /// from the light or something stands before the light, and above 0 everywhere else.
    ///
    /// The answer is, to the bit, that of [`vers_lumiere`](Intersection::vers_lumiere) or
    /// [`vers_soleil`](Intersection::vers_soleil), then [`est_occulte`](Self::est_occulte), then the
    /// scalar product of the ray and the normal, with the promises of these calls. Where they would
    /// fail it is 0. [Leave out](Self::sans) a lamp that is itself an object of the list.
    ///
    /// ```
    /// use lancer_rayon::{Lumiere, Monde, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |y, r| SphereGeo::new(Vecteur::new(0.0, y, -5.0), r, Texture(0));
    /// let objets = [boule(0.0, 1.0)?.into(), boule(4.0, 0.5)?.into()];
    /// let monde = Monde::de_liste(&objets);
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.6, -5.0))?;
    /// let touche = monde.premiere_intersection(&rayon)?;
    /// let vers = |y, z| Lumiere::lampe(Vecteur::new(0.0, y, z));
    /// assert!(monde.eclairement(&touche, &vers(3.0, -2.0)?) > 0.9);
    /// assert_eq!(monde.eclairement(&touche, &vers(9.0, -5.2)?), 0.0); // behind the small ball
    /// assert_eq!(monde.eclairement(&touche, &vers(0.0, -9.0)?), 0.0); // behind the surface
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("is_lit", "visible", "irradiance", "lambert", "cosine", "shadow"))]
    #[must_use]
    #[inline]
    pub fn eclairement(&self, touche: &Intersection<R>, lumiere: &Lumiere<R>) -> R {
        let (ombre, cosinus, eclaire) = touche.vers(|source| lumiere.vue_de(source));
        let eclaire = eclaire && !self.est_occulte_depuis(touche, &ombre);
        if eclaire { cosinus } else { R::ZERO }
    }

    /// How much of a light falls on each of these hits, as a batch wrote them:
    /// [`eclairement`](Self::eclairement) of each hit, and 0 for a miss.
    ///
    /// The shadow rays are made side by side and asked as a batch, in far less time than it takes to
    /// make them one by one and to pass them to [`sont_occultes`](Self::sont_occultes)
    /// (`docs/vitesse.md`, "A whole picture"). The order matters as in
    /// [`premieres_intersections`](Self::premieres_intersections).
    ///
    /// # Errors
    /// If `touches` and `cosinus` are not of the same length; nothing is written then.
    ///
    /// ```
    /// use lancer_rayon::{Lumiere, Monde, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = ObjetRay::from(SphereGeo::new(Vecteur::new(0.0, 0.0, -5.0), 1.0, Texture(0))?);
    /// let vers = |x| Rayon::new(Vecteur::NUL, Vecteur::new(x, 0.0, -5.0));
    /// let rayons = [vers(0.0)?, vers(0.5)?, vers(9.0)?];
    /// let (mut touches, mut cosinus) = ([Err(NoIntersection); 3], [0.0; 3]);
    ///
    /// let objets = [boule];
    /// let monde = Monde::de_liste(&objets);
    /// monde.premieres_intersections(&rayons, &mut touches)?;
    /// monde.eclairements(&touches, &Lumiere::soleil(Vecteur::Z)?, &mut cosinus)?;
    /// assert!(cosinus[0] == 1.0 && cosinus[1] > 0.8 && cosinus[2] == 0.0);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("is_lit", "visible", "irradiance", "lambert", "shadow", "batch"))]
    pub fn eclairements(
        &self,
        touches: &[Reponse<R>],
        lumiere: &Lumiere<R>,
        cosinus: &mut [R],
    ) -> Result<(), LongueursDifferentes> {
        R::lancer_rayon_eclairements(&self.sujet(), touches, lumiere, cosinus)
    }

    /// Writes the objects that the ray enters before its end, the nearest first; of two at the same
    /// distance the earlier in the list comes first. Places that are left over become misses. It
    /// returns how many were filled: if all were, there may be more.
    ///
    /// The result is, to the bit, that of asking every object alone and sorting, also where two
    /// objects touch. A ray in the common face of two boxes enters both, and one along a common
    /// edge each box there. [`sortie`](ObjetRay::sortie) tells where a ray leaves an object. An
    /// object in which the ray starts is not entered; [`contenants`](Self::contenants) of its
    /// source shows those.
    ///
    /// With n objects entered and k places the time grows as n log k, in whatever order the objects
    /// stand. A tree shows near objects first, and skips what lies beyond the last place.
    ///
    /// ```
    /// use lancer_rayon::{Monde, NoIntersection, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |z| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(0));
    /// let objets: [ObjetRay; 3] = [boule(-9.0)?.into(), boule(-4.0)?.into(), boule(-4.5)?.into()];
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    ///
    /// let mut touches = [Err(NoIntersection); 4];
    /// let monde = Monde::de_liste(&objets);
    /// assert_eq!(monde.dans_l_ordre(&rayon, &mut touches), 3);
    /// let indices = touches.iter().flatten().map(|touche| touche.indice());
    /// assert!(indices.eq([1, 2, 0]));
    ///
    /// // The first two alone; and those before 3.2.
    /// assert_eq!(monde.dans_l_ordre(&rayon, &mut touches[..2]), 2);
    /// assert_eq!(monde.dans_l_ordre(&rayon.jusqu_a(3.2)?, &mut touches), 1);
    /// assert!(touches[1..].iter().all(Result::is_err));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("all_hits", "multi_hit", "k_nearest", "in_order", "transparency", "picking"))]
    pub fn dans_l_ordre(&self, rayon: &Rayon<R>, touches: &mut [Reponse<R>]) -> usize {
        R::lancer_rayon_dans_l_ordre(&self.sujet(), rayon, touches)
    }

    /// Calls `voir` once for every object that the ray enters before its end, in no order, with the
    /// index of the object and the distance.
    ///
    /// `voir` returns `Break(())` to stop, or `Continue(fin)` to go on with a ray that ends at
    /// `fin` from then on. `Continue(t)` thus goes on to nearer objects alone, and
    /// `Continue(rayon.fin())` to all others. The end never moves away again: a `fin` beyond the
    /// end so far, or a NaN, leaves it where it is.
    ///
    /// It serves what no other question asks: to count objects, to weigh them, or to find the first
    /// by a rule of your own. Only the distance is computed; [`ObjetRay::intersection`] of the
    /// object has the rest of the hit.
    ///
    /// ```
    /// use core::ops::ControlFlow::{Break, Continue};
    /// use lancer_rayon::{Monde, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |z, texture| SphereGeo::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(texture));
    /// let objets: [ObjetRay; 3] =
    ///     [boule(-9.0, 1)?.into(), boule(-4.0, 2)?.into(), boule(-20.0, 2)?.into()];
    /// let monde = Monde::de_liste(&objets);
    /// let rayon = Rayon::new(Vecteur::NUL, Vecteur::new(0.0, 0.0, -1.0))?;
    ///
    /// let mut nombre = 0;
    /// monde.visiter(&rayon, |_, _| {
    ///     nombre += 1;
    ///     Continue(rayon.fin())
    /// });
    /// assert_eq!(nombre, 3);
    ///
    /// // The first with the texture 2: what comes later need not be shown.
    /// let mut premier = None;
    /// monde.visiter(&rayon, |indice, t| {
    ///     if objets[indice].texture() != Texture(2) {
    ///         return Continue(rayon.fin());
    ///     }
    ///     premier = Some(indice);
    ///     Continue(t)
    /// });
    /// assert_eq!(premier, Some(1));
    ///
    /// // Whether there are two: the third need not be shown.
    /// let mut encore = 2;
    /// monde.visiter(&rayon, |_, _| {
    ///     encore -= 1;
    ///     if encore == 0 { Break(()) } else { Continue(rayon.fin()) }
    /// });
    /// assert_eq!(encore, 0);
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("any_hit", "visitor", "for_each_hit", "count"))]
    pub fn visiter(&self, rayon: &Rayon<R>, mut voir: impl FnMut(usize, R) -> ControlFlow<(), R>) {
        R::lancer_rayon_visiter(&self.sujet(), rayon, &mut voir);
    }

    /// Whether this point is in some object or on its surface, as [`ObjetRay::contient`] says.
    ///
    /// ```
    /// use lancer_rayon::{Monde, ObjetRay, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |x| SphereGeo::new(Vecteur::new(x, 0.0, 0.0), 2.0, Texture(0));
    /// let objets: [ObjetRay; 2] = [boule(0.0)?.into(), boule(3.0)?.into()];
    /// let monde = Monde::de_liste(&objets);
    /// let milieu = Vecteur::new(1.5, 0.0, 0.0);
    /// assert!(monde.contient(milieu) && !monde.contient(milieu * 9.0));
    ///
    /// let mut lesquels = vec![];
    /// monde.contenants(milieu, |indice| lesquels.push(indice));
    /// assert_eq!(lesquels, [0, 1]);
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("contains", "inside", "point_query"))]
    #[must_use]
    pub fn contient(&self, point: Vecteur<R>) -> bool {
        R::lancer_rayon_contenants(&self.sujet(), point, &mut |_, _| Break(()))
    }

    /// Calls `voir` once, in no order, with the index of every object that
    /// [contains](ObjetRay::contient) this point. To learn whether any of some objects does,
    /// [`contient`](Self::contient) of a [`parmi`](Self::parmi) is faster.
    #[doc(alias("contains", "inside", "point_query"))]
    pub fn contenants(&self, point: Vecteur<R>, mut voir: impl FnMut(usize)) {
        R::lancer_rayon_contenants(&self.sujet(), point, &mut |indice, _| {
            voir(indice);
            Continue(R::INFINI)
        });
    }

    /// Whether an answer of [`premiere_intersection`](Self::premiere_intersection), a hit or a
    /// miss, is certain: whether exact arithmetic on the numbers as they are stored names the same
    /// object first, or none as well. (Which face of a box was hit at an edge is not certified.)
    ///
    /// It is never true of a wrong answer (lemma 18). It judges the source as it stands: a hit at
    /// once, by δ, is not certain, and what δ might let the ray hit does not count. It may be false
    /// of a right answer: where [`est_certain`](ObjetRay::est_certain) of some object is false,
    /// where no distance is promised, where two entries are almost equally far, and among numbers
    /// below the normal ones. Most often a right answer that is not certified is an exact tie, as
    /// where the sides of two boxes are flush. A tree certifies a few more right answers than a
    /// list, since it skips objects whose boxes come later.
    ///
    /// Only the [`indice`](crate::Intersection::indice) of `reponse` counts, so that an answer
    /// found elsewhere can be judged. On average a certificate takes less than twice as long as the
    /// ray, on top of it (`docs/vitesse.md`, "Certified or not").
    ///
    /// If an answer of `f32` is not certain, ask the same numbers in `f64`:
    /// [`ObjetRay::temoin_f64`] of all objects, and [`Rayon::temoin_f64`].
    ///
    /// ```
    /// use lancer_rayon::{Monde, ObjetRay, Rayon, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |z| SphereGeo::<f32>::new(Vecteur::new(0.0, 0.0, z), 1.0, Texture(0));
    /// let objets: [ObjetRay<f32>; 2] = [boule(-5.0)?.into(), boule(-5.000001)?.into()];
    /// let vers_le_fond = |x| Rayon::new(Vecteur::new(x, 0.0, 0.0), Vecteur::new(0.0, 0.0, -1.0));
    /// let certaine = |monde: Monde<'_, f32>, rayon| {
    ///     monde.certifie(&rayon, &monde.premiere_intersection(&rayon))
    /// };
    /// assert!(certaine(Monde::de_liste(&objets), vers_le_fond(0.3)?)); // the nearer one
    /// assert!(certaine(Monde::de_liste(&objets), vers_le_fond(1.5)?)); // a miss
    /// assert!(!certaine(Monde::de_liste(&[objets[0]; 2]), vers_le_fond(0.3)?)); // a tie
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("is_certain", "certify", "certificate"))]
    #[must_use]
    pub fn certifie(&self, rayon: &Rayon<R>, reponse: &Reponse<R>) -> bool {
        R::lancer_rayon_certifie(&self.sujet(), rayon, reponse)
    }

    /// A box along the axes that holds all of these objects except the half-spaces, which no box
    /// holds; `None` if there are no others.
    ///
    /// ```
    /// use lancer_rayon::{Etendue, Monde, PlanGeo, Rotation, SphereGeo, Texture, Vecteur};
    ///
    /// let boule = |x| SphereGeo::new(Vecteur::new(x, 0.0, 0.0), 1.0, Texture(0));
    /// let mur = PlanGeo::new(Rotation::IDENTITE, 0.0, Texture(0))?;
    /// let objets = [boule(3.0)?.into(), mur.into(), boule(-5.0)?.into()];
    /// let Etendue { bas, haut } = Monde::de_liste(&objets).etendue().unwrap();
    /// assert!((bas - Vecteur::new(-6.0, -1.0, -1.0)).longueur() < 1e-13);
    /// assert!((haut - Vecteur::new(4.0, 1.0, 1.0)).longueur() < 1e-13);
    /// # Ok::<(), lancer_rayon::ErreurGeo>(())
    /// ```
    #[doc(alias("bounding_box", "aabb", "bounds"))]
    #[must_use]
    pub fn etendue(&self) -> Option<Etendue<R>> {
        let Sujet { liste, .. } = self.sujet();
        let objets = (0..self.objets.len()).filter_map(|indice| liste.objet(indice));
        objets.filter_map(ObjetRay::etendue).reduce(Etendue::avec)
    }
}

/// The first object that the ray enters. Whether the world is a list is decided here, in the crate of
/// the caller: the compiler then drops the test for a `Monde` that `de_liste` has just made.
#[inline]
fn premiere<R: Reel>(sujet: &Sujet<'_, R>, rayon: &Rayon<R>) -> Reponse<R> {
    if sujet.arbre.est_une_liste() {
        return R::lancer_rayon_premiere_d_une_liste(&sujet.liste, sujet.niveau, rayon);
    }
    R::lancer_rayon_premiere(sujet, rayon)
}

/// Whether anything stands before the end of the ray.
#[inline]
fn occulte<R: Reel>(sujet: &Sujet<'_, R>, rayon: &Rayon<R>) -> bool {
    if sujet.arbre.est_une_liste() {
        return R::lancer_rayon_occulte_d_une_liste(&sujet.liste, sujet.niveau, rayon);
    }
    R::lancer_rayon_occulte(sujet, rayon)
}
