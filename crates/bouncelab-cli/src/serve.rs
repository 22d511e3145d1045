//! `bouncelab serve`: the browser laboratory, on this computer only.

use std::convert::Infallible;
use std::future::{poll_fn, ready};
use std::io;
use std::net::{Ipv4Addr, Ipv6Addr, TcpListener};
use std::pin::{Pin, pin};
use std::sync::Arc;
use std::task::Poll;
use std::time::Duration;

use clap::Args;
use http_body_util::Full;
use hyper::body::{Bytes, Incoming};
use hyper::header::{ACCEPT_ENCODING, HOST, HeaderName, HeaderValue, IF_NONE_MATCH};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, Response, StatusCode};
use hyper_util::rt::TokioIo;
use rust_embed::{EmbeddedFile, RustEmbed};
use tokio::sync::Semaphore;
use tokio::task::JoinSet;
use tokio::time::sleep;

use crate::failure::Failure;
use crate::language::text_with;
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

/// Headers of every answer: the page loads nothing from elsewhere and is shown nowhere else.
const HEADERS: [(&str, &str); 6] = [
    (
        "content-security-policy",
        // The page itself states the same policy, for other servers (`web/build/policy.ts`).
        include_str!("policy.txt").trim_ascii_end(),
    ),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("permissions-policy", "camera=(self), microphone=(self)"),
    ("cross-origin-opener-policy", "same-origin"),
    ("cross-origin-resource-policy", "same-origin"),
];

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    files()?;
    let listeners = bind(arguments.port)?;
    let port = listeners[0].local_addr()?.port();
    // By its name, not its number: browsers trust "localhost" with the microphone.
    let address = format!("http://localhost:{port}/");
    let at = [("address", address.as_str().into())];
    print(format_args!("{}\n", text_with("serve-address", &at)))?;
    if !arguments.no_open
        && let Err(reason) = open::that_detached(&address)
    {
        let [at] = at;
        let why = text_with(
            "serve-no-browser",
            &[at, ("reason", reason.to_string().into())],
        );
        say(format_args!("bouncelab: {why}"));
    }
    let served = serve(listeners, &LIMITS);
    served.map_err(|reason| Failure::Input(format!("cannot serve any longer: {reason}")))
}

/// Every file of the page: its name, with folders, and its content.
pub(crate) fn files() -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let named = Page::iter().filter_map(|name| {
        let file = Page::get(&name)?;
        Some((name.into_owned(), file.data.into_owned()))
    });
    let files: Vec<_> = named.collect();
    if files.iter().any(|(name, _)| name == "index.html") {
        return Ok(files);
    }
    Err(Failure::Input(
        "this program was built without the page. In the folder of the sources, `cargo xtask install` builds the \
         page and installs the program with it (it needs Node.js)"
            .to_owned(),
    ))
}

/// Takes the port in both families of addresses to which "localhost" leads; 0 is any.
fn bind(port: u16) -> Result<Vec<TcpListener>, Failure> {
    let taken = |reason: io::Error| {
        Failure::Input(format!(
            "cannot serve at port {port}: {reason}; choose another one with --port, or any that is \
             free with --port 0"
        ))
    };
    let first = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(taken)?;
    let same_port = first.local_addr().map_err(taken)?.port();
    match TcpListener::bind((Ipv6Addr::LOCALHOST, same_port)) {
        Ok(second) => Ok(vec![first, second]),
        // Browsers may try it first: another program must not answer there.
        Err(reason) if reason.kind() == io::ErrorKind::AddrInUse => match port {
            // While the first is held, the system gives another one.
            0 => bind(0),
            _ => Err(taken(reason)),
        },
        Err(_) => Ok(vec![first]),
    }
}

/// What clients may take.
struct Limits {
    /// How many are answered at a time; others wait.
    clients: usize,
    /// Bytes of the head of a request.
    head: usize,
    /// Ends when a client has taken too long, from the connection to the end of the answer.
    patience: fn() -> Pin<Box<dyn Future<Output = ()> + Send>>,
}

