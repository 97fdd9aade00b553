//! The smallest size of an effect that a search would have named: what "nothing is missing" is worth.
//!
//! An effect that is there changes the whitened loads by c, which its fit takes out: the evidence is
//! `(c'c)/(2 phi) - prior/2 - ½ ln(1 + c'c/phi)` where the data agree with it exactly. With c in proportion to the size, the size at
//! which this is the threshold follows from one that was flown.

/// An effect at one size, as screening flew it.
#[derive(Debug, Clone)]
pub(crate) struct Flight {
    pub(crate) name: &'static str,
    pub(crate) form: &'static str,
    /// The parameter that has a size.
    pub(crate) parameter: String,
    /// Its value, and how large it may be.
    pub(crate) value: f64,
    pub(crate) largest: f64,
    /// Chi square of what it changes.
    pub(crate) information: f64,
    /// `sum (theta/plausible)²`.
    pub(crate) prior: f64,
}

/// See the module.
#[derive(Debug, Clone, PartialEq)]
pub struct Smallest {
    /// Effect.
    pub name: &'static str,
    /// Its form.
    pub form: &'static str,
    /// Parameter, the others at rest (or where the search begins with them).
    pub parameter: String,
    /// Its size, either sign; none if it would not be seen within the effect's bounds.
    pub value: Option<f64>,
}

/// What is seen of one flight of an effect without which the model is right: by its threshold and the misfit a row.
pub(crate) fn smallest(flight: &Flight, threshold: f64, phi: f64) -> Smallest {
    let information = flight.information / phi;
    let occam = 0.5 * information.ln_1p();
    let square = 2.0 * (threshold + occam) / (information - flight.prior);
    let value = (square > 0.0).then(|| square.sqrt() * flight.value.abs());
    Smallest {
        name: flight.name,
        form: flight.form,
        parameter: flight.parameter.clone(),
        value: value.filter(|value| *value <= flight.largest),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_evidence_at_the_smallest_size_is_the_threshold() {
        let flight = Flight {
            name: "gain",
            form: "",
            parameter: "g_my".to_owned(),
            value: 0.05,
            largest: 0.3,
            information: 900.0,
            prior: 1.0,
        };
        let seen = smallest(&flight, 40.0, 1.5).value.expect("within bounds");
        let share = (seen / 0.05).powi(2);
        // the determinant is that of the size that was flown: a little more than that of the smaller one
        let evidence = 0.5 * share * (900.0 / 1.5 - 1.0) - 0.5 * (900.0_f64 / 1.5).ln_1p();
        assert!((evidence - 40.0).abs() < 1e-9, "{evidence}");
        // what does nothing is never seen, nor what would have to be larger than it can be
        assert_eq!(smallest(&Flight { information: 0.0, ..flight.clone() }, 40.0, 1.0).value, None);
        assert_eq!(smallest(&Flight { largest: 0.01, ..flight }, 40.0, 1.0).value, None);
    }
}
