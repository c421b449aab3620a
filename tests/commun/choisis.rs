//! Every question of a choice of objects, at any end and with any number of places, beside the answers of each object
//! asked alone.

use std::any::type_name;
use std::ops::ControlFlow::{Break, Continue};
use std::sync::atomic::{AtomicU32, Ordering};

use lancer_rayon::{Choix, Etendue, Monde, NoIntersection, Rayon, Reponse, Vecteur};

use crate::conversion::{Bits, Mots, mots, voisin};
use crate::fabrique::sphere;

/// A choice that is kept for all questions, the indices of what it is to take, and how it is asked, which assertions
/// show.
pub struct Choisis<'a, R, C> {
    pub monde: Monde<'a, R, C>,
    pub pris: Vec<usize>,
    pub facon: String,
}

/// The objects that two choices both take, less the two that a third byte leaves out before and between them.
pub fn choisir<R: Bits>(
    monde: Monde<'_, R>,
    [un, sauf, deux]: [u8; 3],
) -> Choisis<'_, R, impl Choix + Copy> {
    let [un, deux] = [un, deux].map(|masque| move |indice: usize| masque >> (indice % 8) & 1 == 0);
    let [a, b] = [sauf % 16, sauf / 16].map(usize::from);
    let prend = |i: &usize| un(*i) && *i != a && *i != b && deux(*i);
    let pris = (0..monde.objets().len()).filter(prend).collect();
    let sans_un = monde.sans(a).parmi(un);
    Choisis { monde: sans_un.sans(b).parmi(deux), pris, facon: String::new() }
}

/// The distance and the bits of a hit of an object that was asked alone; the bits hold its index.
pub type Vue<R> = (R, Mots);

