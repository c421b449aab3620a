//! The laws of `Rotation`.

use commun::hasard::{Hasard, Tirage, pour_chaque};
use commun::regimes::{angles, deux_puissance, direction, entre, repere, rotation};
use commun::strategies::{quelconque, vecteur, vecteur_quelconque};
use commun::tolerances::{ECART_ROTATION, ORTHONORMALE, PRODUIT, promesses, u};
use commun::{Bits, arrondi, cas, en_f32_et_f64};
use lancer_rayon::pour_les_tests::DEJA_ORTHONORMALE;
use lancer_rayon::{ErreurGeo, Nombre, Reel, Rotation, Vecteur};

/// What a constructor made of these numbers and vectors.
type Essai<'a, R> = (Result<Rotation<R>, ErreurGeo>, &'a [R], &'a [Vecteur<R>]);
type Matrice = [[f64; 3]; 3];

const IDENTITE: Matrice = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn matrice<R: Reel>(r: Rotation<R>) -> Matrice {
    r.matrice().map(|ligne| ligne.map(R::vers_f64))
}

fn bits<R: Bits>(r: Rotation<R>) -> [[u64; 3]; 3] {
    r.matrice().map(|ligne| ligne.map(R::bits))
}

fn produit(a: Matrice, b: Matrice) -> Matrice {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum::<f64>()))
}

fn transposee(m: Matrice) -> Matrice {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

/// The largest difference between two elements.
fn ecart(a: Matrice, b: Matrice) -> f64 {
    let elements = a.as_flattened().iter().zip(b.as_flattened());
    elements.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

fn determinant(m: Matrice) -> f64 {
    let [a, b, c] = m;
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The definition of §2.1, each matrix written out as the handout prints it.
fn enonce(r: Vecteur) -> Matrice {
    let (s, c) = r.x.sin_cos();
    let m_x = [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]];
    let (s, c) = r.y.sin_cos();
    let m_y = [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]];
    let (s, c) = r.z.sin_cos();
    let m_z = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]];
    produit(produit(m_x, m_y), m_z)
}

fn la_matrice_est_celle_de_la_formule<R: Reel>() {
    pour_chaque(
        cas(256),
        |alea| angles::<R>(alea),
        |v| {
            let attendu = enonce(v.vers_f64());
            // At a quarter turn the formula sees the rounding of the angle, at most 4u at 2π; an element
            // is a sum of products of up to three such cosines.
            let tolerance = elements::<R>().min(PRODUIT * u::<R>()) + 3.0 * 4.0 * u::<R>();
            let r = Rotation::new(v).unwrap();
            est_orthonormale(r);
            assert!(ecart(matrice(r), attendu) <= tolerance);
            let oppose = (-v).vers_f64();
            assert!(ecart(matrice(Rotation::main_droite(v).unwrap()), enonce(oppose)) <= tolerance);
        },
    );
}

en_f32_et_f64!(la_matrice_est_celle_de_la_formule);

/// The laws of a group; and V·M has the vector on the left.
fn les_rotations_forment_un_groupe<R: Bits>() {
    let faire =
        |alea: &mut Hasard| (rotation::<R>(alea), rotation::<R>(alea), vecteur::<R>(alea, 1e3));
    pour_chaque(cas(256), faire, |(r, s, v)| {
        let attendu = produit(matrice(r), matrice(s));
        assert!(ecart(matrice(r.puis(s)), attendu) <= PRODUIT * u::<R>());
        assert!(ecart(matrice(r.puis(r.inverse())), IDENTITE) <= PRODUIT * u::<R>());
        assert_eq!(r.inverse().inverse(), r);
        assert_eq!(matrice(r.inverse()), transposee(matrice(r)));
        // A polished matrix stays as it is, bit for bit.
        assert_eq!(bits(Rotation::depuis_matrice(r.matrice()).unwrap()), bits(r));
        let [ligne, ..] = produit([v.vers_f64().into(), [0.0; 3], [0.0; 3]], matrice(r));
        // There are three products and two sums in each coordinate.
        let permis = 3.0_f64.sqrt() * 3.1 * u::<R>() * v.vers_f64().longueur();
        assert!((r.appliquer(v).vers_f64() - Vecteur::from(ligne)).longueur() <= permis);
    });
}

en_f32_et_f64!(les_rotations_forment_un_groupe);

