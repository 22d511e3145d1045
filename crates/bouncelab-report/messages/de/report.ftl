report-made-by = Bericht von bouncelab { $version }
report-made-on = Bericht von bouncelab { $version }, { $date }
report-note = Hinweis
report-page = Seite { $page } von { $pages }
report-figure = Abbildung
report-details = Einzelheiten

report-drop = Der Versuch
report-drop-of = Versuch { $number } von { $count }
report-drops = Die Versuche
report-no-drop = Kein springender Ball gefunden: { $reason }
report-no-reason = Nichts darin springt.
report-drops-found = { $drops } Versuche mit { $impacts } Aufprallen wurden gefunden.
report-first-drops = Die ersten { $count } Versuche haben unten eigene Abschnitte; Ergebnisse für Programme haben alle.

report-impacts = { $count ->
    [one] Ein Aufprall wurde erkannt, bei { $first } s
   *[other] { $count } Aufpralle wurden erkannt, von { $first } s bis { $last } s
  }, { $uncertain ->
    [0] keiner davon unsicher.
    [one] einer davon unsicher.
   *[other] { $uncertain } davon unsicher.
  }

report-answers = Schätzung mit Luft, und Ausgleichsgerade ohne
report-quantities = Weitere Größen
report-quantities-table = Weitere Größen, mit dem Verfahren zu jeder
report-impacts-heading = Die Aufpralle
report-impacts-table = Aufpralle, jeder mit dem Flug danach und seiner Stoßzahl, ohne Luft gerechnet und mit ihr (? heißt unsicher)
report-line-heading = Die Ausgleichsgerade
report-line-flights = Sie geht durch { $count ->
    [one] einen Flug.
   *[other] { $count } Flüge.
  }
report-line-fits = Sie geht durch { $count } Flüge, mit einem Bestimmtheitsmaß von { $determination }.
report-no-line = Es gibt keine: { $reason }

report-uncertainty = Unsicherheitsbudget
report-budget-restitution = Beiträge zur Unsicherheit der Stoßzahl
report-budget-drop-height = Beiträge zur Unsicherheit der Fallhöhe
report-laws = Vergleich der Gesetze
report-laws-table = Gesetze, vor den Daten gleich wahrscheinlich
report-contraction = Was diese Aufnahme festlegt
report-correlations = Korrelationen der Schätzwerte
report-uninformative = { $unknown }: Diese Daten sagen fast nichts darüber; es bleibt bei dem, was man vorher wusste.
report-little-informative = { $unknown }: Die Daten helfen ein wenig; { $left } % der vorigen Unsicherheit bleiben.
report-informative = { $unknown }: Das legen die Daten fest; { $left } % der vorigen Unsicherheit bleiben.
report-fit = Wie gut es passt
report-fit-table = Die Aufpralle, wie die Schätzung sie sieht, mit der Energie, die jeder nahm, und seinem Gewicht darin
report-sampling = Die Stichprobe ist { $draws } unabhängige Ziehungen wert; ihre Pareto-Form ist { $shape } (gut unter 0,7).

report-air = Die Luft bei diesem Tempo
report-conditions = Bedingungen und Annahmen
report-assumed = Das hat niemand angegeben, darum ist es angenommen:
report-priors = Was die Schätzung vor den Daten wusste
report-source = Quelle
report-source-times = { $origin ->
    [none] eine Liste von Aufprallzeiten
   *[other] eine Liste von Aufprallzeiten: { $origin }
  }
report-source-sound = { $format }, { $rate } kHz, { $duration } s
report-samples = Abtastwerte
report-microphone = Mikrofon
report-channel = Kanal
report-channel-of = { $channel } von { $count }
report-onsets = Laute über dem Rauschen
report-ball = Ball
report-mass = Masse
report-diameter = Durchmesser
report-contact-time = Kontaktzeit
report-gravity = Fallbeschleunigung
report-air-density = Dichte der Luft
report-drag-law = Widerstandsgesetz
report-displaced-air = Auftrieb und mitbewegte Luft
report-displaced-air-both = beide berücksichtigt
report-displaced-air-buoyancy = nur der Auftrieb
report-displaced-air-added-mass = nur mitbewegte Luft
report-displaced-air-none = weggelassen
report-measured-height = Gemessene Fallhöhe
report-release = Loslassen, in der Aufnahme
report-sampler = Stichprobe
report-sampler-draws = { $draws } Ziehungen, Startwert { $seed }