impl<R: Bits, C: Choix + Copy> Choisis<'_, R, C> {
    /// Asks each ray at its own end, at one of its hits and at one of these limits; `places` sets how many places there
    /// are for what comes in order.
    pub fn interroger(
        &self,
        rayons: &[Rayon<R>],
        limites: &[R],
        points: &[Vecteur<R>],
        places: u8,
    ) {
        let toutes = self.toutes(rayons);
        self.un_par_un(rayons, &toutes, limites, places);
        for (rayon, toutes) in rayons.iter().zip(&toutes) {
            self.certificat(rayon, toutes);
        }
        self.en_lot(rayons, &toutes, |i, _| rayons[i].fin());
        if !limites.is_empty() {
            self.en_lot(rayons, &toutes, |i, _| limites[i % limites.len()]);
        }
        (0..BOUTS).for_each(|genre| self.en_lot(rayons, &toutes, bout(genre)));
        points.iter().for_each(|point| self.points(*point));
        self.etendue();
    }

    /// The questions that one ray asks, given all its hits, without certificates.
    pub fn un_par_un(
        &self,
        rayons: &[Rayon<R>],
        toutes: &[Vec<Vue<R>>],
        limites: &[R],
        places: u8,
    ) {
        for (i, (rayon, toutes)) in rayons.iter().zip(toutes).enumerate() {
            let une = toutes.get(usize::from(places) % (toutes.len() + 1)).map(|(t, _)| *t);
            let limite = limites.get(i % limites.len().max(1)).copied();
            let voisine = une.map(|t| voisin(t, 1));
            for (k, fin) in [Some(rayon.fin()), une, voisine, limite].into_iter().enumerate() {
                let Some(fin) = fin else { continue };
                let fini = rayon.jusqu_a(fin);
                assert_eq!(fini.is_ok(), fin >= R::ZERO, "{fin:?}");
                let Ok(fini) = fini else { continue };
                // All hits have a place, or only some.
                let places = if k == 0 { toutes.len() + 1 } else { (usize::from(places) + k) % 9 };
                self.un_rayon(&fini, avant(toutes, fin), places);
            }
            self.visites(rayon, toutes, limites);
            let premiere = toutes.first().map(|(t, _)| rayon.point(*t));
            [rayon.source()].into_iter().chain(premiere).for_each(|point| self.points(point));
        }
    }

    /// All hits of each ray without its end, in order, from each chosen object asked alone.
    pub fn toutes(&self, rayons: &[Rayon<R>]) -> Vec<Vec<Vue<R>>> {
        let toutes = |rayon: &Rayon<R>| {
            let rayon = rayon.jusqu_a(R::INFINI).unwrap();
            let touche = |indice: &usize| {
                let touche = self.monde.objets()[*indice].intersection(&rayon).ok()?;
                Some((touche.distance(), Mots { objet: Some(*indice), ..mots(&Ok(touche)) }))
            };
            let mut toutes: Vec<_> = self.pris.iter().filter_map(touche).collect();
            // Stably, so that the earlier in the list wins a tie.
            toutes.sort_by(|(a, _), (b, _)| a.partial_cmp(b).unwrap());
            toutes
        };
        rayons.iter().map(toutes).collect()
    }

    /// What an assertion says of the objects; only their number if they are many.
    fn objets(&self) -> String {
        let objets = match self.monde.objets() {
            objets if objets.len() < 20 => format!("{:?} of {objets:?}", self.pris),
            objets => format!("{} of {} objects", self.pris.len(), objets.len()),
        };
        format!("{}, {}: {objets}", self.facon, type_name::<R>())
    }

    /// Checks the first hit of this ray, whoever gave the answer.
    pub fn premiere(&self, rayon: &Rayon<R>, toutes: &[Vue<R>], obtenue: Reponse<R>) {
        let voulue = premiers_mots::<R>(avant(toutes, rayon.fin()));
        assert_eq!(mots(&obtenue), voulue, "{rayon:?} {}", self.objets());
    }

    /// Checks the first hit, the shadow and what comes in order, for a ray whose hits before its end are `avant`.
    fn un_rayon(&self, rayon: &Rayon<R>, avant: &[Vue<R>], places: usize) {
        let contexte = || format!("{rayon:?} {}", self.objets());
        let voulues: Vec<_> = avant.iter().map(|(_, mots)| *mots).collect();
        self.premiere(rayon, avant, self.monde.premiere_intersection(rayon));
        assert_eq!(self.monde.est_occulte(rayon), !avant.is_empty(), "{}", contexte());
        let mut touches = vec![absurde(); places];
        let nombre = self.monde.dans_l_ordre(rayon, &mut touches);
        let obtenues: Vec<_> = touches[..nombre].iter().map(mots).collect();
        assert_eq!(obtenues, voulues[..voulues.len().min(touches.len())], "{}", contexte());
        assert!(touches[nombre..].iter().all(Result::is_err), "{}", contexte());
    }

    /// Visits that go on, that come nearer with every object, that end where raw numbers say, and that look for one
    /// texture. Each shows only what lies before its end at that moment, and nothing twice.
    fn visites(&self, rayon: &Rayon<R>, toutes: &[Vue<R>], fins: &[R]) {
        let contexte = || format!("{rayon:?} {}", self.objets());
        let visiter = |prochaine: &mut dyn FnMut(usize, R) -> R| {
            let (mut fin, mut vus) = (rayon.fin(), Vec::new());
            self.monde.visiter(rayon, |indice, t| {
                assert!(t < fin, "{t} is not before {fin}: {}", contexte());
                vus.push((indice, t.bits()));
                let suivante = prochaine(indice, t);
                // A NaN leaves the end where it is.
                fin = if suivante < fin { suivante } else { fin };
                Continue(suivante)
            });
            vus.sort_unstable();
            assert!(vus.windows(2).all(|w| w[0].0 != w[1].0), "twice: {}", contexte());
            (vus, fin)
        };
        let vues_avant = |fin: R| {
            let vues = avant(toutes, fin).iter();
            let mut vues: Vec<_> = vues.filter_map(|(t, m)| Some((m.objet?, t.bits()))).collect();
            vues.sort_unstable();
            vues
        };
        let toutes_avant = vues_avant(rayon.fin());
        // A NaN is no end.
        for sans_fin in [R::INFINI, R::depuis_f64(f64::NAN)] {
            assert_eq!(visiter(&mut |_, _| sans_fin).0, toutes_avant, "{}", contexte());
        }
        let premiere = avant(toutes, rayon.fin()).first().map_or(rayon.fin(), |(t, _)| *t);
        assert_eq!(visiter(&mut |_, t| t).1.bits(), premiere.bits(), "{}", contexte());
        // A question that a user may write: the first object of a texture, which is also the first of a choice.
        let objets = self.monde.objets();
        let derniere = toutes.last().and_then(|(_, mots)| mots.objet);
        let texture = derniere.map(|indice| objets[indice].texture());
        let de_texture = |indice: usize| Some(objets[indice].texture()) == texture;
        let (_, fin) = visiter(&mut |indice, t| if de_texture(indice) { t } else { R::INFINI });
        let premiere = self.monde.parmi(de_texture).premiere_intersection(rayon);
        let voulue = premiere.map_or(rayon.fin(), |touche| touche.distance());
        assert_eq!(fin.bits(), voulue.bits(), "{}", contexte());
        for nul in [R::ZERO, -R::UN] {
            assert!(visiter(&mut |_, _| nul).0.len() <= 1, "{}", contexte());
        }
        let mut vus = 0;
        self.monde.visiter(rayon, |_, _| {
            vus += 1;
            Break(())
        });
        assert_eq!(vus, toutes_avant.len().min(1), "{}", contexte());
        let mut suivantes = fins.iter().copied().cycle();
        let (vus, fin) = visiter(&mut |_, _| suivantes.next().unwrap_or(R::INFINI));
        // The visit showed all that lies before the last end, and nothing that no object alone reports.
        assert!(vues_avant(fin).iter().all(|vu| vus.contains(vu)), "{}", contexte());
        assert!(vus.iter().all(|vu| toutes_avant.contains(vu)), "{}", contexte());
    }

    /// First hits and shadows of all rays at once; each ray ends where `fin`, given its hits, says.
    pub fn en_lot(
        &self,
        rayons: &[Rayon<R>],
        toutes: &[Vec<Vue<R>>],
        fin: impl Fn(usize, &[Vue<R>]) -> R,
    ) {
        let finir = |(i, (rayon, toutes)): (usize, (&Rayon<R>, &Vec<Vue<R>>))| {
            rayon.jusqu_a(fin(i, toutes)).unwrap_or(*rayon)
        };
        let finis: Vec<_> = rayons.iter().zip(toutes).enumerate().map(finir).collect();
        let avant: Vec<_> = finis.iter().zip(toutes).map(|(r, t)| avant(t, r.fin())).collect();
        // The contrary and an impossible hit are there before, so that a place which is left out shows.
        let mut touches = vec![absurde(); finis.len()];
        let mut occultes: Vec<_> = avant.iter().map(|avant| avant.is_empty()).collect();
        self.monde.premieres_intersections(&finis, &mut touches).unwrap();
        self.monde.sont_occultes(&finis, &mut occultes).unwrap();
        let obtenues = touches.iter().zip(occultes);
        for ((rayon, avant), (touche, occulte)) in finis.iter().zip(avant).zip(obtenues) {
            self.premiere(rayon, avant, *touche);
            assert_eq!(occulte, !avant.is_empty(), "{rayon:?} {}", self.objets());
        }
    }

    /// A hit of an object that the choice leaves out is never certain, nor are two different answers both certain; and
    /// where a list of only what the choice takes is certain, the choice is too.
    fn certificat(&self, rayon: &Rayon<R>, toutes: &[Vue<R>]) {
        let objets = self.monde.objets();
        let toute = Monde::de_liste(objets).premiere_intersection(rayon);
        if toute.is_ok_and(|touche| !self.pris.contains(&touche.indice())) {
            assert!(!self.monde.certifie(rayon, &toute), "{rayon:?} {}", self.objets());
        }
        // The answer, a miss and the second hit.
        let premiere = self.monde.premiere_intersection(rayon);
        let sure = self.monde.certifie(rayon, &premiere);
        let seconde = toutes.get(1).and_then(|(_, mots)| mots.objet).map(|indice| {
            let autre = self.monde.parmi(move |i| i == indice);
            autre.premiere_intersection(rayon)
        });
        for autre in [Some(Err(NoIntersection)), seconde].into_iter().flatten() {
            let la_meme = autre.map(|t| t.indice()) == premiere.map(|t| t.indice());
            let fausse = sure && !la_meme && self.monde.certifie(rayon, &autre);
            assert!(!fausse, "{premiere:?} and {autre:?}: {rayon:?} {}", self.objets());
        }
        let restants: Vec<_> = self.pris.iter().map(|indice| objets[*indice]).collect();
        let restants = Monde::de_liste(&restants);
        let la = restants.premiere_intersection(rayon);
        assert!(sure || !restants.certifie(rayon, &la), "{rayon:?} {}", self.objets());
    }

    /// Those that hold this point are those that say so themselves, each once.
    fn points(&self, point: Vecteur<R>) {
        let objets = self.monde.objets();
        let voulus = self.pris.iter().copied().filter(|indice| objets[*indice].contient(point));
        let voulus: Vec<_> = voulus.collect();
        let mut vus = Vec::new();
        self.monde.contenants(point, |indice| vus.push(indice));
        vus.sort_unstable();
        assert_eq!(vus, voulus, "{point:?} {}", self.objets());
        assert_eq!(self.monde.contient(point), !voulus.is_empty(), "{point:?} {}", self.objets());
    }

    /// The box around a choice is that around its boxes, and there is none where no object has one.
    fn etendue(&self) {
        let siennes = self.pris.iter().filter_map(|indice| self.monde.objets()[*indice].etendue());
        let coins = siennes.clone().map(|Etendue { bas, haut }| [bas, haut].map(<[R; 3]>::from));
        let voulue = coins.reduce(|[bas, haut], [b, h]| {
            let bout = |i: usize| if b[i] < bas[i] { b[i] } else { bas[i] };
            let autre = |i: usize| if h[i] > haut[i] { h[i] } else { haut[i] };
            [[0, 1, 2].map(bout), [0, 1, 2].map(autre)]
        });
        let obtenue = self.monde.etendue().map(|e| [e.bas, e.haut].map(<[R; 3]>::from));
        assert_eq!(obtenue, voulue, "{}", self.objets());
    }
}

