//! A drop as a QR code.

use bouncelab::settings::Settings;
use bouncelab_report::link::LinkedDrop;
use bouncelab_wasm::link::link;

/// Sixty impacts, photographed: what a phone reads of it is the link.
#[test]
fn a_camera_reads_the_link() {
    let drop = LinkedDrop {
        name: "Anna".to_owned(),
        settings: Settings::default(),
        times_s: (1..=60).map(|n| 5.0 * (1.0 - 0.94_f64.powi(n))).collect(),
    };
    let link = link(&drop, "https://lab.example/#lab?drop=").unwrap();
    let (margin, scale) = (4, 4);
    let side = (link.modules as usize + 2 * margin) * scale;
    let dark: Vec<(usize, usize)> = link.path.split('M').skip(1).map(corner).collect();
    let shade = |x: usize, y: usize| {
        let module = |at: usize| (at / scale).checked_sub(margin);
        let is_dark = module(x)
            .zip(module(y))
            .is_some_and(|at| dark.contains(&at));
        if is_dark { 0 } else { 255 }
    };
    let mut picture = rqrr::PreparedImage::prepare_from_greyscale(side, side, shade);
    let (_, read) = picture.detect_grids()[0].decode().unwrap();
    assert_eq!(read, link.address);
    assert_eq!(
        LinkedDrop::of_code(read.split_once('=').unwrap().1)
            .unwrap()
            .name,
        "Anna"
    );
}

/// Where a square of the path begins.
fn corner(square: &str) -> (usize, usize) {
    let (x, rest) = square.split_once(' ').unwrap();
    let (y, _) = rest.split_once('h').unwrap();
    (x.parse().unwrap(), y.parse().unwrap())
}
