terminal-advice-impact-gains-energy = Exclus-le avec --exclude TIME.
terminal-advice-scatter-exceeds-prior = Indique la dispersion de cette surface avec --known scatter=2%.
terminal-advice-contact-overlaps = Les options sont --exclude, --ball et --contact-time.
terminal-advice-restitution-undetermined = L’option est --height.
terminal-advice-ball-floats = L’option est --no-buoyancy.
terminal-advice-rule-needs-height = Indique-la avec --height.
terminal-advice-no-channel = Choisis-en une autre avec --channel.
terminal-advice-too-many-channels = L’option est --channel.

advice-balls = « bouncelab balls » les montre avec d’autres mots, masse, diamètre et source.
advice-allow-implausible = Corrige la valeur, ou accepte-la avec --allow-implausible

page-advice-impact-gains-energy = Supprime-le s’il paraît faux dans la forme d’onde.
page-advice-contact-overlaps = Supprime-le dans la forme d’onde ou dans la liste des impacts.
page-advice-restitution-rises = Choisis-la dans la rangée « Quelle balle ? ».
page-advice-other-ball-fits-better = { page-advice-restitution-rises }
