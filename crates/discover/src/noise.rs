//! Pure error: what repeated measurements differ by, or what was stated.
