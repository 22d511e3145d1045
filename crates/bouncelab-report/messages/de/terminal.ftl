terminal-note = Hinweis: { $text }
terminal-assumed = Angenommen: { $list }
analyze-balls-heading = Was die Zeiten zu jedem Ball sagen, verglichen mit dem angegebenen oder angenommenen:
terminal-cannot-tell = { $what }: nicht zu sagen: { $reason }

analyze-times = { $origin ->
    [none] { $name }: Aufprallzeiten
   *[other] { $name }: Aufprallzeiten, { $origin }
  }
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
analyze-line = Ausgleichsgerade
analyze-line-heading = Ausgleichsgerade durch die Logarithmen der Flugzeiten, ohne Luft:
analyze-corrected = Luftwiderstand herausgerechnet
analyze-corrected-heading = Luftwiderstand herausgerechnet ({ $law }):
analyze-inference-heading = Schätzung, mit Luft:

analyze-details-models = Modelle, vor den Daten gleich wahrscheinlich:
analyze-details-budget-restitution = Unsicherheitsbudget von e:
analyze-details-budget-height = Unsicherheitsbudget von h0:
analyze-details-contraction = Wie weit die Daten die Unsicherheit verringert haben:
analyze-details-correlations = Korrelationen der Schätzwerte:
analyze-details-impacts = Aufpralle in der Schätzung:
analyze-details-priors = Annahmen vor den Daten:
analyze-details-sampling = Stichprobe: { $draws } unabhängige Ziehungen, Pareto-Form { $shape } (gut unter 0,7).
analyze-no-drop = { $name }: kein springender Ball gefunden: { $reason }
analyze-detecting = suche { $bar } { $done } s, noch { $left }
analyze-inferring = Inferenz aus { $impacts } Aufprallen (--no-inference lässt sie aus)
analyze-one-report = ein Bericht gilt einer Aufnahme, hier sind es mehrere: bouncelab session macht einen aus vielen
analyze-cues-of-file = --cues kopiert eine Aufnahme und braucht deshalb eine Datei statt der Standardeingabe
analyze-input-too-long = die Standardeingabe ist länger als 1 GiB, und sie wird im Speicher gehalten; speichere sie in einer Datei
analyze-one-labelled = Textmarken, Marken im Ton und Bewegung gelten einer Aufnahme, hier sind es mehrere: eine nach der anderen angeben
analyze-cues-need-sound = { $name } ist eine Liste von Zeiten ohne Ton, in dem Marken stehen könnten; --format audacity oder textgrid schreibt Textmarken

terminal-wrote = { $file } geschrieben
terminal-not-printed = { $browser } hat den Bericht nicht gedruckt: { $reason }
terminal-no-browser = Ein PDF druckt Chromium, Chrome oder Edge; keiner wurde gefunden. Installiere einen davon, oder schreibe den Bericht als .html und drucke ihn.
terminal-wrote-figure = { $file }, .png, .pdf und .csv geschrieben
terminal-first-figures = Die ersten { $count } Versuche haben eigene Abbildungen; Ergebnisse für Programme haben alle.
terminal-all-shown = ... und { $count } weitere; --format csv hat alle.

demo-heading = Ein Versuch aus 30,5 cm, erzeugt, erkannt und ausgewertet ({ $file })
demo-truth = Wahrheit
demo-detected = gemessen
demo-flight-time-error = größter Fehler einer Flugzeit
demo-restitution-line = e, Ausgleichsgerade, 10 Flüge
demo-restitution-inference = e, Schätzung
demo-height-line = Fallhöhe, Ausgleichsgerade
demo-height-inference = Fallhöhe, Schätzung
demo-second-speed = Tempo des zweiten Aufpralls
demo-conclusion =
    Die Ausgleichsgerade vernachlässigt den Luftwiderstand: Stoßzahl und Fallhöhe sind zu klein.
    Die Schätzung berücksichtigt die Luft und findet beide wieder.

simulate-heading = Ein Versuch mit einem Ball ({ $ball }), simuliert
simulate-bounces = Sprünge
simulate-first-speed = Tempo des ersten Aufpralls
simulate-no-terminal-speed = keine
simulate-total-time = Zeit bis zum Ende
simulate-total-path = Weg bis zum Ende
simulate-initial-energy = Energie am Anfang
simulate-lost-to-surface = an den Untergrund verloren
simulate-lost-to-air = an die Luft verloren
simulate-each-bounce = Jeder Sprung, Luftwiderstand { $law }:
simulate-bounce = Sprung
simulate-to-surface = Untergrund µJ
simulate-to-air = Luft µJ
simulate-drag = Luftwiderstand { $law }