/// The first column of a matrix is too long, by ever more. Then its columns, which are the rows of its inverse, are up
/// to three times as far from orthonormal as its rows.
fn l_inverse_d_une_matrice_presque_orthonormale_est_une_rotation<R: Bits>() {
    let [x, y, z] = repere(Vecteur::new(1.0, 1.0, 1.0).unitaire().unwrap());
    let base = transposee([z, x, y]);
    let mut gardees = 0;
    for k in 0..40 {
        let m =
            base.map(|[a, b, c]| [a * (1.0 + f64::from(k) * u::<R>()), b, c].map(R::depuis_f64));
        let r = Rotation::depuis_matrice(m).unwrap();
        gardees += u32::from(r.matrice() == m);
        for r in [r, r.inverse()] {
            let m = matrice(r);
            // Both this test and the crate judge an f64 in f64: 4u each.
            let permis = DEJA_ORTHONORMALE * u::<R>() + 8.0 * f64::U;
            assert!(ecart(produit(m, transposee(m)), IDENTITE) <= permis, "{k}: {m:?}");
            assert_eq!(bits(Rotation::depuis_matrice(r.matrice()).unwrap()), bits(r), "{k}");
        }
    }
    assert!((1..40).contains(&gardees), "{gardees} kept");
}

en_f32_et_f64!(l_inverse_d_une_matrice_presque_orthonormale_est_une_rotation);

/// Orthonormal by rows as lemma 13 promises, and by columns, for the inverse.
fn est_orthonormale<R: Reel>(r: Rotation<R>) {
    est_orthonormale_a(ORTHONORMALE, r);
}

fn est_orthonormale_a<R: Reel>(combien: f64, r: Rotation<R>) {
    let m = matrice(r);
    let lignes = ecart(produit(m, transposee(m)), IDENTITE);
    // This test rounds in f64 as well.
    assert!(lignes <= combien * u::<R>() + 4.0 * f64::U, "{r:?}");
    assert!(ecart(produit(transposee(m), m), IDENTITE) <= 12.0 * u::<R>(), "{r:?}");
    assert!((determinant(m) - 1.0).abs() <= 1.5 * 12.0 * u::<R>(), "{r:?}");
}

fn une_matrice_en_decimales_est_acceptee<R: Reel>() {
    let faire = |alea: &mut Hasard| (rotation::<R>(alea), alea.i8(4..=7).into());
    pour_chaque(cas(256), faire, |(r, decimales)| {
        let m = matrice(r);
        let dix = 10_f64.powi(decimales);
        // Half of the last decimal if it is rounded, all of it if it is cut off.
        for (ecrire, h) in [(f64::round as fn(f64) -> f64, 0.5 / dix), (f64::trunc, 1.0 / dix)] {
            let ecrite = m.map(|ligne| ligne.map(|x| R::depuis_f64(ecrire(x * dix) / dix)));
            let lue = Rotation::depuis_matrice(ecrite).unwrap();
            // In f32 a matrix with seven decimals may be exact enough to be kept.
            let gardee = lue.matrice() == ecrite;
            est_orthonormale_a(if gardee { DEJA_ORTHONORMALE } else { ORTHONORMALE }, lue);
            // The bound of lemma 13, a hundredth for the second order, and the roundings of what is written and read.
            let permis = 6_f64.sqrt() * 1.01 * h + (ORTHONORMALE + 3.0) * u::<R>();
            assert!(ecart(matrice(lue), m) <= permis, "{decimales}: {r:?}");
        }
    });
}

en_f32_et_f64!(une_matrice_en_decimales_est_acceptee);

/// A matrix that is off by up to the limit is repaired, whatever the direction of the fault, and becomes the nearest
/// rotation. For a symmetric fault, which only stretches, that is the original rotation.
fn une_matrice_presque_orthonormale_est_reparee<R: Reel>() {
    let faire = |alea: &mut Hasard| {
        (rotation::<R>(alea), [(); 3].map(|()| [(); 3].map(|()| entre(alea, -1.0, 1.0))))
    };
    pour_chaque(cas(256), faire, |(r, bruit)| {
        let symetrique: Matrice =
            std::array::from_fn(|i| std::array::from_fn(|j| bruit[i.min(j)][i.max(j)]));
        // The largest element of (I + S)² − I is to be just within the limit. For a fault that is not symmetric, an
        // element is two sums of three products, at most 2√3 times as large.
        let grand = (0..9).fold(1e-3, |g: f64, k| g.max(symetrique[k / 3][k % 3].abs()));
        let k = (0.5 * ECART_ROTATION - 1e-6) / grand;
        let fautes = [
            (symetrique, k, 20.0 * u::<R>()),
            // The antisymmetric part stays.
            (bruit, ECART_ROTATION / 8.0, 4.0 * ECART_ROTATION / 8.0),
        ];
        for (faute, k, permis) in fautes {
            let i_plus_s: Matrice =
                std::array::from_fn(|i| std::array::from_fn(|j| IDENTITE[i][j] + k * faute[i][j]));
            let abimee = produit(i_plus_s, matrice(r)).map(|ligne| ligne.map(R::depuis_f64));
            let reparee = Rotation::depuis_matrice(abimee).unwrap();
            est_orthonormale(reparee);
            assert!(ecart(matrice(reparee), matrice(r)) <= permis);
        }
    });
}

