//! A particle in a closed room, in steps of any length, some of which end on a wall, for as long as one likes.

use lancer_rayon::{ErreurGeo, Monde, Rayon, Reel};

/// After this many bounces the particle starts again.
const REBONDS: u32 = 100;

/// How many bounces a step has at most, since a chain of hits need not end.
const REBONDS_D_UN_PAS: u32 = 100_000;

pub struct Particule<R> {
    pub rayon: Rayon<R>,
    rebonds: u32,
}

impl<R: Reel> Particule<R> {
    pub fn new(rayon: Rayon<R>) -> Self {
        Self { rayon, rebonds: 0 }
    }

    /// Goes this far, mirrored by every wall on the way; not so far if a step has had its last bounce.
    pub fn avancer(&mut self, monde: &Monde<'_, R>, mut pas: R) -> Result<(), ErreurGeo> {
        let deux = R::UN + R::UN;
        for _ in 0..REBONDS_D_UN_PAS {
            let Ok(touche) = monde.premiere_intersection(&self.rayon.jusqu_a(pas)?) else {
                // The step ends in mid-air, or on a wall that the ray does not reach: the next step touches that at
                // once.
                self.rayon = self.rayon.bifurque(pas, self.rayon.direction())?;
                break;
            };
            let direction = self.rayon.direction();
            // A bounce may start in a seam, and so may a step that ended on a wall. Only a point amid the way between
            // two walls, and in no object, may replace what is known of a start.
            let milieu = self.rayon.point(touche.distance() / deux);
            if self.rebonds >= REBONDS && touche.distance() > R::ZERO && !monde.contient(milieu) {
                (self.rayon, self.rebonds) = (Rayon::new(milieu, direction)?, 0);
                pas = pas - touche.distance() / deux;
                continue;
            }
            self.rayon = touche.reflechi(direction)?;
            self.rebonds += 1;
            pas = pas - touche.distance();
        }
        Ok(())
    }
}