const LIMITS: Limits = Limits {
    clients: 64,
    head: 16 << 10,
    patience: || Box::pin(sleep(Duration::from_secs(10))),
};

/// Answers clients; returns only on a failure.
fn serve(listeners: Vec<TcpListener>, limits: &'static Limits) -> io::Result<()> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()?;
    runtime.block_on(async {
        let permits = Arc::new(Semaphore::new(limits.clients));
        let mut doors = JoinSet::new();
        for listener in listeners {
            listener.set_nonblocking(true)?;
            let listener = tokio::net::TcpListener::from_std(listener)?;
            doors.spawn(admit(listener, Arc::clone(&permits), limits));
        }
        doors.join_all().await;
        Ok(())
    })
}

/// Answers the clients of one address.
async fn admit(
    listener: tokio::net::TcpListener,
    permits: Arc<Semaphore>,
    limits: &'static Limits,
) {
    /// The system may have no more connections for now.
    const RETRY: Duration = Duration::from_millis(100);
    while let Ok(permit) = Arc::clone(&permits).acquire_owned().await {
        let Ok((stream, _)) = listener.accept().await else {
            sleep(RETRY).await;
            continue;
        };
        tokio::spawn(async move {
            let service = service_fn(|request| ready(Ok::<_, Infallible>(answer(&request))));
            let connection = http1::Builder::new()
                .keep_alive(false)
                .max_buf_size(limits.head)
                .serve_connection(TokioIo::new(stream), service);
            // A client that has gone, or takes too long, needs no answer.
            let (mut connection, mut patience) = (pin!(connection), (limits.patience)());
            poll_fn(|context| {
                let is_over = connection.as_mut().poll(context).is_ready()
                    || patience.as_mut().poll(context).is_ready();
                if is_over {
                    Poll::Ready(())
                } else {
                    Poll::Pending
                }
            })
            .await;
            drop(permit);
        });
    }
}

fn answer(request: &Request<Incoming>) -> Response<Full<Bytes>> {
    let header = |name: HeaderName| {
        let value = request.headers().get(name)?;
        Some(value.to_str().ok()?.to_owned())
    };
    let asked = Asked {
        method: request.method().clone(),
        path: path(request.uri().path()).to_owned(),
        host: header(HOST).unwrap_or_default(),
        cached: header(IF_NONE_MATCH),
        takes_brotli: header(ACCEPT_ENCODING).is_some_and(|all| names(&all, BROTLI)),
    };
    asked.answer()
}

/// A request.
struct Asked {
    method: Method,
    /// Without a leading slash.
    path: String,
    host: String,
    /// The version that the browser has.
    cached: Option<String>,
    /// Whether the browser takes compressed files.
    takes_brotli: bool,
}

impl Asked {
    fn answer(&self) -> Response<Full<Bytes>> {
        if !is_local(&self.host) {
            return plain(403, "This page is for this computer only.");
        }
        if !matches!(self.method, Method::GET | Method::HEAD) {
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
            (Some(file), _) => {
                let mut answer = self.file(name, &file);
                set(&mut answer, "content-encoding", BROTLI);
                answer
            }
            (None, Some(file)) => self.file(name, &file),
            (None, None) => plain(404, "There is no such page."),
        }
    }

