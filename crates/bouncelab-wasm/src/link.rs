//! Links as QR codes: of a drop, or any other.

use bouncelab_report::link::{DropLink, LinkProblem, LinkedDrop};
use qrcodegen::{QrCode, QrCodeEcc};

use crate::refusal::Result;

/// The link of a drop, for a page at this address, which ends where the drop begins.
///
/// # Errors
///
/// If it is no drop, or too long for a QR code.
pub fn link(drop: &LinkedDrop, page: &str) -> Result<DropLink> {
    qr_code([page, &drop.code()?].concat())
}

/// A link with its QR code.
///
/// # Errors
///
/// If it is too long for one.
pub fn qr_code(address: String) -> Result<DropLink> {
    let code = QrCode::encode_text(&address, QrCodeEcc::Low);
    let code = code.map_err(|_| LinkProblem::TooLong)?;
    Ok(DropLink {
        address,
        modules: code.size().unsigned_abs(),
        path: path(&code),
    })
}

/// The text of a QR code in a picture of these grey levels, row by row; nothing if none can be read.
#[must_use]
pub fn read_qr_code(grey: &[u8], width: usize) -> Option<String> {
    let height = grey.len().checked_div(width)?;
    let shade = |x: usize, y: usize| grey[y * width + x];
    let mut picture = rqrr::PreparedImage::prepare_from_greyscale(width, height, shade);
    let mut read = picture.detect_grids().into_iter();
    read.find_map(|grid| grid.decode().ok().map(|(_, text)| text))
}

/// The dark modules as squares of a path of SVG.
fn path(code: &QrCode) -> String {
    let places = (0..code.size()).flat_map(|y| (0..code.size()).map(move |x| (x, y)));
    let dark = places.filter(|&(x, y)| code.get_module(x, y));
    let squares: Vec<String> = dark.map(|(x, y)| format!("M{x} {y}h1v1h-1z")).collect();
    squares.concat()
}
