//! Texts without parts: each knows its own effects, written into it, and no other.

/// `text!(Protected tariff [+ , ;] quota [+ , ;])`: the economy with these effects, in the order in which
/// it declares them. An effect brings the signs before its terms, behind its data and behind its items;
/// where it is not named, none of these is in the text.
macro_rules! text {
    ($name:ident
        $(tax [$tax:tt $tax_data:tt $tax_item:tt])?
        $(tariff [$tariff:tt $tariff_data:tt $tariff_item:tt])?
        $(quota [$quota:tt $quota_data:tt $quota_item:tt])?
        $(emission_cap [$cap:tt $cap_data:tt $cap_item:tt])?
        $(markup [$markup:tt $markup_data:tt $markup_item:tt])?
        $(rationing [$rationing:tt $rationing_data:tt $rationing_item:tt])?
    ) => {
        mcp! {
            #[allow(dead_code, reason = "a twin is solved and looked at as a whole")]
            model $name {
                data {
                    households: Set, sectors: Set, traded: Subset(sectors),
                    labor[households]: f64, share[households, sectors]: f64, hours[sectors]: f64,
                    cif[traded]: f64, fob[traded]: f64, reference[sectors]: f64,
                    $(tax_to[households]: f64 $tax_data)?
                    $(duty_to[households]: f64 $tariff_data)?
                    $(import_limit[traded]: f64, licences_to[households]: f64 $quota_data)?
                    $(emission_limit: f64, intensity[sectors]: f64, permits_to[households]: f64 $cap_data)?
                    $(profits_to[households]: f64 $markup_data)?
                    $(ration[households, sectors]: f64 $rationing_data)?
                }
                $(param tax_rate[s in sectors] $tax_item)?
                $(param duty_rate[i in traded] $tariff_item)?
                $(param markup_rate[s in sectors] $markup_item)?

                var y[s in sectors] >= 0.0 start 1.0;
                var p[s in sectors] >= 0.0 start reference[s];
                var w >= 0.0 start 20.0;
                var m[s in sectors] >= 0.0 if traded.contains(s);
                var x[s in sectors] >= 0.0 if traded.contains(s);
                var e >= 0.0 start 1.0;
                var income[h in households] free start 20.0 * labor[h];
                $(var revenue free start labor.sum() $tax_item)?
                $(var rent[i in traded] >= 0.0 if import_limit[i].is_finite() $quota_item)?
                $(var permit >= 0.0 $cap_item)?
                $(var scarcity[h in households, s in sectors] >= 0.0
                    if ration[h, s].is_finite() $rationing_item)?
                fix e = 1.0;

                def cost[s in sectors]: hours[s] * w $($cap intensity[s] * permit)?;
                def landed[i in traded]:
                    cif[i] * e $($tariff duty_rate[i] * cif[i] * e)? $($quota rent[i])?;
                def means[h in households]: income[h]
                    $($rationing sum(sectors, |s| {
                        when(ration[h, s].is_finite(), || ration[h, s] * scarcity[h, s])
                    }))?;
                def paid[h in households, s in sectors]:
                    p[s] $($tax tax_rate[s] * p[s])? $($rationing scarcity[h, s])?;
                def demand[h in households, s in sectors]: share[h, s] * means[h] / paid[h, s];
                $(def duties: sum(traded, |i| duty_rate[i] * cif[i] * e * m[i]) $tariff_item)?
                $(def rents: sum(traded, |i| rent[i] * m[i]) $quota_item)?
                $(def emissions: sum(sectors, |s| intensity[s] * y[s]) $cap_item)?
                $(def profits: sum(sectors, |s| markup_rate[s] * cost[s] * y[s]) $markup_item)?

                eq profit[s in sectors]: cost[s] - p[s] $($markup markup_rate[s] * cost[s])?
                    complements y[s];
                eq market[s in sectors]: y[s] + m[s] - x[s] >= sum(households, |h| demand[h, s])
                    complements p[s];
                eq employment: labor.sum() >= sum(sectors, |s| hours[s] * y[s])    complements w;
                eq import[i in traded]: landed[i] - p[i]    complements m[i];
                eq export[i in traded]: p[i] - fob[i] * e    complements x[i];
                eq budget[h in households]: w * labor[h] - income[h]
                    $($tax tax_to[h] * revenue)?
                    $($tariff duty_to[h] * duties)?
                    $($quota licences_to[h] * rents)?
                    $($cap permits_to[h] * (permit * emissions))?
                    $($markup profits_to[h] * profits)?
                    complements income[h];
                eq balance: sum(traded, |i| fob[i] * x[i] - cif[i] * m[i])    complements e;
                $(eq treasury: revenue
                    == sum(sectors, |s| tax_rate[s] * p[s] * sum(households, |h| demand[h, s]))
                    complements revenue $tax_item)?
                $(eq licences[i in traded]: import_limit[i] >= m[i]    complements rent[i] $quota_item)?
                $(eq cap: emission_limit >= emissions    complements permit $cap_item)?
                $(eq coupons[h in households, s in sectors]: ration[h, s] >= demand[h, s]
                    complements scarcity[h, s] $rationing_item)?

                report welfare[h in households]:
                    cobb(sectors, |s| (share[h, s], reference[s] * demand[h, s] / share[h, s]));
            }
        }
    };
}

pub(crate) use text;
