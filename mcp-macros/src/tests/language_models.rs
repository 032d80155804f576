//! Four models the language must be able to say, without the parts that are not available yet.

/// General equilibrium with taxes: calibrated share form.
pub(super) const CGE: &str = r"
/// CGE: Y = CES(VA(factors), intermediates); factor and output tax; calibrated share form, base prices 1
pub model Cge {
  data { sectors: Set, factors: Set[labor, capital],
         y0[sectors]: f64, va0[sectors]: f64, id0[sectors, sectors]: f64, fd0[factors, sectors]: f64,
         c0[sectors]: f64, g0[sectors]: f64, fbar[factors]: f64, tf0[factors, sectors]: f64,
         sva[sectors]: f64, sy[sectors]: f64, sc: f64 }
  param ty[s in sectors] = 0.0;
  /// activity level [base = 1]
  var y[s in sectors] >= 0.0 start 1.0;    var p[s in sectors] >= 1e-9 start 1.0;
  var pf[f in factors] >= 1e-9 start 1.0;  var hh free start sum(factors, |f| fbar[f]);
  var gov free start sum(sectors, |s| g0[s]);
  fix pf[labor] = 1.0;
  def pfu[f in factors, s in sectors]: pf[f] / (1.0 + tf0[f, s]);
  def cva[s in sectors]: ces(sva[s], factors, |f| (fd0[f, s] / va0[s], pfu[f, s]));
  def cin[s in sectors]: cobb(sectors, |k| (id0[k, s], p[k]));
  def cy[s in sectors]:  ces2(sy[s], va0[s] / (y0[s] * (1.0 - ty.base(s))), cva[s], cin[s]);
  def df[f in factors, s in sectors]: fd0[f,s] * y[s] * (cy[s]/cva[s]).pow(sy[s]) * (cva[s]/pfu[f,s]).pow(sva[s]);
  def cpi: ces(sc, sectors, |s| (c0[s] / c0.sum(), p[s]));
  eq zero_profit[s in sectors]: cy[s] * (1.0 - ty.base(s)) - p[s] * (1.0 - ty[s]) complements y[s];
  eq goods[s in sectors]: y0[s] * y[s] - sum(sectors, |k| id0[s, k] * y[k] * (cy[k]/cin[k]).pow(sy[k]) * cin[k]/p[s])
       - c0[s] / c0.sum() * hh / cpi * (cpi/p[s]).pow(sc) - g0[s] * gov / (g0.sum() * p[s]) complements p[s];
  eq endow[f in factors]: fbar[f] - sum(sectors, |s| df[f, s]) complements pf[f];
  eq income: hh - sum(factors, |f| pf[f] * fbar[f]) complements hh;
  eq budget: gov - sum(sectors, |s| ty[s] * p[s] * y0[s] * y[s]) complements gov;
  report welfare: hh / cpi / c0.sum(); }
";

