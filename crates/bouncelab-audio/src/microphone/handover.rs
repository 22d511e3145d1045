//! Passes samples from the real-time thread of the sound system to the reading thread.
//!
//! The system calls the feeder with each buffer of sound. The feeder must neither wait nor allocate, or
//! sound is lost. So the two threads share two ring buffers without locks, one for samples and one
//! for the losses between them.

use rtrb::{Consumer, Producer, RingBuffer};

/// Length of the ring of samples in seconds: the reading thread may be that late, because of an analysis or a sleeping
/// disk.
const RING_S: usize = 30;
/// Maximum number of losses that wait to be read.
const MAX_LOSSES: usize = 1024;
/// Maximum number of frames that are taken at once.
const MAX_FRAMES: usize = 4096;

/// Sound that was lost just before a frame.
#[derive(Debug, Clone, Copy)]
struct Loss {
    /// Index of that frame among those in the ring.
    before: u64,
    /// Number of lost frames, as far as it is known.
    frames: u64,
}

/// The side of the real-time thread.
pub(super) struct Feeder {
    channels: usize,
    samples: Producer<f32>,
    losses: Producer<Loss>,
    /// Number of frames that were written into the ring.
    fed: u64,
    /// Number of frames that were lost since.
    lost: Option<u64>,
}

/// The side of the reading thread.
pub(super) struct Taker {
    channels: usize,
    samples: Consumer<f32>,
    losses: Consumer<Loss>,
    /// Number of frames that were read from the ring.
    taken: u64,
}

/// The result of a read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrival {
    /// New samples.
    Sound,
    /// Sound is missing here: the computer was too slow, or the device had a fault.
    Lost {
        /// Number of missing frames, as far as it is known; 0 if it is unknown.
        frames: u64,
    },
    /// Nothing yet.
    Nothing,
}

/// The two sides.
pub(super) fn handover(sample_rate_hz: u32, channels: usize) -> (Feeder, Taker) {
    with_capacity(sample_rate_hz as usize * RING_S, channels)
}

fn with_capacity(frames: usize, channels: usize) -> (Feeder, Taker) {
    let (samples_in, samples_out) = RingBuffer::new(frames * channels);
    let (losses_in, losses_out) = RingBuffer::new(MAX_LOSSES);
    let feeder = Feeder {
        channels,
        samples: samples_in,
        losses: losses_in,
        fed: 0,
        lost: None,
    };
    let taker = Taker {
        channels,
        samples: samples_out,
        losses: losses_out,
        taken: 0,
    };
    (feeder, taker)
}

impl Feeder {
    /// Writes interleaved frames into the ring; if it is full, they are
    /// lost, and counted.
    pub(super) fn feed(&mut self, samples: impl ExactSizeIterator<Item = f32>) {
        let frames = (samples.len() / self.channels) as u64;
        let fits = self.samples.slots() >= samples.len();
        if !fits || !self.pass_on_loss() {
            self.lose(frames);
            return;
        }
        if let Ok(chunk) = self.samples.write_chunk_uninit(samples.len()) {
            chunk.fill_from_iter(samples);
            self.fed += frames;
        }
    }

    /// Notes that `frames` frames are missing here.
    pub(super) fn lose(&mut self, frames: u64) {
        self.lost = Some(self.lost.unwrap_or(0) + frames);
    }

    /// Writes the loss before the next frame into its ring; `false` if that is full.
    fn pass_on_loss(&mut self) -> bool {
        let Some(frames) = self.lost else {
            return true;
        };
        let before = self.fed;
        let is_written = self.losses.push(Loss { before, frames }).is_ok();
        if is_written {
            self.lost = None;
        }
        is_written
    }
}

impl Taker {
    /// Takes the next samples or the next loss; samples replace those in `planes`, one plane for each channel.
    pub(super) fn take(&mut self, planes: &mut Vec<Vec<f32>>) -> Arrival {
        // In this order: the feeder writes a loss before the samples behind it. So the loss in front of samples that are
        // counted here is in its ring.
        let mut frames = (self.samples.slots() / self.channels).min(MAX_FRAMES);
        if let Ok(&Loss {
            before,
            frames: lost,
        }) = self.losses.peek()
        {
            let frames_before = (before - self.taken) as usize;
            if frames_before == 0 {
                let _ = self.losses.pop();
                return Arrival::Lost { frames: lost };
            }
            frames = frames.min(frames_before);
        }
        if frames == 0 {
            return Arrival::Nothing;
        }
        let Ok(chunk) = self.samples.read_chunk(frames * self.channels) else {
            return Arrival::Nothing;
        };
        planes.resize_with(self.channels, Vec::new);
        let (first, second) = chunk.as_slices();
        for (channel, plane) in planes.iter_mut().enumerate() {
            plane.clear();
            let interleaved = first.iter().chain(second).skip(channel);
            plane.extend(interleaved.step_by(self.channels));
        }
        chunk.commit_all();
        self.taken += frames as u64;
        Arrival::Sound
    }
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::*;

