//! [`Circuit`]: elements between nodes as a [`ComplementaritySystem`].

use super::complementarity_system::{ComplementaritySystem, Pair};
use super::error::{DynamicsError, finite, positive, unused};

/// An entry counts as zero below this share of the largest of its row: rounding of the elimination.
const NOTHING: f64 = 1e-12;

/// What an element is, with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ElementKind {
    /// `u = R i` \[Ω\].
    Resistor(f64),
    /// `C u' = i` \[F\], from a voltage \[V\].
    Capacitor(f64, f64),
    /// `L i' = u` \[H\], from a current \[A\].
    Inductor(f64, f64),
    /// A constant voltage \[V\].
    Source(f64),
    /// Ideal: `0 <= i ⟂ −u >= 0`.
    Diode,
}

/// An element; its current `i` flows from one node to the other, `u` falls in that direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Name; the state is `u[name]` of a capacitor, `i[name]` of an inductor.
    pub name: String,
    /// Kind and value.
    pub kind: ElementKind,
    /// Node where the current enters.
    pub from: String,
    /// Node where it leaves.
    pub to: String,
}

/// A circuit of ideal elements.
///
/// Kirchhoff's laws and the laws of the elements are eliminated once, exactly as by hand: what is
/// left are the voltages of capacitors and the currents of inductors as states, and for every diode
/// a pair of current and reverse voltage, one of them given by the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Circuit {
    elements: Vec<Element>,
}

impl Circuit {
    /// Nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an element.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for a resistance, capacity or inductance that is not positive or a
    /// voltage or a start that is not finite, [`DynamicsError::NameTwice`].
    pub fn add(&mut self, element: Element) -> Result<(), DynamicsError> {
        let name = &element.name;
        unused(name, self.elements.iter().map(|element| element.name.as_str()))?;
        match element.kind {
            ElementKind::Resistor(r) => positive("resistance", name, r).map(drop)?,
            ElementKind::Capacitor(c, u) => {
                positive("capacity", name, c)?;
                finite("start", name, u)?;
            }
            ElementKind::Inductor(l, i) => {
                positive("inductance", name, l)?;
                finite("start", name, i)?;
            }
            ElementKind::Source(u) => finite("voltage", name, u).map(drop)?,
            ElementKind::Diode => {}
        }
        self.elements.push(element);
        Ok(())
    }

    /// The system, with the first node named as the ground.
    ///
    /// # Errors
    /// [`DynamicsError::Circuit`] if currents and voltages do not follow from the states: a loop of
    /// capacitors and sources, or a node that only inductors lead to.
    pub fn system(&self) -> Result<ComplementaritySystem, DynamicsError> {
        if self.elements.is_empty() {
            let reason = "it has no elements".to_owned();
            return Err(DynamicsError::Circuit { element: None, reason });
        }
        let mut tableau = Tableau::new(&self.elements);
        tableau.eliminate()?;
        tableau.system()
    }
}

/// Kirchhoff's laws and those of the elements, `P w = Q (x, 1)`, with `P` and `Q` side by side.
///
/// `w` has the potentials of all nodes but the ground, one number for each element, its current (of an
/// inductor its voltage, of a diode its reverse voltage), and the currents of the diodes. There are
/// as many equations but for one for each diode: a balance for each node, a law for each element.
struct Tableau<'a> {
    elements: &'a [Element],
    nodes: Vec<&'a str>,
    /// Numbers of the capacitors and inductors, and of the diodes, among the elements.
    states: Vec<usize>,
    diodes: Vec<usize>,
    rows: Vec<Vec<f64>>,
    /// The row that gives a number of `w`; `None`: it is given from outside.
    row_of: Vec<Option<usize>>,
}

impl<'a> Tableau<'a> {
    fn new(elements: &'a [Element]) -> Self {
        let mut nodes: Vec<&str> = Vec::new();
        for node in elements.iter().flat_map(|e| [&e.from, &e.to]) {
            if !nodes.contains(&node.as_str()) {
                nodes.push(node);
            }
        }
        let numbers = |of: fn(ElementKind) -> bool| -> Vec<usize> {
            (0..elements.len()).filter(|&k| of(elements[k].kind)).collect()
        };
        let states =
            numbers(|kind| matches!(kind, ElementKind::Capacitor(..) | ElementKind::Inductor(..)));
        let diodes = numbers(|kind| kind == ElementKind::Diode);
        let equations = nodes.len().saturating_sub(1) + elements.len();
        let unknowns = equations + diodes.len();
        let mut tableau = Tableau {
            rows: vec![vec![0.0; unknowns + states.len() + 1]; equations],
            row_of: vec![None; unknowns],
            elements,
            nodes,
            states,
            diodes,
        };
        for k in 0..elements.len() {
            tableau.write(k);
        }
        tableau
    }

