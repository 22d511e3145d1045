axis-amplitude = Ausschlag, bezogen auf Vollausschlag
axis-bounce = Sprung
axis-drag = Luftwiderstand / Gewicht
axis-drag-coefficient = Widerstandsbeiwert
axis-drop = Versuch
axis-drop-height = Fallhöhe
axis-energy-lost = verlorene Energie
axis-flight = Nummer des Flugs
axis-flight-time = Flugzeit
axis-height = Höhe
axis-impact = Aufprall
axis-impact-speed = Aufpralltempo
axis-off-line = Abweichung von der Geraden
axis-rebound = Rückprallhöhe
axis-restitution = Stoßzahl: Tempo nachher / vorher
axis-restitution-at = Stoßzahl bei { $speed }
axis-restitution-short = Stoßzahl
axis-share-of-reference = Anteil des Vergleichswerts
axis-speed = Tempo
axis-time = Zeit

figure-bounce-energies-title = Wohin geht die Energie?
figure-bounce-energies-tab = Energie
figure-bounce-energies-caption = Was jeder Aufprall nimmt, und darauf, was die Luft im Flug danach nimmt: je schneller der Ball, desto größer der Anteil der Luft.
figure-bounce-energies-empty = Hier gibt es keine Energien zu zeigen.
figure-bounce-energies-air = die Luft, im Flug danach
figure-bounce-energies-surface = der Aufprall

figure-bounce-heights-title = Wie hoch ist jeder Sprung?
figure-bounce-heights-tab = Höhen
figure-bounce-heights-caption = Jeder Sprung behält etwa denselben Anteil der Höhe vor ihm, sodass die Punkte nahe einer Geraden liegen.
figure-bounce-heights-empty = Hier gibt es keine Höhen zu zeigen.

figure-budget-title = Woher die Unsicherheit kommt
figure-budget-tab = Unsicherheit
figure-budget-caption = Jeder Balken ist der Anteil einer Quelle an der Varianz: Wer den Ball besser kennen will, verbessert, was oben steht.
figure-budget-empty = Hier gibt es keine Unsicherheit zu zerlegen.
figure-budget-axis = Anteil an der Varianz
figure-budget-drop-height = Fallhöhe: { $value }
figure-budget-others = alles andere
figure-budget-restitution = Stoßzahl: { $value }

figure-calibration-title = Wo die Wahrheit unter den Ziehungen liegt
figure-calibration-caption = Flache Balken: Die Bereiche treffen so oft wie angegeben. Ein Hügel hieße zu breite Bereiche, ein Tal zu schmale, ein Hang einen systematischen Fehler.
figure-calibration-empty = Hier gibt es keine Ränge zu zeigen.
figure-calibration-drops = simulierte Versuche
figure-calibration-expected = 99 % der Balken enden hier, wenn alles stimmt
figure-calibration-rank = Rang der Wahrheit

figure-comparison-title = Der Versuch und eine Simulation davon
figure-comparison-tab = Vergleich
figure-comparison-caption = Wo sich die Kurven trennen, fehlt dem Modell etwas, oder ein Aufprall ist keiner.
figure-comparison-empty = Hier gibt es keine Höhen zu zeigen.
figure-comparison-best-fit = simuliert, mit 95 %
figure-comparison-measured = gemessen
figure-comparison-simulation = deine Simulation

figure-detection-found-title = Im Rauschen gefundene Aufpralle
figure-detection-found-caption = F1 ist 1, wo jeder Aufprall gefunden wird, der so laut wie das Rauschen ist, und sonst nichts.
figure-detection-found-empty = Hier gibt es nichts zu vergleichen.
figure-detection-found-axis = F1
figure-detection-found-loudness = lautester Aufprall über dem Rauschen

figure-detection-late-title = Leise Aufpralle werden nicht später gefunden als laute
figure-detection-late-caption = Der erste Abtastwert über einer festen Schwelle kommt umso später, je leiser der Aufprall ist; wo der ganze Ton am besten passt, hängt nicht von der Lautstärke ab.
figure-detection-late-empty = Hier gibt es nichts zu vergleichen.
figure-detection-late-axis = später als der lauteste
figure-detection-late-loudness = Aufprall über dem Rauschen

