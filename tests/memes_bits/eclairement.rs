//! Light on hits, and rays that are asked with the hit that they leave: the bits of the calls one by one.

use commun::conversion::mots;
use commun::fabrique::{avec_arbre, mur, sphere};
use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{Cas, deux_puissance, direction, regimes};
use commun::strategies::{objet, vecteur, vecteur_quelconque};
use commun::{Bits, arrondi, en_f32_et_f64, scenes};
use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    Choix, Intersection, LongueursDifferentes, Lumiere, Monde, NoIntersection, ObjetRay, Rayon,
    Reponse, Vecteur,
};

/// Where a light is, for the calls that take a place or a direction.
#[derive(Debug, Clone, Copy)]
enum Ou<R> {
    Lampe(Vecteur<R>),
    Soleil(Vecteur<R>),
}

impl<R: Bits> Ou<R> {
    /// `None` for one that is refused.
    fn lumiere(self) -> Option<Lumiere<R>> {
        match self {
            Self::Lampe(position) => Lumiere::lampe(position).ok(),
            Self::Soleil(direction) => Lumiere::soleil(direction).ok(),
        }
    }

    /// The same light on one hit, call by call.
    fn un_par_un<C: Choix>(self, monde: &Monde<'_, R, C>, touche: &Reponse<R>) -> R {
        let Ok(touche) = touche else { return R::ZERO };
        let ombre = match self {
            Self::Lampe(position) => touche.vers_lumiere(position),
            Self::Soleil(direction) => touche.vers_soleil(direction),
        };
        match ombre {
            Ok(ombre) if !monde.est_occulte(&ombre) => {
                ombre.direction().produit_scalaire(touche.normale())
            }
            Ok(_) | Err(_) => R::ZERO,
        }
    }
}

/// Asks for this light on these hits in every way; returns how many are lit.
#[track_caller]
fn comparer<R: Bits, C: Choix + Copy>(
    monde: Monde<'_, R, C>,
    touches: &[Reponse<R>],
    ou: Ou<R>,
) -> usize {
    let Some(lumiere) = ou.lumiere() else { return 0 };
    let voulus: Vec<_> = touches.iter().map(|touche| ou.un_par_un(&monde, touche).bits()).collect();
    for (nom, reglage) in Reglage::tous() {
        let monde = reglage.monde(monde);
        let mut cosinus = vec![R::depuis_f64(f64::NAN); touches.len()];
        monde.eclairements(touches, &lumiere, &mut cosinus).unwrap();
        let obtenus: Vec<_> = cosinus.into_iter().map(R::bits).collect();
        assert_eq!(obtenus, voulus, "{nom}, {ou:?}");
        for (touche, voulu) in touches.iter().zip(&voulus) {
            let Ok(touche) = touche else { continue };
            let obtenu = monde.eclairement(touche, &lumiere).bits();
            assert_eq!(obtenu, *voulu, "{nom}, {ou:?}, {touche:?}");
        }
    }
    voulus.into_iter().filter(|voulu| *voulu != R::ZERO.bits()).count()
}

/// A picture with misses and hits of all shapes, in calls of any length, lit by a lamp, a sun, a lamp in an object and one
/// that is left out.
fn une_image_est_eclairee_comme_rayon_par_rayon<R: Bits>() {
    let rayons = scenes::en_tuiles(&scenes::rayons_camera::<R>(32, 24), 32);
    for n in [0, 3, 12, 300] {
        let scene = scenes::melange::<R>(n);
        let mut touches = vec![Err(NoIntersection); rayons.len()];
        let monde = avec_arbre(&scene);
        monde.premieres_intersections(&rayons, &mut touches).unwrap();
        let v = |x, y, z| arrondi(Vecteur::new(x, y, z));
        let dans_un_objet = touches.iter().flatten().next().map(|t| t.point() - t.normale());
        let ici = [v(-2.6, 8.2, 5.2), v(0.0, 1.0, 4.0), dans_un_objet.unwrap_or(Vecteur::NUL)];
        let lumieres = ici.map(Ou::Lampe).into_iter().chain([Ou::Soleil(v(1.0, 5.0, 2.0))]);
        let mut eclairees = 0;
        for (i, ou) in lumieres.enumerate() {
            for monde in [monde, Monde::de_liste(&scene)] {
                eclairees += comparer(monde, &touches, ou);
                comparer(monde.sans(i), &touches[..100], ou);
                comparer(monde.sans(i).parmi(|indice| indice % 3 > 0), &touches[..100], ou);
            }
            for longueur in [1, 15, 16, 17, 63, 64, 65, 129] {
                comparer(monde, &touches[300..300 + longueur], ou);
            }
        }
        assert!(n == 0 || eclairees > 500, "{n} objects, {eclairees} lit");
    }
}

