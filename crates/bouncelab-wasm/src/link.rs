//! A drop as a link and a QR code.

use bouncelab_report::link::{LinkProblem, LinkedDrop};
use qrcodegen::{QrCode, QrCodeEcc};

use crate::refusal::Result;
use crate::wire::DropLink;

/// The link of a drop, for a page at this address, which ends where the drop begins.
///
/// # Errors
///
/// If it is no drop, or too long for a QR code.
pub fn link(drop: &LinkedDrop, page: &str) -> Result<DropLink> {
    let address = [page, &drop.code()?].concat();
    let code = QrCode::encode_text(&address, QrCodeEcc::Low);
    let code = code.map_err(|_| LinkProblem::TooLong)?;
    Ok(DropLink {
        address,
        modules: code.size().unsigned_abs(),
        path: path(&code),
    })
}

/// The dark modules as squares of a path of SVG.
fn path(code: &QrCode) -> String {
    let places = (0..code.size()).flat_map(|y| (0..code.size()).map(move |x| (x, y)));
    let dark = places.filter(|&(x, y)| code.get_module(x, y));
    let squares: Vec<String> = dark.map(|(x, y)| format!("M{x} {y}h1v1h-1z")).collect();
    squares.concat()
}
