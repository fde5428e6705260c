//! Pictures one after the other in one file: APNG, which browsers play without end and other
//! programs show as the first picture.

use png::{BitDepth, BlendOp, ColorType, Encoder};

use crate::palette::{Palette, UNCHANGED};
use crate::raster::{PlotError, pixels};

/// Pictures from which the colours of all are taken.
const SAMPLES: usize = 4;
/// Pixels for each unit of the scene: a file a fourth of that of a still picture's.
const PIXELS_PER_UNIT: u16 = 1;

/// The pictures of an animation, all of one size.
pub trait Frames {
    /// Number of pictures.
    fn count(&self) -> usize;
    /// One of them as SVG of this crate, by its number from 0 on.
    fn svg(&self, number: usize) -> String;
    /// For how long it is shown (milliseconds).
    fn milliseconds(&self, number: usize) -> u16;
}

/// Renders pictures as one animated PNG that begins again when it has ended: the same bytes on every
/// machine. Each picture holds what differs from the one before it alone, in 255 colours of some of
/// the pictures: blends at the borders of lines may be a little off.
///
/// # Errors
/// [`PlotError`] for pictures that are no SVG or too large, or differ in size, and if there are none.
pub fn animated_png(frames: &impl Frames) -> Result<Vec<u8>, PlotError> {
    let count = frames.count();
    if count == 0 {
        return Err(PlotError::NoPicture);
    }
    let picture = |number: usize| pixels(&frames.svg(number), PIXELS_PER_UNIT);
    let samples = (0..SAMPLES).map(|k| picture(k * count.saturating_sub(1) / (SAMPLES - 1)));
    let samples = samples.collect::<Result<Vec<_>, _>>()?;
    let mut palette = Palette::of(&samples);
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, samples[0].width(), samples[0].height());
    encoder.set_color(ColorType::Indexed);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_palette(palette.bytes());
    encoder.set_trns(&[0][..]);
    encoder.set_animated(u32::try_from(count).unwrap_or(u32::MAX), 0)?;
    encoder.set_blend_op(BlendOp::Over)?;
    let mut writer = encoder.write_header()?;
    let mut before = Vec::new();
    for number in 0..count {
        let now = palette.indices(&picture(number)?);
        writer.set_frame_delay(frames.milliseconds(number), 1000)?;
        writer.write_image_data(&changes(&before, &now))?;
        before = now;
    }
    writer.finish()?;
    Ok(bytes)
}

/// What of a picture is not in the one before it.
fn changes(before: &[u8], now: &[u8]) -> Vec<u8> {
    if before.len() != now.len() {
        return now.to_vec();
    }
    let pairs = before.iter().zip(now);
    pairs.map(|(before, now)| if before == now { UNCHANGED } else { *now }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Axis, Label, Panel, Pen, Sheet};

    /// A line that turns.
    struct Turning(usize);

    impl Frames for Turning {
        fn count(&self) -> usize {
            self.0
        }

        fn svg(&self, number: usize) -> String {
            let (sin, cos) = (number as f64 * 0.3).sin_cos();
            let axis = || Axis::new([-1.0, 1.0], Label::default().symbol("x"));
            let line = vec![[-cos, -sin], [cos, sin]];
            let panel = Panel::new(axis(), axis()).curve(line, Pen::of(1));
            Sheet::new("A line that turns").panel(panel).svg()
        }

        fn milliseconds(&self, number: usize) -> u16 {
            if number == 0 { 500 } else { 40 }
        }
    }

    /// Every picture as a viewer puts it together, and for how long it shows it.
    fn played(bytes: &[u8]) -> Vec<(Vec<[u8; 3]>, u16)> {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let control = reader.info().animation_control.unwrap();
        assert_eq!(control.num_plays, 0); // without end
        let palette = reader.info().palette.clone().unwrap();
        let mut screen = vec![[0; 3]; reader.info().width as usize * reader.info().height as usize];
        let mut raw = vec![0; reader.output_buffer_size().unwrap()];
        let mut all = Vec::new();
        for _ in 0..control.num_frames {
            reader.next_frame(&mut raw).unwrap();
            for (pixel, number) in screen.iter_mut().zip(&raw) {
                let from = 3 * usize::from(*number);
                if *number > 0 {
                    *pixel = [palette[from], palette[from + 1], palette[from + 2]];
                }
            }
            let delay = reader.info().frame_control.unwrap().delay_num;
            all.push((screen.clone(), delay));
        }
        all
    }

    #[test]
    fn every_picture_is_shown_as_it_is() {
        let frames = Turning(12);
        let played = played(&animated_png(&frames).unwrap());
        assert_eq!(played.len(), 12);
        for (number, (shown, delay)) in played.iter().enumerate() {
            assert_eq!(*delay, frames.milliseconds(number));
            let real = pixels(&frames.svg(number), PIXELS_PER_UNIT).unwrap();
            let far = |(shown, real): (&[u8; 3], [u8; 3])| {
                (0..3).any(|i| shown[i].abs_diff(real[i]) > 24)
            };
            let real = real.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]);
            // A tenth of the tones: what an eye takes for the same colour in so small a spot. Blends
            // that are in none of the pictures that colours are taken from may be further off.
            let apart = shown.iter().zip(real).filter(|pair| far(*pair)).count();
            assert!(10_000 * apart < shown.len(), "{number}: {apart} of {}", shown.len());
        }
    }

    #[test]
    fn one_picture_is_enough_and_none_is_an_error() {
        assert_eq!(played(&animated_png(&Turning(1)).unwrap()).len(), 1);
        assert!(matches!(animated_png(&Turning(0)), Err(PlotError::NoPicture)));
    }
}
