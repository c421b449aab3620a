//! A choice of objects, all objects along a ray, and a first hit before an end, as programs use them.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use commun::choisis::Choisis;
use commun::conversion::mots;
use commun::fabrique::{avec_arbre, boite, boite_droite, v};
use commun::facons::noeuds;
use commun::scenes::{melange, rayons_camera};
use commun::{Bits, en_f32_et_f64};
use lancer_rayon::pour_les_tests::Reglage;
use lancer_rayon::{
    Choix, Intersection, Monde, NoIntersection, ObjetRay, PlanGeo, Rayon, Reel, Reponse, Rotation,
    Texture, Tous, Vecteur, places, premiere_intersection,
};
use recettes::deux_mondes;

fn cube<R: Reel>(centre: Vecteur<R>) -> ObjetRay<R> {
    boite_droite(centre, v(1.0, 1.0, 1.0))
}

/// A half-space at this height along z.
fn sol_a(z: f64) -> ObjetRay {
    PlanGeo::new(Rotation::IDENTITE, -z, Texture(0)).unwrap().into()
}

/// The indices of the objects of these hits.
fn indices<R: Reel>(touches: &[Reponse<R>]) -> Vec<usize> {
    touches.iter().flatten().map(Intersection::indice).collect()
}

/// A choice among a choice takes what both take, in either order. A borrowed predicate serves as well. An index beyond
/// the list leaves nothing out, even if its lowest 32 bits are those of an index of the list.
#[test]
fn un_choix_parmi_un_choix_prend_ce_que_les_deux_prennent() {
    let scene: Vec<ObjetRay> = (0..40).map(|i| cube(v(0.0, 0.0, -2.0 * f64::from(i)))).collect();
    let rayon = Rayon::new(v(0.0, 0.0, 5.0), v(0.1, 0.07, -9.0)).unwrap();
    fn premier<C: Choix>(monde: Monde<'_, f64, C>, rayon: &Rayon) -> Option<usize> {
        monde.premiere_intersection(rayon).ok().map(|touche| touche.indice())
    }
    let au_dela = usize::MAX - usize::MAX % (usize::MAX >> (usize::BITS / 2)).wrapping_add(1);
    for monde in [avec_arbre(&scene), Monde::de_liste(&scene)] {
        let [un, zero] = [1, 0].map(|k| move |indice: usize| indice != k);
        for (obtenu, attendu) in [
            (premier(monde.parmi(zero).parmi(un), &rayon), Some(2)),
            (premier(monde.parmi(&un).parmi(&zero), &rayon), Some(2)),
            (premier(monde.parmi(un).parmi(un), &rayon), Some(0)),
            (premier(monde.sans(1).sans(0), &rayon), Some(2)),
            (premier(monde.parmi(zero).sans(1), &rayon), Some(2)),
            (premier(monde.sans(0).parmi(un), &rayon), Some(2)),
            (premier(monde.sans(au_dela).sans(usize::MAX), &rayon), Some(0)),
            (premier(monde.parmi(|_| false), &rayon), None),
            (premier(monde, &rayon), Some(0)),
        ] {
            assert_eq!(obtenu, attendu);
        }
    }
}

/// Choices five deep, each of which leaves one object out: every question heeds all of them, in a tree and in a list.
#[test]
fn chaque_question_connait_tous_les_choix() {
    let mut scene = vec![sol_a(-60.0)];
    scene.extend((0..20).map(|i| cube(v(0.0, 0.0, -2.0 * f64::from(i)))));
    let rayon = Rayon::new(v(0.0, 0.0, 5.0), v(0.01, 0.007, -9.0)).unwrap();
    for monde in [avec_arbre(&scene), Monde::de_liste(&scene)] {
        fn en_ordre<C: Choix>(parmi: &Monde<'_, f64, C>, rayon: &Rayon) -> Vec<usize> {
            let mut touches = [Err(NoIntersection); 30];
            parmi.dans_l_ordre(rayon, &mut touches);
            indices(&touches)
        }
        let tous: Vec<_> = (1..=20).chain([0]).collect();
        assert_eq!(en_ordre(&monde, &rayon), tous);
        let nue = |&k: &usize| monde.parmi(|indice| indice == k).premiere_intersection(&rayon);
        let nues: Vec<_> = tous.iter().map(nue).collect();
        // The five left out, in any order, include the half-space and the first two.
        for exclus in [[1, 2, 0, 9, 20], [20, 0, 2, 1, 5], [0, 20, 19, 2, 1], [2, 9, 1, 20, 0]] {
            let [a, b, c, d, e] = exclus.map(|k| move |indice| indice != k);
            let parmi = monde.parmi(a).parmi(b).parmi(c).parmi(d).parmi(e);
            let reste = tous.iter().copied().filter(|indice| !exclus.contains(indice));
            let mut voulus: Vec<_> = reste.collect();
            voulus.sort_unstable();
            let premiere = parmi.premiere_intersection(&rayon);
            let t = premiere.unwrap().distance();
            let milieux: Vec<_> = (0..20).map(|k| v(0.0, 0.0, -2.0 * f64::from(k))).collect();
            let choisis = Choisis { monde: parmi, pris: voulus, facon: String::new() };
            choisis.interroger(&[rayon; 70], &[t, t.next_up()], &milieux, 7);
            // The first of the choice is certain; a hit of any of the five is no answer.
            assert!(parmi.certifie(&rayon, &premiere));
            for nue in &nues {
                let lui = nue.unwrap().indice();
                assert_eq!(parmi.certifie(&rayon, nue), lui == 3, "{lui}");
            }
        }
    }
}