/// A hit that no ray has.
fn absurde<R: Bits>() -> Reponse<R> {
    let boule = sphere::<R>(Vecteur::NUL, R::UN);
    boule.intersection(&Rayon::new(Vecteur::Z * R::LIMITE, -Vecteur::Z).unwrap())
}

/// How many kinds of ends there are.
pub const BOUTS: usize = 6;

/// The ends of rays, made from their hits: at the first hit and beside it, far beyond it, at one of the hits, some that
/// no segment reaches, and none.
pub fn bout<R: Bits>(genre: usize) -> impl Fn(usize, &[Vue<R>]) -> R {
    let etranges = [R::INFINI, R::ZERO, -R::ZERO, R::ETA];
    move |i, toutes| {
        let nieme = toutes.get(i % (toutes.len() + 1)).map(|(t, _)| *t);
        let t = toutes.first().map_or(R::UN, |(t, _)| *t);
        match genre {
            0 => t,
            1 => voisin(t, 1),
            2 => t * R::depuis_f64(1.0 + (i % 9) as f64),
            3 if i % 8 == 0 => etranges[i / 8 % etranges.len()],
            3 => nieme.map_or(t, |t| voisin(t, i as i64 / 8 % 2)),
            4 => voisin(t, i as i64 % 5 - 2),
            _ => R::INFINI,
        }
    }
}

