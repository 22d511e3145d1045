paper-chapter-numbers = Die Zahlen des Aufsatzes
paper-chapter-series = Stoßzahl, Zeit und Weg ohne Luftwiderstand
paper-chapter-equations = Gleichungen, wie gedruckt und wie sie sein müssen
paper-chapter-beyond = Ergebnisse über den Aufsatz hinaus
paper-chapter-flights = Ein Ball mit der Ausgleichsgeraden des Aufsatzes: e = 0,9529 mit Luftwiderstand
paper-weight = Gewicht
paper-buoyancy = Auftrieb
paper-buoyancy-note = legt die Dichte der Luft fest, 1,2276 kg/m³
paper-buoyancy-over-weight = Auftrieb durch Gewicht
paper-first-impact = erster Aufprall, ohne Luftwiderstand
paper-reynolds-number = Reynolds-Zahl dort
paper-reynolds-number-note = nicht turbulent wie gedruckt: unterhalb der Widerstandskrise, mit laminarer Grenzschicht
paper-terminal-speed = Endgeschwindigkeit, C_D = 0,4
paper-terminal-speed-note = 9,385 liegt auf der Grenze des Rundens
paper-first-impact-with-drag = erster Aufprall, C_D = 0,4 (Gl. 15)
paper-drag-over-weight = Luftwiderstand durch Gewicht bei 2,4 m/s, C_D(Re)
paper-drag-over-weight-note = der Aufsatz las seine Kurve aus einer Abbildung ab
paper-terminal-speed-of-sphere = Endgeschwindigkeit, C_D(Re)
paper-terminal-speed-of-sphere-note = dasselbe
paper-rule-steel-least = e nach dem Regelbuch, Stahl, kleinstes
paper-rule-steel-most = e nach dem Regelbuch, Stahl, größtes
paper-rule-table-least = e nach dem Regelbuch, Tisch, kleinstes
paper-rule-table-most = e nach dem Regelbuch, Tisch, größtes
paper-height-error = Fehler von h₀ = 26,7 cm
paper-height-error-note = aus den gerundeten 26,7 cm; die Flugzeiten sind nicht gedruckt
paper-restitution-of-time = e aus 7,50 s nach dem ersten Aufprall
paper-restitution-of-time-note = wenn die 7,50 s ab dem ersten Aufprall zählen
paper-restitution-of-total-time = e aus 7,50 s nach dem Loslassen (Gl. 7)
paper-restitution-of-total-time-note = Gl. 7 zählt ab dem Loslassen
paper-total-path = Weg bis zur Ruhe bei e = 0,94 (Gl. 8)
paper-equation-6-printed = h₀ nach Gl. 6 wie gedruckt: g 10^b/8
paper-equation-6-printed-note = 10^b = 2 v₀/g gehört quadriert
paper-equation-6 = h₀ nach Gl. 6 berichtigt: g (10^b)²/8
paper-equation-13 = Gl. 13 beim ersten Aufprall
paper-equation-13-note = die Fallhöhe: links steht der Weg y, nicht v
paper-equation-14 = Gl. 14 beim ersten Aufprall
paper-equation-14-note = dasselbe
paper-drag-twice = e = 0,935 mit Luftwiderstand (Abb. 8) gibt als Gerade
paper-drag-twice-note = Abb. 8 rechnet den Luftwiderstand doppelt
paper-drag-twice-height = Fallhöhe dieser Geraden
paper-behind-line = e, das mit Luftwiderstand als Gerade 0,9375 gibt
paper-behind-line-note = über zehn Flüge
paper-behind-line-height = Fallhöhe seiner Geraden
paper-explained = Anteil der Lücke zu 30,5 cm, den der Luftwiderstand erklärt
paper-explained-note = der Rest: eine Stoßzahl, die mit dem Tempo fällt, oder mehr Flüge in der Geraden
paper-twenty-flights-height = Fallhöhe, gleiches e, zwanzig Flüge
paper-twenty-flights-height-note = die Gerade hängt davon ab, durch wie viele Flüge sie geht
paper-lost-gravity = was Auftrieb und mitbewegte Luft der Fallbeschleunigung nehmen
paper-lost-gravity-note = der Auftrieb allein 1,4 %; jede Höhe schrumpft mit
paper-flight-time = T{ $of }
paper-time-until-rest = Zeit bis zur Ruhe mit Luftwiderstand, e = { $of }
paper-path-until-rest = Weg bis zur Ruhe mit Luftwiderstand, e = { $of }

paper-verdict-agrees = stimmt
paper-verdict-agrees-when-corrected = stimmt, berichtigt
paper-verdict-agrees-within-reading = stimmt, soweit ablesbar
paper-verdict-misprint = Druckfehler
paper-verdict-differs = weicht ab

paper-air-none = keine
paper-air-constant = C_D = 0,4
paper-air-sphere = C_D(Re)
paper-air-all-of-air = C_D(Re), Auftrieb, mitbewegte Luft
