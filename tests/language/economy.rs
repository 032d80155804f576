//! Two goods with any of three parts: a tax, a cap on what is dirty, quotas.

/// The economy with these parts in its text, `tax`, `cap` and `quota` in this order.
macro_rules! economy {
    (@ { $($parts:tt)* }) => {
        mcp_core::mcp! {
            /// Two goods, their prices, and the income of those who make them.
            pub(crate) model Economy {
                data { goods: Set, cost[goods]: f64, slope[goods]: f64, demand[goods]: f64, dirty: Subset(goods) }
                var y[g in goods] >= 0.0 start 1.0;
                var p[g in goods] >= 0.0 start 1.0;
                var income free start 10.0;
                def price[g in goods]: p[g];
                def unit_cost[g in goods]: cost[g] + slope[g] * y[g];
                eq profit[g in goods]: unit_cost[g] - p[g]                 complements y[g];
                eq market[g in goods]: y[g] >= demand[g] - price[g]        complements p[g];
                eq earned: income - sum(goods, |g| p[g] * y[g])            complements income;
                report welfare: income - sum(goods, |g| unit_cost[g] * y[g]);
                $($parts)*
            }
        }
    };
    (@ { $($parts:tt)* } tax $($rest:ident)*) => {
        economy!(@ { $($parts)*
            /// A tax on what is bought, which falls to those who make it.
            part tax {
                param rate[g in goods] = 0.25;
                adds price[g]: rate[g] * p[g];
                adds earned: -sum(goods, |g| rate[g] * p[g] * y[g]);
            }
        } $($rest)*);
    };
    (@ { $($parts:tt)* } cap $($rest:ident)*) => {
        economy!(@ { $($parts)*
            /// A cap on what is dirty, with permits.
            part cap {
                data { limit: f64, dirt[dirty]: f64 }
                /// price of a permit
                var permit >= 0.0;
                eq within: limit - sum(dirty, |g| dirt[g] * y[g])          complements permit;
                adds unit_cost[g in dirty]: dirt[g] * permit;
                adds earned: -permit * limit;
                report paid: permit * limit;
            }
        } $($rest)*);
    };
    (@ { $($parts:tt)* } quota $($rest:ident)*) => {
        economy!(@ { $($parts)*
            /// Most of a good that may be made.
            part quota {
                data { most[goods]: f64 }
                var rent[g in goods] >= 0.0;
                eq under[g in goods]: most[g] - y[g]                       complements rent[g];
                adds profit[g]: rent[g];
                adds earned: -sum(goods, |g| rent[g] * y[g]);
            }
        } $($rest)*);
    };
    ($($part:ident)*) => {
        economy!(@ {} $($part)*);

        /// Bread and steel.
        pub(crate) fn economy() -> Economy {
            Economy::builder()
                .goods(["bread", "steel"])
                .cost([1.0, 2.0])
                .slope([0.5, 0.25])
                .demand([10.0, 12.0])
                .dirty(["steel"])
                .build()
                .unwrap()
        }
    };
}

/// With all three parts in the text.
pub(crate) mod full {
    economy!(tax cap quota);
}
/// Texts that never heard of some of the parts.
pub(crate) mod plain {
    economy!();
}
/// Only the tax.
pub(crate) mod tax {
    economy!(tax);
}
/// Only the cap.
pub(crate) mod cap {
    economy!(cap);
}
/// Only the quotas.
pub(crate) mod quota {
    economy!(quota);
}
/// No quotas.
pub(crate) mod tax_cap {
    economy!(tax cap);
}
/// No cap.
pub(crate) mod tax_quota {
    economy!(tax quota);
}
/// No tax.
pub(crate) mod cap_quota {
    economy!(cap quota);
}

/// Limit of the cap: without it 8 t of steel are made.
pub(crate) const LIMIT: f64 = 3.0;
/// Dirt of a tonne of steel.
pub(crate) const DIRT: f64 = 1.0;
/// Quotas: without them 6 t of bread are made.
pub(crate) const MOST: [f64; 2] = [2.0, 100.0];
