//! Files that an input file includes, put in their places.

use super::lines::Lines;
use anyhow::{Context, Result, bail, ensure};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// Files within files within files, at most; Abaqus' own limit.
const MOST_LEVELS: usize = 5;

/// Bytes that all comes to, by those of the files that it is made of, at most.
const MOST_REPEATS: usize = 100;

/// A text in which no file is included any more.
pub struct Expanded {
    /// All lines, those of included files in their places.
    pub text: String,
    /// Where each line stands: number of the file, and line from 1.
    places: Vec<(usize, usize)>,
    files: Vec<PathBuf>,
    /// Bytes of all files that were read, once each.
    size: usize,
}

impl Expanded {
    /// The text of a file with what it includes, which is looked for in the file's folder.
    ///
    /// # Errors
    /// If one of them cannot be read, or they include one another.
    pub fn new(text: &str, path: Option<&Path>) -> Result<Self> {
        let main = path.unwrap_or(Path::new("")).to_path_buf();
        let mut expanded =
            Self { text: String::with_capacity(text.len()), places: Vec::new(), files: vec![main], size: text.len() };
        let folder = path.map(|path| path.parent().unwrap_or(Path::new("")));
        expanded.take(text, folder, &mut vec![0])?;
        Ok(expanded)
    }

    /// Adds a text; `open` are the files that are being read.
    fn take(&mut self, text: &str, folder: Option<&Path>, open: &mut Vec<usize>) -> Result<()> {
        // Editors of Windows mark UTF-8 by its first character.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let file = open[open.len() - 1];
        let mut lines = text.lines().zip(1..).peekable();
        while let Some((line, number)) = lines.next() {
            let trimmed = line.trim();
            if !trimmed.starts_with('*') || trimmed.starts_with("**") {
                self.push(line, file, number);
                continue;
            }
            // A comma at the end goes on in the next line.
            let mut statement = vec![(line, number)];
            while statement.last().is_some_and(|(line, _)| line.trim_end().ends_with(',')) {
                let Some(more) = lines.next_if(|(line, _)| !line.trim_start().starts_with('*')) else { break };
                statement.push(more);
            }
            let whole: String = statement.iter().map(|(line, _)| *line).collect::<Vec<_>>().join("\n");
            let keyword = Lines::new(&whole).keyword();
            let input = keyword.as_ref().and_then(|keyword| keyword.value("INPUT"));
            let is_include = keyword.as_ref().is_some_and(|keyword| keyword.name == "INCLUDE");
            if !is_include {
                statement.iter().for_each(|&(line, number)| self.push(line, file, number));
            }
            match (input, is_include) {
                (Some(name), _) if !name.is_empty() => self
                    .include(name, folder, open)
                    .with_context(|| format!("line {} includes '{name}'", self.place(file, number)))?,
                (_, true) => bail!("line {}: *INCLUDE has no INPUT=", self.place(file, number)),
                _ => {}
            }
        }
        Ok(())
    }

    fn include(&mut self, name: &str, folder: Option<&Path>, open: &mut Vec<usize>) -> Result<()> {
        let folder = folder.context("there is no folder to look for it in")?;
        ensure!(open.len() <= MOST_LEVELS, "files are included in one another more than {MOST_LEVELS} times");
        // Files of Windows name folders with a backslash.
        let exact = folder.join(name);
        let path = if exact.exists() { exact } else { folder.join(name.replace('\\', "/")) };
        let is_file = fs::metadata(&path).with_context(|| format!("{} cannot be read", path.display()))?.is_file();
        ensure!(is_file, "{} is not a file", path.display());
        let bytes = fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
        let known = self.files.iter().position(|file| *file == path);
        let number = known.unwrap_or_else(|| {
            self.files.push(path.clone());
            self.size += bytes.len();
            self.files.len() - 1
        });
        ensure!(!open.contains(&number), "{} includes itself", path.display());
        let total = self.text.len() + bytes.len();
        ensure!(total <= MOST_REPEATS * self.size, "{} is included too often: {total} bytes", path.display());
        open.push(number);
        self.take(&String::from_utf8_lossy(&bytes), Some(folder), open)?;
        open.pop();
        Ok(())
    }

    fn push(&mut self, line: &str, file: usize, number: usize) {
        self.text.push_str(line);
        self.text.push('\n');
        self.places.push((file, number));
    }

    /// A line as messages name it: with its file, unless that is the one that was asked for.
    fn place(&self, file: usize, number: usize) -> String {
        match file {
            0 => number.to_string(),
            _ => format!("{number} of {}", self.files[file].display()),
        }
    }

    /// File and line of a line of the text, as editors and compilers write them.
    pub fn source(&self, line: usize) -> String {
        match self.places.get(line.wrapping_sub(1)) {
            Some(&(file, number)) => format!("{}:{number}", self.files[file].display()),
            None => self.files[0].display().to_string(),
        }
    }

    /// A message about the text, with lines as they stand in the files.
    pub(super) fn in_files(&self, message: &str) -> String {
        if self.files.len() == 1 {
            return message.to_owned();
        }
        let mut parts = message.split("line ");
        let mut told = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let digits = part.len() - part.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            let found = part[..digits].parse().ok().and_then(|number: usize| self.places.get(number.wrapping_sub(1)));
            match found {
                Some(&(file, number)) => {
                    let _ = write!(told, "line {}{}", self.place(file, number), &part[digits..]);
                }
                None => {
                    let _ = write!(told, "line {part}");
                }
            }
        }
        told
    }
}
