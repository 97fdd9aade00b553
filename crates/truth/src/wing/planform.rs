//! The outline of a half wing with straight edges.

/// Half span along y, chords along x, a straight quarter-chord line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planform {
    /// Half span, m.
    pub semispan_m: f64,
    /// Chord at y = 0, m; inboard of it the chord stays.
    pub root_chord_m: f64,
    /// Chord at the tip, m.
    pub tip_chord_m: f64,
    /// Sweep of the quarter-chord line, rad.
    pub sweep_rad: f64,
    /// Leading edge at y = 0, m.
    pub root_leading_x_m: f64,
}

impl Planform {
    /// Chord at a place of the span, m.
    pub fn chord_m(&self, y_m: f64) -> f64 {
        let eta = (y_m / self.semispan_m).max(0.0);
        self.root_chord_m + eta * (self.tip_chord_m - self.root_chord_m)
    }

    /// A point of the chord at a place of the span, m: 0 is the leading edge, 1 the trailing edge.
    pub fn x_m(&self, y_m: f64, share: f64) -> f64 {
        let quarter = self.root_leading_x_m + 0.25 * self.root_chord_m + y_m.max(0.0) * self.sweep_rad.tan();
        quarter + (share - 0.25) * self.chord_m(y_m)
    }

    /// Mean chord, m.
    pub fn mean_chord_m(&self) -> f64 {
        0.5 * (self.root_chord_m + self.tip_chord_m)
    }

    /// Area of the half wing outboard of y = 0, m².
    pub fn area_m2(&self) -> f64 {
        self.mean_chord_m() * self.semispan_m
    }
}
