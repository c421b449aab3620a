//! The answers to the questions of a [`Monde`](crate::Monde), compiled in this crate for either
//! scalar: generic code would be compiled again in every crate that calls it, and with the optimisation of
//! that crate.

use core::fmt;

use fearless_simd::{Level, Simd};

use crate::arbre::Arbre;
use crate::arbre::budget::Budget;
use crate::arbre::construction::construire;
use crate::cote_a_cote::bloc::{BLOC, Bloc, Ensemble, GROUPES, Groupes};
use crate::cote_a_cote::eclairage::{Eclairage, Ombres};
use crate::cote_a_cote::groupe::{Groupe, VOIES};
use crate::cote_a_cote::niveau::{AVEC_AVX_512, SANS_AVX_512, selon_le_niveau};
use crate::question::jugement::certificat::Certificat;
use crate::question::liste::Liste;
use crate::question::visite::{Montrer, Rangee, Visite};
use crate::question::{Premier, Question};
use crate::{Lumiere, Nombre, ObjetRay, PlacesInsuffisantes, Rayon, Reponse, Vecteur};

/// What a question is asked of: the objects, their tree, which has no nodes if they are asked as a
/// list, and the instructions.
///
/// It is passed by reference: a copy of what was just written piece by piece stalls until the
/// pieces are stored, and a ray among few objects takes up to 1.2 times as long (measured).
pub struct Sujet<'a, R> {
    pub(crate) liste: Liste<'a, R>,
    pub(crate) arbre: &'a Arbre<'a, R>,
    pub(crate) niveau: Level,
}

/// What is said of a first object: a hit, or whether there is one.
trait Conclure<R: Nombre> {
    type Dit;

    /// Says it of one ray.
    fn dire(self, rayon: &Rayon<R>, objets: &[ObjetRay<R>]) -> Self::Dit;

    /// Writes it for each ray of a group, which holds these rays.
    fn ecrire(
        groupe: &Groupe<R>,
        objets: &[ObjetRay<R>],
        rayons: &[Rayon<R>],
        dits: &mut [Self::Dit],
    );
}

impl<R: Nombre> Conclure<R> for Premier<R> {
    type Dit = Reponse<R>;

    #[inline(always)]
    fn dire(self, rayon: &Rayon<R>, objets: &[ObjetRay<R>]) -> Reponse<R> {
        self.reponse(rayon, objets)
    }

    #[inline(always)]
    fn ecrire(
        groupe: &Groupe<R>,
        objets: &[ObjetRay<R>],
        rayons: &[Rayon<R>],
        touches: &mut [Reponse<R>],
    ) {
        groupe.ecrire(objets, rayons, touches);
    }
}

impl<R: Nombre> Conclure<R> for Premier<R, true> {
    type Dit = bool;

    #[inline(always)]
    fn dire(self, _: &Rayon<R>, _: &[ObjetRay<R>]) -> bool {
        self.rang.is_some()
    }

    #[inline(always)]
    fn ecrire(groupe: &Groupe<R>, _: &[ObjetRay<R>], _: &[Rayon<R>], occultes: &mut [bool]) {
        groupe.dire_les_ombres(occultes);
    }
}

/// What is said of the first object of one ray.
type Dit<R, const OMBRE: bool> = <Premier<R, OMBRE> as Conclure<R>>::Dit;

/// Asks the tree for the first object of one ray with these instructions: of a ray that a block
/// leaves over, from what it has found so far.
///
/// The function that [`vectorize`](Simd::vectorize) makes takes addresses, in registers. If it took
/// the question, that would be written to memory and read again before the walk begins, and shadows
/// among a dozen objects would take up to 1.1 times as long (measured).
#[inline(always)]
fn premier_d_un_arbre<S: Simd, R: Nombre, const OMBRE: bool>(
    simd: S,
    sujet: &Sujet<'_, R>,
    rayon: &Rayon<R>,
    deja: Option<&Premier<R>>,
) -> Dit<R, OMBRE>
where
    Premier<R, OMBRE>: Conclure<R>,
{
    simd.vectorize(
        #[inline(always)]
        move || {
            let premier = deja.map_or(Premier::avant(rayon.fin()), |deja| deja.en_question());
            let premier = sujet.arbre.parcourir(simd, &sujet.liste, rayon, premier);
            premier.dire(rayon, sujet.liste.objets)
        },
    )
}

