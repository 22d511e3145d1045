terminal-note = Hinweis: { $text }
terminal-assumed = Angenommen: { $list }.
terminal-cannot-tell = { $what }: nicht zu sagen: { $reason }

analyze-times = { $name }: Aufprallzeiten
analyze-sound = { $name }: { $format }, { $rate } kHz{ $channels ->
    [1] {""}
   *[other] , Kanal { $channel } von { $channels }
  }, { $duration } s
analyze-listening = { $onsets } Laute heben sich vom Hintergrund ab, und { $impacts } Aufpralle wurden erkannt, am deutlichsten von { $low } bis { $high } Hz, { $above } dB über dem Ton davor (--channel, --band).
analyze-drop = { $drops ->
    [1] Versuch
   *[other] Versuch { $number } von { $drops }
  }: { $count } Aufpralle von { $first } s bis { $last } s{ $uncertain ->
    [0] {""}
   *[other] , { $uncertain } unsicher (?)
  }{ $probability ->
    [none] {""}
   *[other] {" "}(mit Wahrscheinlichkeit { $probability } ein springender Ball)
  }
analyze-line = Gerade
analyze-line-heading = Gerade durch die Logarithmen der Flugzeiten, als gäbe es keine Luft:
analyze-line-flights = (vor dem ersten erkannten Aufprall; { $count ->
    [one] 1 Flug
   *[other] { $count } Flüge
  })
analyze-until-rest = bis zur Ruhe
analyze-corrected = Luftwiderstand herausgerechnet
analyze-corrected-heading = Luftwiderstand herausgerechnet ({ $ball }, { $law }):
analyze-corrected-impacts = (Median von { $count } Aufprallen bei { $slowest } bis { $fastest } m/s)
analyze-corrected-too-few = Luftwiderstand herausgerechnet: kein Mittelwert: { $count } der Aufpralle liegen zwischen zwei Flügen, und es braucht 3.
analyze-inference = Schätzung
analyze-inference-heading = Schätzung, mit Luft ({ $ball }):
analyze-at-speed = bei { $speed }
analyze-before-data = { $value } vor den Daten
analyze-known = als bekannt angenommen
analyze-first-fall = vor dem ersten erkannten Aufprall
analyze-missed = vorher verpasste Aufpralle: { $list }
analyze-reach = Sprung { $bounce } erreicht { $apex } aus
analyze-interval = 95 %: { $interval }

analyze-details-models = Modelle, vor den Daten gleich wahrscheinlich:
analyze-details-budget-restitution = Woher die Unsicherheit von e kommt:
analyze-details-budget-height = Woher die Unsicherheit von h0 kommt:
analyze-details-contraction = Wie weit die Daten eingegrenzt haben, was bekannt war:
analyze-details-correlations = Korrelationen der Antworten:
analyze-details-impacts = Aufpralle in der Schätzung:
analyze-details-priors = Vor den Daten:
analyze-details-sampling = Stichprobe: { $draws } unabhängige Ziehungen, Pareto-Form { $shape } (gut unter 0,7).
analyze-no-drop = { $name }: kein springender Ball gefunden: { $reason }
analyze-one-report = ein Bericht gilt einer Aufnahme, hier sind es mehrere: bouncelab session macht einen aus vielen
advice-allow-implausible = Berichtigen Sie es, oder bestehen Sie mit --allow-implausible darauf
