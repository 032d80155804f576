//! Every set of effects against one program by hand, in plain Rust: the 64 economies have the names, the
//! nonzeros, the operations, and bit for bit the values, derivatives and iterates of what is written
//! here, whatever is off.

use super::by_hand::definition::{COST, DEMAND};
use super::by_hand::variable::{E, M, OF_EFFECT, P, Y};
use super::by_hand::{self, base_def, base_row, base_shape};
use super::economy::data::{CIF, HOUSEHOLDS, LABOR, SECTORS};
use super::economy::effect::Effect;
use super::economy_with;
use super::laws::sets;
use super::sample::{
    DUTY, EMISSIONS, INTENSITY, MARKUP, QUOTA, RATION, TAX, TO_BOTH, TO_MERCHANTS,
};
use super::twins::assert_twins;
use mcp_core::{
    AdProblem, Definition, Equation, Model, Parameter, Problem, Reader, Real, Scalar, Set, Shape,
    Variable, sum, when,
};

/// An effect, or what it brings.
type Name = &'static str;

/// The economy with these effects on.
struct ByHand {
    shape: Shape,
    on: Vec<Name>,
    /// Definitions and equations behind those of the base.
    definitions: Vec<Name>,
    equations: Vec<Name>,
}

impl ByHand {
    fn new(effects: &[Effect]) -> Self {
        let name = |effect: &Effect| match effect {
            Effect::Tax { .. } => "tax",
            Effect::Tariff { .. } => "tariff",
            Effect::Quota { .. } => "quota",
            Effect::EmissionCap { .. } => "emission_cap",
            Effect::Markup { .. } => "markup",
            Effect::Rationing { .. } => "rationing",
        };
        let on = effects.iter().map(name).collect();
        let (shape, definitions, equations) = (Shape::default(), Vec::new(), Vec::new());
        let mut economy = ByHand { shape, on, definitions, equations };
        economy.declare();
        economy
    }

    fn has(&self, effect: Name) -> bool {
        self.on.contains(&effect)
    }

    /// Families of the base, then those of the effects in the order of the text.
    fn declare(&mut self) {
        let sectors = Set::new("sectors", SECTORS).unwrap();
        let households = Set::new("households", HOUSEHOLDS).unwrap();
        let traded = Set::new("traded", ["food", "tools"]).unwrap();
        // Food is limited, and rationed for both households.
        let limited = Set::new("limited", ["food"]).unwrap();
        let rationed = [0, 3];
        let mut shape = base_shape();
        let mut pairs = Vec::new();
        if self.has("tax") {
            shape = shape
                .parameter(Parameter::new("tax_rate", TAX).over(&[&sectors]))
                .variable(Variable::new("revenue").start(LABOR.iter().sum::<f64>()));
            pairs.push(Equation::new("treasury").complements("revenue"));
            self.equations.push("treasury");
        }
        if self.has("tariff") {
            shape = shape.parameter(Parameter::new("duty_rate", DUTY).over(&[&traded]));
            self.definitions.push("duties");
        }
        if self.has("quota") {
            shape = shape.variable(Variable::new("rent").over(&[&limited]).lower(0.0));
            pairs.push(Equation::new("licences").over(&[&limited]).complements("rent"));
            self.definitions.push("rents");
            self.equations.push("licences");
        }
        if self.has("emission_cap") {
            shape = shape.variable(Variable::new("permit").lower(0.0));
            pairs.push(Equation::new("cap").complements("permit"));
            self.definitions.push("emissions");
            self.equations.push("cap");
        }
        if self.has("markup") {
            shape = shape.parameter(Parameter::new("markup_rate", MARKUP).over(&[&sectors]));
            self.definitions.push("profits");
        }
        if self.has("rationing") {
            let over = [&households, &sectors];
            let scarcity = Variable::new("scarcity").over(&over).only(rationed).lower(0.0);
            shape = shape.variable(scarcity);
            let coupons = Equation::new("coupons").over(&over).only(rationed);
            pairs.push(coupons.complements("scarcity"));
            self.equations.push("coupons");
        }
        for pair in pairs {
            shape = shape.equation(pair);
        }
        for &name in &self.definitions {
            shape = shape.definition(Definition::new(name));
        }
        self.shape = shape.build().unwrap();
    }