/// The recipe of two worlds, one of what stays and one of what moves, gives the answers of one list of both. Some
/// moving objects stand where a fixed one does, which then comes first.
fn deux_mondes_repondent_comme_une_liste<R: Bits>() {
    let tout = melange::<R>(300);
    let fixes = &tout[..200];
    let mobiles = [&tout[200..], &tout[..40]].concat();
    let (mut a, mut b) = (vec![0.0; places(200)], vec![0.0; places(mobiles.len())]);
    let fixe = Monde::new(fixes, &mut a).unwrap();
    let mobile = Monde::new(&mobiles, &mut b).unwrap();
    let ensemble = [fixes, &mobiles].concat();
    let (mut de_mobile, mut ex_aequo) = (0, 0);
    for rayon in rayons_camera::<R>(60, 40) {
        let trouvee = deux_mondes::premiere(&fixe, &mobile, &rayon);
        let reponse = trouvee.map(|(_, touche)| touche).ok_or(NoIntersection);
        let voulue = mots(&premiere_intersection(&ensemble, &rayon));
        assert_eq!(mots(&reponse).valeurs, voulue.valeurs, "{rayon:?}");
        assert_eq!(trouvee.map(|(indice, _)| indice), voulue.objet, "{rayon:?}");
        de_mobile += u32::from(trouvee.is_some_and(|(indice, _)| indice >= fixes.len()));
        let [a, b] = [&fixe, &mobile].map(|monde| monde.premiere_intersection(&rayon).ok());
        ex_aequo += u32::from(a.zip(b).is_some_and(|(a, b)| a.distance() == b.distance()));
    }
    assert!(de_mobile > 20 && ex_aequo > 20, "{de_mobile} of what moves, {ex_aequo} at one place");
}

en_f32_et_f64!(deux_mondes_repondent_comme_une_liste);

/// What a program keeps of a world for its shadows.
struct Ombres<'a, C> {
    monde: Monde<'a, f64, C>,
    demandes: usize,
}

impl<C: Choix> Ombres<'_, C> {
    fn claire(&mut self, rayon: &Rayon) -> bool {
        self.demandes += 1;
        !self.monde.est_occulte(rayon)
    }
}

/// The world without its first objects.
fn sans_les_premiers<'a, C: Choix + Copy + 'a>(
    monde: Monde<'a, f64, C>,
    combien: usize,
) -> Monde<'a, f64, impl Choix + Copy + 'a> {
    monde.parmi(move |indice| indice >= combien)
}

/// A choice that owns what it needs, and is therefore not `Copy`.
fn parmi_ceux_ci(monde: Monde<'_>, indices: Vec<usize>) -> Monde<'_, f64, impl Choix + use<'_>> {
    monde.parmi(move |indice| indices.contains(&indice))
}

/// Choices are stored in variables and structs, returned by functions, chosen among again, copied if what they hold can
/// be, and shared by threads. The world that they came from stays as it is.
#[test]
fn un_choix_est_une_valeur() {
    let scene: Vec<ObjetRay> = (0..40).map(|i| cube(v(0.0, 0.0, -2.0 * f64::from(i)))).collect();
    let rayon = Rayon::new(v(0.0, 0.0, 5.0), v(0.01, 0.007, -9.0)).unwrap();
    for monde in [avec_arbre(&scene), Monde::de_liste(&scene)] {
        let bouts = |indice: usize| {
            let touche = scene[indice].intersection(&rayon).unwrap();
            [touche.distance(), touche.distance().next_up()].map(|fin| rayon.jusqu_a(fin).unwrap())
        };
        let x = monde.sans(1).sans(2);
        let y = x.sans(0);
        assert_eq!(x.premiere_intersection(&rayon).unwrap().indice(), 0);
        assert_eq!(y.premiere_intersection(&rayon).unwrap().indice(), 3);
        assert_eq!(monde.premiere_intersection(&rayon).unwrap().indice(), 0);

        let mut ombres = Ombres { monde: y, demandes: 0 };
        let [juste, apres] = bouts(3);
        assert!(ombres.claire(&juste) && !ombres.claire(&apres));
        assert_eq!(ombres.demandes, 2);

        let reste = sans_les_premiers(x, 10);
        let encore = sans_les_premiers(reste, 12);
        assert_eq!(reste.premiere_intersection(&rayon).unwrap().indice(), 10);
        assert_eq!(encore.premiere_intersection(&rayon).unwrap().indice(), 12);
        let memes = [reste; 2].map(|copie| Ombres { monde: copie, demandes: 0 });
        let [juste, apres] = bouts(10);
        for mut ombres in memes {
            assert!(ombres.claire(&juste) && !ombres.claire(&apres));
        }

        let quelques = parmi_ceux_ci(monde, vec![30, 7, 22, 99]);
        let mut touches = [Err(NoIntersection); 4];
        assert_eq!(quelques.dans_l_ordre(&rayon, &mut touches), 3);
        assert_eq!(indices(&touches), [7, 22, 30]);
        let moins = quelques.sans(7);
        assert_eq!(moins.premiere_intersection(&rayon).unwrap().indice(), 22);

        // One choice is shared by two threads, another moves into a thread.
        let comptees = AtomicUsize::new(0);
        let comptes = moins.parmi(|_| comptees.fetch_add(1, Ordering::Relaxed) < usize::MAX);
        thread::scope(|fils| {
            let partage = || comptes.premiere_intersection(&rayon).unwrap().indice();
            let deux = [fils.spawn(partage), fils.spawn(partage)];
            assert_eq!(deux.map(|fil| fil.join().unwrap()), [22; 2]);
            let seul = fils.spawn(move || encore.premiere_intersection(&rayon).unwrap().indice());
            assert_eq!(seul.join().unwrap(), 12);
        });
        assert!(comptees.into_inner() >= 2);
    }
}

