//! The work on one recording: a function of its content, name and options.

use std::collections::BTreeMap;
use std::sync::Arc;

use bouncelab::inference::{Measured, Priors};
use bouncelab::settings::Settings;
use bouncelab::{Options, demo};
use bouncelab_audio::{SampleFormat, encode_wav};
use bouncelab_session::hash::{Hash, hash};
use bouncelab_session::{KnownRecording, Metadata, Record, RecordingFile};

/// The sound of the demonstration as a WAV file, and fast options.
fn wav() -> (Vec<u8>, Options) {
    let sound = demo::sound(&demo::history().unwrap(), 1).unwrap();
    let format = SampleFormat::Int16;
    let wav = encode_wav(sound.sample_rate_hz, format, &[&sound.samples]).unwrap();
    let mut options = Options::default();
    if let Some(inference) = &mut options.inference {
        inference.sampler.draws = 200;
    }
    (wav, options)
}

#[test]
fn memory_and_file_say_the_same() {
    let (wav, options) = wav();
    let file = tempfile::NamedTempFile::with_suffix(".wav").unwrap();
    std::fs::write(file.path(), &wav).unwrap();
    let of_file = Record::of_file(file.path(), hash(&wav), &options).unwrap();
    assert!(of_file == Record::of_bytes(wav, "demo.wav", &options));
    let drop = &of_file.drops[0];
    // The truth of the demonstration.
    assert_eq!(drop.impacts.len(), 61);
    let restitution = drop.quantities["restitution"];
    assert!((restitution.value - 0.9529).abs() < 5e-4, "{restitution:?}");
}

/// So a result from the journal equals a new one.
#[test]
fn a_record_comes_back_from_json() {
    let (wav, options) = wav();
    let record = Record::of_bytes(wav, "demo.wav", &options);
    let json = serde_json::to_string(&record).unwrap();
    let back: Record = serde_json::from_str(&json).unwrap();
    assert!(serde_json::to_string(&back).unwrap() == json);
}

#[test]
fn what_cannot_be_read_is_a_record_too() {
    let options = Options::default();
    let broken = Record::of_bytes(&b"no sound"[..], "broken.wav", &options);
    assert!(broken.failure.unwrap().starts_with("broken.wav: "));
    assert!(broken.drops.is_empty());
    let one = Record::of_bytes(&b"0.5"[..], "one.txt", &options);
    assert!(one.failure.is_none() && one.no_drop.is_some());
}

/// The hash under which a result with these options is kept.
fn settings(options: Options) -> Hash {
    let settings = Settings::default();
    let mut setup = settings.resolve().unwrap();
    setup.options = options;
    let metadata = Metadata {
        settings,
        setup,
        factors: BTreeMap::new(),
        height_m: None,
        temperature_k: None,
    };
    let known = KnownRecording {
        recording: RecordingFile {
            entry: None,
            path: "a.wav".into(),
            name: "a.wav".to_owned(),
        },
        metadata: Arc::new(metadata),
    };
    known.key(hash(b"a")).settings
}

#[test]
fn another_setting_is_another_key() {
    let options = Options::default;
    assert_eq!(settings(options()), settings(options()));
    let priors = Priors {
        drop_height_m: Some(Measured {
            value: 0.305,
            sd: 0.002,
        }),
        ..options().priors
    };
    let others = [
        options().without_inference(),
        options().with_gravity_m_s2(9.81),
        options().with_drag("constant:0.45".parse().unwrap()),
        Options {
            priors,
            ..options()
        },
    ];
    for other in others {
        assert_ne!(settings(other.clone()), settings(options()), "{other:?}");
    }
}
