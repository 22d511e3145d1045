//! Messages: every language has all of them, and the code asks for none that is not there.
//!
//! The languages are compared with English. The code is read as text: an id is a string literal, and a
//! message is used if its id, or the beginning that a group of ids shares, is one.

#![expect(clippy::disallowed_methods, reason = "names of files of the project")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use bouncelab::diagnostic::Code;
use bouncelab::rulebook::{Requirement, Rule};
use bouncelab_report::messages::{Translator, languages};
use bouncelab_report::rules::words;
use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement, Resource};
use fluent_syntax::parser;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The arguments of each message of a language, by file and id.
type Messages = BTreeMap<(String, String), BTreeSet<String>>;

fn messages(language: &str) -> Messages {
    let folder = root()
        .join("crates/bouncelab-report/messages")
        .join(language);
    let mut messages = Messages::new();
    for file in fs::read_dir(&folder).unwrap() {
        let path = file.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let parsed: Resource<String> = parser::parse(fs::read_to_string(&path).unwrap())
            .unwrap_or_else(|(_, errors)| panic!("{}: {errors:?}", path.display()));
        for entry in parsed.body {
            let Entry::Message(message) = entry else {
                continue;
            };
            let mut arguments = BTreeSet::new();
            collect(&message.value.unwrap(), &mut arguments);
            messages.insert((name.clone(), message.id.name), arguments);
        }
    }
    messages
}

/// The names of the arguments, and in brackets the messages that are part of this one.
fn collect(pattern: &Pattern<String>, arguments: &mut BTreeSet<String>) {
    for element in &pattern.elements {
        if let PatternElement::Placeable { expression } = element {
            collect_from(expression, arguments);
        }
    }
}

fn collect_from(expression: &Expression<String>, arguments: &mut BTreeSet<String>) {
    let mut inline = |expression: &InlineExpression<String>| match expression {
        InlineExpression::VariableReference { id } => {
            arguments.insert(id.name.clone());
        }
        InlineExpression::MessageReference { id, .. } => {
            arguments.insert(format!("({})", id.name));
        }
        InlineExpression::StringLiteral { .. } => {}
        other => panic!("not supported: {other:?}"),
    };
    match expression {
        Expression::Inline(one) => inline(one),
        Expression::Select { selector, variants } => {
            inline(selector);
            for variant in variants {
                collect(&variant.value, arguments);
            }
        }
    }
}

#[test]
fn every_language_has_every_message_with_the_same_arguments_and_no_more() {
    let english = messages("en");
    assert!(languages().count() > 1, "there is nothing to compare");
    let ids: BTreeSet<&str> = english.keys().map(|(_, id)| id.as_str()).collect();
    assert_eq!(ids.len(), english.len(), "an id is in two files");
    for language in languages() {
        assert_eq!(messages(language), english, "{language}");
        let translator = Translator::new(language).unwrap();
        let own = english.keys().filter(|(file, _)| file != "page.ftl");
        assert!(own.clone().all(|(_, id)| translator.has(id)));
    }
}

/// Fluent's names of the arguments of a code.
fn arguments_of(code: Code) -> BTreeSet<String> {
    let names = code.arguments().iter();
    names
        .map(|name| name.trim_end_matches('?').to_owned())
        .collect()
}

#[test]
fn every_diagnostic_has_a_sentence_with_no_other_arguments_than_its_own() {
    let english = messages("en");
    for code in Code::ALL {
        let key = ("diagnostics.ftl".to_owned(), format!("diagnostic-{code}"));
        let used = english
            .get(&key)
            .unwrap_or_else(|| panic!("{code} has no sentence"));
        let known = arguments_of(*code);
        assert!(used.is_subset(&known), "{code}: {used:?}, {known:?}");
    }
    let codes: BTreeSet<&str> = Code::ALL.iter().map(|code| code.name()).collect();
    for (file, id) in english.keys() {
        if let Some((_, code)) = id.split_once("-advice-") {
            assert!(
                file == "advice.ftl" && codes.contains(code),
                "{id} is of no code"
            );
        }
        let code = id.strip_prefix("diagnostic-");
        assert!(
            code.is_none_or(|code| codes.contains(code)),
            "{id} is of no code"
        );
    }
}

/// The English sentences of the diagnostics by message id, with `…` for each argument.
fn sentences() -> BTreeMap<String, String> {
    let file = root().join("crates/bouncelab-report/messages/en/diagnostics.ftl");
    let parsed: Resource<String> = parser::parse(fs::read_to_string(file).unwrap()).unwrap();
    let sentences = parsed.body.into_iter().filter_map(|entry| match entry {
        Entry::Message(message) => Some((message.id.name, printed(&message.value.unwrap()))),
        _ => None,
    });
    sentences.collect()
}

