use super::*;
use crate::model::{Equation, Model, Reader, Shape, Variable};
use crate::scalar::{Real, Scalar};

fn set(name: &str, labels: &[&str]) -> Set {
    Set::new(name, labels.iter().copied()).unwrap()
}

/// A table of the data, to be read by label.
fn table<const R: usize>(name: &str, sets: &[&Set], values: &[f64]) -> Levels<R> {
    Levels(numbers(&Family::of_table(name, sets), values, &[]))
}

/// `x[plants, markets]`, numbered.
fn dense() -> Levels<2> {
    let (plants, markets) = (set("plants", &["a", "b"]), set("markets", &["u", "v", "w"]));
    table("x", &[&plants, &markets], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0])
}

/// A model whose rows are `x − level`, with a variable for each label, or only for some of them.
#[derive(Debug)]
struct Market(Shape);

impl Model for Market {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        read.var(i) - read.param(0)
    }
}

fn market(name: &str, labels: &[&str], only: &[usize], parameter: &str) -> Market {
    let goods = set("goods", labels);
    let variable = Variable::new(name).over(&[&goods]).only(only.to_vec());
    let equation = Equation::new("f").over(&[&goods]).only(only.to_vec());
    let shape = Shape::builder()
        .parameter(crate::model::Parameter::new(parameter, 2.0))
        .variable(variable)
        .equation(equation.complements(name));
    Market(shape.build().unwrap())
}

fn solution(model: &Market, z: &[f64]) -> Solution {
    let f = z.iter().map(|z| z - 2.0).collect();
    Solution { shape: Arc::new(model.0.clone()), z: z.to_vec(), f, ..Solution::nothing() }
}

#[test]
fn every_element_is_found_under_the_labels_it_is_listed_with() {
    let x = dense();
    assert_eq!((x.len(), x.is_empty()), (6, false));
    for ([plant, market], value) in x.iter() {
        assert_eq!(x.get((&plant, &market)), Ok(value));
        assert_eq!(x[[&plant, &market]], value);
    }
    let listed: Vec<String> = x.iter().map(|(labels, _)| labels.concat()).collect();
    assert_eq!(listed, ["au", "av", "aw", "bu", "bv", "bw"]);
}

#[test]
fn labels_are_found_with_the_spaces_they_have_and_without_those_they_do_not() {
    let x: Levels<1> = table("x", &[&set("goods", &[" a", "a", "b "])], &[1.0, 2.0, 3.0]);
    for ([label], value) in x.iter() {
        assert_eq!(x.get(&label), Ok(value));
    }
    assert_eq!(dense().get((" b", "w ")), Ok(5.0));
}

#[test]
fn keys_are_text_tuples_and_lists() {
    let one: Levels<1> = table("p", &[&set("markets", &["u"])], &[7.0]);
    let owned = "u".to_owned();
    assert_eq!([one["u"], one[&owned], one[("u",)], one[["u"]]], [7.0; 4]);
    let x = dense();
    assert_eq!([x[("b", "v")], x[["b", "v"]], x[("b", "v".to_owned())]], [4.0; 3]);
}

#[test]
fn an_unknown_label_is_answered_with_the_nearest() {
    let x: Levels<1> = table("x", &[&set("goods", &["wheat", "iron"])], &[1.0, 2.0]);
    let error = x.get("whaet").unwrap_err().to_string();
    assert_eq!(error, "there is no label `whaet`; did you mean `wheat`?");
    assert_eq!(x.get("").unwrap_err().to_string(), "there is no label ``");
    assert!(dense().get(("u", "a")).is_err(), "labels come in the order of the sets");
}

#[test]
#[should_panic(expected = "x: there is no label `q`")]
fn an_unknown_label_in_brackets_panics() {
    let _ = dense()[("a", "q")];
}

#[test]
fn a_combination_that_does_not_exist_is_an_error() {
    let model = market("x", &["a", "b", "c"], &[0, 2], "level");
    let solution = solution(&model, &[5.0, 6.0]);
    let [x, _level] = viewed(&model, &solution, &[]).unwrap();
    let x = VariableLevels::<1>(Levels(x));
    let listed: Vec<([String; 1], f64)> = x.iter().collect();
    assert_eq!(listed, [(["a".to_owned()], 5.0), (["c".to_owned()], 6.0)]);
    assert_eq!((x.get("c"), x.marginal("c"), x["a"]), (Ok(6.0), Ok(4.0), 5.0));
    let absent = "there is no `x[b]`: `x` has only some of the combinations of its sets";
    assert_eq!(x.get("b").unwrap_err().to_string(), absent);
    assert_eq!(x.marginal("b").unwrap_err().to_string(), absent);
}