synth-made = { $file }: { $count ->
    [one] 1 Aufprall
   *[other] { $count } Aufpralle
  } in { $seconds } s, { $rate } Hz, Startwert { $seed }

puzzle-question = Die Abweichung: Was lässt die Ausgleichsgerade e = 0,9375 und h0 = 26,7 cm ergeben, wenn der Ball aus 30,5 cm fällt?
puzzle-flights = Flüge
puzzle-first = e bei 2,4 m/s
puzzle-slow = e bei 0,5 m/s
puzzle-height = Gerade: h0 cm
puzzle-solved = die 26,7 des Aufsatzes?
puzzle-yes = ja
puzzle-no = nein
puzzle-answer =
    Jedes Gesetz ist so gewählt, dass die Gerade e = 0,9375 ergibt; Knicke liegen bei 1,5 m/s. Luftwiderstand mit gleichbleibender
    Stoßzahl gibt 26,7 cm erst mit etwa 21 Flügen in der Geraden; mit zehn Flügen muss die Stoßzahl auch
    mit dem Tempo fallen. Die Ausgleichsgerade kann beides nicht unterscheiden, denn ihr Ergebnis hängt
    von der Zahl der Flüge ab.
puzzle-quantity = Größe
puzzle-printed = gedruckt
puzzle-computed = berechnet
puzzle-verdict = Urteil

job-check-failed = Die Prüfung des Verfahrens ist fehlgeschlagen: Das Programm findet nicht, was bekannt ist. Es wurde kein Auftrag angelegt.
job-no-drop-added = Dem Auftrag wurde kein Versuch hinzugefügt.
job-damaged = { $count ->
    [one] Eine Zeile von { $file } ist beschädigt und zählt nicht; `bouncelab job show` nennt jede Aufnahme ohne Zeile.
   *[other] { $count } Zeilen von { $file } sind beschädigt und zählen nicht; `bouncelab job show` nennt jede Aufnahme ohne Zeile.
}
job-uncounted = { $file } bleibt aufbewahrt, zählt aber nicht: Sie wurde nicht eingetragen, wie nach einer Unterbrechung. Ist ihr Versuch vollständig, zählt { $command } sie mit.

balls-numbers = { $ball }, Kontakt { $contact }
balls-words = auch: { $words }

listen-begins = höre { $source }, { $rate } kHz, { $channels ->
    [one] 1 Kanal
   *[other] { $channels } Kanäle
  }; { $file ->
    [none] nichts wird gespeichert
   *[other] laufend gespeichert in { $file }
  }
listen-saved-in = gespeichert in { $file }
listen-not-saved = NICHT GESPEICHERT
listen-silence = vom Mikrofon kommt nur Stille: Ist es stumm, oder das falsche (--devices)?
listen-fault = die Auswertung scheiterte an einem Fehler des Programms; bitte melden
listen-goes-on = Die Aufnahme läuft weiter, bis Sie sie beenden.
listen-lost = Ton ging verloren: Der Rechner war zu langsam, oder das Mikrofon hatte einen Fehler; Flüge über die Lücke zählen nicht
listen-lost-in-all = { $frames } Abtastwerte jedes Kanals ({ $seconds } s) gingen an { $count ->
    [one] einer Stelle
   *[other] { $count } Stellen
  } verloren
listen-lacks-sound = nicht der ganze Ton wurde gespeichert: Wo er verloren ging, hat die Datei Stille und sagt es
listen-not-analysed = ein Versuch lässt sich nicht auswerten: { $reason }
listen-once-more = Versuch { $number } noch einmal, da nun alles bekannt ist
listen-heading = Versuch { $number }
listen-all-drops = Alle Versuche:
listen-saved = der Ton ist in { $file }; um ihn noch einmal auszuwerten: { $command }
listen-left-out = der Versuch bei { $start } s { $reason ->
    [distant] ist ein viel leiserer Ball als die anderen
   *[unlikely] hält der ganzen Aufnahme nicht stand
  } und ist weggelassen, da nun alles bekannt ist
listen-impact = Versuch { $drop }: Aufprall { $impact } bei { $time } s nach { $flight } ms{ $rests ->
    [yes] ; der Ball ruht
   *[no] {""}
  }