/// A message as it is printed, with the default variant of each selection.
fn printed(pattern: &Pattern<String>) -> String {
    let parts = pattern.elements.iter().map(|element| match element {
        PatternElement::TextElement { value } => value.replace('\n', " "),
        PatternElement::Placeable { expression } => match expression {
            Expression::Inline(InlineExpression::StringLiteral { value }) => value.clone(),
            Expression::Inline(_) => "…".to_owned(),
            Expression::Select { variants, .. } => {
                let default = variants.iter().find(|variant| variant.default);
                printed(&default.unwrap().value)
            }
        },
    });
    parts.collect()
}

/// The page of all codes lists each once, with its severity and the sentence that is printed.
#[test]
fn every_diagnostic_is_documented() {
    let page = fs::read_to_string(root().join("docs/diagnostics.md")).unwrap();
    let sentences = sentences();
    let rows: Vec<Vec<&str>> = page
        .lines()
        .filter(|line| line.starts_with("| `"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    let listed: Vec<_> = rows.iter().map(|row| row[0].trim_matches('`')).collect();
    let codes: Vec<&str> = Code::ALL.iter().map(|code| code.name()).collect();
    assert_eq!(listed, codes);
    for (row, code) in rows.iter().zip(Code::ALL) {
        let severity = format!("{:?}", code.severity()).to_lowercase();
        assert_eq!(row[1], severity, "{code}");
        assert_eq!(row[2], sentences[&format!("diagnostic-{code}")].trim());
        assert!(
            row.len() == 4 && row.iter().all(|cell| !cell.is_empty()),
            "{code}"
        );
    }
}

/// Whether this is a test of the page.
fn is_test(path: &Path) -> bool {
    path.file_stem()
        .is_some_and(|stem| stem.to_string_lossy().ends_with(".test"))
}

/// All source files that may ask for a message.
fn sources() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().join("web/src")];
    for crate_folder in fs::read_dir(root().join("crates")).unwrap() {
        folders.push(crate_folder.unwrap().path().join("src"));
    }
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).into_iter().flatten() {
            let path = entry.unwrap().path();
            let ending = path.extension().and_then(|ending| ending.to_str());
            if path.is_dir() {
                folders.push(path);
            } else if matches!(ending, Some("rs" | "ts" | "tsx")) && !is_test(&path) {
                found.push(path);
            }
        }
    }
    found
}

/// The string literals of a file: what stands before a gap (`{name}`, `${name}`) if there is one, and
/// where the literal ends.
fn literals(source: &str) -> Vec<(&str, bool, usize)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = source[at..].find(['"', '\'', '`']) {
        let start = at + start;
        let is_id = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        let rest = &source[start + 1..];
        let length = rest.find(|c| !is_id(c)).unwrap_or(rest.len());
        let after = &rest[length..];
        let gap = after.starts_with('{') || after.starts_with("${");
        if length > 0 && (gap || after.starts_with(&source[start..=start])) {
            found.push((&rest[..length], gap, start + 1 + length));
        }
        at = start + 1 + length;
    }
    found
}

#[test]
fn every_quantity_that_is_refused_has_a_name_in_every_language() {
    for language in languages() {
        let translator = Translator::new(language).unwrap();
        for quantity in bouncelab::Quantity::ALL {
            let id = format!("input-{}", quantity.key());
            assert!(translator.has(&id), "{language}: {id}");
        }
    }
}

/// English says what the files of rules say, and every text of them has its message in the other languages.
#[test]
fn the_rules_that_are_built_in_speak_every_language() {
    let rules = bouncelab_report::rules::all(&[]).unwrap();
    let said: BTreeSet<String> = rules.iter().flat_map(words_of).collect();
    let ids = messages("en").into_keys();
    let written = ids.filter(|(file, _)| file == "rules.ftl");
    assert_eq!(written.count(), said.len());
    for rule in &rules {
        let known = [Some(&rule.title), rule.note.as_ref(), rule.surface.as_ref()];
        let shown = |words: &Translator| {
            [
                Some(words::title(rule, words)),
                words::note(rule, words),
                rule.surface
                    .as_ref()
                    .map(|name| words::surface(name, words)),
            ]
        };
        let english = shown(&Translator::english());
        assert_eq!(english.each_ref().map(Option::as_ref), known);
        let french = shown(&Translator::new("fr").unwrap());
        let (french, english) = (french.iter().flatten(), english.iter().flatten());
        assert!(
            french
                .zip(english)
                .all(|(french, english)| french != english)
        );
    }
    let mut own = rules[0].clone();
    own.title = "Our hall".to_owned();
    let german = Translator::new("de").unwrap();
    assert_eq!(words::title(&own, &german), "Our hall");
}

