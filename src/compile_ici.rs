//! What is compiled in this crate, whoever calls it.

/// `compile_ici! { fn f<'a, R>(x: &'a [R]) -> R { … } }`: the function `f<R: Reel>`, compiled in this crate for
/// `f32` and for `f64`. Whoever calls it, generic or not, compiles a call.
macro_rules! compile_ici {
    ($(
        $(#[$attribut:meta])*
        $visible:vis fn $nom:ident<$vie:lifetime, $R:ident>($($argument:ident: $type:ty),* $(,)?)
            -> $reponse:ty $corps:block
    )*) => {$(
        $(#[$attribut])*
        #[inline]
        $visible fn $nom<$vie, $R: $crate::reel::Reel>($($argument: $type),*) -> $reponse {
            fn generique<$vie, $R: $crate::reel::Reel>($($argument: $type),*) -> $reponse $corps

            struct Ici<$vie>(core::marker::PhantomData<&$vie ()>);

            impl<$vie> $crate::reel::Travail for Ici<$vie> {
                type Arguments<$R: $crate::reel::Reel> = ($($type,)*);
                type Reponse<$R: $crate::reel::Reel> = $reponse;

                fn en_f32(($($argument,)*): Self::Arguments<f32>) -> Self::Reponse<f32> {
                    generique($($argument),*)
                }

                fn en_f64(($($argument,)*): Self::Arguments<f64>) -> Self::Reponse<f64> {
                    generique($($argument),*)
                }
            }

            $R::faire::<Ici<$vie>>(($($argument,)*))
        }
    )*};
}
pub(crate) use compile_ici;
