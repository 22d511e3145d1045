//! A scene as a PNG picture.
//!
//! The drawing library does not smooth the edges of lines, which shows in small pictures. So
//! it draws a larger one, and each pixel here is the mean of a square of its pixels.

use std::io::Cursor;

use kuva::backend::raster::RasterBackend;
use kuva::render::render::Scene;

use crate::MARK;

/// Up to this width, in pixels, it is worth drawing more finely than asked.
const FINE_PX: u32 = 3200;
/// Finer than this shows no more.
const FINEST: u32 = 4;

/// Rows of pixels, each with red, green and blue.
struct Pixels {
    width: usize,
    height: usize,
    rgb: Vec<[u8; 3]>,
}

/// Draws a scene in the given width, as a PNG file.
pub(super) fn png(scene: &Scene, width_px: u32) -> Result<Vec<u8>, String> {
    let finer = (FINE_PX / width_px).clamp(1, FINEST);
    // The library rounds the size up; aiming a hair low hits the width exactly.
    let scale = (f64::from(width_px * finer) - 0.01) / scene.width;
    let drawn = RasterBackend::new()
        .with_scale(scale as f32)
        .render_scene(scene)?;
    let fine = decode(&drawn).map_err(|error| error.to_string())?;
    encode(&mean_of_squares(&fine, finer as usize)).map_err(|error| error.to_string())
}

fn decode(file: &[u8]) -> Result<Pixels, png::DecodingError> {
    let mut reader = png::Decoder::new(Cursor::new(file)).read_info()?;
    let size = reader
        .output_buffer_size()
        .ok_or(png::DecodingError::LimitsExceeded)?;
    let mut bytes = vec![0; size];
    let frame = reader.next_frame(&mut bytes)?;
    // The library always writes opaque pixels of four bytes.
    let (pixels, _) = bytes.as_chunks::<4>();
    Ok(Pixels {
        width: frame.width as usize,
        height: frame.height as usize,
        rgb: pixels.iter().map(|&[r, g, b, _]| [r, g, b]).collect(),
    })
}

/// One pixel for each square of `side` times `side`; incomplete squares at the bottom are left
/// out.
fn mean_of_squares(fine: &Pixels, side: usize) -> Pixels {
    let (width, height) = (fine.width / side, fine.height / side);
    let pixel = |row: usize, column: usize| {
        let mut sum = [0_usize; 3];
        for y in row * side..(row + 1) * side {
            let start = y * fine.width + column * side;
            for rgb in &fine.rgb[start..start + side] {
                for (sum, part) in sum.iter_mut().zip(rgb) {
                    *sum += usize::from(*part);
                }
            }
        }
        let half = side * side / 2;
        sum.map(|sum| ((sum + half) / (side * side)) as u8)
    };
    let rows = (0..height).flat_map(|row| (0..width).map(move |column| (row, column)));
    Pixels {
        width,
        height,
        rgb: rows.map(|(row, column)| pixel(row, column)).collect(),
    }
}

fn encode(pixels: &Pixels) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width as u32, pixels.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.add_text_chunk("Software".to_owned(), MARK.to_owned())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels.rgb.as_flattened())?;
    writer.finish()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_the_mean_of_a_square() {
        let black = [0; 3];
        let white = [255; 3];
        let fine = Pixels {
            width: 4,
            height: 3,
            rgb: [
                [black, black, white, black],
                [black, white, white, white],
                [white; 4],
            ]
            .concat(),
        };
        let mean = mean_of_squares(&fine, 2);
        assert_eq!((mean.width, mean.height), (2, 1));
        assert_eq!(mean.rgb, [[64; 3], [191; 3]]);
    }
}
