//! Twins written by hand, each for the effects that it knows: none, a quota, tax and markup.

use super::economy::data::{CIF, FOB, HOURS, HOUSEHOLDS, LABOR, REFERENCE, SECTORS, SHARE, TRADED};
use super::economy_with;
use super::sample::{self, MARKUP, QUOTA, TAX, TO_BOTH, TO_MERCHANTS};
use super::twins::assert_twins;
use mcp_core::{
    Definition, Equation, Model, Parameter, Reader, Real, Scalar, Set, Shape, ShapeBuilder,
    Variable, sum, when,
};

/// First variable of each family of the base; those of an effect follow.
pub(crate) mod variable {
    pub(crate) const Y: usize = 0;
    pub(crate) const P: usize = 3;
    pub(crate) const W: usize = 6;
    pub(crate) const M: usize = 7;
    pub(crate) const X: usize = 9;
    pub(crate) const E: usize = 11;
    pub(crate) const INCOME: usize = 12;
    pub(crate) const OF_EFFECT: usize = 14;
}

/// First definition of each family of the base.
pub(crate) mod definition {
    pub(crate) const COST: usize = 0;
    pub(crate) const LANDED: usize = 3;
    pub(crate) const MEANS: usize = 5;
    pub(crate) const PAID: usize = 7;
    pub(crate) const DEMAND: usize = 13;
    pub(crate) const OF_EFFECT: usize = 19;
}

use variable::{E, INCOME, M, P, W, X, Y};

/// Families of definitions and of equations to which an effect adds, and those that it brings.
pub(crate) const COST: usize = 0;
pub(crate) const LANDED: usize = 1;
pub(crate) const MEANS: usize = 2;
pub(crate) const PAID: usize = 3;
pub(crate) const DEFINITION_OF_EFFECT: usize = 5;
pub(crate) const PROFIT: usize = 0;
pub(crate) const BUDGET: usize = 5;
pub(crate) const EQUATION_OF_EFFECT: usize = 7;

pub(crate) fn base_shape() -> ShapeBuilder {
    let [households, sectors, traded] = [
        Set::new("households", HOUSEHOLDS).unwrap(),
        Set::new("sectors", SECTORS).unwrap(),
        Set::new("traded", TRADED).unwrap(),
    ];
    let above_0 = |name: &str| Variable::new(name).lower(0.0);
    Shape::builder()
        .variable(above_0("y").over(&[&sectors]).start(1.0))
        .variable(above_0("p").over(&[&sectors]).start(REFERENCE))
        .variable(above_0("w").start(20.0))
        .variable(above_0("m").over(&[&traded]))
        .variable(above_0("x").over(&[&traded]))
        .variable(Variable::new("e").fixed(1.0))
        .variable(Variable::new("income").over(&[&households]).start(LABOR.map(|l| 20.0 * l)))
        .definition(Definition::new("cost").over(&[&sectors]))
        .definition(Definition::new("landed").over(&[&traded]))
        .definition(Definition::new("means").over(&[&households]))
        .definition(Definition::new("paid").over(&[&households, &sectors]))
        .definition(Definition::new("demand").over(&[&households, &sectors]))
        .equation(Equation::new("profit").over(&[&sectors]).complements("y"))
        .equation(Equation::new("market").over(&[&sectors]).complements("p"))
        .equation(Equation::new("employment").complements("w"))
        .equation(Equation::new("import").over(&[&traded]).complements("m"))
        .equation(Equation::new("export").over(&[&traded]).complements("x"))
        .equation(Equation::new("budget").over(&[&households]).complements("income"))
        .equation(Equation::new("balance").complements("e"))
}

pub(crate) fn base_def<D: Scalar>(family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
    match family {
        COST => HOURS[k] * read.var(W),
        LANDED => CIF[k] * read.var(E),
        MEANS => read.var(INCOME + k),
        PAID => read.var(P + k % 3),
        _ => {
            SHARE[k / 3][k % 3] * read.def(definition::MEANS + k / 3)
                / read.def(definition::PAID + k)
        }
    }
}

