//! What is flown: motions, maneuver files, the servo.

mod maneuver;
mod motion;
mod servo;

pub use maneuver::Maneuver;
pub use motion::Motion;
pub use servo::Servo;