    /// Column of the number of element `k`, and its row.
    fn own(&self, k: usize) -> usize {
        self.nodes.len() - 1 + k
    }

    /// Column of the current of diode `d`.
    fn diode_current(&self, d: usize) -> usize {
        self.rows.len() + d
    }

    /// Column of state `s`; the last column is the constant.
    fn state(&self, s: usize) -> usize {
        self.row_of.len() + s
    }

    /// Position of element `k` in a list of numbers.
    fn place(k: usize, list: &[usize]) -> usize {
        list.partition_point(|&other| other < k)
    }

    /// The equations of an element: its current in the balances of its nodes, and its law.
    fn write(&mut self, k: usize) {
        let element = &self.elements[k];
        let (own, constant) = (self.own(k), self.rows[0].len() - 1);
        let state = self.state(Self::place(k, &self.states));
        let law = own;
        // Where the current stands in a balance: known ones are on the right-hand side.
        let (current, sign) = match element.kind {
            ElementKind::Inductor(..) => (state, -1.0),
            ElementKind::Diode => (self.diode_current(Self::place(k, &self.diodes)), 1.0),
            _ => (own, 1.0),
        };
        for (node, direction) in [(&element.from, 1.0), (&element.to, -1.0)] {
            let node = self.nodes.iter().position(|n| n == node).unwrap_or(0);
            // The ground, node 0, has neither potential nor balance.
            if node > 0 {
                self.rows[node - 1][current] += sign * direction;
                self.rows[law][node - 1] += direction;
            }
        }
        let (column, value) = match element.kind {
            ElementKind::Resistor(r) => (own, -r),
            ElementKind::Capacitor(..) => (state, 1.0),
            ElementKind::Source(u) => (constant, u),
            ElementKind::Inductor(..) => (own, -1.0),
            ElementKind::Diode => (own, 1.0),
        };
        self.rows[law][column] += value;
    }

    /// Gauss–Jordan: first all that is no diode's, then one of the two numbers of every diode, its
    /// reverse voltage where possible.
    fn eliminate(&mut self) -> Result<(), DynamicsError> {
        let inner = (0..self.rows.len()).filter(|&column| {
            column + 1 < self.nodes.len()
                || self.elements[column + 1 - self.nodes.len()].kind != ElementKind::Diode
        });
        for column in inner.collect::<Vec<_>>() {
            // A part without connection to the ground has a potential to choose: 0.
            if !self.pivot(column) && column + 1 >= self.nodes.len() {
                let name = &self.elements[column + 1 - self.nodes.len()].name;
                let reason = format!("{name} closes a loop of capacitors and sources");
                return Err(DynamicsError::Circuit { element: Some(name.clone()), reason });
            }
        }
        let mut left = Vec::new();
        for d in 0..self.diodes.len() {
            if !self.pivot(self.own(self.diodes[d])) {
                left.push(d);
            }
        }
        for d in left {
            if !self.pivot(self.diode_current(d)) {
                let name = &self.elements[self.diodes[d]].name;
                let reason = format!("neither current nor voltage of {name} follows");
                return Err(DynamicsError::Circuit { element: Some(name.clone()), reason });
            }
        }
        self.check_balances()
    }

    /// What is left of equations that follow from the others must be `0 = 0`.
    fn check_balances(&self) -> Result<(), DynamicsError> {
        let is_left = |r: &usize| !self.row_of.contains(&Some(*r));
        let known = |r: usize| &self.rows[r][self.row_of.len()..];
        let mut left = (0..self.rows.len()).filter(is_left);
        if left.any(|r| known(r).iter().any(|x| x.abs() > NOTHING)) {
            let reason = "currents of inductors alone meet in a node".to_owned();
            return Err(DynamicsError::Circuit { element: None, reason });
        }
        Ok(())
    }

