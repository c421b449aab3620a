//! The answers to the questions of a [`Monde`](crate::Monde), compiled in this crate for either
//! scalar: generic code would be compiled again by every crate that calls it, and as slowly as that
//! crate is.

use core::marker::PhantomData;
use core::ops::ControlFlow::Continue;

use fearless_simd::{Level, Simd};

use crate::algebre::nombre::Nombre;
use crate::algebre::refus::LongueursDifferentes;
use crate::algebre::vecteur::Vecteur;
use crate::arbre::construction::{Arbre, PlacesInsuffisantes, construire};
use crate::arbre::parcours_de_bloc::RAYONS_D_UN_BLOC;
use crate::cote_a_cote::bloc::{BLOC, Bloc, EnLot, Groupes};
use crate::cote_a_cote::groupe::VOIES;
use crate::cote_a_cote::niveau::selon_le_niveau;
use crate::objet::ObjetRay;
use crate::question::jugement::certificat::Certificat;
use crate::question::liste::Liste;
use crate::question::visite::{Contenance, Montrer, Rangee, Visite};
use crate::question::{Ombre, Premier, Question};
use crate::rayon::Rayon;
use crate::rayon::intersection::Reponse;

/// What a question is asked of: the objects, their tree, which has no nodes if they are asked as a
/// list, and the instructions.
///
/// It is passed by reference: a copy of what was just written piece by piece stalls until the
/// pieces are stored, and a ray among few objects takes up to 1.2 times as long (measured).
pub struct Vue<'a, R> {
    pub(crate) liste: Liste<'a, R>,
    pub(crate) arbre: &'a Arbre<'a, R>,
    pub(crate) niveau: Level,
}

/// Asks this question for one ray.
#[inline(always)]
fn demander<R: Nombre, Q: Question<R>>(
    vue: &Vue<'_, R>,
    rayon: &Rayon<R>,
    question: Q,
) -> Q::Reponse {
    let sans_boite = vue.arbre.sans_boite;
    selon_le_niveau!(vue.niveau, simd => demander_avec(simd, vue, rayon, sans_boite, question))
}

/// Asks this question for one ray: of a list, or of a tree and these objects without a box.
#[inline(always)]
fn demander_avec<S: Simd, R: Nombre, Q: Question<R>>(
    simd: S,
    vue: &Vue<'_, R>,
    rayon: &Rayon<R>,
    sans_boite: &[f32],
    mut question: Q,
) -> Q::Reponse {
    simd.vectorize(
        #[inline(always)]
        || {
            let Vue { liste, arbre, .. } = vue;
            if arbre.noeuds.is_empty() {
                liste.interroger(rayon, &mut question);
            } else {
                question = arbre.parcourir(simd, liste, rayon, sans_boite, question);
            }
            question.repondre(rayon, liste.objets)
        },
    )
}

/// Visits objects until all have been shown.
#[inline(always)]
fn visiter<R: Nombre, const D_UN_POINT: bool>(
    vue: &Vue<'_, R>,
    rayon: &Rayon<R>,
    mut visite: Visite<'_, R, D_UN_POINT>,
) {
    loop {
        demander(vue, rayon, &mut visite);
        if !visite.montrer_ce_qui_attend() {
            return;
        }
    }
}

/// Fewer rays than this are asked of a list one by one (`benches/seuils.md`, "Thresholds").
const RAYONS_D_UNE_LISTE: usize = 6;

/// Asks this question for many rays.
#[inline(always)]
fn demander_en_lot<R: Nombre, Q: EnLot<R>>(
    vue: &Vue<'_, R>,
    rayons: &[Rayon<R>],
    reponses: &mut [Q::Reponse],
) -> Result<(), LongueursDifferentes> {
    if rayons.len() != reponses.len() {
        return Err(LongueursDifferentes { rayons: rayons.len(), reponses: reponses.len() });
    }
    let mut groupes = Groupes::new_const();
    let mut bloc = Bloc::new(&mut groupes, Q::UN_SUFFIT);
    selon_le_niveau!(vue.niveau, simd => simd.vectorize(
        #[inline(always)]
        || {
            for (rayons, reponses) in rayons.chunks(BLOC).zip(reponses.chunks_mut(BLOC)) {
                demander_au_bloc::<_, _, Q>(simd, vue, &mut bloc, (rayons, reponses));
            }
        },
    ));
    Ok(())
}

/// Asks this question for the rays of a block: of those together that find their first objects
/// together, and of the others one by one, from what they have found so far.
#[inline(always)]
fn demander_au_bloc<S: Simd, R: Nombre, Q: EnLot<R>>(
    simd: S,
    vue: &Vue<'_, R>,
    bloc: &mut Bloc<'_, R>,
    (rayons, reponses): (&[Rayon<R>], &mut [Q::Reponse]),
) {
    let Vue { liste, arbre, .. } = vue;
    // The groups whose rays go on one by one; `None` if they have asked nothing.
    let restent = if arbre.noeuds.is_empty() {
        (rayons.len() >= RAYONS_D_UNE_LISTE).then(|| {
            bloc.charger(rayons);
            bloc.interroger(simd, liste);
            0
        })
    } else if rayons.len() >= RAYONS_D_UN_BLOC {
        arbre.chercher_ensemble(simd, liste, bloc, rayons)
    } else {
        None
    };
    if let Some(restent) = restent {
        let groupes = rayons.len().div_ceil(VOIES);
        if restent.count_ones() < groupes as u32 {
            bloc.repondre::<_, Q>(simd, liste, (rayons, reponses));
        }
        if restent == 0 {
            return;
        }
    }
    for (i, (rayon, reponse)) in rayons.iter().zip(reponses).enumerate() {
        let (premier, sans_boite) = match restent {
            Some(groupes) if groupes >> (i / VOIES) & 1 == 0 => continue,
            Some(_) => (bloc.premier(i), &[][..]),
            None => (Premier::avant(rayon.fin()), arbre.sans_boite),
        };
        *reponse = if Q::UN_SUFFIT && premier.rang.is_some() {
            Q::from(premier).repondre(rayon, liste.objets)
        } else {
            demander_avec(simd, vue, rayon, sans_boite, Q::from(premier))
        };
    }
}

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
pub trait Reel: Nombre + Repondant {}