pub(crate) fn base_row<D: Scalar>(family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
    let demand = |s: usize| sum(0..2, |h| read.def(definition::DEMAND + 3 * h + s));
    match family {
        PROFIT => read.def(definition::COST + k) - read.var(P + k),
        1 => {
            let imports = when(k < 2, || read.var(M + k));
            let exports = when(k < 2, || read.var(X + k));
            read.var(Y + k) + imports - exports - demand(k)
        }
        2 => LABOR.iter().sum::<f64>() - sum(0..3, |s| HOURS[s] * read.var(Y + s)),
        3 => read.def(definition::LANDED + k) - read.var(P + k),
        4 => read.var(P + k) - FOB[k] * read.var(E),
        BUDGET => read.var(W) * LABOR[k] - read.var(INCOME + k),
        _ => sum(0..2, |i| FOB[i] * read.var(X + i) - CIF[i] * read.var(M + i)),
    }
}

/// The base alone.
struct Free(Shape);

impl Model for Free {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn def<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        base_def(family, k, read)
    }
    fn row<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        base_row(family, k, read)
    }
}

#[test]
fn the_economy_without_effects_is_the_base_by_hand() {
    let by_hand = Free(base_shape().build().unwrap());
    assert_twins("base", &economy_with(&[]), &by_hand);
}

/// The base with a quota on food.
struct Quota(Shape);

impl Quota {
    fn new() -> Self {
        let food = Set::new("limited", ["food"]).unwrap();
        let shape = base_shape()
            .variable(Variable::new("rent").over(&[&food]).lower(0.0))
            .definition(Definition::new("rents"))
            .equation(Equation::new("licences").over(&[&food]).complements("rent"));
        Quota(shape.build().unwrap())
    }
}

impl Model for Quota {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn def<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let rent = |i: usize| when(i == 0, || read.var(variable::OF_EFFECT));
        match family {
            LANDED => base_def(family, k, read) + rent(k),
            DEFINITION_OF_EFFECT => sum(0..2, |i| rent(i) * read.var(M + i)),
            _ => base_def(family, k, read),
        }
    }
    fn row<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            BUDGET => base_row(family, k, read) + TO_MERCHANTS[k] * read.def(definition::OF_EFFECT),
            EQUATION_OF_EFFECT => QUOTA[0] - read.var(M),
            _ => base_row(family, k, read),
        }
    }
}

#[test]
fn the_economy_with_a_quota_is_the_quota_by_hand() {
    assert_twins("quota", &economy_with(&[sample::quota()]), &Quota::new());
}

/// The base with a tax and a markup.
struct TaxAndMarkup(Shape);

impl TaxAndMarkup {
    fn new() -> Self {
        let sectors = Set::new("sectors", SECTORS).unwrap();
        let shape = base_shape()
            .parameter(Parameter::new("tax_rate", TAX).over(&[&sectors]))
            .parameter(Parameter::new("markup_rate", MARKUP).over(&[&sectors]))
            .variable(Variable::new("revenue").start(LABOR.iter().sum::<f64>()))
            .definition(Definition::new("profits"))
            .equation(Equation::new("treasury").complements("revenue"));
        TaxAndMarkup(shape.build().unwrap())
    }
    /// Of the tax and of the markup, by sector.
    fn rates<'r, D: Scalar>(read: &'r Reader<'_, D>) -> [impl Fn(usize) -> Real<D> + 'r; 2] {
        [0, 3].map(|first| move |s| read.param(first + s))
    }
}

impl Model for TaxAndMarkup {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn def<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let [tax, markup] = TaxAndMarkup::rates(read);
        match family {
            PAID => base_def(family, k, read) + tax(k % 3) * read.var(P + k % 3),
            DEFINITION_OF_EFFECT => {
                sum(0..3, |s| markup(s) * read.def(definition::COST + s) * read.var(Y + s))
            }
            _ => base_def(family, k, read),
        }
    }
    fn row<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let [tax, markup] = TaxAndMarkup::rates(read);
        let revenue = || read.var(variable::OF_EFFECT);
        let demand = |s: usize| sum(0..2, |h| read.def(definition::DEMAND + 3 * h + s));
        match family {
            PROFIT => base_row(family, k, read) + markup(k) * read.def(definition::COST + k),
            BUDGET => {
                let profits = read.def(definition::OF_EFFECT);
                base_row(family, k, read) + TO_BOTH[k] * revenue() + TO_MERCHANTS[k] * profits
            }
            EQUATION_OF_EFFECT => revenue() - sum(0..3, |s| tax(s) * read.var(P + s) * demand(s)),
            _ => base_row(family, k, read),
        }
    }
}

#[test]
fn the_economy_with_tax_and_markup_is_the_two_by_hand() {
    let effects = [sample::tax(), sample::markup()];
    assert_twins("tax and markup", &economy_with(&effects), &TaxAndMarkup::new());
}
