//! Conversions from and to glam, compared with what glam does.

use std::error::Error;

use lancer_rayon::{Rotation, Vecteur};
use parry3d_f64::glamx::{DMat3, DQuat, DVec3, EulerRot};

/// An error unless a rotation and the matrix or the quaternion that stands for it turn a vector alike.
pub(crate) fn verifier() -> Result<(), Box<dyn Error>> {
    let (x, y, z) = (0.3, -1.1, 2.0);
    let r = Rotation::main_droite(Vecteur::new(x, y, z))?;
    let m = DMat3::from_euler(EulerRot::ZYX, z, y, x);
    let v = [1.0, 2.0, 3.0];
    let attendu = m * DVec3::from(v);
    let depuis = Rotation::<f64>::depuis_matrice(m.to_cols_array_2d())?;
    let q = DQuat::from_euler(EulerRot::ZYX, z, y, x);
    let du_quaternion = Rotation::<f64>::depuis_quaternion(q.to_array())?;
    let obtenus = [
        r.appliquer(v.into()).into(),
        depuis.appliquer(v.into()).into(),
        du_quaternion.appliquer(v.into()).into(),
        (DMat3::from_cols_array_2d(&r.matrice()) * DVec3::from(v)).to_array(),
    ];
    for obtenu in obtenus {
        if (DVec3::from(obtenu) - attendu).length() > 1e-14 {
            return Err("glam turns another way".into());
        }
    }
    Ok(())
}
