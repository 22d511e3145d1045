//! Records the sound: a thread fetches and saves it.
//!
//! Only the disk can delay this thread. Results, duration and failures of the analysis, and a closed terminal, do not
//! affect what is saved.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, SyncSender, TrySendError};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use bouncelab::Diagnostic;
use bouncelab::analysis::Gap;

use super::save::Saver;
use super::sound::{Arrival, Sound};
use crate::failure::Failure;
use crate::interrupt::Stop;

/// Maximum size of the sound that waits for the analysis, in bytes: three minutes of a stereo microphone.
const MAX_WAITING: usize = 1 << 26;
/// Maximum number of frames of one event.
const MAX_BLOCK: usize = 4096;
/// Pause while no sound arrives.
const PAUSE: Duration = Duration::from_millis(20);

/// An event for the analysis.
pub(super) enum Event {
    /// Samples of every channel; for a file also all gaps so far.
    Sound(Vec<Vec<f32>>, Option<Vec<Gap>>),
    /// The number of frames that are missing here, or 0 if it is not known.
    Lost(u64),
    /// The number of frames that are saved, but that the analysis was too slow to receive.
    LeftOut(u64),
    /// Nothing yet.
    Nothing,
}

type Troubles = Arc<Mutex<Vec<String>>>;

/// A recording in progress.
pub(super) struct LiveRecording {
    events: Receiver<Event>,
    /// Whether the analysis needs no more sound.
    enough: Arc<AtomicBool>,
    /// Messages for the user.
    troubles: Troubles,
    is_saved: bool,
    thread: JoinHandle<Ended>,
}

/// A recording that has ended.
pub(super) struct Ended {
    /// The files.
    pub(super) files: Vec<PathBuf>,
    /// Messages for the user that were not shown yet.
    pub(super) troubles: Vec<String>,
    /// Whether saving failed, so that some of the sound was not saved.
    pub(super) is_incomplete: bool,
    /// Whether silence was saved for sound that was lost on its way.
    pub(super) lacks_sound: bool,
    /// Faults of a file that was played.
    pub(super) warnings: Vec<Diagnostic>,
    /// The failure that ended it, if any.
    pub(super) result: Result<(), Failure>,
}

impl LiveRecording {
    /// Starts to record at most `last_frame` frames.
    pub(super) fn start(
        sound: Sound,
        saver: Saver,
        stop: Stop,
        last_frame: u64,
    ) -> Result<Self, Failure> {
        let block = MAX_BLOCK * sound.info().channels * size_of::<f32>();
        let waiting = if sound.is_live() {
            (MAX_WAITING / block).max(1)
        } else {
            0
        };
        let (sender, events) = mpsc::sync_channel(waiting);
        let enough = Arc::new(AtomicBool::new(false));
        let troubles = Troubles::default();
        let is_saved = !saver.files().is_empty();
        let work = Work {
            outlet: Outlet {
                sender,
                waits: !sound.is_live(),
                left_out: 0,
            },
            sound,
            saver,
            stop,
            enough: Arc::clone(&enough),
            troubles: Arc::clone(&troubles),
            frames: 0,
            has_lost: false,
            last_frame,
        };
        let thread = thread::Builder::new().name("recording".to_owned());
        let thread = thread.spawn(|| work.run())?;
        Ok(Self {
            events,
            enough,
            troubles,
            is_saved,
            thread,
        })
    }

    /// The next event; `None` at the end.
    pub(super) fn next(&self) -> Option<Event> {
        match self.events.recv_timeout(PAUSE) {
            Ok(event) => Some(event),
            Err(RecvTimeoutError::Timeout) => Some(Event::Nothing),
            Err(RecvTimeoutError::Disconnected) => None,
        }
    }

    /// Whether the sound is saved.
    pub(super) fn is_saved(&self) -> bool {
        self.is_saved
    }

    /// Messages for the user since the last call.
    pub(super) fn troubles(&self) -> Vec<String> {
        let mut troubles = self.troubles.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut troubles)
    }

    /// Ends it: the analysis needs no more sound.
    pub(super) fn stop(&self) {
        self.enough.store(true, Ordering::Relaxed);
    }

    /// Waits for its end.
    pub(super) fn ended(self) -> Ended {
        drop(self.events);
        let mut ended = self.thread.join().unwrap_or_else(|_| Ended {
            troubles: Vec::new(),
            files: Vec::new(),
            is_incomplete: true,
            lacks_sound: false,
            warnings: Vec::new(),
            result: Err(Failure::Input(
                "the recording ended by a fault of the program; please report it".to_owned(),
            )),
        });
        ended.troubles =
            std::mem::take(&mut self.troubles.lock().unwrap_or_else(PoisonError::into_inner));
        ended
    }
}

/// The channel to the analysis.
struct Outlet {
    sender: SyncSender<Event>,
    /// Whether the sound can wait for the analysis.
    waits: bool,
    /// How many frames did not fit into the queue.
    left_out: u64,
}

