"""Run other detectors on the recordings of the grid: compare.py FOLDER BOUNCELAB."""

import json
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

# A detection belongs to an impact this near, in seconds. A constant delay is forgiven: a detection
# is right if it is this near after the median offset of the recording is taken out.
NEAR_S = 0.02
SAME_S = 0.003


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
    command = [sys.argv[2], "analyze", "--format", "json", str(path)]
    out = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    try:
        drops = json.loads(out)["drops"]
    except (ValueError, KeyError):
        return []
    return sorted(impact["time_s"] for drop in drops for impact in drop["impacts"])


DETECTORS = {
    "bouncelab": by_bouncelab,
    "aubio": by_aubio,
    "librosa": by_librosa,
    "ObsPy": by_sta_lta,
    "phone app": by_block_maximum,
}


class Tally:
    """Counts of one detector in one cell."""

    def __init__(self):
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
            if abs(error) < SAME_S:
                self.found += 1
                self.errors.append(abs(error))

    def f1(self):
        if self.audible == 0:
            return None
        wrong = self.made_up + (self.audible - self.found)
        return 2 * self.found / (2 * self.found + wrong)

    def text(self):
        f1 = self.f1()
        if f1 is None:
            return "-"
        if not self.errors:
            return f"{f1:.2f}"
        return f"{f1:.2f}, {1e6 * statistics.median(self.errors):.0f} us"


def main():
    warnings.filterwarnings("ignore")
    folder = Path(sys.argv[1])
    cells = {}
    for recording in json.loads((folder / "truth.json").read_text()):
        path = folder / recording["file"]
        samples, rate = soundfile.read(path, dtype="float32")
        key = recording["group"], recording["cell"]
        tallies = cells.setdefault(key, {name: Tally() for name in DETECTORS})
        for name, detect in DETECTORS.items():
            tallies[name].add(detect(samples, rate, path), recording)
    group = None
    for (of, cell), tallies in cells.items():
        if of != group:
            group = of
            print(f"\n| {group} | " + " | ".join(DETECTORS) + " |")
            print("|---" * (len(DETECTORS) + 1) + "|")
        print(f"| {cell} | " + " | ".join(t.text() for t in tallies.values()) + " |")
    print()
    for name in DETECTORS:
        scores = [tallies[name].f1() for tallies in cells.values()]
        print(f"{name}: mean F1 {statistics.mean(s for s in scores if s is not None):.3f}")


main()