en_f32_et_f64!(une_matrice_presque_orthonormale_est_reparee);

/// Directions that are opposite but for a sine of 16u or less have the axis that is promised: at a
/// right angle to `vers` and to x, if y does not lie farther from `vers`. Beyond that the axis is
/// theirs.
fn de_directions_presque_opposees_l_axe_est_promis<R: Reel>() {
    for (k, promis) in [(0.0, true), (15.9, true), (16.1, false), (99.0, false)] {
        let de = Vecteur::new(R::ZERO, R::U * R::depuis_f64(k), -R::UN);
        let [x, ..] = Rotation::entre(de, Vecteur::Z).unwrap().axes();
        assert_eq!(x.x < R::ZERO, promis, "{k}");
    }
    let vers = Vecteur::new(R::UN, R::UN, R::UN);
    let [x, ..] = Rotation::entre(-vers, vers).unwrap().axes();
    assert!((x + Vecteur::X).longueur() < R::U * R::depuis_f64(36.0), "{x:?}");
}

en_f32_et_f64!(de_directions_presque_opposees_l_axe_est_promis);

fn ce_qui_n_est_pas_une_rotation_est_refuse<R: Reel>() {
    let faire = |alea: &mut Hasard| (rotation::<R>(alea), alea.usize(0..3));
    pour_chaque(cas(256), faire, |(r, i)| {
        let m = matrice(r);
        let refus = |m: Matrice| {
            let m = m.map(|ligne| ligne.map(R::depuis_f64));
            // Any determinant is below 0.
            Rotation::depuis_matrice(m).err().map(|erreur| (erreur.champ, erreur.valeur < 0.0))
        };
        // The nearest are off by a fiftieth more than the limit.
        for k in [1.01, 0.99, 1.000_51, 0.999_49, 1.001, 0.999, 0.0, -1.01] {
            assert_eq!(refus(m.map(|l| l.map(|x| k * x))), Some(("matrice", false)));
        }
        let mut penchee = m;
        penchee[i] = std::array::from_fn(|j| m[i][j] + 0.01 * m[(i + 1) % 3][j]);
        assert_eq!(refus(penchee), Some(("matrice", false)));
        let mut miroir = m;
        miroir[i] = m[i].map(|x| -x);
        assert_eq!(refus(miroir), Some(("matrice", true)));
        let mut sans_nombre = m;
        sans_nombre[1][i] = f64::NAN;
        let champ = ["matrice[1][0]", "matrice[1][1]", "matrice[1][2]"][i];
        assert_eq!(refus(sans_nombre), Some((champ, false)));
    });
}

en_f32_et_f64!(ce_qui_n_est_pas_une_rotation_est_refuse);

/// q·V·q⁻¹, by Hamilton's products.
fn hamilton(q: [f64; 4], v: Vecteur) -> [f64; 3] {
    let fois = |a: [f64; 4], b: [f64; 4]| {
        let ([x, y, z, w], [i, j, k, l]) = (a, b);
        [
            w * i + x * l + y * k - z * j,
            w * j - x * k + y * l + z * i,
            w * k + x * j - y * i + z * l,
            w * l - x * i - y * j - z * k,
        ]
    };
    let [x, y, z, w] = q;
    let carre = q.iter().map(|c| c * c).sum::<f64>();
    let [i, j, k, _] = fois(fois(q, [v.x, v.y, v.z, 0.0]), [-x, -y, -z, w]);
    [i, j, k].map(|c| c / carre)
}

/// What `new`, `autour_de` and `depuis_quaternion` promise for an element, and 20u of `f64` for the test.
fn elements<R: Reel>() -> f64 {
    1.1 * u::<R>() + (promesses::TOUR + 20.0) * f64::U
}