impl Outlet {
    /// Sends an event that covers `frames` frames. If the queue of the analysis is full, the event is dropped and its
    /// frames are counted. If the analysis has ended, the event is dropped.
    fn send(&mut self, event: Event, frames: u64) {
        if self.waits {
            // The analysis takes the second event when it is done with the first: a file that is played is saved as far
            // as it was analysed, the same each time.
            let _ = self.sender.send(event);
            let _ = self.sender.send(Event::Nothing);
            return;
        }
        if self.left_out > 0 {
            match self.sender.try_send(Event::LeftOut(self.left_out)) {
                Err(TrySendError::Full(_)) => {
                    self.left_out += frames;
                    return;
                }
                Ok(()) | Err(TrySendError::Disconnected(_)) => self.left_out = 0,
            }
        }
        if let Err(TrySendError::Full(_)) = self.sender.try_send(event) {
            self.left_out += frames;
        }
    }
}

/// The work of the thread.
struct Work {
    sound: Sound,
    saver: Saver,
    outlet: Outlet,
    stop: Stop,
    enough: Arc<AtomicBool>,
    troubles: Troubles,
    frames: u64,
    /// Whether the sound could not be fetched in time.
    has_lost: bool,
    last_frame: u64,
}

impl Work {
    fn run(mut self) -> Ended {
        let result = self.record();
        let trouble = self.saver.finish();
        self.tell(trouble);
        Ended {
            troubles: Vec::new(),
            files: self.saver.files().to_vec(),
            is_incomplete: self.saver.has_failed(),
            lacks_sound: self.has_lost && !self.saver.files().is_empty(),
            warnings: self.sound.warnings(),
            result,
        }
    }

    fn record(&mut self) -> Result<(), Failure> {
        let mut planes = Vec::new();
        while !self.is_over() {
            match self.sound.next(&mut planes)? {
                Arrival::Sound => {
                    let left = usize::try_from(self.last_frame - self.frames);
                    for plane in &mut planes {
                        plane.truncate(left.unwrap_or(usize::MAX));
                    }
                    let gaps = self.sound.gaps().map(<[Gap]>::to_vec);
                    for gap in gaps.iter().flatten().skip(self.saver.gaps()) {
                        self.saver.note_gap(*gap);
                    }
                    self.save(&planes);
                    let frames = planes.first().map_or(0, Vec::len) as u64;
                    let event = Event::Sound(std::mem::take(&mut planes), gaps);
                    self.outlet.send(event, frames);
                }
                Arrival::Lost(frames) => {
                    self.has_lost = true;
                    let left = usize::try_from(self.last_frame - self.frames);
                    let silence = silence_for(frames, self.sound.info().sample_rate_hz);
                    let silence = silence.min(left.unwrap_or(usize::MAX));
                    self.note_gap(silence, is_certain(silence, frames));
                    self.save(&vec![vec![0.0; silence]; self.sound.info().channels]);
                    self.outlet.send(Event::Lost(frames), silence as u64);
                }
                Arrival::Nothing => thread::sleep(PAUSE),
                Arrival::End => break,
            }
        }
        Ok(())
    }

    fn is_over(&self) -> bool {
        let has_enough = self.enough.load(Ordering::Relaxed);
        has_enough || self.stop.requested() || self.frames >= self.last_frame
    }

    fn save(&mut self, planes: &[Vec<f32>]) {
        self.frames += planes.first().map_or(0, Vec::len) as u64;
        let channels: Vec<&[f32]> = planes.iter().map(Vec::as_slice).collect();
        let trouble = self.saver.push(&channels);
        self.tell(trouble);
    }

    /// Notes that sound was lost, in place of which there are `silence` frames of silence.
    fn note_gap(&mut self, silence: usize, certain: bool) {
        let rate_hz = f64::from(self.sound.info().sample_rate_hz);
        self.saver.note_gap(Gap {
            start_s: self.frames as f64 / rate_hz,
            duration_s: silence as f64 / rate_hz,
            certain,
        });
    }

    fn tell(&self, trouble: Option<String>) {
        let mut troubles = self.troubles.lock().unwrap_or_else(PoisonError::into_inner);
        troubles.extend(trouble);
    }
}

/// The number of frames of silence in place of lost sound, which keeps later times right.
pub(super) fn silence_for(lost_frames: u64, sample_rate_hz: u32) -> usize {
    /// Maximum silence, in seconds: no drop continues after it.
    const MAX_S: u64 = 10;
    lost_frames.min(MAX_S * u64::from(sample_rate_hz)) as usize
}

/// Whether this silence is as long as the sound that was lost.
pub(super) fn is_certain(silence: usize, lost_frames: u64) -> bool {
    silence as u64 == lost_frames && lost_frames > 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sound(frames: usize) -> Event {
        Event::Sound(vec![vec![0.0; frames]], None)
    }

    #[test]
    fn frames_that_the_analysis_misses_are_counted_where_they_are_missing() {
        let (sender, events) = mpsc::sync_channel(2);
        let mut outlet = Outlet {
            sender,
            waits: false,
            left_out: 0,
        };
        for frames in [1, 2, 4, 8] {
            outlet.send(sound(frames), frames as u64);
        }
        let received = || match events.try_recv() {
            Ok(Event::Sound(planes, _)) => (planes[0].len(), 0),
            Ok(Event::LeftOut(frames)) => (0, frames),
            _ => (0, 0),
        };
        assert_eq!(
            [received(), received(), received()],
            [(1, 0), (2, 0), (0, 0)]
        );
        outlet.send(sound(16), 16);
        assert_eq!(
            [received(), received(), received()],
            [(0, 12), (16, 0), (0, 0)]
        );
        // Once the analysis has ended, nothing waits.
        drop(events);
        outlet.send(sound(32), 32);
    }
}
