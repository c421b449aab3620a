//! How often each named step of `docs/preuves` rounds, and how many programs a question has, read from the tapes that
//! the crate's own code leaves.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use lancer_rayon::pour_les_tests::{
    composee, tour_autour, tour_de_camera, tour_du_quaternion, tour_vers, trois_tours,
};
use lancer_rayon::*;

use crate::ruban::Op::*;
use crate::ruban::*;

pub(crate) const S: [f64; 3] = [0.125, 0.25, 3.0];

pub(crate) fn rayon<T: Taille>(s: [f64; 3]) -> Rayon<Trace<T>> {
    Rayon::new(entrees("S", s), entrees("D", [0.0, 0.0, -1.0])).unwrap()
}

pub(crate) fn sphere<T: Taille>() -> SphereGeo<Trace<T>> {
    SphereGeo::new(entrees("C", [0.5, 0.25, -5.0]), entree("r", 1.5), Texture(0)).unwrap()
}

/// A rotation with which the ray enters a box by its face of z.
fn rotation<T: Taille>() -> Rotation<Trace<T>> {
    let axes = Rotation::<f64>::autour_de(Vecteur::new(1.0, 2.0, 2.0), 0.3).unwrap().axes();
    let [x, y, z] =
        [("U", axes[0]), ("V", axes[1]), ("N", axes[2])].map(|(nom, v)| entrees(nom, v));
    Rotation::depuis_matrice([x, y, z].map(Into::into)).unwrap()
}

pub(crate) fn plan<T: Taille>() -> PlanGeo<Trace<T>> {
    PlanGeo::new(rotation(), entree("d", 2.0), Texture(0)).unwrap()
}

pub(crate) fn boite<T: Taille>() -> BoiteRay<Trace<T>> {
    let (centre, tailles) = (entrees("C", [0.5, 0.25, -5.0]), entrees("l", [4.0, 3.0, 2.0]));
    BoiteGeo::new(centre, tailles, rotation(), Texture(0)).unwrap().vers_ray()
}

/// The two operands of a quotient, a sum and so on.
macro_rules! cotes {
    ($place:expr, $op:ident) => {
        match crate::ruban::op($place) {
            crate::ruban::Op::$op(a, b) => [a, b],
            autre => panic!("{autre:?} is no {}", stringify!($op)),
        }
    };
}
pub(crate) use cotes;

/// The operand of a root, an absolute value or −x.
pub(crate) fn de(place: Place) -> Place {
    let (Racine(a) | Absolu(a) | Oppose(a)) = op(place) else { panic!("{:?}", op(place)) };
    a
}

/// The first factors in a sum of three squares, or of three products by the same vector.
fn facteurs(somme: Place) -> [Place; 3] {
    let [xy, z] = cotes!(somme, Somme);
    let [x, y] = cotes!(xy, Somme);
    [x, y, z].map(|produit| cotes!(produit, Produit)[0])
}

/// The value before it was made unit, if it was.
fn brute(place: Place) -> Place {
    if let Quotient(a, _) = op(place) { a } else { place }
}

/// The other side of the one comparison of this place with what is no constant.
pub(crate) fn compare_a(place: Place) -> Place {
    let deux = |(a, b)| (a == place).then_some(b).or_else(|| (b == place).then_some(a));
    let trouvees: BTreeSet<_> = comparaisons().into_iter().filter_map(deux).collect();
    let trouvees: Vec<_> =
        trouvees.into_iter().filter(|x| !matches!(op(*x), Constante(..))).collect();
    assert_eq!(trouvees.len(), 1, "{trouvees:?}");
    trouvees[0]
}

/// How often each product of a sum is rounded, by the names of the product's factors.
type Comptes = BTreeMap<String, BTreeSet<u32>>;