/// Those of these hits, which are in order, that lie before an end.
fn avant<R: PartialOrd>(toutes: &[Vue<R>], fin: R) -> &[Vue<R>] {
    &toutes[..toutes.partition_point(|(t, _)| *t < fin)]
}

/// The first of these hits, or a miss.
fn premiers_mots<R: Bits>(toutes: &[Vue<R>]) -> Mots {
    toutes.first().map_or_else(|| mots::<R>(&Err(NoIntersection)), |(_, mots)| *mots)
}

/// A choice that answers differently each time: every answer is still a hit of some object, and in order.
pub fn un_choix_inconstant<R: Bits>(monde: Monde<'_, R>, rayons: &[Rayon<R>], graine: u8) {
    let etat = AtomicU32::new(graine.into());
    let parmi = monde.parmi(|_| {
        let suivant = etat.load(Ordering::Relaxed).wrapping_mul(747_796_405).wrapping_add(1);
        etat.store(suivant, Ordering::Relaxed);
        suivant >> 31 == 0
    });
    let seule = |indice: usize, rayon: &Rayon<R>| monde.objets()[indice].intersection(rayon);
    let mut lot = vec![Err(NoIntersection); rayons.len()];
    parmi.premieres_intersections(rayons, &mut lot).unwrap();
    for (rayon, touche) in rayons.iter().zip(lot) {
        let mut touches = [Err(NoIntersection); 4];
        let nombre = parmi.dans_l_ordre(rayon, &mut touches);
        let places: Vec<_> =
            touches[..nombre].iter().flatten().map(|t| (t.distance(), t.indice())).collect();
        assert!(places.len() == nombre && places.windows(2).all(|w| w[0] < w[1]));
        parmi.visiter(rayon, |indice, _| {
            assert!(seule(indice, rayon).is_ok(), "{rayon:?}");
            Continue(rayon.fin())
        });
        parmi.contenants(rayon.source(), |indice| {
            assert!(monde.objets()[indice].contient(rayon.source()), "{rayon:?}");
        });
        let une = parmi.premiere_intersection(rayon);
        let _ = (parmi.certifie(rayon, &une), parmi.est_occulte(rayon));
        for touche in touches.iter().chain(&[touche, une]).flatten() {
            let seule = seule(touche.indice(), rayon);
            assert_eq!(mots(&seule).valeurs, mots(&Ok(*touche)).valeurs, "{rayon:?}");
        }
    }
}

/// Certain answers in two precisions name the same object or none, in a list and in a tree; and a tree answers what
/// `temoin_f64` gives as a list does (`Rayon::temoin_f64`).
pub fn exiger_les_certificats<R: Bits>(
    monde: Monde<'_, R>,
    en_double: Monde<'_>,
    rayon: &Rayon<R>,
) {
    let (touche, double) = (monde.premiere_intersection(rayon), rayon.temoin_f64());
    let la = en_double.premiere_intersection(&double);
    let liste = Monde::de_liste(en_double.objets());
    let contexte = || format!("{:?} {rayon:?}", monde.objets());
    assert_eq!(mots(&la), mots(&liste.premiere_intersection(&double)), "{}", contexte());
    let ici = [monde, Monde::de_liste(monde.objets())].map(|m| m.certifie(rayon, &touche));
    let la_bas = [en_double, liste].map(|monde| monde.certifie(&double, &la));
    if ici.contains(&true) && la_bas.contains(&true) {
        let [ici, la] = [touche.ok().map(|t| t.indice()), la.ok().map(|t| t.indice())];
        assert_eq!(ici, la, "{}", contexte());
    }
}
