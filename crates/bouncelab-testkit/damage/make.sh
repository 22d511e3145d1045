#!/bin/sh
# Makes `drops.tar.gz` anew: the drop of `src/damage.rs` in every format that is compressed, or that
# nothing here writes. Needs ffmpeg with libmp3lame, libopus and libvorbis.
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
mkdir "$work/drops"
cargo run --quiet --manifest-path "$folder/../../bouncelab-bench/Cargo.toml" -- drop-sounds "$work"

# sound RATE OUTPUT OPTIONS...: encodes the sound of that rate, without dates and versions.
sound() {
    rate=$1 output=$2
    shift 2
    ffmpeg -loglevel error -y -i "$work/$rate.wav" -map_metadata -1 \
        -fflags +bitexact -flags:a +bitexact "$@" "$work/drops/$output"
}

sound 16000 sound.flac -c:a flac
sound 16000 flac.ogg -c:a flac
sound 16000 flac.mkv -c:a flac
sound 16000 pcm.mov -c:a pcm_s16le
sound 16000 alac.m4a -c:a alac
sound 16000 alac.caf -c:a alac
sound 48000 aac.m4a -c:a aac -b:a 64k
sound 48000 aac-front.m4a -c:a aac -b:a 64k -movflags +faststart
sound 48000 aac-parts.mp4 -c:a aac -b:a 64k -movflags +frag_keyframe+empty_moov+default_base_moof -frag_duration 1000000
sound 48000 aac.aac -c:a aac -b:a 64k
sound 48000 aac.mkv -c:a aac -b:a 64k
sound 48000 constant.mp3 -c:a libmp3lame -b:a 64k
sound 48000 constant-no-tag.mp3 -c:a libmp3lame -b:a 64k -write_xing 0 -id3v2_version 0
sound 48000 constant.mkv -c:a libmp3lame -b:a 64k
sound 48000 variable.mp3 -c:a libmp3lame -q:a 5
sound 48000 variable-no-tag.mp3 -c:a libmp3lame -q:a 5 -write_xing 0 -id3v2_version 0
sound 48000 vorbis.ogg -c:a libvorbis -q:a 3
sound 48000 vorbis.mkv -c:a libvorbis -q:a 3
sound 48000 opus.ogg -c:a libopus -b:a 64k
sound 48000 opus.webm -c:a libopus -b:a 64k
sound 48000 opus-stream.webm -c:a libopus -b:a 64k -f webm -live 1
sound 48000 opus.mp4 -c:a libopus -b:a 64k

cd "$work/drops"
tar --owner=0 --group=0 --numeric-owner --mtime=@0 -c -- * | gzip -9n > "$folder/drops.tar.gz"