listen-line = e = { $restitution }, h0 = { $height } ohne Luft
listen-corrected = e = { $restitution }, Luftwiderstand herausgerechnet
listen-too-loud = ZU LAUT: übersteuert
listen-level = Pegel
listen-seconds = { $seconds } s
listen-drops = { $count ->
    [one] 1 Versuch
   *[other] { $count } Versuche
  }
listen-sounds = { $count ->
    [one] 1 Laut
   *[other] { $count } Laute
  }
listen-lost-so-far = { $count } Abtastwerte VERLOREN
listen-ends = Strg-C beendet
listen-at = bei s
listen-e-line = e, ohne Luft
listen-h0-line = h0, ohne Luft
listen-mean = Mittel
listen-scatter = Streuung
listen-save-failed = der Ton wird nicht mehr gespeichert: { $fault }; { $seconds } s sind in der Datei. Das Zuhören geht weiter
listen-end-not-saved = das Ende des Tons ist vielleicht nicht gespeichert: { $fault }
listen-device = Name
listen-device-kind = Art
listen-device-default = voreingestellt

session-ball-assumed = Der Luftwiderstand hängt vom Ball ab, der nicht angegeben ist: angeben mit --ball, in den Namen der Aufnahmen oder in session.toml.
session-title = Sitzung
session-speed = Stoßzahl bei einem Aufpralltempo von { $speed } m/s:
session-legend =
    ±: Standardunsicherheit; gemeinsam: was davon alle Versuche teilen (Luftwiderstand, Luft, Ball, Personen)
    und keine Zahl von Versuchen kleiner macht; zwischen Versuchen: Streuung über ihre eigenen Fehler hinaus; { $wanted ->
        [none] nötig: Versuche insgesamt, die den Bereich halbieren würden
       *[other] nötig: Versuche insgesamt für eine auf ± { $wanted } bekannte Stoßzahl (95 %)
      }
session-intervals = 95-%-Bereiche, und die Standardabweichungen nach ISO 5725:
session-scatters = Streuung neben der der Versuche, relativ:
session-curves = Stoßzahl über dem Aufpralltempo:
session-drop-heights = Fallhöhen:
session-outliers = Ausreißer in ihrer Gruppe; stimmt, was zu ihnen notiert ist?
session-outlier = { $name }: { $off } { $side ->
    [above] über
   *[below] unter
  } den anderen von { $group }, { $score } Standardabweichungen
session-outliers-count = Sie zählen in allem, was oben steht. Mit ihnen und ohne sie:
session-exclude = --exclude NAME lässt einen überall weg.
session-differences = Unterschiede von Gruppen:
session-more = und { $count } weitere (--details)
session-tables = Tabellen: { $list }
session-no-drop = keine Aufnahme enthält einen springenden Ball
session-damaged-journal = { $count } Zeilen des Journals sind abgeschnitten oder beschädigt und zählen nicht
session-died = ihre Auswertung hat ihren Prozess zweimal beendet, das zweite Mal allein ({ $how }); ist sie lang, gib ihr mehr mit --memory, sonst melde es bitte
session-unmatched-names = { $count ->
    [one] 1 Name passt
   *[other] { $count } Namen passen
  } nicht zum Muster „{ $pattern }“: { $names }
session-noted-otherwise = { $first } und { $other } sind derselbe Ton, aber { $field } ist beim einen { $of-first } und beim anderen { $of-other }; es zählt, was zum ersten vermerkt ist
session-not-noted = nicht vermerkt
session-by-hand = von Hand ausgelassen
session-inference-left-out = verglichen werden Versuche durch die Inferenz, und die wurde ausgelassen (--no-inference)
session-progress = analysiere { $bar } { $done } Aufnahmen, { $rate }, noch { $left }
session-known = { $kept } von { $all } Aufnahmen sind aus einem früheren Lauf ausgewertet
session-out-of-time = ihre Auswertung hat mehr als { $seconds } s Rechenzeit gebraucht; gib ihr mehr mit --time-limit oder verlange weniger: weniger --draws, eine kürzere Aufnahme
session-restitution = Stoßzahl

serve-address = Das Labor ist auf { $address } (Strg-C beendet es)
serve-no-browser = kein Browser ließ sich öffnen ({ $reason }); öffne { $address } selbst
page-written = { $files } Dateien liegen in { $folder }. Liefert ein Server sie mit https aus, dürfen Handys ihr Mikrofon benutzen.