fn un_quaternion_tourne_comme_son_produit<R: Reel>() {
    let faire = |alea: &mut Hasard| {
        ([(); 4].map(|()| entre(alea, -1.0, 1.0)), deux_puissance(alea, -100.0, 100.0))
    };
    pour_chaque(cas(256), faire, |(q, k)| {
        let q = q.map(|c| R::depuis_f64(c * k));
        let r = Rotation::depuis_quaternion(q).unwrap();
        est_orthonormale(r);
        let ce_que_deviennent = [Vecteur::X, Vecteur::Y, Vecteur::Z]
            .map(|axe| hamilton(q.map(|c| c.vers_f64() / k), axe));
        assert!(ecart(matrice(r), ce_que_deviennent) <= elements::<R>(), "{q:?}: {r:?}");
    });
}

en_f32_et_f64!(un_quaternion_tourne_comme_son_produit);

fn autour_d_un_axe_le_sens_est_celui_de_new<R: Reel>() {
    let sinus_et_cosinus = |n: Vecteur, angle: f64| {
        let (sin, cos) = (0.5 * angle).sin_cos();
        let v = n * -sin;
        [v.x, v.y, v.z, cos]
    };
    let faire =
        |alea: &mut Hasard| (vecteur::<R>(alea, 1e3), entre(alea, -7.0, 7.0), alea.usize(0..3));
    pour_chaque(cas(256), faire, |(axe, angle, i)| {
        let angle = R::depuis_f64(angle);
        let r = Rotation::autour_de(axe, angle).unwrap();
        est_orthonormale(r);
        // The angle is negated, since a quaternion turns by the right-hand rule.
        let q = sinus_et_cosinus(axe.vers_f64().unitaire().unwrap(), angle.vers_f64());
        let attendu = [Vecteur::X, Vecteur::Y, Vecteur::Z].map(|axe| hamilton(q, axe));
        assert!(ecart(matrice(r), attendu) <= elements::<R>(), "{axe:?} {angle}: {r:?}");

        let e_i: Vecteur<R> = [Vecteur::X, Vecteur::Y, Vecteur::Z][i];
        let (par_axe, par_new) = (Rotation::autour_de(e_i, angle), Rotation::new(e_i * angle));
        let ecart_des_deux = ecart(matrice(par_axe.unwrap()), matrice(par_new.unwrap()));
        assert!(ecart_des_deux <= 2.0 * elements::<R>());
    });
    for k in -4..=4_i8 {
        let quarts = R::depuis_f64(f64::from(k) * std::f64::consts::FRAC_PI_2);
        for axe in [Vecteur::<R>::X, Vecteur::Y, Vecteur::Z] {
            let r = Rotation::autour_de(axe, quarts).unwrap();
            assert_eq!(r, Rotation::new(axe * quarts).unwrap());
            assert_eq!(r, Rotation::main_droite(-axe * quarts).unwrap());
        }
    }
}

en_f32_et_f64!(autour_d_un_axe_le_sens_est_celui_de_new);

/// Two directions, half of the time parallel or opposite to within some power of two.
fn deux_directions<R: Reel>(alea: &mut Hasard) -> [Vecteur<R>; 2] {
    let (a, b) = (direction(alea), direction(alea));
    let presque = a + b * deux_puissance(alea, -56.0, 0.0);
    let b = [b, b, presque, -presque][alea.usize(0..4)];
    [a, b].map(|v| arrondi(v * deux_puissance(alea, -40.0, 40.0)))
}

fn entre_deux_directions_le_tour_est_le_plus_court<R: Reel>() {
    pour_chaque(cas(256), deux_directions::<R>, |[de, vers]| {
        let r = Rotation::entre(de, vers).unwrap();
        est_orthonormale(r);
        let [a, b] = [de, vers].map(|v| v.vers_f64().unitaire().unwrap());
        let arrive = r.appliquer(de).vers_f64().unitaire().unwrap();
        // In f32 what is made in f64 counts as exact: elements and V·M round, by √3 and 5.2u.
        let permis = (promesses::ENTRE * f64::U + 7.0 * u::<R>())
            .min(promesses::ENTRE * u::<R>() + 8.0 * f64::U);
        assert!((arrive - b).longueur() <= permis, "{:e}", (arrive - b).longueur());

        // V·M is K·V with K = Mᵀ, whose antisymmetric part is the sine times the axis.
        let m = matrice(r);
        let axe = Vecteur::new(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]) * 0.5;
        let k = a.produit_vectoriel(b);
        let angle = |sin: Vecteur, cos: f64| sin.longueur().atan2(cos);
        let exces =
            angle(axe, 0.5 * (m[0][0] + m[1][1] + m[2][2] - 1.0)) - angle(k, a.produit_scalaire(b));
        let precis = 100.0 * f64::U + 10.0 * u::<R>();
        // Near half a turn the axis is less certain, and therefore the angle, to 3√u or 16u₃₂.
        let pres_du_demi_tour = a.produit_scalaire(b) < 0.0 && k.longueur() < 1e-3;
        let permis =
            if pres_du_demi_tour { 3.0 * f64::U.sqrt() + 17.0 * u::<R>() } else { 0.0 } + precis;
        assert!(exces.abs() <= permis, "{exces:e}, {:e}", k.longueur());
        assert!((axe - k).longueur() <= precis + 32.0 * u::<R>());
    });
}

