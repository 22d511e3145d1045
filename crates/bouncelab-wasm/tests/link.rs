//! A drop as a QR code.

use std::collections::HashSet;

use bouncelab::settings::Settings;
use bouncelab_report::link::{DropLink, LinkedDrop};
use bouncelab_wasm::link::{link, qr_code, read_qr_code};

/// Sixty impacts, photographed: what a phone reads of it is the link.
#[test]
fn a_camera_reads_the_link() {
    let drop = LinkedDrop {
        name: "Anna".to_owned(),
        surface: "wood".to_owned(),
        settings: Settings::default(),
        times_s: (1..=60).map(|n| 5.0 * (1.0 - 0.94_f64.powi(n))).collect(),
    };
    let link = link(&drop, "https://lab.example/#lab?drop=").unwrap();
    let (grey, side) = photographed(&link);
    let read = read_qr_code(&grey, side).unwrap();
    assert_eq!(read, link.address);
    assert_eq!(
        LinkedDrop::of_code(read.split_once('=').unwrap().1)
            .unwrap()
            .name,
        "Anna"
    );
}

#[test]
fn any_address_is_a_code_and_a_blank_picture_none() {
    let address = "https://lab.example/#lab?class=1&balls=tennis.marble".to_owned();
    let (grey, side) = photographed(&qr_code(address.clone()).unwrap());
    assert_eq!(read_qr_code(&grey, side), Some(address));
    assert_eq!(read_qr_code(&[200; 10_000], 100), None);
    assert_eq!(read_qr_code(&[], 0), None);
    assert!(qr_code("x".repeat(5000)).is_err());
}

/// The grey levels of a code, row by row, and the width of a row.
fn photographed(link: &DropLink) -> (Vec<u8>, usize) {
    let (margin, scale) = (4, 4);
    let side = (link.modules as usize + 2 * margin) * scale;
    let dark: HashSet<(usize, usize)> = link.path.split('M').skip(1).map(corner).collect();
    let shade = |x: usize, y: usize| {
        let module = |at: usize| (at / scale).checked_sub(margin);
        let is_dark = module(x)
            .zip(module(y))
            .is_some_and(|at| dark.contains(&at));
        if is_dark { 0 } else { 255 }
    };
    let grey = (0..side * side).map(|at| shade(at % side, at / side));
    (grey.collect(), side)
}

/// Where a square of the path begins.
fn corner(square: &str) -> (usize, usize) {
    let (x, rest) = square.split_once(' ').unwrap();
    let (y, _) = rest.split_once('h').unwrap();
    (x.parse().unwrap(), y.parse().unwrap())
}
