//! Where the repository is.

use std::path::{Path, PathBuf};

/// The repository's root: the folder above the manifest that cargo names when it runs us, or built us.
pub fn root() -> PathBuf {
    let manifest = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let root =
        manifest.as_deref().and_then(Path::parent).filter(|root| root.join("xtask/Cargo.toml").is_file());
    let built = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.map_or_else(|| built.parent().unwrap_or(built).to_path_buf(), Path::to_path_buf)
}

/// A path inside the repository, short if the command runs in its root (so that messages stay readable).
pub fn path(inside: &str) -> PathBuf {
    let root = root();
    match std::env::current_dir() {
        Ok(here) if here == root => PathBuf::from(inside),
        _ => root.join(inside),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_repository_is_found() {
        assert!(root().join("Cargo.toml").is_file());
        assert!(path("xtask").join("src/repository.rs").is_file());
    }
}
