//! Constraint equations (MPC), and systems of them solved for chosen motions.

use super::Dependent;
use nalgebra::DMatrix;
use nastran::{InputError, Span};

/// One equation: the sum of factor times motion is zero.
pub(crate) type Equation = Vec<(usize, f64)>;

/// Solves as many equations as there are `chosen` motions for these.
///
/// # Errors
/// If the chosen motions are not determined by the equations.
pub(crate) fn solved_for(
    equations: &[Equation],
    chosen: &[usize],
    owner: &str,
    span: &Span,
) -> Result<Vec<Dependent>, InputError> {
    let factor = |equation: &Equation, dof: usize| {
        equation.iter().filter(|(other, _)| *other == dof).map(|(_, f)| f).sum::<f64>()
    };
    let size = equations.len();
    let own = DMatrix::from_fn(size, chosen.len(), |i, j| factor(&equations[i], chosen[j]));
    let largest = own.amax();
    let inverse = (size == chosen.len()).then(|| own.clone().try_inverse()).flatten();
    let Some(inverse) = inverse.filter(|inverse| inverse.amax() * largest < 1e10) else {
        let message = format!("{owner}: the dependent motions it names are not determined by the others");
        let help = "as many dependent motions as equations are needed, and they must hold what follows";
        return Err(InputError::at(span, message).with_help(help));
    };
    let mut others: Vec<usize> = equations.iter().flatten().map(|(dof, _)| *dof).collect();
    others.sort_unstable();
    others.dedup();
    others.retain(|dof| !chosen.contains(dof));
    let rest = DMatrix::from_fn(size, others.len(), |i, j| factor(&equations[i], others[j]));
    let rows = -(inverse * rest);
    let dependents = chosen.iter().enumerate().map(|(at, dof)| {
        let row = others.iter().enumerate().map(|(column, other)| (*other, rows[(at, column)]));
        let row = row.filter(|(_, f)| *f != 0.0).collect();
        Dependent { dof: *dof, row, owner: owner.to_owned(), span: span.clone() }
    });
    Ok(dependents.collect())
}
