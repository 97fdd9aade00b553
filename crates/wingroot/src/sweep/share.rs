//! Which share of a sweep a process has: by its options, or by what a Slurm array or a Kubernetes Indexed Job tells it.

use std::fmt;
use std::str::FromStr;

use nastran::InputError;

/// How many parts a sweep has, where the scheduler does not tell: Kubernetes never does, Slurm not if a part of an array runs again.
pub const PARTS: &str = "WINGROOT_PARTS";
/// Number of a task in a Slurm array; its other variables begin with `SLURM_ARRAY_TASK_`.
const SLURM: &str = "SLURM_ARRAY_TASK_ID";
/// Number of a pod in an Indexed Job, from zero.
const KUBERNETES: &str = "JOB_COMPLETION_INDEX";
/// Most parts.
const MOST: usize = 1_000_000;

/// A share of the cases: the `number`-th of `of`, counted from one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Share {
    /// Counted from one.
    pub number: usize,
    /// How many there are.
    pub of: usize,
}

/// A share, and the variable of the environment that names it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The share.
    pub share: Share,
    /// The variable.
    pub variable: &'static str,
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Share {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "expected K/N with K from 1 to N, as 3/8".to_owned();
        let (number, of) = text.split_once('/').ok_or_else(wrong)?;
        let [number, of] = [number, of].map(str::parse::<usize>);
        let (Ok(number), Ok(of)) = (number, of) else { return Err(wrong()) };
        if (1..=of).contains(&number) && of <= MOST { Ok(Self { number, of }) } else { Err(wrong()) }
    }
}

/// The share that the environment names, if it does; `get` reads a variable.
///
/// Tasks of a Slurm array are counted from its smallest number, pods of an Indexed Job from zero. With `WINGROOT_PARTS` both are
/// counted from zero among so many parts.
///
/// # Errors
/// If the variables contradict each other, or leave open how many parts there are.
pub fn of_environment(get: &dyn Fn(&str) -> Option<String>) -> Result<Option<Source>, InputError> {
    let number = |name: &str| -> Result<Option<usize>, InputError> {
        let Some(text) = get(name) else { return Ok(None) };
        let wrong = || {
            InputError::general(format!("the environment has {name}={text}, which is no whole number"))
                .with_help("name the share with --part K/N (1/1 for all cases)")
        };
        text.trim().parse().map(Some).map_err(|_| wrong())
    };
    let parts = number(PARTS)?;
    let refused = |message: String| {
        let help =
            format!("set {PARTS} to the number of parts (tasks are counted from 0 then), or give --part K/N");
        InputError::general(message).with_help(help)
    };
    let share = |zero_based: usize, of: usize, variable: &'static str| {
        let share: Result<Share, String> = format!("{}/{of}", zero_based.saturating_add(1)).parse();
        share.map(|share| Some(Source { share, variable })).map_err(|_| {
            refused(format!("{variable} is {zero_based} parts behind the first, and there are {of}"))
        })
    };
    if let Some(id) = number(SLURM)? {
        if let Some(parts) = parts {
            return share(id, parts, SLURM);
        }
        let of = |what: &str| number(&format!("SLURM_ARRAY_TASK_{what}"));
        let (Some(count), Some(min)) = (of("COUNT")?, of("MIN")?) else {
            return Err(refused(format!(
                "{SLURM} is set, but neither how many tasks there are nor the first"
            )));
        };
        let (max, step) =
            (of("MAX")?.unwrap_or(min + count.saturating_sub(1)), of("STEP")?.unwrap_or(1).max(1));
        if count == 0 || id < min || max < min || max - min != (count - 1) * step || (id - min) % step != 0 {
            return Err(refused(format!(
                "the Slurm array has {count} tasks from {min} to {max}, with gaps: which share task {id} has is not clear"
            )));
        }
        return share((id - min) / step, count, SLURM);
    }
    let Some(index) = number(KUBERNETES)? else { return Ok(None) };
    match parts {
        Some(parts) => share(index, parts, KUBERNETES),
        None => Err(refused(format!("{KUBERNETES} is set, but not how many parts there are"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(variables: &[(&str, &str)]) -> Result<Option<Source>, InputError> {
        let get = |name: &str| {
            variables.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned())
        };
        of_environment(&get)
    }

    fn share(variables: &[(&str, &str)]) -> String {
        of(variables)
            .expect("a share that can be")
            .map_or_else(String::new, |source| source.share.to_string())
    }

    const ARRAY: [&str; 4] =
        ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX"];

    fn array(values: [&'static str; 4]) -> Vec<(&'static str, &'static str)> {
        ARRAY.into_iter().zip(values).collect()
    }

    #[test]
    fn tasks_of_a_slurm_array_are_counted_from_its_first() {
        assert_eq!(share(&array(["0", "8", "0", "7"])), "1/8");
        assert_eq!(share(&array(["8", "8", "1", "8"])), "8/8");
        let mut stepped = array(["30", "4", "10", "40"]);
        stepped.push(("SLURM_ARRAY_TASK_STEP", "10"));
        assert_eq!(share(&stepped), "3/4");
        assert_eq!(share(&[]), "");
    }

    #[test]
    fn an_array_with_gaps_is_refused_unless_the_number_of_parts_is_known() {
        let mut gaps = array(["5", "2", "3", "5"]);
        let said = of(&gaps).expect_err("gaps").to_string();
        assert!(said.contains("from 3 to 5, with gaps"), "{said}");
        gaps.push((PARTS, "8"));
        assert_eq!(share(&gaps), "6/8");
        gaps[0].1 = "8";
        assert!(of(&gaps).is_err(), "the ninth of eight");
    }

    #[test]
    fn pods_of_an_indexed_job_are_counted_from_zero() {
        assert_eq!(share(&[(KUBERNETES, "0"), (PARTS, "16")]), "1/16");
        assert_eq!(share(&[(KUBERNETES, "15"), (PARTS, "16")]), "16/16");
        let said = of(&[(KUBERNETES, "0")]).expect_err("no number of parts").to_string();
        assert!(said.contains("how many parts"), "{said}");
        assert!(of(&[(KUBERNETES, "x"), (PARTS, "16")]).is_err());
    }

    #[test]
    fn shares_outside_of_the_whole_are_refused() {
        for text in ["0/8", "9/8", "1/0", "1", "a/b", "-1/4", "1/4/2"] {
            assert!(text.parse::<Share>().is_err(), "{text}");
        }
    }
}
