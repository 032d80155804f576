//! The economy and its effects.

use super::data::{CIF, FOB, HOURS, HOUSEHOLDS, LABOR, REFERENCE, SECTORS, SHARE, TRADED};
use super::effect::Effect;
use mcp_core::economics::cobb;
use mcp_core::{ModelError, mcp};

mcp! {
    /// Households buy what sectors make of labor, and what the world sells.
    pub(crate) model Economy {
        data {
            households: Set, sectors: Set, traded: Subset(sectors),
            /// labor of a household [Mh]
            labor[households]: f64,
            /// part of its means that a household spends on a good
            share[households, sectors]: f64,
            /// labor in a unit of a good [h]
            hours[sectors]: f64,
            /// what a unit costs on its way into the country, and what it brings on its way out [$]
            cif[traded]: f64, fob[traded]: f64,
            /// price at which welfare is measured [$]
            reference[sectors]: f64,
        }
        // Starts have the size of what is looked for: `Robust` scales by them.
        /// output [M]
        var y[s in sectors] >= 0.0 start 1.0;
        /// price [$]
        var p[s in sectors] >= 0.0 start reference[s];
        /// wage [$/h]
        var w >= 0.0 start 20.0;
        /// imports [M]
        var m[s in sectors] >= 0.0 if traded.contains(s);
        /// exports [M]
        var x[s in sectors] >= 0.0 if traded.contains(s);
        /// price of foreign exchange [$/$]
        var e >= 0.0 start 1.0;
        /// income [M$]
        var income[h in households] free start 20.0 * labor[h];
        fix e = 1.0;

        /// cost of a unit [$]
        def cost[s in sectors]: hours[s] * w;
        /// cost of an imported unit [$]
        def landed[i in traded]: cif[i] * e;
        /// what a household divides among the goods [M$]
        def means[h in households]: income[h];
        /// what a household counts as the price [$]
        def paid[h in households, s in sectors]: p[s];
        /// demand [M]
        def demand[h in households, s in sectors]: share[h, s] * means[h] / paid[h, s];

        eq profit[s in sectors]: cost[s] - p[s]                                    complements y[s];
        eq market[s in sectors]: y[s] + m[s] - x[s] >= sum(households, |h| demand[h, s])
                                                                                   complements p[s];
        eq employment: labor.sum() >= sum(sectors, |s| hours[s] * y[s])            complements w;
        eq import[i in traded]: landed[i] - p[i]                                   complements m[i];
        eq export[i in traded]: p[i] - fob[i] * e                                  complements x[i];
        eq budget[h in households]: w * labor[h] - income[h]                       complements income[h];
        eq balance: sum(traded, |i| fob[i] * x[i] - cif[i] * m[i])                 complements e;

        /// income that buys the same welfare at the reference prices [M$]
        report welfare[h in households]:
            cobb(sectors, |s| (share[h, s], reference[s] * demand[h, s] / share[h, s]));

        /// Households pay a tax on what they buy; the yield is theirs.
        part tax {
            /// tax, a part of the price
            param tax_rate[s in sectors];
            data {
                /// part of the yield that a household gets
                tax_to[households]: f64,
            }
            /// yield of the tax [M$]
            var revenue free start labor.sum();
            eq treasury: revenue
                == sum(sectors, |s| tax_rate[s] * p[s] * sum(households, |h| demand[h, s]))
                                                                                   complements revenue;
            adds paid[h, s]: tax_rate[s] * p[s];
            adds budget[h]: tax_to[h] * revenue;
        }

        /// Imports pay a duty on what they cost.
        part tariff {
            /// duty, a part of the price on the way into the country
            param duty_rate[i in traded];
            data {
                /// part of the yield that a household gets
                duty_to[households]: f64,
            }
            /// yield of the duties [M$]
            def duties: sum(traded, |i| duty_rate[i] * cif[i] * e * m[i]);
            adds landed[i]: duty_rate[i] * cif[i] * e;
            adds budget[h]: duty_to[h] * duties;
        }

        /// No more than a limit may come in; who has a licence earns its rent. A good whose limit is
        /// infinite needs none.
        part quota {
            data {
                /// most imports [M]
                import_limit[traded]: f64,
                /// part of the licences that a household has
                licences_to[households]: f64,
            }
            /// rent of a licence [$]
            var rent[i in traded] >= 0.0 if import_limit[i].is_finite();
            /// what licences bring [M$]
            def rents: sum(traded, |i| rent[i] * m[i]);
            eq licences[i in traded]: import_limit[i] >= m[i]                      complements rent[i];
            adds landed[i]: rent[i];
            adds budget[h]: licences_to[h] * rents;
        }

        /// Who emits needs a permit; there are so many.
        part emission_cap {
            data {
                /// permits [Mt]
                emission_limit: f64,
                /// emissions of a unit [t]
                intensity[sectors]: f64,
                /// part of what permits bring that a household gets
                permits_to[households]: f64,
            }
            /// price of a permit [$/t]
            var permit >= 0.0;
            /// emissions [Mt]
            def emissions: sum(sectors, |s| intensity[s] * y[s]);
            eq cap: emission_limit >= emissions                                    complements permit;
            adds cost[s]: intensity[s] * permit;
            adds budget[h]: permits_to[h] * (permit * emissions);
        }

        /// Monopolies sell above their cost.
        part markup {
            /// what is added to the cost, a part of it
            param markup_rate[s in sectors];
            data {
                /// part of the profits that a household gets
                profits_to[households]: f64,
            }
            /// profits of the monopolies [M$]
            def profits: sum(sectors, |s| markup_rate[s] * cost[s] * y[s]);
            adds profit[s]: markup_rate[s] * cost[s];
            adds budget[h]: profits_to[h] * profits;
        }

        /// A household may buy so much of a good. It behaves as if it paid the scarcity on top of the
        /// price, and had it back as income; an infinite ration is none.
        part rationing {
            data {
                /// the most a household may buy of a good [M]
                ration[households, sectors]: f64,
            }
            /// what one more coupon would be worth to a household [$]
            var scarcity[h in households, s in sectors] >= 0.0 if ration[h, s].is_finite();
            eq coupons[h in households, s in sectors]: ration[h, s] >= demand[h, s]
                                                                                   complements scarcity[h, s];
            adds means[h]:
                sum(sectors, |s| when(ration[h, s].is_finite(), || ration[h, s] * scarcity[h, s]));
            adds paid[h, s]: scarcity[h, s];
        }
    }
}

