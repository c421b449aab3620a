//! The macro that has a question compiled here, once for each scalar, whoever asks it.

/// `compilees! { Nom: De => Reponse = f; … }`: the [`Question`](crate::reel::Question) `Nom`, which
/// `f::<f32>` and `f::<f64>` answer. `R::demander` asks it of either.
macro_rules! compilees {
    ($($question:ident<$vie:lifetime, $R:ident>: $de:ty => $reponse:ty = $f:ident;)*) => {$(
        #[doc = concat!("[`", stringify!($f), "`], compiled here.")]
        pub(crate) struct $question;

        impl $crate::reel::Question for $question {
            type De<$vie, $R: $crate::reel::Reel> = $de;
            type Reponse<$vie, $R: $crate::reel::Reel> = $reponse;

            fn en_f32(de: Self::De<'_, f32>) -> Self::Reponse<'_, f32> {
                $f(de)
            }

            fn en_f64(de: Self::De<'_, f64>) -> Self::Reponse<'_, f64> {
                $f(de)
            }
        }
    )*};
}
pub(crate) use compilees;
