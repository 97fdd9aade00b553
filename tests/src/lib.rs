//! Helpers of the validation tests.