/// Asks a list for the first object of one ray. It stands apart, so that it needs neither the stack
/// nor the registers of a tree.
#[inline(always)]
fn premier_d_une_liste<S: Simd, R: Nombre, const OMBRE: bool>(
    simd: S,
    liste: &Liste<'_, R>,
    rayon: &Rayon<R>,
) -> Dit<R, OMBRE>
where
    Premier<R, OMBRE>: Conclure<R>,
{
    simd.vectorize(
        #[inline(always)]
        move || {
            let mut premier = Premier::avant(rayon.fin());
            liste.interroger(rayon, &mut premier);
            premier.dire(rayon, liste.objets)
        },
    )
}

/// Asks one ray a question other than that for a first object.
#[inline(always)]
fn demander<R: Nombre, Q: Question<R>, T>(
    Sujet { liste, arbre, niveau }: &Sujet<'_, R>,
    rayon: &Rayon<R>,
    mut question: Q,
    dire: impl Fn(Q) -> T,
) -> T {
    selon_le_niveau!(*niveau, SANS_AVX_512, simd => simd.vectorize(
        #[inline(always)]
        || {
            if arbre.est_une_liste() {
                liste.interroger(rayon, &mut question);
            } else {
                question = arbre.parcourir(simd, liste, rayon, question);
            }
            dire(question)
        },
    ))
}

/// Fewer rays than this are asked of a list one by one (`DEVELOPING.md`, "Thresholds").
const MOINDRE_LOT_D_UNE_LISTE: usize = 6;

/// Asks for the first objects of many rays: of the rays of a block side by side as long as they
/// stay together, and of the others one by one, from what they have found so far.
#[inline(always)]
fn demander_en_lot<R: Nombre, const OMBRE: bool>(
    sujet: &Sujet<'_, R>,
    budget: &mut Option<Budget>,
    rayons: &[Rayon<R>],
    dits: &mut [Dit<R, OMBRE>],
) -> Result<(), LongueursDifferentes>
where
    Premier<R, OMBRE>: Conclure<R>,
{
    if rayons.len() != dits.len() {
        return Err(LongueursDifferentes { rayons: rayons.len(), reponses: dits.len() });
    }
    let &Sujet { liste, arbre, niveau } = sujet;
    // The rays that a block leaves over have asked the objects without a box.
    let sans = Arbre { sans_boite: &[], ..*arbre };
    let reste = Sujet { liste, arbre: &sans, niveau };
    let mut groupes = Groupes::new_const();
    let mut bloc = Bloc::new(&mut groupes, OMBRE);
    selon_le_niveau!(niveau, AVEC_AVX_512, simd => simd.vectorize(
        #[inline(always)]
        || {
            let mut ici = budget.unwrap_or_else(|| arbre.budget(simd, &liste));
            for (rayons, dits) in rayons.chunks(BLOC).zip(dits.chunks_mut(BLOC)) {
                let ensemble = chercher_en_bloc(simd, sujet, (&mut ici, &mut bloc), rayons);
                let par_groupe = rayons.chunks(VOIES).zip(dits.chunks_mut(VOIES));
                for (i, (rayons, dits)) in par_groupe.enumerate() {
                    match ensemble[i] {
                        Ensemble::JusquAuBout => {
                            let groupe = &bloc.groupes[i];
                            Premier::<R, OMBRE>::ecrire(groupe, liste.objets, rayons, dits);
                        }
                        Ensemble::EnPartie => {
                            un_par_un::<_, _, OMBRE>(simd, &reste, Some(&bloc.groupes[i]), rayons, dits);
                        }
                        Ensemble::Rien => un_par_un::<_, _, OMBRE>(simd, sujet, None, rayons, dits),
                    }
                }
            }
            *budget = Some(ici);
        },
    ));
    Ok(())
}

