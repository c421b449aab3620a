//! What `serde` writes and reads of the types whose constructors check something: fields that are
//! read go through the same checks.

use core::fmt;
use core::marker::PhantomData;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::algebre::nombre::fois_u;
use crate::algebre::refus::exiger;
use crate::rayon::flou::Flou;
use crate::rayon::intersection::{Contact, Rang};
use crate::{ErreurGeo, Nombre, Rotation, Texture, Vecteur};

/// `champs! { T |valeur| { champ: type = expression, … } => lu }`: a T is written as these fields,
/// in this order, and read as these and no others, by name or in order; `lu` makes a T of them, or
/// an [`ErreurGeo`]. A field with `#[serde(default)]` may be left out.
macro_rules! champs {
    (
        $type:ident |$valeur:ident| {
            $($(#[$attribut:meta])* $champ:ident: $de:ty = $ecrit:expr),* $(,)?
        } => $lu:expr
    ) => {
        const _: () = {
            // Under the name that formats and their errors give it.
            #[derive(Serialize, Deserialize)]
            #[serde(deny_unknown_fields)]
            #[serde(bound(serialize = "R: Nombre + Serialize"))]
            #[serde(bound(deserialize = "R: Nombre + Deserialize<'de>"))]
            struct $type<R> {
                $($(#[$attribut])* $champ: $de),*
            }

            impl<R: Nombre + Serialize> Serialize for crate::$type<R> {
                fn serialize<S: Serializer>(&self, vers: S) -> Result<S::Ok, S::Error> {
                    let $valeur = self;
                    $type { $($champ: $ecrit),* }.serialize(vers)
                }
            }

            impl<'de, R: Nombre + Deserialize<'de>> Deserialize<'de> for crate::$type<R> {
                fn deserialize<D: Deserializer<'de>>(lecteur: D) -> Result<Self, D::Error> {
                    let $type { $($champ),* } = $type::deserialize(lecteur)?;
                    let lire = || -> Result<Self, ErreurGeo> { $lu };
                    lire().map_err(D::Error::custom)
                }
            }
        };
    };
}

impl<'de, R: Nombre + Deserialize<'de>> Deserialize<'de> for Rotation<R> {
    fn deserialize<D: Deserializer<'de>>(lecteur: D) -> Result<Self, D::Error> {
        let lignes = <[Ligne<R>; 3]>::deserialize(lecteur)?;
        Self::depuis_matrice(lignes.map(|Ligne(ligne)| ligne)).map_err(D::Error::custom)
    }
}

/// A row of a rotation. The error of an array would say nothing of matrices, and some write three
/// angles.
struct Ligne<R>([R; 3]);

impl<'de, R: Deserialize<'de>> Deserialize<'de> for Ligne<R> {
    fn deserialize<D: Deserializer<'de>>(lecteur: D) -> Result<Self, D::Error> {
        struct Visiteur<R>(PhantomData<R>);

        impl<'de, R: Deserialize<'de>> Visitor<'de> for Visiteur<R> {
            type Value = [R; 3];

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a row of a rotation's matrix")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, suite: A) -> Result<[R; 3], A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(suite))
            }
        }

        lecteur.deserialize_tuple(3, Visiteur(PhantomData)).map(Self)
    }
}

champs! {
    SphereGeo |s| {
        centre: Vecteur<R> = s.centre(),
        rayon: R = s.rayon(),
        texture: Texture = s.texture(),
    } => Self::new(centre, rayon, texture)
}

champs! {
    PlanGeo |p| {
        #[serde(default)]
        rotation: Rotation<R> = p.orientation(),
        distance: R = p.distance(),
        texture: Texture = p.texture(),
    } => Self::new(rotation, distance, texture)
}

champs! {
    BoiteGeo |b| {
        centre: Vecteur<R> = b.centre(),
        dimensions: Vecteur<R> = b.dimensions(),
        #[serde(default)]
        rotation: Rotation<R> = b.orientation(),
        texture: Texture = b.texture(),
    } => Self::new(centre, dimensions, rotation, texture)
}

// `fin` is none where there is no end, which not every format can say as a number.
champs! {
    Rayon |r| {
        source: Vecteur<R> = r.source(),
        direction: Vecteur<R> = r.direction(),
        fin: Option<R> = Some(r.fin()).filter(|fin| *fin < R::INFINI),
        #[serde(default = "nul")]
        flou: R = r.flou(),
        #[serde(default)]
        dedans: u64 = u64::from(r.flou.est_dedans()),
    } => {
        let rayon = Self::new(source, direction)?.jusqu_a(fin.unwrap_or(R::INFINI))?;
        // A number above 1 was written by version 1.0, where it counted objects.
        (if dedans > 0 { rayon.dedans() } else { rayon }).avec_flou(flou)
    }
}

/// δ = 0, where a ray is written without it.
fn nul<R: Nombre>() -> R {
    R::ZERO
}

// A hit that was written can be read again, so that a simulation goes on to the bit. One that
// somebody else wrote may be no hit of any ray: only what would make a question go wrong is
// refused. `marge` is none where it is +∞. `dedans` is part of the form since 1.0, where rays that
// start at a hit depended on it.
champs! {
    Intersection |i| {
        distance: R = i.distance,
        normale: Vecteur<R> = i.contact.normale,
        marge: Option<R> = Some(i.contact.marge).filter(|marge| *marge < R::INFINI),
        point: Vecteur<R> = i.contact.point,
        flou: R = i.delta,
        texture: Texture = i.texture,
        indice: u32 = i.rang.indice() as u32,
        #[serde(default)]
        dedans: u64 = 0,
    } => {
        let au_moins_0 = |champ, x: R| exiger(x >= R::ZERO, champ, x, "a number, 0 or more");
        exiger(distance < R::INFINI, "distance", distance, "finite")?;
        let (distance, marge) = (au_moins_0("distance", distance)?, marge.unwrap_or(R::INFINI));
        let contact = Contact { normale, marge: au_moins_0("marge", marge)?, point };
        let longueur = normale.longueur();
        let unitaire = (longueur - R::UN).absolu() <= fois_u(32.0);
        exiger(unitaire, "normale", longueur, "1 in length, to rounding")?;
        for x in <[R; 3]>::from(point) {
            exiger(x.absolu() >= R::ZERO, "point", x, "a number")?;
        }
        let delta = Flou::NUL.avec(flou)?.delta();
        let _ = dedans;
        exiger(indice < u32::MAX, "indice", R::depuis_f64(indice.into()), "below 2^32 - 1")?;
        Ok(Self { distance, contact, delta, texture, rang: Rang::de(indice as usize) })
    }
}
