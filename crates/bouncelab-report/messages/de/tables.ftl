# „Spur“ weicher Trennstriche: Überschriften schmaler Spalten dürfen umbrechen.

column-impact = Aufprall
column-impacts = Aufpralle
column-drop = Versuch
column-start = ab s
column-time = Zeit s
column-flight = Flug s
column-apex = Höhe cm
column-speed = Tempo m/s
column-e = e
column-e-error = ± e
column-h0 = h0
column-ratio = e ohne Luft
column-time-error = ± Zeit µs
column-level = Pegel dB
column-probability = Wahrscheinlichkeit
column-line = Residuum %
column-law = Gesetz der Stoßzahl
column-drag = Luftwiderstand
column-evidence = ln Evidenz
column-ball = Ball
column-bayes-factor = ln Bayes-Faktor
column-source = Quelle
column-alone = allein
column-variance = % der Varianz
column-unknown = Unbekannte
column-width-left = % der vorigen Breite
column-to-surface = Untergrund mJ
column-to-air = Luft mJ
column-residual = Abweichung
column-weight = Gewicht
column-inference = Schätzung, mit Luft
column-plain = g T²/8
column-95 = 95 %
column-straight-line = Ausgleichsgerade, ohne Luft

quantity-restitution = Stoßzahl
quantity-restitution-e = Stoßzahl e
quantity-drop-height = Fallhöhe
quantity-energy-kept = behaltene Energie
quantity-drag-coefficient = Widerstandsbeiwert
quantity-terminal-speed = Endgeschwindigkeit
quantity-gravity = Fallbeschleunigung
quantity-scatter = Streuung von Aufprall zu Aufprall
quantity-release-until-rest = vom Loslassen bis zur Ruhe
quantity-path-until-rest = Weg bis zur Ruhe
quantity-height-to-reach = Höhe, aus der Sprung { $bounce } bis { $apex } reicht

unknown-restitution = Stoßzahl
unknown-drop-height = Fallhöhe
unknown-drag = Widerstandsbeiwert
unknown-slope = Gefälle der Stoßzahl
unknown-scatter = Streuung der Stoßzahl
unknown-timing = Fehler der Zeiten
unknown-contact-time = Kontaktzeit
unknown-gravity = Fallbeschleunigung

source-impact-timing = Zeiten der Aufpralle
source-restitution-scatter = Streuung der Stoßzahl
source-release-time = Zeitpunkt des Loslassens
source-restitution-slope = Gefälle der Stoßzahl
source-measured-height = gemessene Höhe
source-drag-law = Widerstandsgesetz
source-contact-time = Kontaktzeit
source-gravity = Fallbeschleunigung
source-air-density = Dichte der Luft
source-ball-mass = Masse des Balls
source-ball-diameter = Durchmesser des Balls
source-added-mass = mitbewegte Luft
source-choice-of-law = Wahl des Gesetzes
source-number-of-impacts = Zahl der Aufpralle

restitution-law-constant = gleichbleibend
restitution-law-linear = linear
restitution-law-power = Potenzgesetz
restitution-law-viscoelastic = viskoelastisch
restitution-law-knee = mit Knick
restitution-law-smooth = glatt, ohne Gesetz

drag-none = keiner
drag-constant = C_D = { $coefficient }
