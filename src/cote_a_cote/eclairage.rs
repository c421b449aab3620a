//! Sixteen hits, and the shadow rays from them to a light, side by side.

use arrayvec::ArrayVec;

use crate::cote_a_cote::bloc::BLOC;
use crate::cote_a_cote::colonne::Colonne;
use crate::cote_a_cote::groupe::VOIES;
use crate::rayon::intersection::{Contact, Rang};
use crate::{Intersection, Lumiere, Nombre, Rayon, Reponse, Texture, Vecteur};

/// The shadow rays of a block of hits.
pub(crate) type Ombres<R> = ArrayVec<Rayon<R>, BLOC>;

/// The numbers of sixteen hits, of their shadow rays, and N·L of each. A column has one number of
/// each.
#[repr(align(64))]
pub(crate) struct Eclairage<R> {
    /// N, P, the margin, t and δ.
    touches: [Colonne<R>; 9],
    /// S, D, the end and δ.
    rayons: [Colonne<R>; 8],
    cosinus: Colonne<R>,
}

impl<R: Nombre> Eclairage<R> {
    pub(crate) const VIDE: Self = Self {
        touches: [[R::ZERO; VOIES]; 9],
        rayons: [[R::ZERO; VOIES]; 8],
        cosinus: [R::ZERO; VOIES],
    };

    /// Writes N·L of each of these hits, and puts the shadow rays of those for which it is above 0
    /// behind `ombres`; it is 0 for a miss and where the surface faces away from the light.
    #[inline(always)]
    pub(crate) fn ombres(
        &mut self,
        touches: &[Reponse<R>],
        lumiere: Lumiere<R>,
        (cosinus, ombres): (&mut [R], &mut Ombres<R>),
    ) {
        for (touches, cosinus) in touches.chunks(VOIES).zip(cosinus.chunks_mut(VOIES)) {
            if touches.iter().all(Result::is_err) {
                cosinus.fill(R::ZERO);
                continue;
            }
            for (voie, touche) in touches.iter().enumerate() {
                self.charger(voie, touche);
            }
            // Lanes without a hit compute what nobody reads.
            for voie in 0..VOIES {
                self.eclairer(voie, lumiere);
            }
            for (voie, cosinus) in cosinus.iter_mut().enumerate() {
                *cosinus = self.cosinus[voie];
                if *cosinus > R::ZERO {
                    ombres.push(self.ombre(voie));
                }
            }
        }
    }

    #[inline(always)]
    fn charger(&mut self, voie: usize, touche: &Reponse<R>) {
        let [nx, ny, nz, px, py, pz, marge, t, delta] = &mut self.touches;
        let Ok(touche) = touche else {
            // As of a hit that no ray starts from.
            marge[voie] = R::INFINI;
            return;
        };
        [nx[voie], ny[voie], nz[voie]] = touche.normale().into();
        [px[voie], py[voie], pz[voie]] = touche.point().into();
        (marge[voie], t[voie], delta[voie]) = (touche.marge(), touche.distance(), touche.delta);
    }

    #[inline(always)]
    fn eclairer(&mut self, voie: usize, lumiere: Lumiere<R>) {
        let [nx, ny, nz, px, py, pz, marge, distance, delta] =
            self.touches.each_ref().map(|colonne| colonne[voie]);
        let (normale, point) = (Vecteur::new(nx, ny, nz), Vecteur::new(px, py, pz));
        let contact = Contact { normale, marge, point };
        // Of which object it is a hit does not matter.
        let (texture, rang) = (Texture(0), Rang::de(0));
        let touche = Intersection { distance, contact, delta, texture, rang };
        let (ombre, cosinus, eclaire) = touche.vers(|source| lumiere.vue_cote_a_cote(source));
        let [sx, sy, sz, dx, dy, dz, fin, flou] = &mut self.rayons;
        [sx[voie], sy[voie], sz[voie]] = ombre.source().into();
        [dx[voie], dy[voie], dz[voie]] = ombre.direction().into();
        (fin[voie], flou[voie]) = (ombre.fin(), ombre.flou());
        self.cosinus[voie] = if eclaire { cosinus } else { R::ZERO };
    }

    #[inline(always)]
    fn ombre(&self, voie: usize) -> Rayon<R> {
        let [sx, sy, sz, dx, dy, dz, fin, flou] =
            self.rayons.each_ref().map(|colonne| colonne[voie]);
        Rayon::en_nombres(Vecteur::new(sx, sy, sz), Vecteur::new(dx, dy, dz), fin, flou)
    }
}