en_f32_et_f64!(une_image_est_eclairee_comme_rayon_par_rayon);

/// Hits at the extremes, alone and in lists of other objects, lit by lamps anywhere: at the start of the shadow ray, beside
/// it, far beyond the limits of a scene, and suns that graze. Some rays know their source only to a part of its distance
/// from O, and so do their hits and the shadow rays from there.
fn aux_extremes_aussi<R: Bits>() {
    let mut eclairees = 0;
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| {
            let cas = alea.liste(20, |alea, _| {
                let Cas { objet, rayon } = (regime.cas)(alea);
                let loin = rayon.source().longueur();
                let flou = loin * R::depuis_f64(deux_puissance(alea, -40.0, -2.0));
                let flou = if alea.u8(0..3) == 0 { flou } else { R::ZERO };
                Cas { objet, rayon: rayon.avec_flou(flou).unwrap_or(rayon) }
            });
            let lumieres = alea.liste(6, |alea, _| {
                let Cas { objet, rayon } = *alea.choix(&cas);
                let touche = objet.intersection(&rayon);
                let point = touche.map_or(rayon.source(), |touche| touche.point());
                let normale = touche.map_or(Vecteur::Y, |touche| touche.normale());
                match alea.u8(0..5) {
                    0 => Ou::Lampe(vecteur_quelconque(alea)),
                    1 => Ou::Lampe(
                        point + normale * R::depuis_f64(deux_puissance(alea, -60.0, 60.0)),
                    ),
                    2 => Ou::Lampe(
                        point + arrondi(direction(alea) * deux_puissance(alea, -60.0, 60.0)),
                    ),
                    3 => Ou::Soleil(vecteur_quelconque(alea)),
                    _ => Ou::Soleil(arrondi(direction(alea))),
                }
            });
            (cas, lumieres)
        };
        pour_chaque(commun::cas(8), faire, |(cas, lumieres)| {
            let objets: Vec<_> = cas.iter().map(|cas| cas.objet).collect();
            let monde = avec_arbre(&objets);
            // Hits of objects that were asked alone have index 0, whichever object they are of.
            let touches: Vec<_> = cas
                .iter()
                .flat_map(|Cas { objet, rayon }| {
                    [
                        objet.intersection(rayon),
                        monde.premiere_intersection(rayon),
                        objet.sortie(rayon),
                    ]
                })
                .collect();
            // At the very start of a shadow ray, where no light is.
            let au_depart = touches.iter().flatten().filter_map(|t| t.secondaire(t.normale()).ok());
            let au_depart = au_depart.map(|depart| Ou::Lampe(depart.source())).take(2);
            for ou in lumieres.into_iter().chain(au_depart) {
                for monde in [monde, Monde::de_liste(&objets)] {
                    eclairees += comparer(monde, &touches, ou);
                }
            }
        });
    }
    assert!(eclairees > 2_000, "{eclairees}");
}

en_f32_et_f64!(aux_extremes_aussi);

