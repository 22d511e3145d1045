//! A page as Markdown for a notebook, with figures as files.

use std::collections::BTreeMap;
use std::fmt::Write;

use bouncelab::Plain;

use super::page::{Block, Language, Page, Section};
use crate::chart::Chart;
use crate::mark::COMMENT;
use crate::table::{Align, Table};

/// A page as Markdown, and the drawings it shows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Markdown {
    /// The text (`CommonMark` with tables; formulas between dollar signs).
    pub text: String,
    /// Name (as in the text, after the folder) and content of each drawing, as SVG.
    pub figures: Vec<(String, String)>,
}

impl Page {
    /// The page as Markdown that looks for its figures in `folder`, a relative path; if empty,
    /// beside itself. Nothing of it is folded.
    pub fn markdown(&self, folder: &str) -> Markdown {
        let mut form = Form {
            language: &self.language,
            folder: folder.to_owned(),
            text: String::new(),
            figures: Vec::new(),
            names: BTreeMap::new(),
        };
        form.block(&format!("# {}", escaped(&self.title)));
        form.block(&format!("*{}*", escaped(&self.subtitle)));
        for block in &self.lead {
            form.piece(block);
        }
        for section in &self.sections {
            form.section(section, 2);
        }
        if !self.details.is_empty() {
            form.block(&format!("## {}", escaped(&self.language.details)));
            for section in &self.details {
                form.section(section, 3);
            }
        }
        form.block(COMMENT);
        Markdown {
            text: form.text,
            figures: form.figures,
        }
    }
}

struct Form<'a> {
    language: &'a Language,
    folder: String,
    text: String,
    figures: Vec<(String, String)>,
    /// How often each name of a figure was used.
    names: BTreeMap<String, usize>,
}

impl Form<'_> {
    /// Something with an empty line after it.
    fn block(&mut self, text: &str) {
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        self.text.push_str(text.trim_end());
        self.text.push('\n');
    }

    fn section(&mut self, section: &Section, level: usize) {
        let marks = "#".repeat(level.min(6));
        self.block(&format!("{marks} {}", escaped(&section.heading)));
        for block in &section.blocks {
            self.piece(block);
        }
        for part in &section.parts {
            self.section(part, level + 1);
        }
    }

    fn piece(&mut self, block: &Block) {
        match block {
            Block::Lead(translator) => self.block(&format!("**{}**", escaped(translator))),
            Block::Text(translator) => self.block(&escaped(translator)),
            Block::Note(translator) => {
                let note = escaped(&self.language.note);
                self.block(&format!("> **{note}.** {}", escaped(translator)));
            }
            Block::List(items) => {
                let rows: Vec<String> = items
                    .iter()
                    .map(|item| format!("- {}", escaped(item)))
                    .collect();
                self.block(&rows.join("\n"));
            }
            Block::Facts(facts) => {
                let mut table = Table::new([("", Align::Left), ("", Align::Left)]);
                for (name, value) in facts {
                    table.row([name.clone(), value.clone()]);
                }
                self.block(&of_table(&table));
            }
            Block::Table { caption, table } => {
                self.block(&format!("**{}**", escaped(caption)));
                self.block(&of_table(table));
            }
            Block::Figure { name, chart } => self.figure(name, chart),
            Block::Equation(equation) => self.block(&format!("$$\n{}\n$$", equation.latex())),
            Block::Code(text) => self.block(&fenced(text)),
        }
    }

    fn figure(&mut self, name: &str, chart: &Chart) {
        let uses = self.names.entry(name.to_owned()).or_default();
        *uses += 1;
        let file = match uses {
            1 => format!("{name}.svg"),
            _ => format!("{name}-{uses}.svg"),
        };
        let path = match self.folder.as_str() {
            "" => file.clone(),
            folder => format!("{folder}/{file}"),
        };
        let number = self.figures.len() + 1;
        let caption = escaped(&chart.caption);
        let word = escaped(&self.language.figure);
        self.block(&format!(
            "![{}](<{}>)\n\n*{word} {number}. {caption}*",
            escaped(&chart.title),
            path.replace(['<', '>', '\n'], "-")
        ));
        self.figures.push((file, chart.svg()));
    }
}

pub(crate) fn of_table(table: &Table) -> String {
    let row = |cells: &mut dyn Iterator<Item = String>| {
        let mut line = String::from("|");
        for cell in cells {
            // Writing to a String cannot fail.
            let _ = write!(line, " {cell} |");
        }
        line
    };
    let mut lines = vec![
        row(&mut table.columns().map(|(name, _)| escaped(name))),
        row(&mut table.columns().map(|(_, align)| match align {
            Align::Left => "---".to_owned(),
            Align::Right => "---:".to_owned(),
        })),
    ];
    lines.extend(
        table
            .rows()
            .iter()
            .map(|cells| row(&mut cells.iter().map(|cell| escaped(cell)))),
    );
    lines.join("\n")
}

/// In a fence longer than any run of backticks inside.
fn fenced(text: &str) -> String {
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    let text = Plain::lines(text);
    format!("{fence}\n{text}\n{fence}")
}

/// The text on one line, so that nothing in it is taken for markup.
pub(crate) fn escaped(text: &str) -> String {
    let text = String::from(Plain::of(text));
    let mut safe = String::with_capacity(text.len());
    for (index, letter) in text.char_indices() {
        match letter {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '$' | '~' | '&' | '#' => {
                safe.push('\\');
                safe.push(letter);
            }
            // At the start of a line these would begin a list.
            '-' | '+' if index == 0 => {
                safe.push('\\');
                safe.push(letter);
            }
            _ => safe.push(letter),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_a_text_is_markup() {
        assert_eq!(escaped("a_b *c* [d](e)"), r"a\_b \*c\* \[d\](e)");
        assert_eq!(escaped("<script>\n# x | y"), r"\<script\>\\n\# x \| y");
        assert_eq!(escaped("- 1"), r"\- 1");
    }

    #[test]
    fn a_fence_is_longer_than_what_it_holds() {
        assert_eq!(fenced("a ``` b"), "````\na ``` b\n````");
        assert_eq!(fenced("a"), "```\na\n```");
    }
}