/// Title, surfaces and note of a rule.
fn words_of(rule: &Rule) -> Vec<String> {
    let reference = match &rule.requirement {
        Requirement::Share { of, .. } => Some(of.clone()),
        _ => None,
    };
    let words = [
        rule.surface.clone(),
        reference,
        rule.note.clone(),
        rule.conditioning.clone(),
    ];
    let words = words.into_iter().flatten();
    words.chain([rule.title.clone()]).collect()
}

#[test]
fn a_refusal_has_the_numbers_of_its_language() {
    let refused = bouncelab::rulebook::Rule::new("a", "", 30.5)
        .check()
        .unwrap_err();
    let german = Translator::new("de")
        .unwrap()
        .diagnostic(&refused.diagnostic());
    assert_eq!(german, "Fallhöhe: 30,5 m; erlaubt ist: von 0,01 bis 20");
    let refused = bouncelab::ball::Ball::new(0.0, 0.04).unwrap_err();
    let english = Translator::english().diagnostic(&refused.diagnostic());
    assert_eq!(
        english,
        "Ball mass is 0 kg; it must be from 1×10⁻²⁰ to 1×10²⁰"
    );
}

/// The lines of the files of a language, without remarks.
fn lines(language: &str) -> Vec<String> {
    let folder = root()
        .join("crates/bouncelab-report/messages")
        .join(language);
    let files = fs::read_dir(folder).unwrap();
    let sources = files.map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
    let lines = sources.flat_map(|source| source.lines().map(str::to_owned).collect::<Vec<_>>());
    lines.filter(|line| !line.starts_with('#')).collect()
}

/// A term of the glossary is the one that the messages of its language use.
#[test]
fn messages_use_the_terms_of_the_glossary() {
    let page = fs::read_to_string(root().join("docs/glossary.md")).unwrap();
    let mut tables = page.lines().filter(|line| line.starts_with("| "));
    let said = ["en", "de", "fr", "es"].map(|language| lines(language).join(" ").to_lowercase());
    let rows = tables.clone().filter(|row| !row.starts_with("| English"));
    assert!(tables.any(|row| row.starts_with("| English | German | French | Spanish |")));
    let mut unused = Vec::new();
    for row in rows {
        for (cell, said) in row.split('|').skip(1).zip(&said) {
            let terms = cell.split('(').next().unwrap().split(',').map(str::trim);
            unused.extend(terms.filter(|term| !said.contains(&term.to_lowercase())));
        }
    }
    assert!(unused.is_empty(), "no message has these terms: {unused:#?}");
}

