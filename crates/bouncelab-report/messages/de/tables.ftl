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
column-corrected = Luftwiderstand herausgerechnet

quantity-restitution = Stoßzahl
quantity-drop-height = Fallhöhe
quantity-energy-kept = behaltene Energie
quantity-drag = Widerstandsbeiwert
quantity-terminal-speed = Endgeschwindigkeit
quantity-gravity = Fallbeschleunigung
quantity-total-time = Zeit bis zur Ruhe
quantity-total-path = Weg bis zur Ruhe
quantity-slope = Gefälle der Stoßzahl
quantity-scatter = Streuung der Stoßzahl
quantity-timing = Fehler der Zeiten
quantity-contact-time = Kontaktzeit
quantity-height-to-reach = Sprung { $bounce } erreicht { $apex } aus

quantity-interval = 95 %: { $interval }
quantity-at-speed = { $quantity } bei { $speed }
quantity-of-impacts = Median von { $count } Aufprallen bei { $slowest } bis { $fastest } m/s
quantity-of-flights = vor dem ersten erkannten Aufprall; { $count ->
    [one] 1 Flug
   *[other] { $count } Flüge
  }
quantity-first-fall = vor dem ersten erkannten Aufprall
quantity-stated = angegeben
quantity-missed = vorher verpasste Aufpralle: { $list }
quantity-before-data = { $value } vor den Daten
quantity-known = als bekannt angenommen

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
source-choice-of-ball = welcher Ball es ist
source-choice-of-law = Wahl des Gesetzes
source-number-of-impacts = Zahl der Aufpralle

drag-none = keiner
drag-constant = C_D = { $coefficient }
drag-standard = Standardkurve einer Kugel
drag-table = eigene Tabelle
