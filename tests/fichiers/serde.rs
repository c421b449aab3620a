//! Reading a value makes the same checks as constructing it, and loses no bit.

use std::fs;

use commun::hasard::{Hasard, pour_chaque};
use commun::regimes::rotation;
use commun::strategies::{objet, scene};
use commun::{cas, en_f32_et_f64};
use lancer_rayon::{
    BoiteGeo, Face, Intersection, ObjetGeo, ObjetRay, PlanGeo, Rayon, Reel, Rotation, SphereGeo,
    Texture, Vecteur,
};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

/// The value, written and read again in RON and in JSON.
fn relu<T: Serialize + DeserializeOwned>(valeur: &T) -> [T; 2] {
    let json = serde_json::to_string(valeur).unwrap();
    [ron::from_str(&ron::to_string(valeur).unwrap()).unwrap(), serde_json::from_str(&json).unwrap()]
}

fn ce_qui_est_ecrit_est_relu_bit_pour_bit<R: Reel + Serialize + for<'de> Deserialize<'de>>() {
    let faire = |alea: &mut Hasard| (objet::<R>(alea), scene::<R>(alea).1, rotation::<R>(alea));
    pour_chaque(cas(256), faire, |(objet, rayon, r)| {
        assert_eq!(relu(&objet), [objet; 2]);
        assert_eq!(relu(&rayon), [rayon; 2]);
        assert_eq!(relu(&r), [r; 2]);
    });
}

en_f32_et_f64!(ce_qui_est_ecrit_est_relu_bit_pour_bit);

/// A ray with an end, one with a δ, one that is inside something, and hits: a simulation that is read again goes on to
/// the bit.
fn une_simulation_reprise_va_du_meme_pas<R: Reel + Serialize + for<'de> Deserialize<'de>>() {
    let v = |x, y, z| Vecteur::<R>::depuis_f64(Vecteur::new(x, y, z));
    let sol = ObjetRay::from(
        PlanGeo::par_un_point(v(0.1, 0.0, 0.0), v(0.1, 1.0, 0.3), Texture(7)).unwrap(),
    );
    let rayon = Rayon::new(v(0.3, 4.0, 0.1), v(0.3, -1.0, 0.7)).unwrap();
    let touche = sol.intersection(&rayon).unwrap();
    let suite = touche.reflechi(rayon.direction()).unwrap();
    assert!(suite.flou() > R::ZERO);
    let dedans = touche.secondaire(rayon.direction()).unwrap();
    for rayon in [rayon.jusqu_a(R::depuis_f64(9.1)).unwrap(), suite, dedans, rayon.dedans()] {
        assert_eq!(relu(&rayon), [rayon; 2]);
    }
    for relue in relu(&touche) {
        assert_eq!(relue, touche);
        assert_eq!(relue.reflechi(rayon.direction()), Ok(suite));
    }
    let perdue = SphereGeo::new(v(0.0, 0.0, 0.0), R::UN / R::LIMITE, Texture(0)).unwrap();
    let loin = Rayon::new(v(0.0, 0.0, 1.0), v(0.0, 0.0, -1.0)).unwrap();
    if let Ok(touche) = ObjetRay::from(perdue).intersection(&loin) {
        assert_eq!(relu(&touche), [touche; 2]);
    }
}

en_f32_et_f64!(une_simulation_reprise_va_du_meme_pas);

/// The lines in `docs/interop.md` are what is written, and can be read again: an object, a ray and a hit.
#[test]
fn la_page_montre_ce_qui_est_ecrit() {
    let objet = ObjetGeo::from(SphereGeo::new(Vecteur::Y * 0.5, 1.5, Texture(2)).unwrap());
    let bas = Vecteur::new(0.0, -1.0, 0.0);
    let rayon = Rayon::new(Vecteur::Y * 4.0, bas).unwrap().jusqu_a(9.0).unwrap();
    let touche = objet.vers_ray().intersection(&rayon).unwrap();
    fn ligne<T: Serialize + DeserializeOwned>(valeur: &T) -> [String; 2] {
        [serde_json::to_string(valeur).unwrap(), ron::to_string(valeur).unwrap()]
    }
    let lignes = [ligne(&objet), ligne(&rayon), ligne(&touche)];
    let page = fs::read_to_string("docs/interop.md").unwrap();
    let (_, section) = page.split_once("\n## Saved\n").expect("the section");
    for (langue, de) in [("json", 0), ("ron", 1)] {
        let (_, bloc) = section.split_once(&format!("```{langue}\n")).expect("a block");
        let (bloc, _) = bloc.split_once("```").expect("the end of a block");
        assert!(bloc.lines().eq(lignes.iter().map(|ligne| &ligne[de])), "{lignes:#?}");
    }
}