en_f32_et_f64!(entre_deux_directions_le_tour_est_le_plus_court);

fn a_l_oppose_l_axe_est_celui_que_la_documentation_nomme<R: Reel>() {
    let faire = |alea: &mut Hasard| (vecteur::<R>(alea, 1e3), entre(alea, 0.1, 10.0));
    pour_chaque(cas(256), faire, |(de, k)| {
        let vers = de * R::depuis_f64(-k);
        let r = Rotation::entre(de, vers).unwrap();
        let v = vers.vers_f64();
        let loin = if v.x.abs() > v.y.abs() { Vecteur::Y } else { Vecteur::X };
        let axe = loin.produit_vectoriel(v).unitaire().unwrap();
        let tourne = |v: Vecteur| r.appliquer(arrondi(v)).vers_f64();
        // Each coordinate rounds when it is multiplied by `k`, so that `vers` is opposite only to u.
        assert!((tourne(axe) - axe).longueur() <= 16.0 * u::<R>() + 60.0 * f64::U);
        let dernier = axe.produit_vectoriel(v.unitaire().unwrap());
        assert!((tourne(dernier) + dernier).longueur() <= 16.0 * u::<R>() + 60.0 * f64::U);
    });
}

en_f32_et_f64!(a_l_oppose_l_axe_est_celui_que_la_documentation_nomme);

fn une_camera_regarde_ou_on_le_dit_et_se_tient_droite<R: Reel>() {
    pour_chaque(cas(256), deux_directions::<R>, |[direction, haut]| {
        let [d, h] = [direction, haut].map(|v| v.vers_f64().unitaire().unwrap());
        let sinus = d.produit_vectoriel(h).longueur();
        match Rotation::regard(direction, haut) {
            Ok(r) => {
                est_orthonormale(r);
                // This test and the crate compute the sine to 5u.
                assert!(sinus > 16.0 * u::<R>() - 5.0 * f64::U);
                let [x, y, z] = r.axes().map(Vecteur::vers_f64);
                // What lemma 13 grants in f64, with 4u for the test; in f32 elements round too.
                assert!((z + d).longueur() <= promesses::REGARD * f64::U + 2.0 * u::<R>());
                assert!(
                    x.produit_scalaire(h).abs()
                        <= promesses::REGARD_DROIT * f64::U + 4.0 * u::<R>()
                );
                // y points up as far as `haut` is at a right angle to the view.
                assert!(y.produit_scalaire(h) > 0.5 * sinus);
                assert!((x - d.produit_vectoriel(y)).longueur() <= 30.0 * u::<R>());
            }
            Err(erreur) => {
                assert_eq!(erreur.champ, "haut");
                assert!(sinus <= 16.0 * u::<R>() + 5.0 * f64::U);
            }
        }
    });
    let faire = |alea: &mut Hasard| (vecteur::<R>(alea, 1e3), entre(alea, -10.0, 10.0));
    pour_chaque(cas(256), faire, |(direction, k)| {
        let parallele = direction * R::depuis_f64(k);
        let erreur = Rotation::regard(direction, parallele).unwrap_err();
        assert_eq!(erreur.champ, "haut");
    });
}

en_f32_et_f64!(une_camera_regarde_ou_on_le_dit_et_se_tient_droite);