/// The steps of the page, as they are computed in this type.
fn etapes<T: Taille>() -> BTreeMap<&'static str, Comptes> {
    let mut etapes = BTreeMap::new();
    // Letters stand for what is counted elsewhere.
    let mut noter = |nom, place, lettres: &[(&'static str, Place)]| {
        assert!(etapes.insert(nom, arrondis(place, lettres)).is_none(), "{nom}");
    };
    let places = |v: Vecteur<Trace<T>>| [v.x, v.y, v.z].map(Trace::place);
    let trois = |nom: &'static str, places: [Place; 3]| places.map(|place| (nom, place));

    // A sphere, from outside.
    neuf();
    let (ray, boule) = (rayon::<T>(S), sphere::<T>().vers_ray());
    let r2 = (boule.rayon() * boule.rayon()).place();
    let touche = ObjetRay::from(boule).intersection(&ray).unwrap();
    let (t, n, p_) = (touche.distance().place(), touche.normale(), touche.point());
    let [p, s] = cotes!(t, Quotient);
    let [sa, ab] = cotes!(s, Somme);
    let [r2_d2, ac2] = cotes!(de(ab), Difference);
    let (ac, [sc2, _]) = (facteurs(ac2), cotes!(p, Difference));
    noter("S1 D²", cotes!(r2_d2, Produit)[1], &[]);
    // SC is −f and counted apart, but for the power all that is computed is wanted too.
    let sc = facteurs(sc2);
    noter("S1 SC", sc[0], &[]);
    noter("S2 SA", sa, &trois("SC", sc));
    noter("S3 SC²", sc2, &trois("SC", sc));
    noter("S3 r²", r2, &[]);
    noter("S3 p", p, &[]);
    noter("S4 r²D²", r2_d2, &[]);
    noter("S4 SC∧D", ac[0], &trois("SC", sc));
    noter("S4 AC²", ac2, &trois("AC", ac));
    noter("S4 AB²", de(ab), &[("r²D²", r2_d2), ("AC²", ac2)]);
    noter("S6 s", s, &[("SA", sa)]);
    noter("S6 t", t, &[("p", p)]);
    let sa_s = ops().iter().position(|op| matches!(op, Produit(_, b) if *b == s)).unwrap();
    noter("S6 SA·s", sa_s, &[("SA", sa), ("s", s)]);
    noter("S6 p·D²", compare_a(sa_s), &[("p", p)]);
    let cb = places(n).map(|n| cotes!(n, Quotient)[0]);
    let longueur = cotes!(places(n)[0], Quotient)[1];
    noter("S7 CB", cb[0], &[("t", t)]);
    noter("S7 CB²", de(longueur), &trois("CB", cb));
    noter("S7 N", places(n)[0], &trois("CB", cb));
    noter("M1 P", p_.x.place(), &[("t", t)]);
    let reste = compare_a(r2);
    noter("O2", reste, &[("SC²", sc2), ("SA", sa)]);
    // M3 and M4, from the margin inward.
    let [sans_plancher, _] = cotes!(touche.marge().place(), Somme);
    let [b_et_l, dix_u] = cotes!(sans_plancher, Somme);
    assert_eq!(cotes!(dix_u, Produit)[0], b_et_l);
    let [b, huit_u] = cotes!(b_et_l, Somme);
    let l = cotes!(huit_u, Produit)[0];
    let [carres, _] = cotes!(b, Produit);
    let [par_rayon, y2] = cotes!(carres, Somme);
    let [_, gx] = cotes!(par_rayon, Produit);
    let [g, x2] = cotes!(gx, Somme);
    let [y, _] = cotes!(y2, Produit);
    let x = facteurs(x2);
    let m = cotes!(cotes!(x[0], Difference)[1], Produit)[1];
    let cp = x.map(|x| cotes!(x, Difference)[0]);
    let p_lettres = trois("P", places(p_));
    noter("M3 CP", cp[0], &p_lettres);
    noter("M3 g", g, &p_lettres);
    noter("M3 m", m, &[trois("CP", cp), trois("N", places(n))].concat());
    noter("M3 x", x[0], &[&trois("CP", cp)[..], &trois("N", places(n)), &[("m", m)]].concat());
    noter("M3 x²", x2, &trois("x", x));
    noter("M3 y", y, &p_lettres);
    noter("M3 b", b, &[("g", g), ("y", y), ("x²", x2)]);
    noter("M3 ℓ", l, &[]);
    noter("M4", touche.marge().place(), &[("b", b), ("ℓ", l)]);

    // The way out of a sphere, with A ahead and with A behind.
    neuf();
    let touche = ObjetRay::from(sphere::<T>()).sortie(&rayon(S)).unwrap();
    let [s, _] = cotes!(touche.distance().place(), Quotient);
    noter("W2 s/D²", touche.distance().place(), &[("s", s)]);
    noter("W2 s", s, &[("SA", cotes!(s, Somme)[0])]);
    neuf();
    let touche = ObjetRay::from(sphere::<T>()).sortie(&rayon([0.5, 0.25, -6.0])).unwrap();
    let [p, s] = cotes!(touche.distance().place(), Quotient);
    noter("W2 p/s", touche.distance().place(), &[("p", p)]);
    noter("W2 s derrière", s, &[("SA", cotes!(s, Difference)[0])]);
    noter("W1 −p·D²", compare_a(de(cotes!(s, Difference)[1])), &[("p", p)]);

    // A half-space, and what starts from a hit.
    neuf();
    let (ray, sol) = (rayon::<T>(S), ObjetRay::from(plan::<T>()));
    let touche = sol.intersection(&ray).unwrap();
    let (t, n, p) = (touche.distance().place(), touche.normale(), touche.point());
    let [e, v] = cotes!(t, Quotient);
    noter("H1 N·S", cotes!(e, Somme)[0], &[]);
    noter("H1 e", e, &[]);
    noter("H1 v", v, &[]);
    noter("H3 t", t, &[("e", e)]);
    let lettres = [trois("P", places(p)), trois("N", places(n))].concat();
    let [sans_plancher, _] = cotes!(touche.marge().place(), Somme);
    let [b, huit_u] = cotes!(cotes!(sans_plancher, Somme)[0], Somme);
    noter("M2 b", b, &lettres);
    noter("M2 ℓ", cotes!(huit_u, Produit)[0], &lettres);
    let depart = touche.secondaire(n).unwrap();
    let [p_x, pas] = cotes!(depart.source().x.place(), Somme);
    assert_eq!(p_x, places(p)[0]);
    noter(
        "M6 pas",
        cotes!(pas, Produit)[1],
        &[&lettres[..], &[("marge", touche.marge().place())]].concat(),
    );
    noter(
        "M6 S′",
        depart.source().x.place(),
        &[&lettres[..], &[("pas", cotes!(pas, Produit)[1])]].concat(),
    );
    let d = ray.direction();
    let lettres = [trois("D", places(d)), trois("N", places(n))].concat();
    let reflet = touche.reflechi(d).unwrap().direction().x.place();
    noter("mirror", brute(reflet), &lettres);
    let brise = brute(touche.refracte(d, entree("n", 0.75)).unwrap().direction().x.place());
    let [t_x, n_k] = cotes!(brise, Difference);
    let [w, _] = cotes!(t_x, Produit);
    noter("M8 W", w, &lettres);
    noter("M8 W·n", t_x, &[("W", w)]);
    let k = de(cotes!(n_k, Produit)[1]);
    noter("M8 D′", brise, &[&lettres[..], &[("W·n", t_x)]].concat());
    let [le_long2, ecart] = cotes!(k, Somme);
    let le_long = cotes!(le_long2, Produit)[0];
    let w2 = cotes!(cotes!(ecart, Produit)[0], Produit)[0];
    noter("M8 W²", w2, &trois("W", facteurs(w2)));
    noter("M8 c′²", k, &[("W²", w2), ("N·D", le_long)]);
    let lampe = entrees("Q", [3.0, 4.0, 5.0]);
    let vers = touche.vers_lumiere(lampe).unwrap();
    let [x, longueur] = cotes!(vers.direction().x.place(), Quotient);
    noter("L2 Q−S′", x, &trois("S′", places(depart.source())));
    let ecarts = facteurs(de(longueur));
    noter("L2 distance²", de(longueur), &trois("Q−S′", ecarts));
    noter("L2 L", vers.direction().x.place(), &trois("Q−S′", ecarts));
    let n_l = n.produit_scalaire(vers.direction());
    noter("L3 N·L", n_l.place(), &trois("L", places(vers.direction())));

    // A box.
    neuf();
    let (ray, boite) = (rayon::<T>(S), boite::<T>());
    let touche = ObjetRay::from(boite).intersection(&ray).unwrap();
    let t = touche.distance().place();
    let [longueur, v] = cotes!(t, Quotient);
    noter("B1 l±f_i", longueur, &[]);
    noter("B2 v", v, &[]);
    noter("B5 t", t, &[("l±f_i", longueur)]);
    let l_o = cotes!(longueur, Produit)[0];
    let fois_l_o =
        |op: &Op| matches!(op, Produit(a, b) if *a == l_o && !matches!(ops()[*b], Constante(..)));
    let croise = ops().iter().position(fois_l_o).unwrap();
    noter("B1 f_i", cotes!(de(l_o), Somme)[1], &[]);
    noter("B3", croise, &[("l±f_i", l_o), ("v", cotes!(croise, Produit)[1])]);
    let [sans_plancher, _] = cotes!(touche.marge().place(), Somme);
    let [b, huit_u] = cotes!(cotes!(sans_plancher, Somme)[0], Somme);
    noter("M2 b box", b, &trois("P", places(touche.point())));
    noter("M2 ℓ box", cotes!(huit_u, Produit)[0], &trois("P", places(touche.point())));
    let lieu = boite.lieu(&ray, &touche).1.x.place();
    noter("lieu", lieu, &[("t", t)]);
    // The source of a ray to a place, of which N·l is counted along the face.
    let vers = boite.vers_lieu(Face::PlusZ, [entree("p", 0.25), entree("q", 0.5)]).unwrap();
    noter("vers_lieu", vers.source().x.place(), &[]);
    let etendue = ObjetRay::from(boite).etendue().unwrap().haut.x.place();
    let [_, h_jeu] = cotes!(etendue, Somme);
    let [h, jeu] = cotes!(h_jeu, Somme);
    noter("E1 H", h, &[]);
    noter("E1 corner", etendue, &[("H", h), ("slack", jeu)]);

    // Moves and turns.
    neuf();
    let (v, sol) = (entrees::<T>("T", [1.0, 2.0, 3.0]), plan::<T>());
    noter("move d", sol.translation(v).unwrap().vers_ray().distance().place(), &[]);
    noter("move C", sphere::<T>().translation(v).unwrap().centre().x.place(), &[]);
    let r = rotation::<T>();
    noter("turn C·M", r.appliquer(v).x.place(), &[]);
    let m = composee(r.matrice(), r.matrice()).map(|ligne| ligne.map(|x| cotes!(x.place(), Somme)));
    noter("M·M′", m[0][0][0], &[]);
    let [defaut, ..] = facteurs(cotes!(m[0][0][1], Quotient)[0]);
    let lettres = m.map(|ligne| ligne.map(|[m, _]| ("M", m)));
    noter("M·Mᵀ", cotes!(defaut, Difference)[1], lettres.as_flattened());
    noter("I−M·Mᵀ", defaut, lettres.as_flattened());
    let lettres = [lettres.as_flattened(), &[("I−M·Mᵀ", defaut)]].concat();
    noter("Newton", m[0][0][1], &lettres);

    // The matrices that rotations are made of, before the Newton step, in all nine elements.
    let (un, autre) = (entrees::<T>("a", [0.36, 0.48, 0.8]), entrees::<T>("b", [0.6, 0.0, 0.8]));
    let tours = [("cx", "sx"), ("cy", "sy"), ("cz", "sz")]
        .map(|(cos, sin)| (entree::<T>(cos, 0.6), entree::<T>(sin, 0.8)));
    let quaternion = ["i", "j", "k", "w"].map(|nom| entree::<T>(nom, 0.5));
    let paralleles = Trace::U * Trace::depuis_f64(16.0);
    for (nom, m) in [
        ("new", trois_tours(tours)),
        ("autour_de", tour_autour(un, tours[0])),
        ("quaternion", tour_du_quaternion(quaternion)),
        ("entre", tour_vers(un, autre, paralleles)),
        ("entre, beyond", tour_vers(un, -autre, paralleles)),
        ("regard", tour_de_camera(un, autre)),
    ] {
        let comptes: &mut Comptes = etapes.entry(nom).or_default();
        for element in m.as_flattened() {
            for (produit, combien) in arrondis(cotes!(element.place(), Somme)[0], &[]) {
                comptes.entry(produit).or_default().extend(combien);
            }
        }
    }
    etapes
}