    /// Solves a free row for `column`, the one with the relatively largest entry there; false if it
    /// vanishes in all of them.
    fn pivot(&mut self, column: usize) -> bool {
        let unknowns = self.row_of.len();
        let relative = |row: &Vec<f64>| {
            let largest = row[..unknowns].iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
            if largest > 0.0 { row[column].abs() / largest } else { 0.0 }
        };
        let free = (0..self.rows.len()).filter(|&r| !self.row_of.contains(&Some(r)));
        let best = free.map(|r| (r, relative(&self.rows[r]))).max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((row, _)) = best.filter(|&(_, size)| size > NOTHING) else { return false };
        self.row_of[column] = Some(row);
        let pivot = self.rows[row][column];
        let pivot_row: Vec<f64> = self.rows[row].iter().map(|x| x / pivot).collect();
        for (r, other) in self.rows.iter_mut().enumerate() {
            let factor = other[column];
            if r != row && factor != 0.0 {
                for (x, p) in other.iter_mut().zip(&pivot_row) {
                    *x -= factor * p;
                }
                other[column] = 0.0;
            }
        }
        self.rows[row] = pivot_row;
        true
    }

    /// A number of `w` as a row over the states, the multipliers and 1.
    fn expression(&self, column: usize, lambda: &[usize]) -> (Vec<f64>, Vec<f64>, f64) {
        let Some(row) = self.row_of[column] else {
            let unit = lambda.iter().map(|&l| f64::from(u8::from(l == column))).collect();
            return (vec![0.0; self.states.len()], unit, 0.0);
        };
        let row = &self.rows[row];
        let states = &row[self.row_of.len()..row.len() - 1];
        (states.to_vec(), lambda.iter().map(|&l| -row[l]).collect(), row[row.len() - 1])
    }

    /// `x' = A x + b + B λ`, `y = C x + a + D λ`.
    fn system(&self) -> Result<ComplementaritySystem, DynamicsError> {
        // Of the two numbers of a diode, the one not solved for is λ.
        let numbers = |d: usize| [self.own(self.diodes[d]), self.diode_current(d)];
        let split = |d: usize| {
            let [voltage, current] = numbers(d);
            if self.row_of[voltage].is_some() { (current, voltage) } else { (voltage, current) }
        };
        let pairs: Vec<(usize, usize)> = (0..self.diodes.len()).map(split).collect();
        let lambda: Vec<usize> = pairs.iter().map(|pair| pair.0).collect();

        let (mut a, mut b, mut drift) = (Vec::new(), Vec::new(), Vec::new());
        let (mut names, mut start, mut storage) = (Vec::new(), Vec::new(), Vec::new());
        for &k in &self.states {
            let Element { name, kind, .. } = &self.elements[k];
            let (weight, from, quantity) = match *kind {
                ElementKind::Inductor(l, i) => (l, i, "i"),
                ElementKind::Capacitor(c, u) => (c, u, "u"),
                _ => continue,
            };
            let (row, inputs, constant) = self.expression(self.own(k), &lambda);
            a.push(row.iter().map(|x| x / weight).collect::<Vec<_>>());
            b.push(inputs.iter().map(|x| x / weight).collect::<Vec<_>>());
            drift.push(constant / weight);
            names.push(format!("{quantity}[{name}]"));
            start.push(from);
            storage.push(weight);
        }
        let system = ComplementaritySystem::new(names, &start, &a)?;
        let mut system = system.drift(&drift)?.storage(&storage)?;
        for (d, &(given, solved)) in pairs.iter().enumerate() {
            let (output, _, constant) = self.expression(solved, &lambda);
            let quantity = if given == numbers(d)[1] { "i" } else { "w" };
            let name = format!("{quantity}[{}]", self.elements[self.diodes[d]].name);
            let input: Vec<f64> = b.iter().map(|row| row[d]).collect();
            let pair = Pair::new(name, input, output).offset(constant);
            system.pair(pair.within(0.0, f64::INFINITY))?;
        }
        for (d, &(_, solved)) in pairs.iter().enumerate() {
            let (_, inputs, _) = self.expression(solved, &lambda);
            for (j, &value) in inputs.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                system.couple(d, j, value)?;
            }
        }
        Ok(system)
    }
}