/// Any ray with any hit, of this list, of an object alone or of another list: what is left out changes no answer.
fn d_ou_l_on_vient_ne_change_aucune_reponse<R: Bits>() {
    let juger = |objets: &[ObjetRay<R>], touche: &Intersection<R>, rayon: &Rayon<R>| {
        for monde in [avec_arbre(objets), Monde::de_liste(objets)] {
            let voulue = monde.premiere_intersection(rayon);
            assert_eq!(mots(&monde.premiere_depuis(touche, rayon)), mots(&voulue), "{rayon:?}");
            assert_eq!(monde.est_occulte_depuis(touche, rayon), voulue.is_ok(), "{rayon:?}");
            let autres = monde.sans(1).parmi(|indice| indice % 5 > 0);
            let voulue = autres.premiere_intersection(rayon);
            assert_eq!(mots(&autres.premiere_depuis(touche, rayon)), mots(&voulue), "{rayon:?}");
        }
    };
    let mut suites = 0;
    let faire = |alea: &mut Hasard| {
        let objets = alea.liste(14, |alea, _| objet::<R>(alea).vers_ray());
        let (source, cible) = (vecteur::<R>(alea, 15.0), vecteur::<R>(alea, 10.0));
        (objets, Rayon::new(source, cible - source).unwrap(), arrondi::<R>(direction(alea)))
    };
    pour_chaque(commun::cas(600), faire, |(objets, rayon, vers)| {
        let Ok(touche) = avec_arbre(&objets).premiere_intersection(&rayon) else { return };
        let d = rayon.direction();
        let rayons = [
            touche.secondaire(vers),
            touche.secondaire(-vers),
            touche.reflechi(d),
            touche.refracte(d, R::depuis_f64(0.7)),
            touche.vers_lumiere(vers),
            touche.secondaire(d).map(Rayon::dehors),
            rayon.bifurque(touche.distance(), d),
            Ok(rayon),
        ];
        for suite in rayons.into_iter().flatten() {
            juger(&objets, &touche, &suite);
            let autres: Vec<_> = objets.iter().rev().copied().collect();
            juger(&autres, &touche, &suite);
            suites += 1;
        }
    });
    assert!(suites > 2_000, "{suites}");
    for regime in regimes::<R>() {
        let faire = |alea: &mut Hasard| {
            let cas = alea.liste(12, |alea, _| (regime.cas)(alea));
            (cas, arrondi::<R>(direction(alea)))
        };
        pour_chaque(commun::cas(6), faire, |(cas, vers)| {
            let objets: Vec<_> = cas.iter().map(|cas| cas.objet).collect();
            for Cas { rayon, .. } in cas {
                for objet in &objets {
                    let Ok(touche) = objet.intersection(&rayon) else { continue };
                    juger(&objets, &touche, &rayon);
                    let suites = [touche.secondaire(vers), touche.reflechi(rayon.direction())];
                    suites.iter().flatten().for_each(|suite| juger(&objets, &touche, suite));
                }
            }
        });
    }
}

en_f32_et_f64!(d_ou_l_on_vient_ne_change_aucune_reponse);

/// A wall is hit beyond the limits of a scene, where no ray may start.
fn au_dela_des_limites_il_fait_nuit<R: Bits>() {
    let loin = R::LIMITE * R::depuis_f64(0.9);
    let mur = mur(Vecteur::X * loin, -Vecteur::X);
    let rayon = Rayon::new(Vecteur::Y * loin, Vecteur::X + Vecteur::Y).unwrap();
    let touche = mur.intersection(&rayon).unwrap();
    assert!(touche.point().y > R::LIMITE && touche.marge() < R::INFINI);
    assert_eq!(touche.vers_lumiere(Vecteur::NUL).unwrap_err().champ, "source.y");
    for ou in [Ou::Lampe(Vecteur::NUL), Ou::Soleil(-Vecteur::X)] {
        assert_eq!(comparer(Monde::de_liste(&[mur]), &[Ok(touche)], ou), 0);
    }
}

en_f32_et_f64!(au_dela_des_limites_il_fait_nuit);

#[test]
fn autant_de_cosinus_que_de_touches() {
    let boule = sphere(Vecteur::NUL, 1.0);
    let (touches, mut cosinus) = ([Err(NoIntersection); 3], [7.0; 2]);
    let lumiere = Lumiere::soleil(Vecteur::Y).unwrap();
    let refus = Monde::de_liste(&[boule]).eclairements(&touches, &lumiere, &mut cosinus);
    assert_eq!(refus, Err(LongueursDifferentes { rayons: 3, reponses: 2 }));
    assert_eq!(cosinus, [7.0; 2]);
}

/// A light names what it refuses.
#[test]
fn une_lumiere_est_quelque_part() {
    let lampe = |x| Lumiere::lampe(Vecteur::new(0.0, x, 0.0)).map_err(|refus| refus.champ);
    assert_eq!([f64::NAN, f64::INFINITY].map(lampe), [Err("position.y"); 2]);
    assert!(lampe(1e300).is_ok());
    let soleil = |x| Lumiere::soleil(Vecteur::new(x, 0.0, 0.0)).map_err(|refus| refus.champ);
    assert_eq!([0.0, f64::NAN].map(soleil), [Err("direction"), Err("direction.x")]);
    // The length of a direction does not matter.
    assert_eq!(soleil(4.0), soleil(0.5));
}
