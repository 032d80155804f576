//! [`behind_calls!`]: a jet whose operations are calls.

/// Operators and [`Scalar`](super::Scalar) for a struct that holds one [`Jet`](super::Jet), each
/// operation a call of the jet's own: what computes in it is compiled as calls. What follows in
/// braces is added to the implementation of `Scalar`.
macro_rules! behind_calls {
    ([$($generics:tt)*] $Number:ty, $Inner:ty, { $($also:item)* }) => {
        $crate::scalar::behind_calls!(@operator [$($generics)*] $Number: Add add);
        $crate::scalar::behind_calls!(@operator [$($generics)*] $Number: Sub sub);
        $crate::scalar::behind_calls!(@operator [$($generics)*] $Number: Mul mul);
        $crate::scalar::behind_calls!(@operator [$($generics)*] $Number: Div div);

        impl<$($generics)*> std::ops::Neg for $Number {
            type Output = Self;
            #[inline(never)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl<$($generics)*> $crate::scalar::Scalar for $Number {
            const LANES: usize = <$Inner>::LANES;
            const ENCLOSES: bool = <$Inner>::ENCLOSES;

            #[inline]
            fn seed(v: f64, lane: usize) -> Self {
                Self(<$Inner>::seed(v, lane))
            }
            #[inline]
            fn tangent(&self, lane: usize) -> f64 {
                self.0.tangent(lane)
            }
            #[inline]
            fn value(&self) -> f64 {
                self.0.value()
            }
            #[inline(never)]
            fn is_zero(&self) -> bool {
                self.0.is_zero()
            }
            #[inline(never)]
            fn is_finite(&self) -> bool {
                self.0.is_finite()
            }
            #[inline(never)]
            fn overlaps(&self, other: &Self) -> bool {
                self.0.overlaps(&other.0)
            }
            fn linearised<const K: usize>(
                value: f64,
                gradient: &[f64; K],
                arguments: &[Self; K],
            ) -> Self {
                Self(<$Inner>::linearised(value, gradient, &arguments.map(|a| a.0)))
            }
            #[inline(never)]
            fn powf_slope(self, p: f64, v: Self) -> Self {
                Self(self.0.powf_slope(p, v.0))
            }

            $crate::scalar::behind_calls! { @functions $Inner:
                constant(; ; v: f64)
                rounded(; ; v: f64)
                hull(self; other; )
                with_unknown_tangents(self; ; )
                shift(self; ; c: f64)
                scale(self; ; c: f64)
                over(self; ; c: f64)
                limit_product(self; other; )
                recip(self; ; )
                powi(self; ; n: i32)
                powf(self; ; p: f64)
                pow(self; y; )
                sqrt(self; ; )
                cbrt(self; ; )
                exp(self; ; )
                exp_m1(self; ; )
                ln(self; ; )
                ln_1p(self; ; )
                log10(self; ; )
                sin(self; ; )
                cos(self; ; )
                tan(self; ; )
                asin(self; ; )
                acos(self; ; )
                atan(self; ; )
                atan2(self; x; )
                sinh(self; ; )
                cosh(self; ; )
                tanh(self; ; )
                hypot(self; y; )
                xlogx(self; ; )
                abs(self; ; )
                max(self; other; )
                min(self; other; )
                select(; s, a, b; )
            }

            $($also)*
        }
    };
    (@operator [$($generics:tt)*] $Number:ty: $Op:ident $op:ident) => {
        impl<$($generics)*> std::ops::$Op for $Number {
            type Output = Self;
            #[inline(never)]
            fn $op(self, other: Self) -> Self {
                Self(std::ops::$Op::$op(self.0, other.0))
            }
        }
    };
    (@functions $Inner:ty:
        $($name:ident($($x:ident)?; $($other:ident),*; $($c:ident: $C:ty),*))*
    ) => { $(
        #[inline(never)]
        fn $name($($x,)? $($other: Self,)* $($c: $C),*) -> Self {
            Self(<$Inner>::$name($($x.0,)? $($other.0,)* $($c),*))
        }
    )* };
}
pub(crate) use behind_calls;
