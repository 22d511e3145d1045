//! `bouncelab serve`: the browser laboratory, on this computer only.

use std::io;

use clap::Args;
use rust_embed::{EmbeddedFile, RustEmbed};
use tiny_http::{Header, Method, Request, Response, Server, StatusCode};

use crate::failure::Failure;
use crate::terminal::{print, say};

/// Serve the browser laboratory on this computer
///
/// The page runs in the browser; no data leave the computer, and other computers cannot reach it.
/// Ctrl-C stops it.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Port of the server; 0 takes any free port
    #[arg(long, value_name = "PORT", default_value_t = 7878)]
    port: u16,
    /// Do not open the browser
    #[arg(long)]
    no_open: bool,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab serve
  bouncelab serve --port 0 --no-open";

/// The page as `cargo xtask web` built it.
#[derive(RustEmbed)]
#[folder = "../../web/dist"]
#[allow_missing = true]
struct Page;

/// What a browser calls the compression of the copies that the build lays beside the files, which is
/// also the ending of their names.
const BROTLI: &str = "br";

/// What every answer says besides: the page gets nothing from elsewhere and is shown nowhere else.
/// The policy is that of `web/build/policy.ts`.
const HEADERS: [(&str, &str); 6] = [
    (
        "Content-Security-Policy",
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src \
         'self'; img-src 'self' data: blob:; font-src 'self'; connect-src 'self'; media-src 'self' \
         blob:; manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    ("Permissions-Policy", "microphone=(self)"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
];

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if Page::get("index.html").is_none() {
        return Err(Failure::Input(
            "this program was built without the page: run `cargo xtask web` first, then build it \
             again with --features serve"
                .to_owned(),
        ));
    }
    let port = arguments.port;
    let server = Server::http(("127.0.0.1", port)).map_err(|reason| {
        Failure::Input(format!(
            "cannot serve at port {port}: {reason}; choose another one with --port, or any that is \
             free with --port 0"
        ))
    })?;
    let port = server
        .server_addr()
        .to_ip()
        .map_or(port, |address| address.port());
    // By its name, not its number: browsers trust "localhost" with the microphone.
    let address = format!("http://localhost:{port}/");
    print(format_args!(
        "The laboratory is at {address} (Ctrl-C ends it)\n"
    ))?;
    if !arguments.no_open
        && let Err(reason) = open::that_detached(&address)
    {
        say(format_args!(
            "bouncelab: no browser could be opened ({reason}); go to {address} yourself"
        ));
    }
    for request in server.incoming_requests() {
        answer(request);
    }
    Ok(())
}

fn answer(request: Request) {
    let asked = Asked {
        method: request.method().clone(),
        path: path(request.url()).to_owned(),
        host: header(&request, "Host").unwrap_or_default(),
        known: header(&request, "If-None-Match"),
        takes_brotli: header(&request, "Accept-Encoding").is_some_and(|all| names(&all, BROTLI)),
    };
    // A browser that has gone away needs no answer.
    let _ = request.respond(asked.answer());
}

/// What is asked of the server.
struct Asked {
    method: Method,
    /// Without a leading slash.
    path: String,
    host: String,
    /// The version that the browser has.
    known: Option<String>,
    /// Whether the browser takes compressed files.
    takes_brotli: bool,
}

impl Asked {
    fn answer(&self) -> Response<io::Cursor<Vec<u8>>> {
        if !is_local(&self.host) {
            return plain(403, "This page is for this computer only.");
        }
        if !matches!(self.method, Method::Get | Method::Head) {
            return plain(405, "There is nothing to change here.");
        }
        let name = match self.path.as_str() {
            "" => "index.html",
            path => path,
        };
        let compressed = self
            .takes_brotli
            .then(|| Page::get(&format!("{name}.{BROTLI}")));
        match (compressed.flatten(), Page::get(name)) {
            (Some(file), _) => self
                .file(name, &file)
                .with_header(field("Content-Encoding", BROTLI)),
            (None, Some(file)) => self.file(name, &file),
            (None, None) => plain(404, "There is no such page."),
        }
    }

    fn file(&self, name: &str, file: &EmbeddedFile) -> Response<io::Cursor<Vec<u8>>> {
        let version = version(file);
        let is_known = self.known.as_deref() == Some(version.as_str());
        let content = if is_known {
            Vec::new()
        } else {
            file.data.to_vec()
        };
        // Names of assets change with their content; all else may change at any time.
        let keep = if name.starts_with("assets/") {
            "public, max-age=31536000, immutable"
        } else {
            "no-cache"
        };
        respond(if is_known { 304 } else { 200 }, media_type(name), content)
            .with_header(field("Cache-Control", keep))
            .with_header(field("Vary", "Accept-Encoding"))
            .with_header(field("ETag", &version))
    }
}

/// Whether a list of encodings names this one, without reserve.
fn names(encodings: &str, encoding: &str) -> bool {
    let mut all = encodings.split(',');
    all.any(|one| one.trim() == encoding)
}

/// The version of a file: the beginning of its hash, in quotes.
fn version(file: &EmbeddedFile) -> String {
    let hash = file.metadata.sha256_hash();
    let digits: Vec<String> = hash[..8].iter().map(|byte| format!("{byte:02x}")).collect();
    format!("\"{}\"", digits.concat())
}

/// Whether this computer was asked by a name of its own: a page elsewhere may have a name that
/// leads here, too.
fn is_local(host: &str) -> bool {
    let name = host.rsplit_once(':').map_or(host, |(name, _)| name);
    matches!(name, "localhost" | "127.0.0.1")
}

fn path(url: &str) -> &str {
    let path = url.split(['?', '#']).next().unwrap_or_default();
    path.trim_start_matches('/')
}

fn header(request: &Request, name: &'static str) -> Option<String> {
    let mut headers = request.headers().iter();
    let header = headers.find(|header| header.field.equiv(name))?;
    Some(header.value.as_str().to_owned())
}

fn media_type(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("json") => "application/json",
        Some("webmanifest") => "application/manifest+json",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("ico") => "image/x-icon",
        _ => "application/octet-stream",
    }
}