figure-detection-stated-title = Fehler der Flugzeiten, und was von ihnen gesagt wird
figure-detection-stated-caption = Von normalverteilten Fehlern liegen 68 % innerhalb eines Standardfehlers.
figure-detection-stated-empty = Hier gibt es nichts zu vergleichen.
figure-detection-stated-axis = innerhalb eines Standardfehlers
figure-detection-stated-loudness = lautester Aufprall über dem Rauschen

figure-detection-timing-title = Fehler der Flugzeiten und die physikalische Grenze
figure-detection-timing-caption = Die Cramér-Rao-Schranke ist der kleinste Fehler, mit dem sich die Zeit eines bekannten Tons in weißem Rauschen bestimmen lässt.
figure-detection-timing-empty = Hier gibt es nichts zu vergleichen.
figure-detection-timing-axis = mittlerer Fehler, geteilt durch den der Schranke
figure-detection-timing-loudness = lautester Aufprall über dem Rauschen

figure-drag-title = Luftwiderstand, verglichen mit dem Gewicht
figure-drag-tab = Luft
figure-drag-caption = Der Luftwiderstand wächst fast mit dem Quadrat des Tempos und trägt bei der Endgeschwindigkeit, wo die Kurve 1 erreicht, das ganze Gewicht.
figure-drag-reached = Der Luftwiderstand wächst fast mit dem Quadrat des Tempos und trägt bei der Endgeschwindigkeit, wo die Kurve 1 erreicht, das ganze Gewicht; dieser Versuch erreichte { $speed }.
figure-drag-empty = Hier gibt es keine Widerstandskurven zu zeigen.
figure-drag-fastest = dieser Versuch: bis { $speed }

figure-drag-log-title = Luftwiderstand, verglichen mit dem Gewicht
figure-drag-log-tab = Luft (log.)
figure-drag-log-caption = Ein gleichbleibender Beiwert ist hier eine Gerade; die Gesetze trennen sich bei kleinem Tempo, wo der Luftwiderstand nichts mehr ausmacht.
figure-drag-log-reached = Ein gleichbleibender Beiwert ist hier eine Gerade; die Gesetze trennen sich bei kleinem Tempo, wo der Luftwiderstand nichts mehr ausmacht; dieser Versuch erreichte { $speed }.
figure-drag-log-empty = Hier gibt es keine Widerstandskurven zu zeigen.

figure-flight-times-title = Die Flugzeiten und die Ausgleichsgerade
figure-flight-times-tab = Mit und ohne Luft
figure-flight-times-caption = Ohne Luft dauerte jeder Flug denselben Anteil des vorigen, nach der Geraden { $ratio }; ein Bogen im unteren Feld zeigt Luftwiderstand oder eine Stoßzahl, die sich mit dem Tempo ändert.
figure-flight-times-no-line = { $count ->
    [one] 1 Flug
   *[other] { $count } Flüge
}, ohne eine Gerade.
figure-flight-times-empty = Hier gibt es keine Flüge zu zeigen.
figure-flight-times-line = Ausgleichsgerade: jedes Mal × { $ratio }
figure-flight-times-all = gemessene Flüge
figure-flight-times-unused = nicht benutzt
figure-flight-times-used = benutzte Flüge

figure-groups-title = Die Stoßzahl jeder Gruppe über dem Tempo
figure-groups-caption = Jeder Punkt ist ein Aufprall; jede Linie ist die Kurve einer Gruppe mit ihrem 95-%-Bereich.
figure-groups-more = Die ersten { $shown } von { $all } Gruppen sind zu sehen.
figure-groups-empty = Hier gibt es keinen Aufprall mit bekannter Stoßzahl.

figure-height-title = Die Höhe des Balls
figure-height-tab = Höhe
figure-height-caption = Jeder Sprung ist niedriger und kürzer als der vorige, sodass unendlich viele in eine endliche Zeit passen.
figure-height-caption-apexes = Jeder Sprung ist niedriger und kürzer als der vorige; die Punkte sind die gemessenen Scheitel.
figure-height-caption-models = Die Modelle beginnen gleich und trennen sich mit der Zeit, weil alles, was ein Sprung verliert, die folgenden verkürzt.
figure-height-empty = Hier gibt es keine Höhen zu zeigen.
figure-height-apexes = gemessene Scheitel
figure-height-model = Flugmodell, Luftwiderstand: { $drag }

