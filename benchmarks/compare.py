"""Run other detectors on a folder of recordings: compare.py FOLDER BOUNCELAB.

The folder holds truth.json beside the recordings: that of the grid, or, for any others,

    {"recordings": {"001-tennis-voices.mp3": {"drops": [{"impacts_s": [], "optional_s": []}]}}}

where the optional impacts count neither if they are found nor if they are missed. A file's name is
words joined by hyphens: the first tells it from the others, the rest say what it is.
"""

import io
import json
import math
import statistics
import subprocess
import sys
import warnings
from pathlib import Path

import aubio
import librosa
import numpy as np
import soundfile
from obspy.signal.trigger import aic_simple, recursive_sta_lta, trigger_onset

from reliability import drops_in

# A detection belongs to an impact this near, in seconds. A constant delay is forgiven: a detection
# is right if it is this near after the median offset of the recording is taken out. The truth of
# real sounds may itself be wrong by milliseconds.
NEAR_S = 0.02
SAME_S = 0.003
SAME_RECORDED_S = 0.008


def by_aubio(samples, rate, _path):
    # Windows of 23 ms, as its default at 44.1 kHz, in powers of two.
    window = 1 << round(np.log2(0.023 * rate))
    hop = window // 4
    detector = aubio.onset("default", window, hop, rate)
    times = []
    for start in range(0, len(samples) - hop + 1, hop):
        if detector(samples[start : start + hop]):
            times.append(detector.get_last_s())
    return times


def by_librosa(samples, rate, _path):
    hop, window = round(0.003 * rate), round(0.046 * rate)
    strength = librosa.onset.onset_strength(
        y=samples, sr=rate, hop_length=hop, n_fft=window, fmax=rate / 2
    )
    return list(
        librosa.onset.onset_detect(onset_envelope=strength, sr=rate, hop_length=hop, units="time")
    )


def by_sta_lta(samples, rate, _path):
    short, long = max(2, int(0.002 * rate)), int(0.05 * rate)
    ratio = recursive_sta_lta(samples.astype(float), short, long)
    times = []
    for start, _ in trigger_onset(ratio, 4.0, 1.5):
        first = max(0, start - int(0.005 * rate))
        window = samples[first : start + int(0.005 * rate)].astype(float)
        pick = int(np.argmin(aic_simple(window)[1:-1])) + 1 if len(window) > 8 else 0
        times.append((first + pick) / rate)
    return times


def by_block_maximum(samples, rate, _path):
    block, threshold = int(0.1 * rate), 0.1
    times = []
    for start in range(0, len(samples), block):
        size = np.abs(samples[start : start + block])
        if len(size) and size.max() > threshold:
            times.append((start + int(size.argmax())) / rate)
    return times


def by_bouncelab(_samples, _rate, path):
    drops = drops_in(sys.argv[2], path)
    return sorted(impact["time_s"] for drop in drops for impact in drop["impacts"])


DETECTORS = {
    "bouncelab": by_bouncelab,
    "aubio": by_aubio,
    "librosa": by_librosa,
    "ObsPy": by_sta_lta,
    "phone app": by_block_maximum,
}


class Tally:
    """Counts of one detector in some recordings."""

    def __init__(self, same_s):
        self.same_s = same_s
        self.audible = self.found = self.made_up = 0
        self.errors = []

    def add(self, times, recording):
        truth, audible = np.array(recording["impacts_s"]), recording["audible_s"]
        nearest = [min(t - truth, key=abs) for t in times]
        near = [e for e in nearest if abs(e) < NEAR_S]
        self.audible += len(audible)
        self.made_up += len(nearest) - len(near)
        if not near:
            return
        middle = statistics.median(near)
        for impact in audible:
            error = min((t - impact - middle for t in times), key=abs)
            if abs(error) < self.same_s:
                self.found += 1
                self.errors.append(abs(error))

    def f1(self):
        if self.audible == 0:
            return None
        wrong = self.made_up + (self.audible - self.found)
        return 2 * self.found / (2 * self.found + wrong)

    def recall(self):
        return self.found / self.audible

    def text(self):
        f1 = self.f1()
        if f1 is None:
            return "-"
        if not self.errors:
            return f"{f1:.2f}"
        return f"{f1:.2f}, {1e6 * statistics.median(self.errors):.0f} us"


def read(path):
    """Mono samples of a recording and their rate. What is not a WAV file is decoded by ffmpeg."""
    if path.suffix != ".wav":
        command = ["ffmpeg", "-v", "error", "-i", str(path), "-f", "wav", "-"]
        path = io.BytesIO(subprocess.run(command, capture_output=True, check=True).stdout)
    samples, rate = soundfile.read(path, dtype="float32", always_2d=True)
    return samples.mean(axis=1), rate


def detect_all(path):
    """The times that each detector finds in a recording."""
    samples, rate = read(path)
    return {name: detect(samples, rate, path) for name, detect in DETECTORS.items()}


def heading(title):
    print(f"\n| {title} | " + " | ".join(DETECTORS) + " |")
    print("|---" * (len(DETECTORS) + 1) + "|")


def compare_grid(folder, truth):
    """One row for each cell of the grid, whose impacts are counted together."""
    cells = {}
    for recording in truth:
        key = recording["group"], recording["cell"]
        tallies = cells.setdefault(key, {name: Tally(SAME_S) for name in DETECTORS})
        for name, times in detect_all(folder / recording["file"]).items():
            tallies[name].add(times, recording)
    group = None
    for (of, cell), tallies in cells.items():
        if of != group:
            group = of
            heading(group)
        print(f"| {cell} | " + " | ".join(t.text() for t in tallies.values()) + " |")
    print()
    for name in DETECTORS:
        scores = [tallies[name].f1() for tallies in cells.values()]
        print(f"{name}: mean F1 {statistics.mean(s for s in scores if s is not None):.3f}")


def compare_recorded(folder, truth):
    """One row for each word in the names of the recordings, with the mean F1 of those that have it.

    A recording without impacts has no F1 and is left out.
    """
    rows = {}
    for file, recording in truth.items():
        audible = [t for drop in recording["drops"] for t in drop["impacts_s"]]
        optional = [t for drop in recording["drops"] for t in drop.get("optional_s", [])]
        if not audible:
            continue
        tallies = {name: Tally(SAME_RECORDED_S) for name in DETECTORS}
        for name, times in detect_all(folder / file).items():
            tallies[name].add(times, {"impacts_s": audible + optional, "audible_s": audible})
        words = enumerate(Path(file).stem.split("-")[1:])
        for key in [*words, (math.inf, "all")]:
            rows.setdefault(key, []).append(tallies)
    heading("recordings")
    for (_, word), of in sorted(rows.items()):
        means = [statistics.mean(tallies[name].f1() for tallies in of) for name in DETECTORS]
        print(f"| {word} ({len(of)}) | " + " | ".join(f"{mean:.2f}" for mean in means) + " |")
    print()
    for name in DETECTORS:
        f1, recall = (
            statistics.mean(score(tallies[name]) for tallies in rows[math.inf, "all"])
            for score in (Tally.f1, Tally.recall)
        )
        print(f"{name}: mean F1 {f1:.3f}, mean recall {recall:.3f}")


def main():
    warnings.filterwarnings("ignore")
    folder = Path(sys.argv[1])
    truth = json.loads((folder / "truth.json").read_text())
    if isinstance(truth, list):
        compare_grid(folder, truth)
    else:
        compare_recorded(folder, truth["recordings"])


main()