impl Economy {
    /// Workers and merchants; food is imported, tools are exported.
    pub(crate) fn illustrative() -> Result<Self, ModelError> {
        Economy::builder()
            .households(HOUSEHOLDS)
            .sectors(SECTORS)
            .traded(TRADED)
            .labor(LABOR)
            .share(SHARE)
            .hours(HOURS)
            .cif(CIF)
            .fob(FOB)
            .reference(REFERENCE)
            .build()
    }

    /// The economy with these effects.
    ///
    /// # Errors
    /// Those of [`with`](Economy::with).
    pub(crate) fn with_effects(effects: &[Effect]) -> Result<Self, ModelError> {
        effects.iter().try_fold(Economy::illustrative()?, |economy, effect| match *effect {
            Effect::Tax { rate, to } => economy.with(Tax { tax_rate: rate, tax_to: to }),
            Effect::Tariff { rate, to } => economy.with(Tariff { duty_rate: rate, duty_to: to }),
            Effect::Quota { limit, to } => {
                economy.with(Quota { import_limit: limit, licences_to: to })
            }
            Effect::EmissionCap { limit, intensity, to } => {
                economy.with(EmissionCap { emission_limit: limit, intensity, permits_to: to })
            }
            Effect::Markup { rate, to } => {
                economy.with(Markup { markup_rate: rate, profits_to: to })
            }
            Effect::Rationing { limit } => economy.with(Rationing { ration: limit }),
        })
    }
}
