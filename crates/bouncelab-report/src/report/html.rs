//! A page as one HTML file that loads nothing.
//!
//! The policy in its head forbids the browser every request, so that a figure or a font can never
//! come from elsewhere, nor a script run.

use bouncelab::Plain;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::page::{Block, Language, Page, Section};
use crate::chart::Chart;
use crate::mark::MARK;
use crate::table::{Align, Table};

pub(crate) const STYLE: &str = include_str!("style.css");

/// Nothing may be fetched and nothing run; the style is in the file.
pub(crate) const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

impl Page {
    /// The page as a whole file.
    pub fn html(&self) -> String {
        let mut form = Form {
            language: &self.language,
            sections: 0,
            figures: 0,
        };
        let page = html! {
            (DOCTYPE)
            html lang=(self.language.code) {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy" content=(POLICY);
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    meta name="generator" content={ (MARK) " " (env!("CARGO_PKG_VERSION")) };
                    title { (self.title) }
                    link rel="icon" href="data:,";
                    style { (PreEscaped(STYLE)) (PreEscaped(self.foot_style())) }
                }
                body .compact[self.compact] {
                    header {
                        @if let Some(logo) = &self.logo { img .logo src=(logo) alt=""; }
                        h1 { (self.title) }
                        p .subtitle { (self.subtitle) }
                    }
                    main {
                        @if !self.lead.is_empty() {
                            div .lead { @for block in &self.lead { (form.block(block)) } }
                        }
                        @for section in &self.sections { (form.section(section, 2)) }
                        @if !self.details.is_empty() {
                            details open[self.unfolded] {
                                summary { h2 { (self.language.details) } }
                                @for section in &self.details { (form.section(section, 3)) }
                            }
                        }
                    }
                }
            }
        };
        Plain::lines(&page.into_string()).into()
    }
}

impl Page {
    /// The style of the foot of printed pages. Texts of others cannot end the style: they are within quotation marks, and
    /// what could end those or the element is escaped.
    fn foot_style(&self) -> String {
        let [before, between, behind] = self.language.page.each_ref().map(|text| quoted(text));
        format!(
            "@page {{ @bottom-left {{ content: {}; }} @bottom-right {{ content: {before} counter(page) {between} \
             counter(pages) {behind}; }} }}",
            quoted(&self.foot)
        )
    }
}

/// A text in a style: letters and digits as they are, all else by its number.
fn quoted(text: &str) -> String {
    let escaped = text.chars().map(|c| {
        if c.is_alphanumeric() || c == ' ' {
            c.to_string()
        } else {
            format!("\\{:x} ", u32::from(c))
        }
    });
    format!("\"{}\"", escaped.collect::<String>())
}

/// A table or a text of up to this count of rows stays on one page.
const SHORT: usize = 16;

/// State while a page is written.
struct Form<'a> {
    language: &'a Language,
    sections: usize,
    figures: usize,
}

impl Form<'_> {
    fn section(&mut self, section: &Section, level: usize) -> Markup {
        self.sections += 1;
        let id = id(self.sections);
        html! {
            section aria-labelledby=(id) {
                (heading(&section.heading, level, &id))
                @for block in &section.blocks { (self.block(block)) }
                @for part in &section.parts { (self.section(part, level + 1)) }
            }
        }
    }

    fn block(&mut self, block: &Block) -> Markup {
        match block {
            Block::Lead(translator) => html! { p .first { (translator) } },
            Block::Text(translator) => html! { p { (translator) } },
            Block::Note(translator) => {
                html! { p .note { strong { (self.language.note) ". " } (translator) } }
            }
            Block::List(items) => html! { ul { @for item in items { li { (item) } } } },
            Block::Facts(facts) => html! {
                dl { @for (name, value) in facts { div { dt { (name) } dd { (value) } } } }
            },
            Block::Table { caption, table } => of_table(caption, table),
            Block::Figure { chart, .. } => self.figure(chart),
            Block::Equation(equation) => html! {
                // What is wider than the screen moves sideways, also by the keyboard; its section names it.
                div .equation role="group" aria-labelledby=(id(self.sections)) tabindex="0" {
                    math display="block" { mrow { (equation.mathml()) } }
                }
            },
            Block::Code(text) => {
                html! { pre .short[text.lines().count() <= SHORT] { code { (text) } } }
            }
        }
    }

    fn figure(&mut self, chart: &Chart) -> Markup {
        self.figures += 1;
        html! {
            figure id={ "figure-" (self.figures) } {
                (PreEscaped(chart.svg()))
                figcaption { b { (self.language.figure) " " (self.figures) ". " } (chart.caption) }
            }
        }
    }
}

/// Of the heading of the section with this number.
fn id(section: usize) -> String {
    format!("section-{section}")
}

fn heading(text: &str, level: usize, id: &str) -> Markup {
    match level {
        0..=2 => html! { h2 id=(id) { (text) } },
        3 => html! { h3 id=(id) { (text) } },
        _ => html! { h4 id=(id) { (text) } },
    }
}

fn of_table(caption: &str, table: &Table) -> Markup {
    let side = |align: &Align| match align {
        Align::Left => None,
        Align::Right => Some("number"),
    };
    html! {
        // Wide tables move sideways by themselves, also by the keyboard.
        div .table .short[table.rows().len() <= SHORT] role="region" aria-label=(caption) tabindex="0" {
            table {
                caption { (caption) }
                thead {
                    tr {
                        @for (name, align) in table.columns() {
                            // A column without a name has no heading.
                            @if name.is_empty() { td {} }
                            @else { th class=[side(align)] scope="col" { (name) } }
                        }
                    }
                }
                tbody {
                    @for row in table.rows() {
                        tr { @for (cell, (_, align)) in row.iter().zip(table.columns()) {
                            td class=[side(align)] { (cell) }
                        } }
                    }
                }
            }
        }
    }
}