    fn file(&self, name: &str, file: &EmbeddedFile) -> Response<Full<Bytes>> {
        let version = version(file);
        let is_current = self.cached.as_deref() == Some(version.as_str());
        let content = if is_current {
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
        let mut answer = respond(
            if is_current { 304 } else { 200 },
            media_type(name),
            content,
        );
        set(&mut answer, "cache-control", keep);
        set(&mut answer, "vary", "accept-encoding");
        set(&mut answer, "etag", &version);
        answer
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
    ["localhost", "127.0.0.1", "[::1]"].iter().any(|name| {
        let port = host.strip_prefix(name);
        port.is_some_and(|port| port.is_empty() || port.starts_with(':'))
    })
}

fn path(url: &str) -> &str {
    let path = url.split(['?', '#']).next().unwrap_or_default();
    path.trim_start_matches('/')
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

fn plain(status: u16, message: &str) -> Response<Full<Bytes>> {
    respond(status, "text/plain; charset=utf-8", message.into())
}

fn respond(status: u16, media_type: &str, content: Vec<u8>) -> Response<Full<Bytes>> {
    let mut response = Response::new(Full::from(content));
    *response.status_mut() = StatusCode::from_u16(status)
        .unwrap_or_else(|_| unreachable!("the numbers here are those of answers"));
    set(&mut response, "content-type", media_type);
    for (name, value) in HEADERS {
        set(&mut response, name, value);
    }
    response
}

fn set(response: &mut Response<Full<Bytes>>, name: &'static str, value: &str) {
    let value = HeaderValue::from_str(value)
        .unwrap_or_else(|_| unreachable!("the values here are plain ASCII"));
    response
        .headers_mut()
        .insert(HeaderName::from_static(name), value);
}

#[cfg(test)]
mod tests {
    use std::future::pending;
    use std::io::{Read, Write};
    use std::net::{SocketAddr, TcpStream};
    use std::thread;

    use hyper::body::Body;
    use hyper::header::CONTENT_ENCODING;

    use super::*;

    /// Small, so that they are soon reached, but for the patience, which has no end.
    const FEW: Limits = Limits {
        clients: 4,
        head: 16 << 10,
        patience: || Box::pin(pending()),
    };

    /// The addresses of a server with these limits.
    fn served(limits: &'static Limits) -> Vec<SocketAddr> {
        let listeners = bind(0).unwrap();
        let addresses = listeners.iter().map(|it| it.local_addr().unwrap());
        let addresses = addresses.collect();
        thread::spawn(move || serve(listeners, limits));
        addresses
    }

    /// Sends a request.
    fn sent(address: SocketAddr, request: &str) -> TcpStream {
        let mut stream = TcpStream::connect(address).unwrap();
        // The server may have closed it, with or without an answer.
        let _ = stream.write_all(request.as_bytes());
        stream
    }

    /// What comes back until the server closes the connection.
    fn answer_of(mut stream: TcpStream) -> String {
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        String::from_utf8(answer).unwrap()
    }

    #[test]
    fn both_addresses_of_localhost_answer() {
        for address in served(&FEW) {
            for host in ["localhost", "127.0.0.1", "[::1]"] {
                let request = format!("GET /none HTTP/1.1\r\nHost: {host}:1\r\n\r\n");
                let answer = answer_of(sent(address, &request));
                assert!(answer.starts_with("HTTP/1.1 404 "), "{address}: {answer}");
            }
        }
    }

    #[test]
    fn a_port_that_is_taken_in_one_family_is_refused() {
        // Without IPv6 there is no other family.
        let Ok(taken) = TcpListener::bind((Ipv6Addr::LOCALHOST, 0)) else {
            return;
        };
        let refused = bind(taken.local_addr().unwrap().port()).unwrap_err();
        assert!(refused.to_string().contains("--port 0"), "{refused}");
    }

    /// Each of these would wait for ever, or keep others waiting, without a limit of time. Here it is over for one
    /// client after the other, in the order in which they came.
    #[test]
    fn slow_clients_are_left_and_keep_nobody_waiting() {
        static OVER: Semaphore = Semaphore::const_new(0);
        const SLOW: Limits = Limits {
            patience: || {
                Box::pin(async {
                    if let Ok(over) = OVER.acquire().await {
                        over.forget();
                    }
                })
            },
            ..FEW
        };
        let address = served(&SLOW)[0];
        let idle = vec![""; 2 * SLOW.clients];
        let slow = idle.into_iter().chain(["GET /none HTTP/1.1\r\nHo"]);
        let slow: Vec<TcpStream> = slow.map(|request| sent(address, request)).collect();
        let waiting = sent(address, "GET /none HTTP/1.1\r\nHost: localhost\r\n\r\n");
        OVER.add_permits(slow.len());
        for stream in slow {
            assert_eq!(answer_of(stream), "");
        }
        let answer = answer_of(waiting);
        assert!(answer.starts_with("HTTP/1.1 404 "), "{answer}");
    }

    #[test]
    fn long_heads_are_refused() {
        let address = served(&FEW)[0];
        let long = "x".repeat(2 * FEW.head);
        for request in [
            format!("GET /none HTTP/1.1\r\nHost: localhost\r\nLong: {long}\r\n\r\n"),
            format!("GET /{long} HTTP/1.1\r\nHost: localhost\r\n\r\n"),
        ] {
            let answer = answer_of(sent(address, &request));
            let is_refused = answer.starts_with("HTTP/1.1 4") && !answer.contains(" 404 ");
            assert!(answer.is_empty() || is_refused, "{answer}");
        }
    }

    fn asked(method: Method, url: &str, host: &str) -> Asked {
        Asked {
            method,
            path: path(url).to_owned(),
            host: host.to_owned(),
            cached: None,
            takes_brotli: false,
        }
    }

    fn status(method: Method, url: &str, host: &str) -> u16 {
        asked(method, url, host).answer().status().as_u16()
    }

    #[test]
    fn only_this_computer_is_answered() {
        assert_eq!(status(Method::GET, "/none", "localhost:7878"), 404);
        assert_eq!(status(Method::GET, "/none", "127.0.0.1"), 404);
        // A name of someone else that leads to this computer.
        assert_eq!(status(Method::GET, "/", "evil.example:7878"), 403);
        assert_eq!(status(Method::GET, "/", ""), 403);
        assert_eq!(status(Method::POST, "/", "localhost"), 405);
    }

    #[test]
    fn nothing_outside_the_page_is_served() {
        for url in [
            "/../Cargo.toml",
            "/..%2fCargo.toml",
            "//etc/passwd",
            "/assets/../../x",
        ] {
            assert_eq!(status(Method::GET, url, "localhost"), 404, "{url}");
        }
    }

    #[test]
    fn every_answer_has_the_headers() {
        let answer = asked(Method::GET, "/none", "localhost").answer();
        for (name, value) in HEADERS {
            assert_eq!(answer.headers()[name], value);
        }
    }

    /// Where the page was built before the program.
    #[test]
    fn compressed_files_go_to_those_who_take_them() {
        let encoding = |asked: &Asked| {
            let answer = asked.answer();
            let encoding = answer.headers().get(CONTENT_ENCODING).cloned();
            (encoding, answer.body().size_hint().exact())
        };
        if Page::get("index.html.br").is_none() {
            return;
        }
        let mut asked = asked(Method::GET, "/", "localhost:7878");
        let (plain, whole) = encoding(&asked);
        asked.takes_brotli = names("gzip, deflate, br, zstd", BROTLI);
        let (compressed, part) = encoding(&asked);
        assert_eq!(
            (plain, compressed),
            (None, Some(HeaderValue::from_static("br")))
        );
        assert!(part < whole);
        assert!(!names("gzip, brand-new", BROTLI));
    }

    /// Where the page was built before the program.
    #[test]
    fn what_a_browser_has_is_not_sent_again() {
        let Some(file) = Page::get("index.html") else {
            return;
        };
        let mut asked = asked(Method::GET, "/?drop=1", "localhost:7878");
        assert_eq!(asked.answer().status().as_u16(), 200);
        asked.cached = Some(version(&file));
        let answer = asked.answer();
        assert_eq!(answer.status().as_u16(), 304);
        assert_eq!(answer.body().size_hint().exact(), Some(0));
    }
}