impl Reel for f32 {}
impl Reel for f64 {}

/// Where the answers in this scalar stand. Were they functions of [`Reel`] itself, a caller could
/// not use a function of the same name of a trait of their own (E0034).
pub trait Repondant: Sized {
    type ReponsesDeLancerRayon: Repond<R = Self>;
}

/// The answers in this scalar, as functions.
pub(crate) type Reponses<R> = <R as Repondant>::ReponsesDeLancerRayon;

/// What has them.
pub struct Compilees<R>(PhantomData<R>);

/// `reponses! { fn …(…) -> … { … } … }`: the trait [`Repond`] of these functions, and their bodies
/// compiled for `f32` and for `f64`, which are `Self::R` in them.
macro_rules! reponses {
    ($(fn $nom:ident$(<$vie:lifetime>)?($($de:ident: $type:ty),* $(,)?) -> $reponse:ty $corps:block)*) => {
        /// The answers in one scalar.
        pub trait Repond {
            type R: Nombre;
            $(fn $nom$(<$vie>)?($($de: $type),*) -> $reponse;)*
        }
        reponses! { dans f32 $(fn $nom$(<$vie>)?($($de: $type),*) -> $reponse $corps)* }
        reponses! { dans f64 $(fn $nom$(<$vie>)?($($de: $type),*) -> $reponse $corps)* }
    };
    (dans $reel:ident $($fonctions:item)*) => {
        impl Repondant for $reel {
            type ReponsesDeLancerRayon = Compilees<Self>;
        }

        impl Repond for Compilees<$reel> {
            type R = $reel;
            $($fonctions)*
        }
    };
}

reponses! {
    fn arbre<'a>(objets: &'a [ObjetRay<Self::R>], places: &'a mut [f32], decouper: bool)
        -> Result<Arbre<'a, Self::R>, PlacesInsuffisantes>
    {
        construire(objets, places, decouper)
    }

    fn premiere(vue: &Vue<'_, Self::R>, rayon: &Rayon<Self::R>) -> Reponse<Self::R> {
        demander(vue, rayon, Premier::avant(rayon.fin()))
    }

    fn premieres(vue: &Vue<'_, Self::R>, rayons: &[Rayon<Self::R>], touches: &mut [Reponse<Self::R>])
        -> Result<(), LongueursDifferentes>
    {
        demander_en_lot::<_, Premier<_>>(vue, rayons, touches)
    }

    fn occulte(vue: &Vue<'_, Self::R>, rayon: &Rayon<Self::R>) -> bool {
        demander(vue, rayon, Ombre::from(Premier::avant(rayon.fin())))
    }

    fn occultes(vue: &Vue<'_, Self::R>, rayons: &[Rayon<Self::R>], occultes: &mut [bool])
        -> Result<(), LongueursDifferentes>
    {
        demander_en_lot::<_, Ombre<_>>(vue, rayons, occultes)
    }

    fn certifie(vue: &Vue<'_, Self::R>, rayon: &Rayon<Self::R>, reponse: &Reponse<Self::R>) -> bool {
        let certificat = Certificat::new(&vue.liste, rayon, reponse);
        certificat.is_some_and(|certificat| demander(vue, rayon, certificat))
    }

    fn visiter(vue: &Vue<'_, Self::R>, rayon: &Rayon<Self::R>, montrer: Montrer<'_, Self::R>) -> () {
        visiter::<_, false>(vue, rayon, Visite::new(rayon.fin(), montrer));
    }

    fn dans_l_ordre(vue: &Vue<'_, Self::R>, rayon: &Rayon<Self::R>, touches: &mut [Reponse<Self::R>]) -> usize {
        let mut rangee = Rangee::new(touches);
        Self::visiter(vue, rayon, &mut |indice, t| rangee.placer(indice, t));
        rangee.conclure(rayon, vue.liste.objets)
    }

    fn contient(vue: &Vue<'_, Self::R>, point: Vecteur<Self::R>) -> bool {
        demander(vue, &du_point(point), Contenance(false))
    }

    fn contenants(vue: &Vue<'_, Self::R>, point: Vecteur<Self::R>, montrer: &mut dyn FnMut(usize)) -> () {
        let montrer: Montrer<'_, Self::R> = &mut |indice, _| {
            montrer(indice);
            Continue(Self::R::INFINI)
        };
        visiter::<_, true>(vue, &du_point(point), Visite::new(Self::R::INFINI, montrer));
    }
}

/// A ray from this point, which need not be finite; its direction does not matter.
fn du_point<R: Nombre>(point: Vecteur<R>) -> Rayon<R> {
    Rayon::sans_fin(point, Vecteur::new(R::ZERO, R::ZERO, R::UN))
}