/// Every question, asked of a choice that would panic at an index beyond the list: lists as long as the nodes of a tree
/// and longer, long boxes in pieces, every instruction set. A hit in a longer list is no answer here, and never
/// certain.
fn un_predicat_n_est_jamais_interroge_au_dela_de_la_liste<R: Bits>() {
    let longue = melange::<R>(300);
    let poutres = |i: usize| {
        let tour = Rotation::new(v(0.5, 0.3 + i as f64, 0.4)).unwrap();
        let cotes = v(0.1, 9.0, 0.1);
        boite(v(i as f64 % 7.0 - 3.0, 2.0, -9.0), cotes, tour)
    };
    let poutres: Vec<ObjetRay<R>> = (0..100).map(poutres).collect();
    let rayons = rayons_camera::<R>(15, 10);
    let au_dela: Vec<_> = rayons.iter().map(|r| premiere_intersection(&longue, r)).collect();
    let (mut etrangeres, mut en_morceaux) = (0, 0);
    for objets in [0, 1, 2, 9, 10, 15, 16, 17, 31, 33, 100, 255, 257]
        .map(|n| &longue[..n])
        .into_iter()
        .chain([&poutres[..], &poutres[..37]])
    {
        let n = objets.len();
        let [mut petite, mut grande] = [1, 3].map(|fois| vec![0.0; fois * places(n)]);
        let arbre = Monde::new(objets, &mut petite).unwrap();
        let coupe = Monde::en_morceaux(objets, &mut grande).unwrap();
        en_morceaux += usize::from(noeuds(&coupe) > noeuds(&arbre));
        let demandes = AtomicUsize::new(0);
        let prend = |indice: usize| {
            assert!(indice < n, "asked for {indice} of {n}");
            demandes.fetch_add(1, Ordering::Relaxed);
            indice % 3 != 1
        };
        for monde in [arbre, coupe, Monde::de_liste(objets)] {
            for (nom, reglage) in Reglage::tous() {
                let monde = reglage.monde(monde).parmi(prend);
                let pris = (0..n).filter(|indice| indice % 3 != 1).collect();
                let choisis = Choisis { monde, pris, facon: nom.to_owned() };
                choisis.interroger(&rayons, &[], &[], n as u8);
                for (rayon, au_dela) in rayons.iter().zip(&au_dela) {
                    if au_dela.is_ok_and(|touche| touche.indice() >= n) {
                        assert!(!monde.certifie(rayon, au_dela), "{n}: {au_dela:?}");
                        etrangeres += 1;
                    }
                }
            }
        }
        assert!(n == 0 || demandes.into_inner() > n, "{n} objects, and hardly a question");
    }
    assert!(etrangeres > 1_000 && en_morceaux > 0, "{etrangeres} {en_morceaux}");
}

en_f32_et_f64!(un_predicat_n_est_jamais_interroge_au_dela_de_la_liste);

/// A user's own trait, with functions named as one would name those of a choice. The compiler would refuse to call them
/// if `Choix` had functions of these names (E0034).
trait Filtre {
    fn prend(&self, indice: usize) -> bool;
    fn regle(&self) -> &str;
}

impl<C: Choix> Filtre for C {
    fn prend(&self, indice: usize) -> bool {
        indice > 1
    }

    fn regle(&self) -> &str {
        "beyond 1"
    }
}

#[test]
fn un_trait_a_soi_a_les_noms_qu_il_veut() {
    fn demande<C: Choix + Filtre>(choix: &C) -> ([bool; 3], &str) {
        ([0, 1, 2].map(|indice| choix.prend(indice)), choix.regle())
    }
    assert_eq!(demande(&Tous), ([false, false, true], "beyond 1"));
}
