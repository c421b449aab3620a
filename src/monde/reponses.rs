//! The answers to the questions of a [`Monde`](crate::Monde), compiled in this crate for either
//! scalar: generic code would be compiled again by every crate that calls it, and as slowly as that
//! crate is.

use core::fmt;

use fearless_simd::{Level, Simd};

use crate::arbre::budget::Budget;
use crate::arbre::construction::{Arbre, construire};
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
/// list, and the instructions; and what the ray has found before.
///
/// It is passed by reference: a copy of what was just written piece by piece stalls until the
/// pieces are stored, and a ray among few objects takes up to 1.2 times as long (measured).
pub struct Sujet<'a, R> {
    pub(crate) liste: Liste<'a, R>,
    pub(crate) arbre: &'a Arbre<'a, R>,
    pub(crate) niveau: Level,
    /// The first object so far of a ray that a block leaves over.
    pub(crate) deja: Option<Premier<R>>,
}

/// Asks the tree for the first object of one ray, alone or left over by a block, with these
/// instructions; `repondre` makes the answer of it.
///
/// What is called gets two addresses, in registers. Were the question among what is passed, it
/// would be written and read again before the walk begins, and shadows among a dozen objects would
/// take up to 1.1 times as long (measured).
#[inline(always)]
fn premier_d_un_arbre<S: Simd, R: Nombre, T, const OMBRE: bool>(
    simd: S,
    sujet: &Sujet<'_, R>,
    rayon: &Rayon<R>,
    repondre: impl Fn(Premier<R, OMBRE>, &Rayon<R>, &[ObjetRay<R>]) -> T,
) -> T {
    simd.vectorize(
        #[inline(always)]
        move || {
            let premier = sujet.deja.map_or(Premier::avant(rayon.fin()), Premier::en_question);
            let premier = sujet.arbre.parcourir(simd, &sujet.liste, rayon, premier);
            repondre(premier, rayon, sujet.liste.objets)
        },
    )
}

/// The same of a list. It stands apart, so that it needs neither the stack nor the registers of a
/// tree.
#[inline(always)]
fn premier_d_une_liste<S: Simd, R: Nombre, T, const OMBRE: bool>(
    simd: S,
    liste: &Liste<'_, R>,
    rayon: &Rayon<R>,
    repondre: impl Fn(Premier<R, OMBRE>, &Rayon<R>, &[ObjetRay<R>]) -> T,
) -> T {
    simd.vectorize(
        #[inline(always)]
        move || {
            let mut premier = Premier::avant(rayon.fin());
            liste.interroger(rayon, &mut premier);
            repondre(premier, rayon, liste.objets)
        },
    )
}

/// Asks one ray any other question.
#[inline(always)]
fn demander<R: Nombre, Q: Question<R>, T>(
    Sujet { liste, arbre, niveau, .. }: &Sujet<'_, R>,
    rayon: &Rayon<R>,
    mut question: Q,
    repondre: impl Fn(Q, &Rayon<R>, &[ObjetRay<R>]) -> T,
) -> T {
    selon_le_niveau!(*niveau, SANS_AVX_512, simd => simd.vectorize(
        #[inline(always)]
        || {
            if arbre.noeuds.is_empty() {
                liste.interroger(rayon, &mut question);
            } else {
                question = arbre.parcourir(simd, liste, rayon, question);
            }
            repondre(question, rayon, liste.objets)
        },
    ))
}

/// Makes a hit of a first object. It is a closure, since a function that is passed on is not
/// inlined, and would be compiled for the baseline instructions.
fn une_touche<R: Nombre>() -> impl Fn(Premier<R>, &Rayon<R>, &[ObjetRay<R>]) -> Reponse<R> + Copy {
    #[inline(always)]
    |premier, rayon, objets| premier.reponse(rayon, objets)
}

/// Makes a shadow of a first object.
fn une_ombre<R: Nombre>() -> impl Fn(Premier<R, true>, &Rayon<R>, &[ObjetRay<R>]) -> bool + Copy {
    #[inline(always)]
    |premier, _, _| premier.rang.is_some()
}

