//! What is written is read back to the bit.

use std::fmt::Debug;

use serde::Serialize;
use serde::de::DeserializeOwned;

pub fn relire<T: Serialize + DeserializeOwned + Debug>(valeur: &T) {
    let texte = ron::to_string(valeur).unwrap();
    let relue = ron::from_str::<T>(&texte).map(|relue| format!("{relue:?}"));
    // `Debug` tells −0 from 0.
    assert_eq!(relue, Ok(format!("{valeur:?}")), "{texte}");
}