/// δ and whether a ray is inside something may be left out. In place of the latter 1.0 wrote a number of objects, where
/// δ was 0; so did a hit of 1.0, though no ray from there depends on it.
#[test]
fn un_rayon_sait_son_flou_et_s_il_est_dedans() {
    let lu = |suite: &str| {
        let texte = format!(r#"{{"source":[0,4,0],"direction":[0,-1,0]{suite}}}"#);
        serde_json::from_str::<Rayon>(&texte)
    };
    let rayon = Rayon::new(Vecteur::Y * 4.0, Vecteur::new(0.0, -1.0, 0.0)).unwrap();
    assert_eq!(lu("").unwrap(), rayon);
    assert_eq!(lu(r#","fin":null,"flou":1e-9"#).unwrap(), rayon.avec_flou(1e-9).unwrap());
    let dedans = rayon.avec_flou(1e-9).unwrap().dedans();
    assert_eq!(lu(r#","flou":1e-9,"dedans":1"#).unwrap(), dedans);
    assert_ne!(lu(r#","flou":1e-9,"dedans":0"#).unwrap(), dedans);
    // δ = 0 and inside, as the next turn shows.
    let tourne = |rayon: Rayon| rayon.bifurque(1.0, Vecteur::X).unwrap();
    let de_1_0 = lu(r#","flou":0,"dedans":2"#).unwrap();
    assert_eq!(tourne(de_1_0), tourne(rayon.dedans()));
    assert_ne!(tourne(de_1_0), tourne(rayon));
    let erreur = lu(r#","flou":-2.0"#).unwrap_err().to_string();
    assert!(erreur.contains("flou is "), "{erreur}");
    let touche = r#"{"distance":1,"normale":[0,1,0],"marge":1,"point":[0,0,0],"flou":0,"texture":0,"indice":0,"dedans":3}"#;
    let touche = serde_json::from_str::<Intersection>(touche).unwrap();
    assert!(touche.secondaire(Vecteur::Y).unwrap().flou() > 0.0);
}

/// However large a δ and a distance somebody writes, the next δ is finite, and can be read again.
fn un_flou_reste_fini<R: Reel + Serialize + for<'de> Deserialize<'de>>() {
    let plus_grand = R::depuis_f64(if size_of::<R>() == 4 { f32::MAX.into() } else { f64::MAX });
    let texte = format!(
        r#"{{"distance": {plus_grand}, "normale": [0, 1, 0], "marge": 1, "point": [0, 0, 0],
             "flou": {plus_grand}, "texture": 0, "indice": 0}}"#
    );
    let touche: Intersection<R> = serde_json::from_str(&texte).unwrap();
    // No distance is too large for a judgement of a made-up hit.
    let sol = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, R::UN, Texture(0)).unwrap());
    for vers in [Vecteur::Y, -Vecteur::Y, Vecteur::new(R::UN, R::UN, -R::UN)] {
        let rayon = Rayon::new(Vecteur::Z, vers).unwrap();
        assert!(sol.erreur(&rayon, &touche) >= R::ZERO, "{rayon:?}");
    }
    let suite = touche.secondaire(touche.normale()).unwrap();
    let virage = suite.bifurque(R::ZERO, suite.direction()).unwrap();
    for rayon in [suite, virage] {
        assert!(rayon.flou() >= plus_grand, "{rayon:?}");
        assert_eq!(relu(&rayon), [rayon; 2]);
        let simple = rayon.vers_f32(Vecteur::NUL).unwrap();
        assert_eq!(simple.flou(), f32::MAX);
    }
}

en_f32_et_f64!(un_flou_reste_fini);

/// Checks that the text is refused with the sentence of the constructor.
fn refuse<T: DeserializeOwned>(texte: &str, phrase: &str) {
    let Err(erreur) = ron::from_str::<T>(texte) else { panic!("accepted: {texte}") };
    let erreur = erreur.to_string();
    assert!(erreur.contains(phrase), "{erreur:?} does not say {phrase:?}");
}

#[test]
fn ce_qui_n_est_pas_valide_est_refuse() {
    let sphere: SphereGeo = ron::from_str("(centre: (0, 1, 2), rayon: 3, texture: (4))").unwrap();
    assert_eq!(sphere, SphereGeo::new(Vecteur::new(0.0, 1.0, 2.0), 3.0, Texture(4)).unwrap());

    let taille = "must be a number above 0";
    let cas = [("-1", "rayon is -1.0"), ("0", "rayon is 0.0"), ("NaN", "rayon is NaN")];
    for (rayon, phrase) in cas {
        let texte = format!("(centre: (0, 0, 0), rayon: {rayon}, texture: (0))");
        refuse::<SphereGeo>(&texte, &format!("{phrase}, but {taille}"));
        refuse::<ObjetGeo>(&format!("Sphere({texte})"), phrase);
    }
    refuse::<SphereGeo>(
        "(centre: (0, 0, 0), rayon: inf, texture: (0))",
        "rayon is inf, but must be a number between",
    );
    refuse::<SphereGeo>("(centre: (0, inf, 0), rayon: 1, texture: (0))", "centre.y is inf");
    let identite = "((1, 0, 0), (0, 1, 0), (0, 0, 1))";
    refuse::<PlanGeo>(
        &format!("(rotation: {identite}, distance: NaN, texture: (0))"),
        "distance is NaN",
    );
    refuse::<BoiteGeo<f32>>(
        &format!(
            "(centre: (0, 0, 0), dimensions: (1, 1e-30, 1), rotation: {identite}, texture: (0))"
        ),
        "dimensions.y is 1.0000000031710769e-30, but must be a number between 2^-60 and 2^60",
    );
    refuse::<Rotation>("((1, 0, 0), (0, 1, 0), (0, 0, 2))", "matrice is 3");
    refuse::<Rotation>("((1, 0, 0), (0, 1, 0), (0, 0, -1))", "matrice is -1");
    refuse::<Rayon>("(source: (0, 0, 0), direction: (0, 0, 0))", "direction is 0");
    refuse::<Rayon>("(source: (1e200, 0, 0), direction: (0, 0, 1))", "source.x is ");
    let rayon = |suite| format!("(source: (0, 0, 0), direction: (0, 0, 1), {suite})");
    refuse::<Rayon>(&rayon("fin: Some(-1)"), "fin is -1.0");
    refuse::<Rayon>(&rayon("flou: inf"), "flou is inf");
    let touche = |distance, x, marge, indice| {
        format!(
            "(distance: {distance}, normale: ({x}, 0, 0), marge: {marge}, point: (0, 0, 0), flou: 0, \
             texture: (0), indice: {indice})"
        )
    };
    // A hit with these numbers replaced.
    let avec = |ancien, nouveau: &str| touche("1", "1", "None", "3").replace(ancien, nouveau);
    assert!(ron::from_str::<Intersection>(&touche("1", "1", "None", "3")).is_ok());
    refuse::<Intersection>(&touche("-1", "1", "None", "3"), "distance is -1.0");
    refuse::<Intersection>(&touche("inf", "1", "None", "3"), "distance is inf");
    refuse::<Intersection>(&touche("1", "2", "None", "3"), "normale is 2.0");
    // A normal is unit to 32u: 2^-49 is 16u, and 2^-47 is 64u.
    let [presque, trop] = [-49, -47].map(|k| (1.0 + 2.0_f64.powi(k)).to_string());
    assert!(ron::from_str::<Intersection>(&touche("1", &presque, "None", "3")).is_ok());
    refuse::<Intersection>(&touche("1", &trop, "None", "3"), "normale is 1.000");
    refuse::<Intersection>(&avec("point: (0, 0, 0)", "point: (0, NaN, 0)"), "point is NaN");
    for (flou, phrase) in [("-1", "flou is -1"), ("inf", "flou is inf"), ("NaN", "flou is NaN")] {
        refuse::<Intersection>(&avec("flou: 0", &format!("flou: {flou}")), phrase);
    }
    refuse::<Intersection>(&touche("1", "1", "Some(NaN)", "3"), "marge is NaN");
    refuse::<Intersection>(&touche("1", "1", "None", "4294967295"), "indice");
}

/// A box or a half-space whose rotation is left out is not turned.
#[test]
fn une_rotation_omise_ne_tourne_pas() {
    let boite: BoiteGeo =
        ron::from_str("(centre: (0, 1, 2), dimensions: (1, 2, 3), texture: (4))").unwrap();
    let (c, cotes) = (Vecteur::new(0.0, 1.0, 2.0), Vecteur::new(1.0, 2.0, 3.0));
    assert_eq!(boite, BoiteGeo::new(c, cotes, Rotation::IDENTITE, Texture(4)).unwrap());
    // Three angles are no rotation; the page quotes this error.
    let angles = r#"{"Plan": {"rotation": [0, 30, 0], "distance": 2, "texture": 3}}"#;
    let erreur = serde_json::from_str::<ObjetGeo>(angles).unwrap_err().to_string();
    assert!(
        erreur.contains("integer `0`, expected a row of a rotation's matrix at line 1"),
        "{erreur}"
    );
    let coupe = r#"{"Plan": {"rotation": [[1, 0, 0], [0, "#;
    assert!(serde_json::from_str::<ObjetGeo>(coupe).unwrap_err().is_eof());
    let sol = r#"{"Plan": {"distance": 2, "texture": 3}}"#;
    let fond = PlanGeo::new(Rotation::IDENTITE, 2.0, Texture(3)).unwrap();
    assert_eq!(serde_json::from_str::<ObjetGeo>(sol).unwrap(), fond.into());
}

/// A refusal names the field that is missing or unknown.
#[test]
fn un_champ_inconnu_ou_absent_se_nomme() {
    let identite = "((1, 0, 0), (0, 1, 0), (0, 0, 1))";
    let boite = format!("centre: (0, 0, 0), dimensions: (1, 1, 1), rotation: {identite}");
    refuse::<SphereGeo>("(centre: (0, 0, 0), rayon: 1, texture: (0), diametre: 2)", "diametre");
    refuse::<SphereGeo>("(centre: (0, 0, 0), texture: (0))", "rayon");
    refuse::<PlanGeo>(&format!("(rotation: {identite}, texture: (0))"), "distance");
    refuse::<PlanGeo>(&format!("(rotation: {identite}, distance: 1, texture: (0), d: 1)"), "`d`");
    refuse::<BoiteGeo>(&format!("({boite})"), "texture");
    refuse::<BoiteGeo>(&format!("({boite}, texture: (0), largeur: 1)"), "largeur");
    refuse::<Rayon>("(source: (0, 0, 0))", "direction");
    refuse::<Rayon>("(source: (0, 0, 0), direction: (0, 0, 1), longueur: 1)", "longueur");
    let erreur = serde_json::from_str::<Rayon>(r#"{"source": [0, 0, 0], "dir": [0, 0, 1]}"#);
    assert!(erreur.unwrap_err().to_string().contains("unknown field `dir`"));
}

/// A face is written as the name of its variant, also as the key of a map. Other names are refused.
#[test]
fn une_face_s_ecrit_par_son_nom() {
    assert_eq!(relu(&Face::TOUTES), [Face::TOUTES; 2]);
    assert_eq!(ron::to_string(&Face::MoinsZ).unwrap(), "MoinsZ");
    assert_eq!(serde_json::to_string(&Face::PlusX).unwrap(), "\"PlusX\"");
    refuse::<Face>("PlusW", "PlusW");
    assert_eq!(format!("{:>4}|{:<3}|{}", Face::PlusY, Face::MoinsX, Face::MoinsZ), "  +y|-x |-z");
}

/// A whole batch of answers can be saved, misses too.
#[test]
fn une_reponse_manquee_est_relue() {
    let boule = ObjetRay::from(SphereGeo::new(Vecteur::NUL, 1.0, Texture(3)).unwrap());
    let reponses = [4.0, -4.0].map(|z| {
        let rayon = Rayon::new(Vecteur::new(0.0, 0.0, z), Vecteur::new(0.0, 0.0, -1.0)).unwrap();
        boule.intersection(&rayon)
    });
    assert!(reponses[0].is_ok() && reponses[1].is_err());
    assert_eq!(relu(&reponses), [reponses; 2]);
}

/// JSON makes nothing of a hit whose point is beyond the type, as the documents say. No ray starts from such a hit.
#[test]
fn une_touche_hors_du_type_n_est_pas_relue_de_json() {
    let sol = ObjetRay::from(PlanGeo::new(Rotation::IDENTITE, 0.0, Texture(0)).unwrap());
    // t is the largest number, and D exceeds 1 by two roundings.
    let haut = 2.0_f64.powi(424) * (1.0 - f64::EPSILON / 2.0);
    let d = Vecteur::new(1.0 + 2.0 * f64::EPSILON, 0.0, -(2.0_f64.powi(-600)));
    let rayon = Rayon::new(Vecteur::new(0.0, 0.0, haut), d).unwrap();
    let touche = sol.intersection(&rayon).unwrap();
    assert_eq!((touche.distance(), touche.point().x), (f64::MAX, f64::INFINITY));
    assert!(touche.secondaire(Vecteur::Z).is_err());
    assert_eq!(ron::from_str(&ron::to_string(&touche).unwrap()), Ok(touche));
    let json = serde_json::to_string(&touche).unwrap();
    assert!(serde_json::from_str::<Intersection>(&json).is_err(), "{json}");
}

/// A bare vector is the one value that may hold a NaN.
#[test]
fn un_nan_ecrit_en_json_n_est_pas_relu() {
    let texte = serde_json::to_string(&Vecteur::new(f64::NAN, 0.0, f64::INFINITY)).unwrap();
    assert_eq!(texte, "[null,0.0,null]");
    assert!(serde_json::from_str::<Vecteur>(&texte).is_err());
}
