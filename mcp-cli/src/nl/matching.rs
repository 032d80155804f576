//! A largest matching of equations with variables they contain.
//!
//! The algorithm of Hopcroft and Karp ([HK73](mcp_core#references)): shortest augmenting paths, as many disjoint ones at a time as
//! there are, in `O(E √V)`; searches keep their own stack.

/// Not matched, not reached.
const NONE: u32 = u32::MAX;

/// For every equation one of its variables, no variable twice; `None` where a largest matching has
/// nothing left for an equation. Equations prefer variables in the order they list them.
///
/// `columns(e)` lists the variables of equation `e`, each below `variables`.
///
/// ```
/// // x_0 = …, x_0 = …, f(x_0, x_1, x_2) = 0: one of the first two has no variable of its own.
/// let rows: [&[u32]; 3] = [&[0], &[0], &[0, 1, 2]];
/// let found = mcp_cli::nl::maximum_matching(3, 3, |e| rows[e]);
/// assert_eq!(found, [Some(0), None, Some(1)]);
/// ```
///
/// # Panics
/// If a listed variable is not below `variables`, or with 2³² equations.
pub fn maximum<'a>(
    equations: usize,
    variables: usize,
    columns: impl Fn(usize) -> &'a [u32],
) -> Vec<Option<usize>> {
    let mut search = Search {
        variable_of: vec![NONE; equations],
        equation_of: vec![NONE; variables],
        layer: vec![NONE; equations],
        next: vec![0; equations],
    };
    search.greedy(&columns);
    while search.layers(&columns) {
        for equation in 0..equations {
            if search.variable_of[equation] == NONE {
                search.augment(equation, &columns);
            }
        }
    }
    let found = |variable: &u32| (*variable != NONE).then_some(*variable as usize);
    search.variable_of.iter().map(found).collect()
}

struct Search {
    variable_of: Vec<u32>,
    equation_of: Vec<u32>,
    /// Length of the shortest alternating path to an equation from one that is not matched.
    layer: Vec<u32>,
    /// The column of an equation that a search tries next.
    next: Vec<usize>,
}

impl Search {
    fn join(&mut self, equation: usize, variable: u32) {
        self.variable_of[equation] = variable;
        self.equation_of[variable as usize] = number(equation);
    }

    /// Every equation takes its first variable that is free.
    fn greedy<'a>(&mut self, columns: &impl Fn(usize) -> &'a [u32]) {
        for equation in 0..self.variable_of.len() {
            let is_free = |j: &&u32| self.equation_of[**j as usize] == NONE;
            if let Some(&variable) = columns(equation).iter().find(is_free) {
                self.join(equation, variable);
            }
        }
    }

    /// Breadth first: the layers of all equations; whether a free variable is within reach.
    fn layers<'a>(&mut self, columns: &impl Fn(usize) -> &'a [u32]) -> bool {
        self.next.fill(0);
        self.layer.fill(NONE);
        let is_free = |e: &usize| self.variable_of[*e] == NONE;
        let mut queue: Vec<usize> = (0..self.variable_of.len()).filter(is_free).collect();
        for &equation in &queue {
            self.layer[equation] = 0;
        }
        let (mut head, mut found) = (0, false);
        while head < queue.len() {
            let equation = queue[head];
            head += 1;
            for &variable in columns(equation) {
                match self.equation_of[variable as usize] {
                    NONE => found = true,
                    other if self.layer[other as usize] == NONE => {
                        self.layer[other as usize] = self.layer[equation] + 1;
                        queue.push(other as usize);
                    }
                    _ => {}
                }
            }
        }
        found
    }

    /// Depth first along the layers to a free variable; exchanges the matching along the path.
    fn augment<'a>(&mut self, root: usize, columns: &impl Fn(usize) -> &'a [u32]) {
        let mut path = vec![root];
        while let Some(&equation) = path.last() {
            let Some(&variable) = columns(equation).get(self.next[equation]) else {
                path.pop();
                continue;
            };
            self.next[equation] += 1;
            match self.equation_of[variable as usize] {
                NONE => {
                    // Every equation of the path gets the variable it was left by.
                    for &equation in &path {
                        self.join(equation, columns(equation)[self.next[equation] - 1]);
                    }
                    return;
                }
                other if self.layer[other as usize] == self.layer[equation] + 1 => {
                    path.push(other as usize);
                }
                _ => {}
            }
        }
    }
}

fn number(equation: usize) -> u32 {
    u32::try_from(equation).expect("the header allows 2^31 rows")
}

#[cfg(test)]
mod tests {
    use super::maximum;

    fn matched(variables: usize, rows: &[&[u32]]) -> Vec<Option<usize>> {
        maximum(rows.len(), variables, |e| rows[e])
    }

    #[test]
    fn equations_take_variables_in_their_own_order_where_they_can() {
        assert_eq!(matched(2, &[&[1, 0], &[0]]), [Some(1), Some(0)]);
    }

    #[test]
    fn an_augmenting_path_makes_room() {
        assert_eq!(matched(3, &[&[0, 1], &[0, 2], &[0]]), [Some(1), Some(2), Some(0)]);
    }

    #[test]
    fn an_equation_without_a_variable_of_its_own_is_left_over() {
        assert_eq!(matched(2, &[&[0], &[0], &[]]), [Some(0), None, None]);
    }

    #[test]
    fn a_chain_that_shifts_all_equations_is_found_without_recursion() {
        let n = 100_000;
        // Equation k contains k and k + 1, the last only variable 0: all others must shift.
        let columns: Vec<[u32; 2]> = (0..n).map(|k| [k, k + 1]).collect();
        let last = [0];
        let rows = n as usize;
        let found = maximum(rows + 1, rows + 1, |e| if e < rows { &columns[e] } else { &last });
        assert!(found[..rows].iter().enumerate().all(|(e, v)| *v == Some(e + 1)));
        assert_eq!(found[rows], Some(0));
    }
}