/// The steps of both types together.
static ETAPES: LazyLock<BTreeMap<&str, Comptes>> = LazyLock::new(|| {
    let mut etapes = etapes::<u32>();
    for (nom, comptes) in self::etapes::<u64>() {
        for (produit, combien) in comptes {
            etapes.get_mut(nom).unwrap().entry(produit).or_default().extend(combien);
        }
    }
    etapes
});

/// How often a product of these names is rounded in this step at most.
#[track_caller]
pub(crate) fn compte(etape: &str, produit: &str) -> f64 {
    let comptes = ETAPES.get(etape).unwrap_or_else(|| panic!("no step {etape}"));
    let combien = comptes.get(produit).unwrap_or_else(|| panic!("{etape}: {comptes:?}"));
    (*combien.last().unwrap()).into()
}

/// `arrondis.txt` has these counts, which the pages tell in words.
#[test]
fn les_etapes_arrondissent_comme_le_dit_la_table() {
    let un = |(produit, combien): (&String, &BTreeSet<u32>)| {
        let combien: Vec<_> = combien.iter().rev().map(u32::to_string).collect();
        format!("{produit}: {}", combien.join(" "))
    };
    let lignes = ETAPES.iter().map(|(etape, comptes)| {
        let comptes: Vec<_> = comptes.iter().map(un).collect();
        format!("{etape:15}{}", comptes.join(",  "))
    });
    let table = include_str!("arrondis.txt").lines().skip(1);
    for (ligne, lue) in lignes.clone().zip(table.clone()) {
        assert_eq!(ligne, lue);
    }
    assert_eq!(lignes.count(), table.count());
}

