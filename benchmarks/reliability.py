"""How many of the drops of each stated probability are real: reliability.py BOUNCELAB FOLDER...

A folder holds truth.json beside its recordings, as compare.py reads it. In a folder without it no
recording has a drop. A drop is real if half of its impacts at least are.
"""

import json
import subprocess
import sys
from pathlib import Path

# An impact is real if it is this near to one of the truth, in seconds: that of real sounds may
# itself be wrong by milliseconds.
NEAR_S = 0.008
CLASSES = [(0.0, "to 0.7"), (0.7, "0.7 to 0.9"), (0.9, "0.9 to 0.99"), (0.99, "above 0.99")]


def truth_of(folder):
    """The recordings of a folder, each with the times of its impacts."""
    file = folder / "truth.json"
    if not file.exists():
        return {name: [] for name in sorted(folder.iterdir()) if name.is_file()}
    recordings = json.loads(file.read_text())["recordings"]
    return {
        folder / name: [
            time
            for drop in recording["drops"]
            for time in [*drop["impacts_s"], *drop.get("optional_s", [])]
        ]
        for name, recording in recordings.items()
    }


def drops_in(program, file):
    """What bouncelab finds in a recording; nothing if it refuses it."""
    command = [program, "analyze", "--format", "json", str(file)]
    out = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    try:
        return json.loads(out)["drops"]
    except (ValueError, KeyError):
        return []


def is_real(drop, truth_s):
    times = [impact["time_s"] for impact in drop["impacts"]]
    real = sum(any(abs(time - true) < NEAR_S for true in truth_s) for time in times)
    return 2 * real >= len(times)


def main():
    program, *folders = sys.argv[1:]
    counts = {name: [0, 0] for _, name in CLASSES}
    for folder in map(Path, folders):
        for file, truth_s in truth_of(folder).items():
            for drop in drops_in(program, file):
                name = next(n for least, n in reversed(CLASSES) if drop["probability"] >= least)
                counts[name][0] += is_real(drop, truth_s)
                counts[name][1] += 1
    print("| probability | " + " | ".join(counts) + " |")
    print("|---" * (len(counts) + 1) + "|")
    cells = (f"{real} of {drops}" for real, drops in counts.values())
    print("| drops | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
