//! The effects that a wing's file lists, checked against those there are.

use super::active::Active;
use super::effect::Effect;
use super::library::library_with;
use coupling::WingFile;
use coupling::wing_file::WingEffect;
use nastran::InputError;
use nastran::suggest::nearest;
use std::sync::Arc;

/// What physics demands may move values by so much of their bounds: the last digits of a value written before.
const ROUNDING: f64 = 1e-9;

/// The effects of a wing with these controls, in the order of its file. Values are those of the file, bit for bit;
/// parameters left out are zero.
///
/// # Errors
/// An effect, form or parameter that there is not, an effect that is the physics of the wing's deflection correction, a value
/// outside its bounds or one that physics does not allow with the others: at its place in the wing's file.
pub fn of_wing(file: &WingFile, controls: &[String]) -> Result<Vec<Active>, InputError> {
    let known = library_with(controls, &file.into());
    file.effects.iter().map(|listed| one(file, listed, &known)).collect()
}

fn one(file: &WingFile, listed: &WingEffect, known: &[Arc<dyn Effect>]) -> Result<Active, InputError> {
    let refuse = |anchors: &[&str], message: String, help: &str| {
        Err(listed.refused(&file.path, anchors, message, help))
    };
    let name = &listed.name;
    let forms: Vec<&Arc<dyn Effect>> = known.iter().filter(|e| e.spec().name == name).collect();
    let Some(first) = forms.first() else {
        let help = meant(name, known.iter().map(|effect| effect.spec().name));
        return refuse(&[], format!("there is no effect \"{name}\""), &help);
    };
    let form = forms.iter().find(|effect| effect.form() == listed.form);
    let Some(effect) = form.or(listed.form.is_empty().then_some(first)) else {
        let help =
            meant(&listed.form, forms.iter().map(|effect| effect.form()).filter(|form| !form.is_empty()));
        return refuse(&["form:"], format!("{name} has no form \"{}\"", listed.form), &help);
    };
    if !file.deflection.is_empty() && effect.excludes_deflection_correction() {
        let message = format!("the wing has both a deflection correction and {name}: the same physics");
        return refuse(&[], message, "leave `deflection` or the effect out");
    }
    let parameters = effect.parameters();
    let mut values = vec![0.0; parameters.len()];
    for (parameter, value) in &listed.parameters {
        let quoted = format!("\"{parameter}\"");
        let at = ["parameters:", quoted.as_str()];
        let Some(place) = parameters.iter().position(|p| p.name == *parameter) else {
            let help = meant(parameter, parameters.iter().map(|p| p.name.as_str()));
            return refuse(&at, format!("{name} has no parameter \"{parameter}\""), &help);
        };
        let (lower, upper) = (parameters[place].lower, parameters[place].upper);
        if !(lower..=upper).contains(value) {
            let message = format!("{parameter} of {name} is {value}, expected {lower} to {upper}");
            return refuse(&at, message, "the unit is in the parameter's name");
        }
        values[place] = *value;
    }
    let allowed = Active::new(Arc::clone(effect), &values);
    for (p, (value, allowed)) in parameters.iter().zip(values.iter().zip(&allowed.values)) {
        if (value - allowed).abs() > ROUNDING * (p.upper - p.lower) {
            let message = format!("{name}: {} of {value} is more than its other parameters allow", p.name);
            return refuse(&["parameters:"], message, &format!("{allowed} would do"));
        }
    }
    Ok(Active { effect: Arc::clone(effect), values })
}

/// What somebody probably meant, or what there is.
pub(super) fn meant<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let mut known: Vec<&str> = known.collect();
    known.dedup();
    match nearest(name, known.iter().copied()) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None if known.is_empty() => "leave it out".to_owned(),
        None => format!("there are {}", known.join(", ")),
    }
}

/// Without the effects of these names.
///
/// # Errors
/// A name that none of them has.
pub fn without(effects: &[Active], names: &[String]) -> Result<Vec<Active>, InputError> {
    let has = || effects.iter().map(|active| active.effect.spec().name);
    if let Some(name) = names.iter().find(|name| !has().any(|known| known == *name)) {
        let help = if effects.is_empty() { "the wing has no effects".to_owned() } else { meant(name, has()) };
        let message = format!("the wing has no effect \"{name}\" to switch off");
        return Err(InputError::general(message).with_help(help));
    }
    let kept = |active: &&Active| !names.iter().any(|name| name == active.effect.spec().name);
    Ok(effects.iter().filter(kept).cloned().collect())
}

impl Active {
    /// The effect as it stands in a wing's file, without what is known of its values.
    pub fn to_wing(&self) -> WingEffect {
        let named = self.parameters().into_iter().zip(&self.values).map(|(p, value)| (p.name, *value));
        WingEffect {
            name: self.effect.spec().name.to_owned(),
            form: self.effect.form().to_owned(),
            parameters: named.collect(),
            ..WingEffect::default()
        }
    }
}
