//! Every number of the detector of a stream, with unit, meaning and source.

// What is remembered.

/// Maximum time for which sounds are remembered, s; when it is over, the past is evaluated.
pub(super) const MAX_REMEMBERED_S: f64 = 180.0;
/// Maximum duration of a drop, as a share of the remembered time; older sounds are then forgotten.
pub(super) const MAX_DROP_SHARE: f64 = 2.0 / 3.0;
/// Maximum samples of all channels together that are remembered (128 MB): nearly three minutes of two
/// channels at 96 kHz, and less of more channels.
pub(super) const MAX_SAMPLES: f64 = 32e6;
/// Minimum time of each channel that must fit into that, s; more channels are refused. A drop may last two thirds of it,
/// and balls of sports bounce for at most 20 s.
pub(super) const MIN_REMEMBERED_S: f64 = 40.0;
/// Maximum onsets that are remembered; when they are full, the past is evaluated. Ten times
/// the impacts of the longest drop (e = 0.99, from a metre to a tenth of a millimetre).
pub(super) const MAX_ONSETS: usize = 4000;
/// If they are full, the oldest 1/2 of them is forgotten, and even of open trains 1/4.
pub(super) const CROWD_DIVISOR: usize = 2;
/// See [`CROWD_DIVISOR`].
pub(super) const OPEN_CROWD_DIVISOR: usize = 4;

// When sounds are evaluated.

/// Minimum silence between independent sounds, s: no flight is as long, and no sound is compared with others that far away.
pub(super) const MIN_GAP_S: f64 = 3.2;
/// Maximum delay after which an onset is detected, s.
pub(super) const MAX_ONSET_DELAY_S: f64 = 0.3;
/// A train is open, that is, may continue, if its last impact came less than this before now, s.
pub(super) const OPEN_S: f64 = 10.0;
/// Time that is kept before the start of an open train, s, so that its first impact stays.
pub(super) const OPEN_MARGIN_S: f64 = 1e-3;

// Watching a live stream.

/// Polling interval, s of sound.
pub(super) const POLL_S: f64 = 0.1;
/// Minimum time between two evaluations of all sounds while no drop is open, s of sound.
pub(super) const MIN_EVALUATION_S: f64 = 1.0;
/// Maximum work of the evaluations per second of sound, in units of [`super::Detector::work`]: a tenth of a second or less
/// on an ordinary computer. Among dense sounds evaluations are therefore rarer. Steady clicks, 30 a second,
/// are still evaluated each second; 100 a second, every ten seconds.
pub(super) const MAX_WORK_PER_S: f64 = 16e6;
/// Minimum time after a drop from which later sounds do not change its evaluation, s: no sound is
/// compared with others farther away than 3 s, and each is detected within half a second.
pub(super) const SETTLED_S: f64 = 3.6;

// The envelope.

/// Maximum steps of an envelope; beyond, each two become one.
pub(super) const MAX_STEPS: usize = 1 << 15;
/// Minimum samples of a step.
pub(super) const MIN_STEP_SAMPLES: usize = 16;

// Quiet before a drop.

/// A sound below this share of the amplitude of the first impact is no earlier impact of the drop: that was faster, and the
/// levels of successive impacts scatter by 3.5 dB (`train`), so an earlier one 6 dB fainter is less than one in twenty.
pub(super) const QUIET_SHARE: f32 = 0.5;
/// Time after an onset within which an impact is loudest, s.
pub(super) const PEAK_S: f64 = 0.02;
/// Time before an onset in which the impact itself may be heard, s: no flight is as short.
pub(super) const SOON_S: f64 = 0.02;

// Clipping.

/// Minimum number of equal samples in a row at the extreme value that count as clipped.
pub(super) const MIN_CLIPPED_RUN: u64 = 3;
/// Minimum level of clipping, as a share of full scale: a flat top below it is not the limit of the recorder.
pub(super) const MIN_CLIPPED_LEVEL: f32 = 0.3;