/// Whatever bits go in, a rotation comes out, or an error that names an unsuitable number.
fn n_importe_quels_bits_donnent_une_rotation_ou_un_refus<R: Bits>() {
    let faire = |alea: &mut Hasard| {
        (vecteur_quelconque(alea), vecteur_quelconque(alea), quelconque::<R>(alea))
    };
    pour_chaque(cas(256), faire, |(v, w, k)| {
        let essais: [Essai<'_, R>; 4] = [
            (Rotation::depuis_quaternion([v.x, v.y, v.z, k]), &[v.x, v.y, v.z, k], &[]),
            (Rotation::autour_de(v, k), &[v.x, v.y, v.z, k], &[v]),
            (Rotation::entre(v, w), &[v.x, v.y, v.z, w.x, w.y, w.z], &[v, w]),
            (Rotation::regard(v, w), &[v.x, v.y, v.z, w.x, w.y, w.z], &[v, w]),
        ];
        for (essai, nombres, directions) in essais {
            let finis = nombres.iter().all(|x| x.absolu() < R::INFINI);
            let nul = nombres.iter().all(|x| *x == R::ZERO) || directions.contains(&Vecteur::NUL);
            match essai {
                Ok(r) => {
                    assert!(finis && !nul);
                    est_orthonormale(r);
                }
                Err(erreur) if erreur.attendu == "a finite number" => {
                    assert!(!finis && !erreur.valeur.is_finite(), "{}", erreur);
                }
                Err(erreur) if erreur.attendu.starts_with("above 16u") => {
                    assert!(finis && !nul)
                }
                Err(erreur) => assert!(finis && nul && erreur.valeur == 0.0, "{}", erreur),
            }
        }
    });
}

en_f32_et_f64!(n_importe_quels_bits_donnent_une_rotation_ou_un_refus);

#[test]
fn un_refus_nomme_le_nombre() {
    let (x, nul, nan) = (Vecteur::X, Vecteur::NUL, Vecteur::new(0.0, f64::NAN, 0.0));
    let infini = f64::INFINITY;
    let cas = [
        (Rotation::depuis_quaternion([0.0; 4]), "quaternion is 0.0, but must be other than 0"),
        (
            Rotation::depuis_quaternion([0.0, 0.0, 1.0, infini]),
            "quaternion.w is inf, but must be a finite number",
        ),
        (Rotation::autour_de(nul, 1.0), "axe is 0.0, but must be a vector other than 0"),
        (Rotation::autour_de(nan, 1.0), "axe.y is NaN, but must be a finite number"),
        (Rotation::autour_de(x, f64::NAN), "angle is NaN, but must be a finite number"),
        (Rotation::entre(nul, x), "de is 0.0, but must be a vector other than 0"),
        (Rotation::entre(x, nan), "vers.y is NaN, but must be a finite number"),
        (Rotation::regard(nul, x), "direction is 0.0, but must be a vector other than 0"),
        (Rotation::regard(x, nan), "haut.y is NaN, but must be a finite number"),
        (
            Rotation::regard(x, -x * 3.0),
            "haut is 0.0, but must be above 16u in the sine of its angle with direction",
        ),
    ];
    for (essai, phrase) in cas {
        assert_eq!(essai.unwrap_err().to_string(), phrase);
    }
}

/// A `mint` matrix that multiplies a column from the left turns it as a vector turns here, and what is read back has
/// the same bits.
#[cfg(feature = "mint")]
fn par_mint_tout_tourne_de_meme<R: Bits>() {
    use mint::{ColumnMatrix3, Quaternion};

    let faire = |alea: &mut Hasard| (rotation::<R>(alea), vecteur::<R>(alea, 1e3));
    pour_chaque(cas(256), faire, |(r, v)| {
        let colonnes = ColumnMatrix3::from(r);
        let [x, y, z] = [colonnes.x, colonnes.y, colonnes.z].map(Vecteur::from);
        assert_eq!(x * v.x + y * v.y + z * v.z, r.appliquer(v));
        assert_eq!(Rotation::try_from(colonnes).map(bits), Ok(bits(r)));

        let q = [v.x, v.y, v.z, R::UN];
        let par_mint = Rotation::try_from(Quaternion { v: v.into(), s: R::UN });
        assert_eq!(par_mint, Rotation::depuis_quaternion(q));
    });
    let champ = |m: [[R; 3]; 3]| Rotation::try_from(ColumnMatrix3::from(m)).unwrap_err().champ;
    let mut m = Rotation::IDENTITE.matrice();
    m[0][2] = R::INFINI;
    assert_eq!(champ(m), "matrice[0][2]");
    m[0][2] = R::UN;
    assert_eq!(champ(m), "matrice");
    let nul = Quaternion { v: Vecteur::<R>::NUL.into(), s: R::ZERO };
    assert_eq!(Rotation::try_from(nul).unwrap_err().champ, "quaternion");
}

#[cfg(feature = "mint")]
en_f32_et_f64!(par_mint_tout_tourne_de_meme);
