//! `cluster`: what a Slurm or a Kubernetes cluster needs to run a sweep: a script, a manifest, a recipe for an image.

use clap::{Args, Subcommand};

use crate::args::{Common, whole};
use crate::commands::swept::Swept;
use crate::failure::Failure;
use crate::show;
use crate::sweep::estimate::Estimate;
use crate::sweep::lines::sweep_line;

/// Options of `cluster`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot cluster slurm fullaircraft --cases data/tuflex/cases.ron > sweep.sh
  wingroot cluster slurm --parts 8 --cpus 4 hidden --cases 600 --seed 2000000 > sweep.sh
  wingroot cluster kubernetes --image example.org/wingroot --claim loads fullaircraft --cases cases.ron > sweep.yaml
  wingroot cluster containerfile > Containerfile

A few cases are computed first, and kept; parts, memory and time are estimated from them and can be changed in what is written.")]
pub struct ClusterArgs {
    /// What kind of cluster.
    #[command(subcommand)]
    kind: Kind,
}

#[derive(Debug, Clone, Subcommand)]
enum Kind {
    /// A script that submits prepare, an array of parts and merge as dependent jobs
    Slurm(Parts),
    /// Jobs for prepare, indexed parts and merge
    Kubernetes {
        /// Parts and sweep.
        #[command(flatten)]
        parts: Parts,
        /// The image that has the program
        #[arg(long, value_name = "NAME", default_value = "localhost/wingroot", value_parser = name)]
        image: String,
        /// The claim of the volume with input and results
        #[arg(long, value_name = "NAME", default_value = "wingroot", value_parser = name)]
        claim: String,
    },
    /// How the image is built
    Containerfile,
}

/// Into what a sweep is divided.
#[derive(Debug, Clone, Args)]
struct Parts {
    /// Number of parts [default: parts of a quarter of an hour, by the estimate]
    #[arg(long = "parts", value_name = "N", value_parser = whole::<100_000>)]
    count: Option<usize>,
    /// Threads of a part
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = whole::<1024>)]
    cpus: usize,
    /// The sweep: the command that computes it, with its options
    #[command(subcommand)]
    what: Swept,
}

/// Names of images and claims, which stand in YAML as they are.
fn name(text: &str) -> Result<String, String> {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./:@".contains(c);
    let is_name = text.starts_with(|c: char| c.is_ascii_alphanumeric()) && text.chars().all(is_plain);
    if is_name { Ok(text.to_owned()) } else { Err("expected letters, digits and -_./:@".to_owned()) }
}

/// Runs the command.
pub(crate) fn run(args: &ClusterArgs, common: &Common) -> Result<(), Failure> {
    let written = match &args.kind {
        Kind::Containerfile => include_str!("../cluster/Containerfile").to_owned(),
        Kind::Slurm(parts) => parts.filled(include_str!("../cluster/slurm.sh"), common)?,
        Kind::Kubernetes { parts, image, claim } => {
            let text = parts.filled(include_str!("../cluster/kubernetes.yaml"), common)?;
            text.replace("@IMAGE@", image).replace("@CLAIM@", claim)
        }
    };
    show::text(&written)
}

impl Parts {
    /// A template with the numbers of the estimate.
    fn filled(&self, template: &str, common: &Common) -> Result<String, Failure> {
        let estimate = self.what.estimate(common)?;
        let parts = self.count.unwrap_or_else(|| estimate.parts(self.cpus)).min(estimate.cases.max(1));
        Ok(filled(template, &estimate, (parts, self.cpus), &sweep_line()))
    }
}

fn filled(template: &str, estimate: &Estimate, (parts, cpus): (usize, usize), line: &str) -> String {
    // within the quotes of the shell's --wrap and of YAML
    let in_quotes = line.replace('\\', "\\\\").replace('"', "\\\"").replace('$', "\\$").replace('`', "\\`");
    let in_yaml = line.replace('\\', "\\\\").replace('"', "\\\"");
    let comment = format!("#   wingroot {line}");
    let text = template.replace("#   wingroot @LINE@", &comment);
    let numbers = [
        ("@PARTS@", parts),
        ("@LAST@", parts - 1),
        ("@CPUS@", cpus),
        ("@MEMORY_MB@", estimate.memory_mb()),
        ("@PART_MINUTES@", estimate.part_minutes(parts, cpus)),
        ("@PREPARE_MINUTES@", 60),
    ];
    let text = numbers.iter().fold(text, |text, (name, value)| text.replace(name, &value.to_string()));
    text.replace("@ESTIMATE@", &estimate.lines(parts, cpus))
        .replace("@LINE_YAML@", &in_yaml)
        .replace("@LINE@", &in_quotes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn templates_are_filled_and_keep_a_line_with_quotes_one_word_of_the_shell() {
        let estimate = Estimate { cases: 100, seconds: 7200.0, ..Estimate::default() };
        for template in [include_str!("../cluster/slurm.sh"), include_str!("../cluster/kubernetes.yaml")] {
            let text = filled(template, &estimate, (8, 4), "fullaircraft --cases 'my \"cases\".ron'");
            let left = text.replace("@IMAGE@", "").replace("@CLAIM@", "");
            assert!(!left.contains('@') || template.contains("\"$@\""), "{left}");
            assert!(text.contains("merge fullaircraft --cases 'my \\\"cases\\\".ron'"), "{text}");
        }
    }
}