figure-intervals-title = Die Stoßzahl jeder Gruppe
figure-intervals-caption = Wo die kräftigen Balken zweier Gruppen weit auseinander liegen, unterscheiden sich die Gruppen; wo einer im blassen Balken der anderen liegt, unterscheiden einzelne Versuche sie nicht.
figure-intervals-empty = Hier gibt es keine Gruppen zu vergleichen.
figure-intervals-count = { $count ->
    [one] 1 Versuch
   *[other] { $count } Versuche
}
figure-intervals-drops = Versuche
figure-intervals-mean = Stoßzahl, 95 %
figure-intervals-next = nächster Versuch, 95 %
figure-intervals-outliers = Ausreißer

figure-limits-title = Die Rückprallhöhe und die Grenzen
figure-limits-caption = Ein Wert, dessen Balken zwischen den Grenzen liegt, hält sie mit einer Wahrscheinlichkeit von mindestens 95 % ein.
figure-limits-empty = Hier gibt es keinen Wert, der sich mit den Grenzen vergleichen lässt.
figure-limits-accepted = bei dieser Unsicherheit angenommen
figure-limits-interval = 95 %
figure-limits-within = innerhalb der Grenzen

figure-models-title = Welches Gesetz ist es?
figure-models-tab = Gesetze
figure-models-caption = Je länger der Balken, desto wahrscheinlicher das Gesetz; wo keiner gewinnt, ist die Antwort ein Mittel über alle.
figure-models-empty = Hier gibt es keine Modelle zu vergleichen.
figure-models-interval = Fallhöhe, 68 %
figure-models-probability = Wahrscheinlichkeit

figure-posterior-title = Gemeinsame Verteilung nach den Daten
figure-posterior-tab = Verteilung
figure-posterior-caption = Eine runde Wolke: Die Daten unterscheiden die beiden Größen. Eine schräge: Was man der einen zugibt, lässt sich der anderen nehmen. Ein Histogramm so breit wie die graue Kurve: Die Daten sagen nichts Neues.
figure-posterior-empty = Hier gibt es keine Größen zu zeigen.
figure-posterior-posterior = nach den Daten: 68 % dunkel, 95 % hell
figure-posterior-prior = vor den Daten

figure-residuals-title = Residuum jedes Aufpralls
figure-residuals-tab = Abweichung
figure-residuals-caption = Zwei von drei Aufprallen sollten im dunklen Band liegen, 19 von 20 im hellen; einer weit außerhalb traf eine Kante oder ist kein Aufprall.
figure-residuals-empty = Hier gibt es keine Abweichungen zu zeigen.
figure-residuals-axis = Abweichung (in Standardabweichungen)
figure-residuals-impact = Aufprall
figure-residuals-odd = Ausreißer, zählt weniger

figure-restitution-title = Die Stoßzahl bei jedem Aufprall
figure-restitution-tab = Stoßzahl
figure-restitution-caption = Was der Ball bei jedem Aufprall von seinem Tempo behält; die Lücke zwischen Grau und Blau nimmt die Luft, und eine Gerade hält sie für Verlust beim Aufprall.
figure-restitution-empty = Hier gibt es keinen Aufprall mit bekannter Stoßzahl.
figure-restitution-corrected = Luft herausgerechnet
figure-restitution-law = angepasstes Gesetz, 68 und 95 %
figure-restitution-line = Ausgleichsgerade: { $value }
figure-restitution-odd = Ausreißer, zählt weniger
figure-restitution-raw = ohne Luft gerechnet

figure-run-title = Wandert etwas?
figure-run-caption = Niveau jedes Versuchs ohne den Median seiner Gruppe, der Reihe nach: Eine Neigung oder eine Stufe bedeutet, dass sich Ball, Untergrund oder Luft geändert haben.
figure-run-empty = Hier gibt es keine Versuche zu zeigen.
figure-run-off = ln e minus Median der Gruppe
figure-run-order = Versuch, der Reihe nach
figure-run-outlier = Ausreißer
figure-run-unchanged = wenn sich nichts ändert