/// Fewer rays than this are asked of a list one by one (`DEVELOPING.md`, "Thresholds").
const MOINDRE_LOT_D_UNE_LISTE: usize = 6;

/// Asks for the first objects of many rays: of the rays of a block side by side as long as they
/// stay together, and of the others one by one, from what they have found so far. `repondre` makes
/// the answer of one ray, `ecrire` writes those of a group.
#[inline(always)]
fn demander_en_lot<R: Nombre, T, const OMBRE: bool>(
    sujet: &Sujet<'_, R>,
    (rayons, reponses): (&[Rayon<R>], &mut [T]),
    repondre: impl Fn(Premier<R, OMBRE>, &Rayon<R>, &[ObjetRay<R>]) -> T + Copy,
    ecrire: impl Fn(&Groupe<R>, &[ObjetRay<R>], &[Rayon<R>], &mut [T]) + Copy,
) -> Result<(), LongueursDifferentes> {
    if rayons.len() != reponses.len() {
        return Err(LongueursDifferentes { rayons: rayons.len(), reponses: reponses.len() });
    }
    let &Sujet { liste, arbre, niveau, .. } = sujet;
    // The rays that a block leaves have asked the objects without a box.
    let sans = Arbre { sans_boite: &[], ..*arbre };
    let mut reste = Sujet { liste, arbre: &sans, niveau, deja: None };
    let mut groupes = Groupes::new_const();
    let mut bloc = Bloc::new(&mut groupes, OMBRE);
    selon_le_niveau!(niveau, AVEC_AVX_512, simd => simd.vectorize(
        #[inline(always)]
        || {
            let mut budget = arbre.budget(simd, &liste);
            for (rayons, reponses) in rayons.chunks(BLOC).zip(reponses.chunks_mut(BLOC)) {
                let ensemble = chercher_en_bloc(simd, sujet, (&mut budget, &mut bloc), rayons);
                let par_groupe = rayons.chunks(VOIES).zip(reponses.chunks_mut(VOIES));
                for (i, (rayons, reponses)) in par_groupe.enumerate() {
                    match ensemble[i] {
                        Ensemble::JusquAuBout => {
                            ecrire(&bloc.groupes[i], liste.objets, rayons, reponses);
                        }
                        Ensemble::EnPartie => {
                            let par_ici = (&mut reste, &bloc.groupes[i]);
                            continuer_un_par_un(simd, par_ici, (rayons, reponses), repondre);
                        }
                        Ensemble::Rien => {
                            demander_un_par_un(simd, sujet, (rayons, reponses), repondre);
                        }
                    }
                }
            }
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
    if !arbre.noeuds.is_empty() {
        return arbre.chercher_ensemble(simd, liste, (budget, bloc), rayons);
    }
    if rayons.len() < MOINDRE_LOT_D_UNE_LISTE {
        return [Ensemble::Rien; GROUPES];
    }
    bloc.charger(rayons);
    bloc.proposer_tous(simd, liste, 0..liste.objets.len());
    [Ensemble::JusquAuBout; GROUPES]
}

/// Asks one ray of a group after another, each from the first object that it has so far.
#[inline(always)]
fn continuer_un_par_un<S: Simd, R: Nombre, T, const OMBRE: bool>(
    simd: S,
    (reste, groupe): (&mut Sujet<'_, R>, &Groupe<R>),
    (rayons, reponses): (&[Rayon<R>], &mut [T]),
    repondre: impl Fn(Premier<R, OMBRE>, &Rayon<R>, &[ObjetRay<R>]) -> T + Copy,
) {
    for (voie, (rayon, reponse)) in rayons.iter().zip(reponses).enumerate() {
        let premier = groupe.premier(voie);
        *reponse = if OMBRE && premier.rang.is_some() {
            repondre(premier.en_question(), rayon, reste.liste.objets)
        } else {
            reste.deja = Some(premier);
            premier_d_un_arbre(simd, reste, rayon, repondre)
        };
    }
}

/// Asks one ray after another.
#[inline(always)]
fn demander_un_par_un<S: Simd, R: Nombre, T, const OMBRE: bool>(
    simd: S,
    sujet: &Sujet<'_, R>,
    (rayons, reponses): (&[Rayon<R>], &mut [T]),
    repondre: impl Fn(Premier<R, OMBRE>, &Rayon<R>, &[ObjetRay<R>]) -> T + Copy,
) {
    for (rayon, reponse) in rayons.iter().zip(reponses) {
        *reponse = if sujet.arbre.noeuds.is_empty() {
            premier_d_une_liste(simd, &sujet.liste, rayon, repondre)
        } else {
            premier_d_un_arbre(simd, sujet, rayon, repondre)
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
            premier_d_un_arbre(simd, sujet, rayon, une_touche())
        })
    }

    fn lancer_rayon_premiere_d_une_liste(
        liste: &Liste<'_, Self>,
        niveau: Level,
        rayon: &Rayon<Self>,
    ) -> Reponse<Self> {
        selon_le_niveau!(niveau, SANS_AVX_512, simd => {
            premier_d_une_liste(simd, liste, rayon, une_touche())
        })
    }

    fn lancer_rayon_premieres(
        sujet: &Sujet<'_, Self>,
        rayons: &[Rayon<Self>],
        touches: &mut [Reponse<Self>],
    ) -> Result<(), LongueursDifferentes> {
        demander_en_lot(
            sujet,
            (rayons, touches),
            une_touche(),
            #[inline(always)]
            |groupe, objets, rayons, touches| groupe.ecrire(objets, rayons, touches),
        )
    }

    fn lancer_rayon_occulte(sujet: &Sujet<'_, Self>, rayon: &Rayon<Self>) -> bool {
        selon_le_niveau!(sujet.niveau, AVEC_AVX_512, simd => {
            premier_d_un_arbre(simd, sujet, rayon, une_ombre())
        })
    }

    fn lancer_rayon_occulte_d_une_liste(
        liste: &Liste<'_, Self>,
        niveau: Level,
        rayon: &Rayon<Self>,
    ) -> bool {
        selon_le_niveau!(niveau, SANS_AVX_512, simd => {
            premier_d_une_liste(simd, liste, rayon, une_ombre())
        })
    }

    fn lancer_rayon_occultes(
        sujet: &Sujet<'_, Self>,
        rayons: &[Rayon<Self>],
        occultes: &mut [bool],
    ) -> Result<(), LongueursDifferentes> {
        demander_en_lot(
            sujet,
            (rayons, occultes),
            une_ombre(),
            #[inline(always)]
            |groupe, _, _, occultes| groupe.dire_les_ombres(occultes),
        )
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
        for (touches, cosinus) in touches.chunks(BLOC).zip(cosinus.chunks_mut(BLOC)) {
            ombres.clear();
            let (eclairage, ecrits) = (&mut eclairage, (&mut *cosinus, &mut ombres));
            selon_le_niveau!(sujet.niveau, AVEC_AVX_512, simd => simd.vectorize(
                #[inline(always)]
                || eclairage.ombres(touches, *lumiere, ecrits)
            ));
            let mut occultes = [false; BLOC];
            let occultes = &mut occultes[..ombres.len()];
            Self::lancer_rayon_occultes(sujet, &ombres, occultes)?;
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
        certificat.is_some_and(|certificat| demander(sujet, rayon, certificat, |q, _, _| !q.doute))
    }

    fn lancer_rayon_visiter(
        sujet: &Sujet<'_, Self>,
        rayon: &Rayon<Self>,
        montrer: Montrer<'_, Self>,
    ) -> () {
        demander(sujet, rayon, Visite::<_, false> { fin: rayon.fin(), montrer }, |_, _, _| ());
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
        demander(sujet, &rayon, visite, |visite, _, _| visite.est_reglee())
    }
}