/// Looks for the first objects of at most 64 rays side by side, and tells of each group how far it
/// came.
#[inline(always)]
fn chercher_en_bloc<S: Simd, R: Nombre>(
    simd: S,
    Sujet { liste, arbre, .. }: &Sujet<'_, R>,
    (budget, bloc): (&mut Budget, &mut Bloc<'_, R>),
    rayons: &[Rayon<R>],
) -> [Ensemble; GROUPES] {
    if !arbre.est_une_liste() {
        return arbre.chercher_ensemble(simd, liste, (budget, bloc), rayons);
    }
    if rayons.len() < MOINDRE_LOT_D_UNE_LISTE {
        return [Ensemble::Rien; GROUPES];
    }
    bloc.charger(rayons);
    bloc.proposer_tous(simd, liste, 0..liste.objets.len());
    [Ensemble::JusquAuBout; GROUPES]
}

/// Asks one ray after another, each from what the group has found for it so far.
#[inline(always)]
fn un_par_un<S: Simd, R: Nombre, const OMBRE: bool>(
    simd: S,
    sujet: &Sujet<'_, R>,
    groupe: Option<&Groupe<R>>,
    rayons: &[Rayon<R>],
    dits: &mut [Dit<R, OMBRE>],
) where
    Premier<R, OMBRE>: Conclure<R>,
{
    let objets = sujet.liste.objets;
    for (voie, (rayon, dit)) in rayons.iter().zip(dits).enumerate() {
        *dit = if let Some(groupe) = groupe {
            let deja = groupe.premier(voie);
            if OMBRE && deja.rang.is_some() {
                deja.en_question::<OMBRE>().dire(rayon, objets)
            } else {
                premier_d_un_arbre::<_, _, OMBRE>(simd, sujet, rayon, Some(&deja))
            }
        } else if sujet.arbre.est_une_liste() {
            premier_d_une_liste::<_, _, OMBRE>(simd, &sujet.liste, rayon)
        } else {
            premier_d_un_arbre::<_, _, OMBRE>(simd, sujet, rayon, None)
        };
    }
}

/// There are more or fewer places for answers than rays.
///
/// ```
/// use lancer_rayon::{LongueursDifferentes, Monde, NoIntersection, Rayon};
///
/// let rayons: [Rayon; 0] = [];
/// let mut touches = [Err(NoIntersection); 3];
/// let refus = Monde::de_liste(&[]).premieres_intersections(&rayons, &mut touches);
/// assert_eq!(refus, Err(LongueursDifferentes { rayons: 0, reponses: 3 }));
/// ```
#[doc(alias = "length_mismatch")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LongueursDifferentes {
    /// How many rays there are.
    #[doc(alias = "rays")]
    pub rayons: usize,
    /// How many answers there are places for.
    #[doc(alias = "answers")]
    pub reponses: usize,
}

impl fmt::Display for LongueursDifferentes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rays, but places for {} answers", self.rayons, self.reponses)
    }
}

impl core::error::Error for LongueursDifferentes {}

/// The scalar type: `f32` or `f64`. Sealed.
///
/// Code that is generic over the scalar says `R: Reel`. It computes with what [`Nombre`] offers;
/// what this trait adds are the answers of a [`Monde`](crate::Monde), which are compiled in this
/// crate.
///
/// ```
/// use lancer_rayon::{Reel, Vecteur};
///
/// /// In either type, and with its own rounding.
/// fn moyenne<R: Reel>(a: Vecteur<R>, b: Vecteur<R>) -> Vecteur<R> {
///     (a + b) / (R::UN + R::UN)
/// }
///
/// let milieu = moyenne(Vecteur::NUL, Vecteur::<f32>::new(1.0, 2.0, 3.0));
/// assert_eq!(milieu, Vecteur::new(0.5, 1.0, 1.5));
/// ```
#[doc(alias("float", "scalar"))]
pub trait Reel: Nombre + Repond {}

impl Reel for f32 {}
impl Reel for f64 {}

/// `reponses! { fn …(…) -> … { … } … }`: the trait [`Repond`] of these functions, and their bodies
/// compiled for `f32` and for `f64`, which are `Self` in them.
macro_rules! reponses {
    ($(fn $nom:ident$(<$vie:lifetime>)?($($de:ident: $type:ty),* $(,)?) -> $dit:ty $corps:block)*) => {
        /// The answers in one scalar. Nobody can name this trait outside of the crate, and its
        /// functions have names that no trait of a caller has: else the caller could not use theirs
        /// for a scalar (E0034).
        pub trait Repond: Nombre {
            $(fn $nom$(<$vie>)?($($de: $type),*) -> $dit;)*
        }
        reponses! { dans f32 $(fn $nom$(<$vie>)?($($de: $type),*) -> $dit $corps)* }
        reponses! { dans f64 $(fn $nom$(<$vie>)?($($de: $type),*) -> $dit $corps)* }
    };
    (dans $reel:ident $($fonctions:item)*) => {
        impl Repond for $reel {
            $($fonctions)*
        }
    };
}

