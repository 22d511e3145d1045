terminal-advice-impact-gains-energy = Lass ihn von Hand weg (--exclude ZEIT).
terminal-advice-scatter-exceeds-prior = Die Streuung dieser Fläche nennt --known scatter=2%.
terminal-advice-contact-overlaps = Die Optionen sind --exclude, --ball und --contact-time.
terminal-advice-restitution-undetermined = Die Option ist --height.
terminal-advice-ball-floats = Die Option ist --no-buoyancy.
terminal-advice-rule-needs-height = Gib sie mit --height an.
terminal-advice-no-channel = Wähle einen anderen mit --channel.
terminal-advice-too-many-channels = Die Option ist --channel.

advice-balls = „bouncelab balls“ zeigt sie mit weiteren Wörtern, Masse, Durchmesser und Quelle.
advice-allow-implausible = Berichtige es, oder bestehe darauf mit --allow-implausible

page-advice-impact-gains-energy = Entferne ihn, wenn er in der Wellenform falsch aussieht.
page-advice-contact-overlaps = Entferne ihn in der Wellenform oder in der Liste der Aufpralle.
page-advice-restitution-rises = Wähle ihn in der Reihe „Welcher Ball?“.
page-advice-other-ball-fits-better = { page-advice-restitution-rises }