/// All that `demander` may answer within `combien` comparisons, except misses.
pub(crate) fn programmes<T: Taille>(
    combien: usize,
    objet: &ObjetRay<Trace<T>>,
    demander: impl Fn(&ObjetRay<Trace<T>>) -> Reponse<Trace<T>>,
) -> Vec<Place> {
    let t = || demander(objet).ok().map(|touche| touche.distance().place());
    tous_les_chemins(combien, t).into_iter().flatten().collect()
}

/// A distance is 0 or one of a few quotients, whatever the numbers.
#[test]
fn une_distance_a_peu_de_programmes() {
    fn compter<T: Taille>() {
        neuf();
        let ray = rayon::<T>(S);
        let objets: [ObjetRay<Trace<T>>; 3] = [sphere().into(), plan().into(), boite().into()];
        // On the way in: p/s and SA/D²; e/v; each of six faces. On the way out: both of W2, with AB² as S4 or as W1 has
        // it; e/v; each of six faces. W5 may answer all ways in. What B4 starts from would be a way out, which lemma 2
        // excludes.
        for (objet, attendu) in objets.iter().zip([(9, 2, 2 + 4), (9, 1, 1), (14, 6, 6 + 6 + 1)]) {
            let (comparaisons, combien, combien_de_sorties) = attendu;
            let entrees = programmes(comparaisons, objet, |objet| objet.intersection(&ray));
            assert!(entrees.iter().all(|t| matches!(op(*t), Quotient(..))), "{entrees:?}");
            let sorties = programmes(comparaisons, objet, |objet| objet.sortie(&ray));
            assert!(entrees.iter().all(|entree| sorties.contains(entree)), "{sorties:?}");
            assert_eq!((entrees.len(), sorties.len()), (combien, combien_de_sorties));
        }
        for objet in [|| sphere::<T>().into(), || plan().into(), || boite().into()] {
            neuf();
            let objet: ObjetRay<Trace<T>> = objet();
            let touche = objet.intersection(&rayon(S)).unwrap();
            let dedans = touche.point() - touche.normale() * Trace::depuis_f64(0.001);
            let dedans = entrees("X", <[Trace<T>; 3]>::from(dedans).map(Trace::vers_f64));
            let ray = Rayon::new(dedans, rayon(S).direction()).unwrap();
            let d_emblee = objet.intersection(&ray.avec_flou(entree("δ", 0.01)).unwrap()).unwrap();
            assert_eq!(op(d_emblee.distance().place()), Constante(0, false));
        }
    }
    compter::<u32>();
    compter::<u64>();
}