    fn revenue<D: Scalar>(read: &Reader<'_, D>) -> Real<D> {
        read.var(OF_EFFECT)
    }
    fn rent<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        when(i == 0, || read.var(OF_EFFECT + usize::from(self.has("tax"))))
    }
    fn permit<D: Scalar>(&self, read: &Reader<'_, D>) -> Real<D> {
        read.var(OF_EFFECT + usize::from(self.has("tax")) + usize::from(self.has("quota")))
    }
    fn scarcity<D: Scalar>(&self, h: usize, s: usize, read: &Reader<'_, D>) -> Real<D> {
        when(s == 0, || read.var(self.shape.n() - 2 + h))
    }
    fn duty_rate<D: Scalar>(&self, i: usize, read: &Reader<'_, D>) -> Real<D> {
        read.param(if self.has("tax") { 3 } else { 0 } + i)
    }
    fn markup_rate<D: Scalar>(&self, s: usize, read: &Reader<'_, D>) -> Real<D> {
        read.param(self.shape.parameter_values().len() - 3 + s)
    }
    /// A definition that an effect brings.
    fn brought<D: Scalar>(&self, name: Name, read: &Reader<'_, D>) -> Real<D> {
        let place = self.definitions.iter().position(|brought| *brought == name);
        read.def(by_hand::definition::OF_EFFECT + place.unwrap())
    }
}

impl Model for ByHand {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn def<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let brought = family.checked_sub(by_hand::DEFINITION_OF_EFFECT);
        match brought.map(|place| self.definitions[place]) {
            Some("duties") => {
                return sum(0..2, |i| {
                    self.duty_rate(i, read) * CIF[i] * read.var(E) * read.var(M + i)
                });
            }
            Some("rents") => return sum(0..2, |i| self.rent(i, read) * read.var(M + i)),
            Some("emissions") => return sum(0..3, |s| INTENSITY[s] * read.var(Y + s)),
            Some(_) => {
                return sum(0..3, |s| {
                    self.markup_rate(s, read) * read.def(COST + s) * read.var(Y + s)
                });
            }
            None => {}
        }
        let mut value = base_def(family, k, read);
        match family {
            by_hand::COST if self.has("emission_cap") => {
                value += INTENSITY[k] * self.permit(read);
            }
            by_hand::LANDED => {
                if self.has("tariff") {
                    value += self.duty_rate(k, read) * CIF[k] * read.var(E);
                }
                if self.has("quota") {
                    value += self.rent(k, read);
                }
            }
            by_hand::MEANS if self.has("rationing") => {
                let worth = |s: usize| RATION[k][s] * self.scarcity(k, s, read);
                value += sum(0..3, |s| when(RATION[k][s].is_finite(), || worth(s)));
            }
            by_hand::PAID => {
                let (h, s) = (k / 3, k % 3);
                if self.has("tax") {
                    value += read.param(s) * read.var(P + s);
                }
                if self.has("rationing") {
                    value += self.scarcity(h, s, read);
                }
            }
            _ => {}
        }
        value
    }

    fn row<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let demand = |h: usize, s: usize| read.def(DEMAND + 3 * h + s);
        let brought = family.checked_sub(by_hand::EQUATION_OF_EFFECT);
        match brought.map(|place| self.equations[place]) {
            Some("treasury") => {
                let yields =
                    sum(0..3, |s| read.param(s) * read.var(P + s) * sum(0..2, |h| demand(h, s)));
                return Self::revenue(read) - yields;
            }
            Some("licences") => return QUOTA[0] - read.var(M),
            Some("cap") => return EMISSIONS - self.brought("emissions", read),
            Some(_) => return RATION[k][0] - demand(k, 0),
            None => {}
        }
        let mut value = base_row(family, k, read);
        if family == by_hand::PROFIT && self.has("markup") {
            value += self.markup_rate(k, read) * read.def(COST + k);
        }
        if family == by_hand::BUDGET {
            if self.has("tax") {
                value += TO_BOTH[k] * Self::revenue(read);
            }
            if self.has("tariff") {
                value += TO_BOTH[k] * self.brought("duties", read);
            }
            if self.has("quota") {
                value += TO_MERCHANTS[k] * self.brought("rents", read);
            }
            if self.has("emission_cap") {
                let paid = self.permit(read) * self.brought("emissions", read);
                value += TO_BOTH[k] * paid;
            }
            if self.has("markup") {
                value += TO_MERCHANTS[k] * self.brought("profits", read);
            }
        }
        value
    }
}

/// `F` and `J` away from the start, bit by bit.
fn bits(model: &impl Model) -> [Vec<u64>; 2] {
    let mut problem = AdProblem::new(model).unwrap();
    let shape = model.shape();
    let z: Vec<f64> = (0..shape.n()).map(|j| shape.start()[j] + 0.3 + 0.01 * j as f64).collect();
    let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
    problem.evaluate(&z, Some(&mut f), Some(&mut jac));
    [f, jac].map(|numbers| numbers.iter().map(|x| x.to_bits()).collect())
}

#[test]
fn every_set_of_effects_costs_what_it_costs_by_hand() {
    assert_eq!(sets().count(), 64);
    for effects in sets() {
        let (economy, by_hand) = (economy_with(&effects), ByHand::new(&effects));
        let case = economy.parts().join(" ");
        assert_eq!(bits(&economy), bits(&by_hand), "{case}");
        assert_twins(&case, &economy, &by_hand);
    }
}