report-repeat = Um das zu wiederholen
report-repeat-version = Version { $version } von bouncelab gibt aus derselben Datei und denselben Einstellungen dieselben Zahlen; die Zufallszahlen der Schätzung haben einen festen Startwert.
report-repeat-files = Die gelesenen Dateien mit ihrer SHA-256-Summe (sha256sum zeigt sie):

report-method = Verfahren
report-method-short = Die Aufpralle werden im Ton gefunden; die Zeit zwischen zweien ist die eines Flugs. Die Schätzung berechnet aus allen Flugzeiten Stoßzahl, Fallhöhe und Luftwiderstand, mit dem Fall durch die Luft, mit Stoßzahlen, die von Aufprall zu Aufprall streuen, und mit Fehlern der Zeiten. Von jeder Größe steht der Median da, ± ihre Standardabweichung; ein Bereich von 95 % enthält die Wahrheit mit dieser Wahrscheinlichkeit, wenn die Annahmen stimmen. Die Ausgleichsgerade durch die Logarithmen der Flugzeiten weiß nichts von der Luft. Die Stoßzahl steht beim Tempo des ersten erkannten Aufpralls und bei einem runden Tempo da, denn die der meisten Bälle ändert sich mit dem Tempo. Ohne angegebene Fallhöhe ist die Fallhöhe die vor dem ersten erkannten Aufprall; ob vor ihm Aufpralle fehlen, zeigen die Zeiten nicht. Ein Versuch misst den Luftwiderstand kaum: Der Beiwert ist vor allem, was man von Kugeln weiß, und die Bereiche enthalten seine Unsicherheit ebenso wie die, dass sich die Stoßzahl auf unbekannte Weise mit dem Tempo ändert. Formeln und Literatur stehen unter „Einzelheiten“.

report-formulas = Das Verfahren mit seinen Formeln
report-method-flight = Nur die Aufpralle machen einen Laut. Die Zeit T zwischen zwei Aufprallen ist die eines Flugs und ergibt seine Höhe h fast unabhängig von der Luft:
report-method-line = Behielte jeder Aufprall denselben Anteil e des Tempos und gäbe es keine Luft, so lägen die Logarithmen der Flugzeiten über der Nummer n des Aufpralls auf einer Geraden. Ihre Steigung gibt die Stoßzahl e, ihr Achsenabschnitt b die Fallhöhe (Nagurka, Gl. 4 und 6):
report-method-motion = Auch die Luft nimmt Tempo, und sie trägt den Ball ein wenig und bewegt sich mit ihm. Mit Masse m, Volumen V und Querschnitt A des Balls, Dichte ρ der Luft und einem Widerstandsbeiwert, der der Reynolds-Zahl folgt, ändert sich die Geschwindigkeit v so:
report-method-restitution = Aus jeder Flugzeit folgt, mit welchem Tempo v der Ball den Untergrund verließ und mit welchem Tempo v′ er wiederkam, und aus zwei benachbarten Flügen die Stoßzahl des Aufpralls zwischen ihnen:
report-method-noise = Zweierlei Rauschen wird getrennt: Aufpralle streuen um einen Anteil σₑ ihrer Stoßzahl, und Zeiten haben Fehler σₜ, die benachbarte Aufpralle über die Ableitungen J teilen. Aufpralle, die aus der Reihe fallen, zählen weniger (Student-t).
report-method-posterior = Die Schätzung wägt alle Werte θ dessen, was unbekannt ist, unter jedem Gesetz M von Stoßzahl und Luftwiderstand: danach, wie gut sie die Zeiten t erklären, und nach dem, was man vorher wusste. Von jeder Größe steht der Median da, ± ihre Standardabweichung; ein Bereich von 95 % enthält die Wahrheit mit dieser Wahrscheinlichkeit, wenn die Annahmen stimmen.
report-references = Literatur:
report-reference-drag = { $work }: die übliche Kurve des Luftwiderstands.
report-reference-scatter = { $work }: die Streuung der Aufpralle.