/// French has a narrow space that does not break before signs of two parts and within its quotation marks.
#[test]
fn french_signs_have_their_space() {
    const SPACE: char = '\u{202f}';
    let is_wrong = |line: &String| {
        let letters: Vec<char> = format!("{line} ").chars().collect();
        let mut signs = letters.windows(3);
        signs.any(|three| match *three {
            [before, ':' | ';' | '?' | '!' | '»', ' ' | ')'] => !matches!(before, SPACE | '('),
            ['«', after, _] => after != SPACE,
            _ => false,
        })
    };
    let wrong: Vec<String> = lines("fr").into_iter().filter(is_wrong).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Readers are addressed as pupils are, by "tu" and "tú".
#[test]
fn readers_are_addressed_as_pupils() {
    for (language, formal) in [
        ("fr", &["vous", "votre", "vos"][..]),
        ("es", &["usted"][..]),
    ] {
        let is_formal = |line: &String| {
            let mut words = line
                .split(|c: char| !c.is_alphabetic())
                .map(str::to_lowercase);
            words.any(|word| formal.contains(&word.as_str()) || language == "fr" && is_order(&word))
        };
        let found: Vec<String> = lines(language).into_iter().filter(is_formal).collect();
        assert!(found.is_empty(), "{language}: {found:#?}");
    }
}

/// Whether a French word has the ending of an order to several, or to a stranger.
fn is_order(word: &str) -> bool {
    word.ends_with("ez") && !["assez", "chez"].contains(&word)
}

/// Numbers in messages are written as the language writes them; only what the program reads has a point.
#[test]
fn messages_have_the_decimal_sign_of_their_language() {
    const READ: [&str; 3] = ["constant:0.4", "[0.1, 0.45]", "0.125."];
    for language in languages() {
        let point = Translator::new(language).unwrap().text("decimal-point");
        let has_other = |line: &String| {
            let line = READ
                .iter()
                .fold(line.clone(), |line, read| line.replace(read, ""));
            let letters: Vec<char> = line.chars().collect();
            let mut parts = letters.windows(3);
            let is_number = |three: &[char]| three[0].is_ascii_digit() && three[2].is_ascii_digit();
            let other = if point == "," { '.' } else { ',' };
            parts.any(|three| is_number(three) && three[1] == other)
        };
        let wrong: Vec<String> = lines(language).into_iter().filter(has_other).collect();
        assert!(wrong.is_empty(), "{language}: {wrong:#?}");
    }
}

/// What looks like an id and is the name of a figure, a class, a colour or a diagnostic.
const OTHER_NAMES: [&str; 6] = [
    "ball-not-stated",
    "drag-log",
    "drag-text",
    "drag-tint",
    "figure-",
    "figure-box",
];

/// What has keys of its own, and asks for no message or is tested by itself.
const OTHER_KEYS: [&str; 3] = [
    "crates/bouncelab/src",
    "crates/bouncelab-report/src/paper",
    "web/src/lab/engine",
];

/// The part of an id that says what group it belongs to.
fn group(id: &str) -> &str {
    id.split_once('-').map_or(id, |(group, _)| group)
}

#[test]
fn the_code_asks_for_every_message_and_for_no_other() {
    let english = messages("en");
    let ids: BTreeSet<&str> = english.keys().map(|(_, id)| id.as_str()).collect();
    let groups: BTreeSet<&str> = ids.iter().map(|id| group(id)).collect();
    let sources: Vec<(PathBuf, String)> = sources()
        .into_iter()
        .map(|path| (path.clone(), fs::read_to_string(path).unwrap()))
        .collect();
    assert!(sources.len() > 100, "the sources are elsewhere");
    let mut used: BTreeSet<String> = english
        .values()
        .flatten()
        .filter_map(|argument| argument.strip_prefix('(')?.strip_suffix(')'))
        .map(str::to_owned)
        .collect();
    let mut missing = Vec::new();
    for (path, source) in &sources {
        let asks = OTHER_KEYS
            .iter()
            .all(|keys| !path.starts_with(root().join(keys)));
        for (literal, gap, _) in literals(source) {
            let is_it = |id: &&&str| {
                if gap {
                    literal.contains('-') && id.starts_with(literal)
                } else {
                    **id == literal
                }
            };
            let asked: Vec<_> = ids.iter().filter(is_it).map(ToString::to_string).collect();
            let belongs = literal.contains('-') && groups.contains(group(literal));
            if asked.is_empty() && belongs && asks && !OTHER_NAMES.contains(&literal) {
                missing.push(format!("{}: {literal}", path.display()));
            }
            used.extend(asked);
        }
    }
    // Advice belongs to a code, as another test says.
    let is_used = |id: &str| used.contains(id) || id.contains("-advice-");
    let unused: Vec<_> = ids.iter().filter(|id| !is_used(id)).collect();
    assert!(missing.is_empty(), "no message has these ids: {missing:#?}");
    assert!(
        unused.is_empty(),
        "nothing asks for these messages: {unused:#?}"
    );
}

/// The names in `&[("name", value), ...]`, which follows the id of a message; `None` if some are elsewhere.
fn arguments_after(source: &str) -> Option<BTreeSet<String>> {
    let list = source
        .strip_prefix("\",")?
        .trim_start()
        .strip_prefix("&[")?;
    let mut depth = 0;
    let mut names = BTreeSet::new();
    let mut begins = true;
    for (at, letter) in list.char_indices() {
        if depth == 0 && begins && letter == '(' {
            let name = list[at + 1..].trim_start().strip_prefix('"')?;
            names.insert(name.split('"').next()?.to_owned());
        } else if depth == 0 && begins && !letter.is_whitespace() && letter != ']' {
            return None;
        }
        match letter {
            '(' | '[' | '{' => depth += 1,
            ']' if depth == 0 => return Some(names),
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        begins = depth == 0 && (letter == ',' || begins && letter.is_whitespace());
    }
    None
}

#[test]
fn the_code_gives_every_message_its_arguments() {
    let english = messages("en");
    let wanted = |id: &str| {
        let (_, arguments) = english.iter().find(|((_, name), _)| name == id)?;
        Some(arguments)
    };
    let mut wrong = Vec::new();
    let mut checked = 0;
    for path in sources() {
        let source = fs::read_to_string(&path).unwrap();
        for (literal, gap, end) in literals(&source) {
            let Some(wanted) = wanted(literal).filter(|_| !gap) else {
                continue;
            };
            // What a message takes over from another is checked where that is used by itself.
            let direct: BTreeSet<String> = wanted
                .iter()
                .filter(|name| !name.starts_with('('))
                .cloned()
                .collect();
            let given = match arguments_after(&source[end..]) {
                Some(given) => given,
                None if source[..end].ends_with(&format!(".text(\"{literal}"))
                    && source[end..].starts_with("\")") =>
                {
                    BTreeSet::new()
                }
                None => continue,
            };
            checked += 1;
            if given != direct {
                wrong.push(format!(
                    "{}: {literal} takes {direct:?}, not {given:?}",
                    path.display()
                ));
            }
        }
    }
    assert!(checked > 0, "no message is asked for");
    assert!(wrong.is_empty(), "{wrong:#?}");
}