    fn feed(feeder: &mut Feeder, samples: &[f32]) {
        feeder.feed(samples.iter().copied());
    }

    #[test]
    fn channels_come_apart_in_order() {
        let (mut feeder, mut taker) = with_capacity(4, 2);
        let mut planes = Vec::new();
        assert_eq!(taker.take(&mut planes), Arrival::Nothing);
        // Six frames through a ring of four: it wraps round.
        for start in [0, 6] {
            let samples: Vec<f32> = (start..start + 6).map(|n| n as f32).collect();
            feed(&mut feeder, &samples);
            assert_eq!(taker.take(&mut planes), Arrival::Sound);
            let start = start as f32;
            assert_eq!(planes[0], [start, start + 2.0, start + 4.0]);
            assert_eq!(planes[1], [start + 1.0, start + 3.0, start + 5.0]);
        }
        assert_eq!(taker.take(&mut planes), Arrival::Nothing);
    }

    #[test]
    fn what_does_not_fit_is_counted_where_it_is_missing() {
        let (mut feeder, mut taker) = with_capacity(4, 1);
        feed(&mut feeder, &[1.0, 2.0, 3.0]);
        feed(&mut feeder, &[4.0, 5.0]);
        feed(&mut feeder, &[6.0, 7.0, 8.0]);
        let mut planes = Vec::new();
        assert_eq!(taker.take(&mut planes), Arrival::Sound);
        assert_eq!(planes[0], [1.0, 2.0, 3.0]);
        feed(&mut feeder, &[9.0]);
        assert_eq!(taker.take(&mut planes), Arrival::Lost { frames: 5 });
        assert_eq!(taker.take(&mut planes), Arrival::Sound);
        assert_eq!(planes[0], [9.0]);
    }

    #[test]
    fn a_fault_of_unknown_length_is_reported_too() {
        let (mut feeder, mut taker) = with_capacity(8, 1);
        feed(&mut feeder, &[1.0]);
        feeder.lose(0);
        feed(&mut feeder, &[2.0]);
        let mut planes = Vec::new();
        assert_eq!(taker.take(&mut planes), Arrival::Sound);
        assert_eq!(planes[0], [1.0]);
        assert_eq!(taker.take(&mut planes), Arrival::Lost { frames: 0 });
        assert_eq!(taker.take(&mut planes), Arrival::Sound);
        assert_eq!(planes[0], [2.0]);
    }

    #[test]
    fn two_threads_agree_on_every_frame() {
        // The feeder counts frames; the taker must see each of them, or a loss of that length.
        const FRAMES: usize = 200_000;
        let (mut feeder, mut taker) = with_capacity(512, 2);
        let feeding = thread::spawn(move || {
            let numbers: Vec<f32> = (0..FRAMES).flat_map(|n| [n as f32, -(n as f32)]).collect();
            for block in numbers.chunks(2 * 37) {
                feed(&mut feeder, block);
            }
            // The last loss is written with the frame behind it, once the ring is empty again.
            while feeder.samples.slots() < 512 * 2 {
                thread::yield_now();
            }
            feed(&mut feeder, &[FRAMES as f32, -(FRAMES as f32)]);
        });
        let mut planes = Vec::new();
        let mut next = 0;
        while next <= FRAMES {
            match taker.take(&mut planes) {
                Arrival::Nothing => thread::yield_now(),
                Arrival::Lost { frames } => next += frames as usize,
                Arrival::Sound => {
                    for (left, right) in planes[0].iter().zip(&planes[1]) {
                        assert_eq!((*left, *right), (next as f32, -(next as f32)));
                        next += 1;
                    }
                }
            }
        }
        feeding.join().unwrap();
    }
}
