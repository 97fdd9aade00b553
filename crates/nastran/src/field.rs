//! Fields (placeholder).