/// Hourly dispatch with a network and cyclic storage.
pub(super) const POWER: &str = r"
/// power: hourly dispatch, network, cyclic storage, scarcity, optional CO2 cap
pub model Power {
  data { nodes: Set, hours: Ordered, gens: Set, stores: Set, thermal: Subset(gens), lines: Pairs(nodes, nodes),
         site: Map(gens, nodes), place: Map(stores, nodes), load[nodes, hours]: f64, cap[gens]: f64,
         avail[gens, hours]: f64, fuel[gens]: f64, fmax[lines]: f64, smax[stores]: f64, pw[stores]: f64, eta: f64, voll: f64 }
  var q[g in gens, t in hours] in 0.0..=cap[g] * avail[g, t];
  var f[l in lines, t in hours] in -fmax[l]..=fmax[l];
  var shed[n in nodes, t in hours] in 0.0..=load[n, t];    var p[n in nodes, t in hours] >= 0.0;
  var ch[k in stores, t in hours] in 0.0..=pw[k];          var dis[k in stores, t in hours] in 0.0..=pw[k];
  var s[k in stores, t in hours] in 0.0..=smax[k];         var v[k in stores, t in hours] free;
  def mc[g in gens]: fuel[g];
  eq run[g in gens, t in hours]: mc[g] - p[site[g], t] complements q[g, t];
  eq flow[l @ (i, j) in lines, t in hours]: p[i, t] - p[j, t] complements f[l, t];
  eq scarcity[n in nodes, t in hours]: voll - p[n, t] complements shed[n, t];
  eq market[n in nodes, t in hours]: sum(site.of(n), |g| q[g, t]) + sum(place.of(n), |k| dis[k, t] - ch[k, t])
     + sum(lines.into(n), |l| f[l, t]) - sum(lines.out_of(n), |l| f[l, t]) + shed[n, t] - load[n, t] complements p[n, t];
  eq charge[k in stores, t in hours]: p[place[k], t] - eta * v[k, t] complements ch[k, t];
  eq discharge[k in stores, t in hours]: v[k, t] - p[place[k], t] complements dis[k, t];
  eq hold[k in stores, t in hours]: v[k, t] - v[k, hours.wrap(t, 1)] complements s[k, t];
  eq level[k in stores, t in hours]: s[k, hours.wrap(t, -1)] + eta*ch[k, t] - dis[k, t] - s[k, t] complements v[k, t]; }
";

/// Spatial price equilibrium on existing arcs.
pub(super) const SPATIAL: &str = r"
/// spatial price equilibrium on existing arcs
pub model Spatial {
  data { regions: Set, arcs: Pairs(regions, regions), cost[arcs]: f64, cap[arcs]: f64,
         a[regions]: f64, b[regions]: f64, d0[regions]: f64, p0[regions]: f64, eps[regions]: f64 }
  var x[r in arcs] in 0.0..=cap[r];   var y[i in regions] >= 0.0;   var p[i in regions] >= 1e-9 start p0[i];
  eq arbitrage[r @ (i, j) in arcs]: p[i] + cost[r] - p[j] complements x[r];
  eq supply[i in regions]: a[i] + b[i] * y[i] - p[i] complements y[i];
  eq market[i in regions]: y[i] + sum(arcs.into(i), |r| x[r]) - sum(arcs.out_of(i), |r| x[r])
                           - d0[i] * (p[i] / p0[i]).pow(-eps[i]) complements p[i];
  report trade[r @ (i, j) in arcs]: p[i] * x[r]; }
";

/// One step of planar contact with friction.
pub(super) const CONTACT_STEP: &str = r"
/// one Moreau–Jean step, planar bodies (x, y, angle); active contacts are data; ground: winv = 0
pub model ContactStep {
  data { bodies: Set, dof: 3, contacts: Pairs(bodies, bodies), vfree[bodies, dof]: f64, winv[bodies, dof]: f64,
         na[contacts, dof]: f64, nb[contacts, dof]: f64, ta[contacts, dof]: f64, tb[contacts, dof]: f64,
         mu[contacts]: f64, e[contacts]: f64, un0[contacts]: f64, rho[contacts]: f64 }
  var rn[c in contacts] >= 0.0;    var rt[c in contacts] free;
  def v[b in bodies, k in dof] lifted: vfree[b, k] + winv[b, k]
       * (sum(contacts.out_of(b), |c| na[c, k] * rn[c] + ta[c, k] * rt[c]) + sum(contacts.into(b), |c| nb[c, k] * rn[c] + tb[c, k] * rt[c]));
  eq impact[c @ (a, b) in contacts]: sum(dof, |k| na[c, k] * v[a, k] + nb[c, k] * v[b, k]) + e[c] * un0[c] complements rn[c];
  eq slip[c @ (a, b) in contacts]: { let ut = sum(dof, |k| ta[c, k] * v[a, k] + tb[c, k] * v[b, k]);
       rt[c] - (rt[c] - rho[c] * ut).clamp(-mu[c] * rn[c], mu[c] * rn[c]) } complements rt[c]; }
";