#[test]
fn a_family_without_index_sets_is_one_number_that_needs_no_label() {
    let eta: Levels<0> = table("eta", &[], &[0.9]);
    assert_eq!((eta.0.single(), eta.get([""; 0]), eta.len()), (0.9, Ok(0.9), 1));
    assert_eq!(eta.iter().collect::<Vec<_>>(), [([], 0.9)]);
}

#[test]
fn a_family_over_an_empty_set_has_no_levels() {
    let x: Levels<2> = table("x", &[&set("few", &[]), &set("goods", &["a"])], &[]);
    assert!(x.is_empty() && x.iter().next().is_none() && x.get(("a", "a")).is_err());
}

#[test]
fn a_solution_is_read_by_a_model_with_the_same_labels() {
    let model = market("x", &["a", "b"], &[0, 1], "level");
    let again = market("x", &["a", "b"], &[0, 1], "level");
    let solution = solution(&again, &[5.0, 6.0]);
    let goods = set("goods", &["a", "b"]);
    let [x, level, cost] = viewed(&model, &solution, &[("cost", &[&goods], &[3.0, 4.0])]).unwrap();
    assert_eq!((Levels::<1>(x)["b"], level.single(), Levels::<1>(cost)["b"]), (6.0, 2.0, 4.0));
}

#[test]
fn a_solution_of_another_model_is_refused_even_if_it_has_as_many_variables() {
    let model = market("x", &["a", "b", "c"], &[0, 1], "level");
    let told = |other: &Market, z: &[f64]| {
        viewed::<2>(&model, &solution(other, z), &[]).unwrap_err().to_string()
    };
    let x = "the solution is of another model: `x` has other elements there";
    assert_eq!(told(&market("x", &["a", "c", "b"], &[0, 1], "level"), &[1.0, 2.0]), x);
    assert_eq!(told(&market("x", &["a", "b", "c"], &[0, 2], "level"), &[1.0, 2.0]), x);
    assert_eq!(told(&market("y", &["a", "b", "c"], &[0, 1], "level"), &[1.0, 2.0]), x);
    let level = "the solution is of another model: `level` has other elements there";
    assert_eq!(told(&market("x", &["a", "b", "c"], &[0, 1], "tax"), &[1.0, 2.0]), level);
    let length = "the length of `levels of the solution` is 1, expected 2";
    assert_eq!(told(&market("x", &["a", "b", "c"], &[0], "level"), &[1.0]), length);
}

#[test]
fn a_solution_without_marginals_is_refused() {
    let model = market("x", &["a"], &[0], "level");
    let solution = Solution { f: vec![], ..solution(&model, &[1.0]) };
    let error = viewed::<2>(&model, &solution, &[]).unwrap_err().to_string();
    assert_eq!(error, "the length of `values of F of the solution` is 0, expected 1");
}

#[cfg(feature = "macros")]
mod models {
    use crate::{Options, mcp, solve};

    mcp! {
        /// A scalar variable that may be absent, and families over sets that may be empty.
        model Switch {
            data {
                open: bool, nodes: Set, few: Subset(nodes), fewer: Subset(few),
                lines: Pairs(few, nodes), site: Map(few, nodes), cost[fewer, lines]: f64,
            }
            param toll[l in lines] = 1.0;
            var x >= 0.0;
            var y >= 0.0 if open;
            var f[l in lines] >= 0.0;
            var g[k in fewer, l in lines] >= 0.0 if k.position() < l.position();
            def c[l in lines]: f[l] + y + sum(fewer, |k| g[k, l]);
            def d[k in few] lifted: x + sum(lines.out_of(k), |l| c[l]);
            fix f[l in lines] = 0.5;
            eq level: x - 1.0                                               complements x;
            eq other: y - 2.0                                               complements y;
            eq flow[l @ (i, j) in lines]: toll[l] * f[l] + d[i] - x         complements f[l];
            eq grow[k in fewer, l in lines]: cost[k, l] + g[k, l] - d[k]    complements g[k, l];
            report total: sum(nodes, |i| sum(site.of(i), |k| d[k])) + cost.sum();
        }
    }

    #[test]
    fn empty_subsets_pairs_maps_and_tables_make_a_model() {
        for open in [false, true] {
            let model = Switch::builder()
                .open(open)
                .nodes(["a", "b"])
                .few([])
                .fewer([])
                .lines([] as [(&str, &str); 0])
                .site([])
                .cost(3.0)
                .build()
                .unwrap();
            let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
            let view = model.view(&solution).unwrap();
            assert!((view.x - 1.0).abs() < 1e-8);
            let expected = if open { 2.0 } else { 0.0 };
            assert!((view.y - expected).abs() < 1e-8, "an absent variable is 0");
            assert!(view.f.is_empty() && view.d.is_empty() && view.g.is_empty());
            assert_eq!((view.total, view.toll.len(), view.cost.len()), (0.0, 0, 0));
        }
    }
}
