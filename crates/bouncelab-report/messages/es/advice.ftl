terminal-advice-impact-gains-energy = Exclúyelo con --exclude TIME.
terminal-advice-scatter-exceeds-prior = Indica la dispersión de esta superficie con --known scatter=2%.
terminal-advice-contact-overlaps = Las opciones son --exclude, --ball y --contact-time.
terminal-advice-restitution-undetermined = La opción es --height.
terminal-advice-ball-floats = La opción es --no-buoyancy.
terminal-advice-rule-needs-height = Indícala con --height.
terminal-advice-no-channel = Elige otro con --channel.
terminal-advice-too-many-channels = La opción es --channel.

advice-balls = «bouncelab balls» las muestra con otras palabras, masa, diámetro y fuente.
advice-allow-implausible = Corrige el valor, o acéptalo con --allow-implausible

page-advice-impact-gains-energy = Elimínalo si parece falso en la forma de onda.
page-advice-contact-overlaps = Elimínalo en la forma de onda o en la lista de impactos.
page-advice-restitution-rises = Elígela en la fila «¿Qué pelota?».
page-advice-other-ball-fits-better = { page-advice-restitution-rises }
