# What to do about a diagnostic in one of the front ends: it is added to the sentence of the diagnostic.

terminal-advice-impact-gains-energy = Exclude it with --exclude TIME.
terminal-advice-scatter-exceeds-prior = State the scatter of this surface with --known scatter=2%.
terminal-advice-contact-overlaps = The options are --exclude, --ball and --contact-time.
terminal-advice-restitution-undetermined = The option is --height.
terminal-advice-ball-floats = The option is --no-buoyancy.
terminal-advice-rule-needs-height = State it with --height.
terminal-advice-no-channel = Choose another with --channel.
terminal-advice-too-many-channels = The option is --channel.

advice-balls = 'bouncelab balls' lists them with other words, mass, diameter and source.
advice-allow-implausible = Correct it, or accept it with --allow-implausible

page-advice-impact-gains-energy = Remove it if it looks wrong in the waveform.
page-advice-contact-overlaps = Remove it in the waveform or in the list of impacts.
page-advice-restitution-rises = Choose it in the row “Which ball?”.
page-advice-other-ball-fits-better = { page-advice-restitution-rises }
