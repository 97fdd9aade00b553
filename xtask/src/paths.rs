//! Where things are: paths the user gives start from the current folder, defaults from the repository root.

use std::path::{Path, PathBuf};

/// The repository root: two folders above the manifest that cargo names when it runs us, or built us.
pub fn repository() -> PathBuf {
    let manifest = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let root =
        manifest.as_deref().and_then(Path::parent).filter(|root| root.join("xtask/Cargo.toml").is_file());
    let built = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.map_or_else(|| built.parent().unwrap_or(built).to_path_buf(), Path::to_path_buf)
}

/// A path inside the repository, short if the command runs in its root (so that messages stay readable).
pub fn in_repository(path: &str) -> PathBuf {
    let root = repository();
    match std::env::current_dir() {
        Ok(here) if here == root => PathBuf::from(path),
        _ => root.join(path),
    }
}

/// What the user gave, or else the default inside the repository.
pub fn given_or(given: Option<&Path>, default: &str) -> PathBuf {
    given.map_or_else(|| in_repository(default), Path::to_path_buf)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_repository_is_found() {
        assert!(repository().join("Cargo.toml").is_file());
        assert!(in_repository("xtask").join("src/paths.rs").is_file());
        assert_eq!(given_or(Some(Path::new("a.ron")), "b.ron"), PathBuf::from("a.ron"));
    }
}
