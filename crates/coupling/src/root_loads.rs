//! Root loads: what the wing puts on the balance.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A load that the balance measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Load {
    /// Force up, N.
    Fz,
    /// Bending moment, tip up, N m.
    Mx,
    /// Torsion moment, nose up, N m.
    My,
}

impl Load {
    /// All, in the order of every table.
    pub const ALL: [Self; 3] = [Self::Fz, Self::Mx, Self::My];

    /// Its column in files of measurements and results.
    pub const fn column(self) -> &'static str {
        ["Fz_N", "Mx_Nm", "My_Nm"][self as usize]
    }
}

/// One value for each load of the balance: a standard deviation, a gap, whether it was measured. In results the values are
/// named as the columns of a run are; inputs (noise) are written `fz_N`, `mx_Nm`, `my_Nm`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ByLoad<T> {
    /// Of the force Fz.
    #[serde(rename(serialize = "Fz_N", deserialize = "fz_N"), alias = "Fz_N")]
    pub fz: T,
    /// Of the bending moment Mx.
    #[serde(rename(serialize = "Mx_Nm", deserialize = "mx_Nm"), alias = "Mx_Nm")]
    pub mx: T,
    /// Of the torsion moment My.
    #[serde(rename(serialize = "My_Nm", deserialize = "my_Nm"), alias = "My_Nm")]
    pub my: T,
}

impl<T> ByLoad<T> {
    /// The value of each load, asked for in the order Fz, Mx, My.
    pub fn from_fn(mut of: impl FnMut(Load) -> T) -> Self {
        let [fz, mx, my] = Load::ALL.map(&mut of);
        Self { fz, mx, my }
    }

    /// From the order Fz, Mx, My.
    pub fn from_array([fz, mx, my]: [T; 3]) -> Self {
        Self { fz, mx, my }
    }

    /// In the order Fz, Mx, My.
    pub fn to_array(self) -> [T; 3] {
        [self.fz, self.mx, self.my]
    }

    /// Another value from each.
    pub fn map<U>(self, of: impl FnMut(T) -> U) -> ByLoad<U> {
        ByLoad::from_array(self.to_array().map(of))
    }

    /// The values in the order Fz, Mx, My.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        [&self.fz, &self.mx, &self.my].into_iter()
    }
}

impl<T> std::ops::Index<Load> for ByLoad<T> {
    type Output = T;
    fn index(&self, load: Load) -> &T {
        match load {
            Load::Fz => &self.fz,
            Load::Mx => &self.mx,
            Load::My => &self.my,
        }
    }
}

impl<T> std::ops::IndexMut<Load> for ByLoad<T> {
    fn index_mut(&mut self, load: Load) -> &mut T {
        match load {
            Load::Fz => &mut self.fz,
            Load::Mx => &mut self.mx,
            Load::My => &mut self.my,
        }
    }
}

/// What the wing puts on the balance, in axes that pitch with it, about the balance point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RootLoads {
    /// Force, up positive, N.
    pub fz_n: f64,
    /// Bending moment, tip up positive (+y Fz), N m.
    pub mx_nm: f64,
    /// Torsion moment, nose up positive (-x Fz), N m.
    pub my_nm: f64,
}

impl RootLoads {
    /// From the order Fz, Mx, My.
    pub fn from_array(values: [f64; 3]) -> Self {
        Self { fz_n: values[0], mx_nm: values[1], my_nm: values[2] }
    }

    /// In the order Fz, Mx, My.
    pub fn to_array(self) -> [f64; 3] {
        [self.fz_n, self.mx_nm, self.my_nm]
    }
}

impl From<RootLoads> for ByLoad<f64> {
    fn from(loads: RootLoads) -> Self {
        Self { fz: loads.fz_n, mx: loads.mx_nm, my: loads.my_nm }
    }
}

impl std::ops::Add for RootLoads {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            fz_n: self.fz_n + other.fz_n,
            mx_nm: self.mx_nm + other.mx_nm,
            my_nm: self.my_nm + other.my_nm,
        }
    }
}

impl std::ops::Sub for RootLoads {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self {
            fz_n: self.fz_n - other.fz_n,
            mx_nm: self.mx_nm - other.mx_nm,
            my_nm: self.my_nm - other.my_nm,
        }
    }
}