reponses! {
    fn lancer_rayon_arbre<'a>(
        objets: &'a [ObjetRay<Self>],
        places: &'a mut [f32],
    ) -> Result<Arbre<'a, Self>, PlacesInsuffisantes> {
        construire(objets, places)
    }

    fn lancer_rayon_premiere(sujet: &Sujet<'_, Self>, rayon: &Rayon<Self>) -> Reponse<Self> {
        selon_le_niveau!(sujet.niveau, AVEC_AVX_512, simd => {
            premier_d_un_arbre::<_, _, false>(simd, sujet, rayon, None)
        })
    }

    fn lancer_rayon_premiere_d_une_liste(
        liste: &Liste<'_, Self>,
        niveau: Level,
        rayon: &Rayon<Self>,
    ) -> Reponse<Self> {
        selon_le_niveau!(niveau, SANS_AVX_512, simd => {
            premier_d_une_liste::<_, _, false>(simd, liste, rayon)
        })
    }

    fn lancer_rayon_premieres(
        sujet: &Sujet<'_, Self>,
        rayons: &[Rayon<Self>],
        touches: &mut [Reponse<Self>],
    ) -> Result<(), LongueursDifferentes> {
        demander_en_lot::<_, false>(sujet, &mut None, rayons, touches)
    }

    fn lancer_rayon_occulte(sujet: &Sujet<'_, Self>, rayon: &Rayon<Self>) -> bool {
        selon_le_niveau!(sujet.niveau, AVEC_AVX_512, simd => {
            premier_d_un_arbre::<_, _, true>(simd, sujet, rayon, None)
        })
    }

    fn lancer_rayon_occulte_d_une_liste(
        liste: &Liste<'_, Self>,
        niveau: Level,
        rayon: &Rayon<Self>,
    ) -> bool {
        selon_le_niveau!(niveau, SANS_AVX_512, simd => {
            premier_d_une_liste::<_, _, true>(simd, liste, rayon)
        })
    }

    fn lancer_rayon_occultes(
        sujet: &Sujet<'_, Self>,
        budget: &mut Option<Budget>,
        rayons: &[Rayon<Self>],
        occultes: &mut [bool],
    ) -> Result<(), LongueursDifferentes> {
        demander_en_lot::<_, true>(sujet, budget, rayons, occultes)
    }

    fn lancer_rayon_eclairements(
        sujet: &Sujet<'_, Self>,
        touches: &[Reponse<Self>],
        lumiere: &Lumiere<Self>,
        cosinus: &mut [Self],
    ) -> Result<(), LongueursDifferentes> {
        if touches.len() != cosinus.len() {
            return Err(LongueursDifferentes { rayons: touches.len(), reponses: cosinus.len() });
        }
        let (mut eclairage, mut ombres) = (Eclairage::VIDE, Ombres::new_const());
        // The blocks learn from each other, as those of one batch.
        let budget = &mut None;
        for (touches, cosinus) in touches.chunks(BLOC).zip(cosinus.chunks_mut(BLOC)) {
            ombres.clear();
            let (eclairage, ecrits) = (&mut eclairage, (&mut *cosinus, &mut ombres));
            selon_le_niveau!(sujet.niveau, AVEC_AVX_512, simd => simd.vectorize(
                #[inline(always)]
                || eclairage.ombres(touches, *lumiere, ecrits)
            ));
            let mut occultes = [false; BLOC];
            let occultes = &mut occultes[..ombres.len()];
            Self::lancer_rayon_occultes(sujet, budget, &ombres, occultes)?;
            let eclaires = cosinus.iter_mut().filter(|cosinus| **cosinus > 0.0);
            for (cosinus, occulte) in eclaires.zip(occultes) {
                *cosinus = if *occulte { 0.0 } else { *cosinus };
            }
        }
        Ok(())
    }

    fn lancer_rayon_certifie(
        sujet: &Sujet<'_, Self>,
        rayon: &Rayon<Self>,
        reponse: &Reponse<Self>,
    ) -> bool {
        let certificat = Certificat::new(&sujet.liste, rayon, reponse);
        certificat.is_some_and(|certificat| demander(sujet, rayon, certificat, |certificat| !certificat.doute))
    }

    fn lancer_rayon_visiter(
        sujet: &Sujet<'_, Self>,
        rayon: &Rayon<Self>,
        montrer: Montrer<'_, Self>,
    ) -> () {
        demander(sujet, rayon, Visite::<_, false> { fin: rayon.fin(), montrer }, |_| ());
    }

    fn lancer_rayon_dans_l_ordre(
        sujet: &Sujet<'_, Self>,
        rayon: &Rayon<Self>,
        touches: &mut [Reponse<Self>],
    ) -> usize {
        let mut rangee = Rangee::new(touches);
        Self::lancer_rayon_visiter(sujet, rayon, &mut |indice, t| rangee.placer(indice, t));
        rangee.en_ordre(rayon, sujet.liste.objets)
    }

    fn lancer_rayon_contenants(
        sujet: &Sujet<'_, Self>,
        point: Vecteur<Self>,
        montrer: Montrer<'_, Self>,
    ) -> bool {
        let visite = Visite::<_, true> { fin: Self::INFINI, montrer };
        // The direction does not matter, and the point need not be finite.
        let rayon = Rayon::sans_fin(point, Vecteur::Z);
        demander(sujet, &rayon, visite, |visite| visite.est_reglee())
    }
}