fn plain(status: u16, words: &str) -> Response<io::Cursor<Vec<u8>>> {
    respond(status, "text/plain; charset=utf-8", words.into())
}

fn respond(status: u16, media_type: &str, content: Vec<u8>) -> Response<io::Cursor<Vec<u8>>> {
    let response = Response::from_data(content)
        .with_status_code(StatusCode(status))
        .with_header(field("Content-Type", media_type));
    HEADERS.iter().fold(response, |response, (name, value)| {
        response.with_header(field(name, value))
    })
}

fn field(name: &str, value: &str) -> Header {
    Header::from_bytes(name, value)
        .unwrap_or_else(|()| unreachable!("the names and values here are plain ASCII"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(method: Method, url: &str, host: &str) -> Asked {
        Asked {
            method,
            path: path(url).to_owned(),
            host: host.to_owned(),
            known: None,
            takes_brotli: false,
        }
    }

    fn status(method: Method, url: &str, host: &str) -> u16 {
        asked(method, url, host).answer().status_code().0
    }

    #[test]
    fn only_this_computer_is_answered() {
        assert_eq!(status(Method::Get, "/none", "localhost:7878"), 404);
        assert_eq!(status(Method::Get, "/none", "127.0.0.1"), 404);
        // A name of someone else that leads to this computer.
        assert_eq!(status(Method::Get, "/", "evil.example:7878"), 403);
        assert_eq!(status(Method::Get, "/", ""), 403);
        assert_eq!(status(Method::Post, "/", "localhost"), 405);
    }

    #[test]
    fn nothing_outside_the_page_is_served() {
        for url in [
            "/../Cargo.toml",
            "/..%2fCargo.toml",
            "//etc/passwd",
            "/assets/../../x",
        ] {
            assert_eq!(status(Method::Get, url, "localhost"), 404, "{url}");
        }
    }

    /// The page itself states the same policy, for other servers; only a header can forbid frames.
    #[test]
    fn header_and_page_have_the_same_policy() {
        let source = include_str!("../../../web/build/policy.ts");
        let (_, policy) = HEADERS[0];
        for rule in policy
            .split("; ")
            .filter(|rule| !rule.starts_with("frame-ancestors"))
        {
            assert!(source.contains(&format!("\"{rule}\"")), "{rule}");
        }
    }

    #[test]
    fn every_answer_has_the_headers() {
        let answer = asked(Method::Get, "/none", "localhost").answer();
        for (name, value) in HEADERS {
            let mut headers = answer.headers().iter();
            let found = headers.find(|header| header.field.equiv(name));
            assert_eq!(found.map(|header| header.value.as_str()), Some(value));
        }
    }

    /// Where the page was built before the program.
    #[test]
    fn compressed_files_go_to_those_who_take_them() {
        let encoding = |asked: &Asked| {
            let answer = asked.answer();
            let mut headers = answer.headers().iter();
            let found = headers.find(|header| header.field.equiv("Content-Encoding"));
            (
                found.map(|header| header.value.to_string()),
                answer.data_length(),
            )
        };
        if Page::get("index.html.br").is_none() {
            return;
        }
        let mut asked = asked(Method::Get, "/", "localhost:7878");
        let (plain, whole) = encoding(&asked);
        asked.takes_brotli = names("gzip, deflate, br, zstd", BROTLI);
        let (compressed, part) = encoding(&asked);
        assert_eq!((plain, compressed), (None, Some("br".to_owned())));
        assert!(part < whole);
        assert!(!names("gzip, brand-new", BROTLI));
    }

    /// Where the page was built before the program.
    #[test]
    fn what_a_browser_has_is_not_sent_again() {
        let Some(file) = Page::get("index.html") else {
            return;
        };
        let mut asked = asked(Method::Get, "/?drop=1", "localhost:7878");
        assert_eq!(asked.answer().status_code().0, 200);
        asked.known = Some(version(&file));
        let answer = asked.answer();
        assert_eq!(answer.status_code().0, 304);
        assert_eq!(answer.data_length(), Some(0));
    }
}