figure-truncation-title = Hängt die Antwort an der Zahl der benutzten Flüge?
figure-truncation-tab = Flugzahl
figure-truncation-caption = Ein richtiges Modell gibt für jede Zahl von Flügen dasselbe Ergebnis; das der Ausgleichsgeraden ändert sich, weil sie die Luft vernachlässigt.
figure-truncation-empty = Hier gibt es keine Antworten zu vergleichen.
figure-truncation-flights = benutzte Flüge
figure-truncation-inference = Inferenz, mit Luft
figure-truncation-line = Ausgleichsgerade
figure-truncation-stated = angegeben

figure-waveform-title = Der Ton und seine Aufpralle
figure-waveform-caption = { $impacts ->
    [one] 1 Aufprall
   *[other] { $impacts } Aufpralle
} { $drops ->
    [one] eines Versuchs
   *[other] aus { $drops } Versuchen
}{ $uncertain ->
    [0] {""}
   *[other] {" "}({ $uncertain } unsicher, offen und orange)
}{ $pattern ->
    [yes] : Ihr Abstand schrumpft jedes Mal fast im selben Verhältnis
   *[no] {""}
}.
figure-waveform-no-impacts = Der Ton, in dem keine Aufpralle gefunden wurden.
figure-waveform-empty = Hier gibt es keinen Ton zu zeigen.
figure-waveform-drop = { $number }. Versuch
figure-waveform-impact = Aufprall
figure-waveform-uncertain = unsicherer Aufprall

figure-drop-impacts-title = Die Stoßzahl jedes Aufpralls, Versuch für Versuch
figure-drop-impacts-caption = Die Luft ist herausgerechnet. Versuche mit einem Ball auf einem Untergrund sollten auf einer Linie liegen.
figure-drop-impacts-more = Die letzten { $shown } von { $all } Versuchen sind zu sehen.
figure-drop-impacts-empty = Hier gibt es keinen Aufprall mit bekannter Stoßzahl.

figure-drops-title = Die Stoßzahl jedes Versuchs
figure-drops-caption = Wie viel der Ball von seinem Tempo behält, Versuch für Versuch; die Balken sind eine Standardabweichung.
figure-drops-empty = Hier gibt es keine Versuche zu zeigen.

figure-lesson-title = Die Fallhöhe nach der Ausgleichsgeraden
figure-lesson-caption = Ohne Luft findet die Gerade mit jeder Zahl von Flügen die wahre Höhe; mit Luft sinkt die gefundene Höhe mit jedem weiteren Flug.
figure-lesson-empty = Hier gibt es keine Flüge zu zeigen.
figure-lesson-air = mit Luft
figure-lesson-flights = Flüge in der Geraden
figure-lesson-height-of-line = Fallhöhe nach der Geraden
figure-lesson-no-air = ohne Luft
figure-lesson-paper = wie im Aufsatz
figure-lesson-truth = wahre Höhe

figure-lesson-height-title = Die Höhe mit und ohne Luft
figure-lesson-height-caption = Zwei Versuche mit derselben Stoßzahl; die Luft verkürzt den Versuch.
figure-lesson-height-empty = Hier gibt es keine Höhen zu zeigen.

figure-lesson-line-title = Flugzeiten ohne Luft
figure-lesson-line-caption = Auf dieser Achse liegen Flüge, von denen jeder denselben Anteil des vorigen dauert, auf einer Geraden.
figure-lesson-line-empty = Hier gibt es keine Flüge zu zeigen.
figure-lesson-line-line = Ausgleichsgerade

figure-run-flight-times-title = Flugzeiten
figure-run-flight-times-caption = Auf dieser Achse ist eine gleichbleibende Stoßzahl ohne Luft eine Gerade; wo die Punkte abbiegen, wirken Luft oder Tempo mit.
figure-run-flight-times-empty = Hier gibt es keine Flüge zu zeigen.

figure-runs-title = Die Höhe des Balls
figure-runs-caption = Jeder Sprung ist niedriger und kürzer als der vorige.
figure-runs-empty = Hier gibt es keine Höhen zu zeigen.
