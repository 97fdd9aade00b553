//! One number of a decision with its unit, its meaning and where it comes from; and the macro that declares a theme of them.

/// Where the value of a rule comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// It follows from an equation, or only decides how finely something is computed.
    Formula(&'static str),
    /// What rigs, balances and wings are like.
    Physical(&'static str),
    /// Set so on campaigns whose effects are known; which ones.
    Measured(&'static str),
    /// Nobody knows.
    Unknown,
}

impl std::fmt::Display for Origin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Formula(of) => write!(f, "formula: {of}"),
            Self::Physical(of) => write!(f, "physical tolerance: {of}"),
            Self::Measured(on) => write!(f, "measured on {on}"),
            Self::Unknown => f.write_str("unknown origin, to be replaced"),
        }
    }
}

/// A rule as it is listed.
#[derive(Debug, Clone, PartialEq)]
pub struct Rule {
    /// Name of the field.
    pub name: &'static str,
    /// Its value, as Rust writes it.
    pub value: String,
    /// Unit; empty for a pure number.
    pub unit: &'static str,
    /// What it decides.
    pub meaning: String,
    /// Where the default comes from.
    pub origin: Origin,
}

/// Declares a theme: fields with meaning, type, default, unit and origin; `Default` gives the defaults, `list` the rules.
macro_rules! rules {
    ($(#[doc = $theme:literal])+ $name:ident {
        $($(#[doc = $meaning:literal])+ $rule:ident: $type:ty = $value:expr, $unit:literal, $origin:expr;)+
    }) => {
        $(#[doc = $theme])+
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(default, deny_unknown_fields)]
        pub struct $name {
            $($(#[doc = $meaning])+ pub $rule: $type,)+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($rule: $value,)+ }
            }
        }

        impl $name {
            /// All rules of the theme.
            pub fn list(&self) -> Vec<$crate::rules::rule::Rule> {
                vec![$($crate::rules::rule::Rule {
                    name: stringify!($rule),
                    value: format!("{:?}", self.$rule),
                    unit: $unit,
                    meaning: [$($meaning.trim()),+].join(" "),
                    origin: $origin,
                },)+]
            }
        }
    };
}

pub(super) use rules;
