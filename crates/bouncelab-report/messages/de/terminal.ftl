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

verdict-because = Grund: { $reason }
verdict-conforms = konform
verdict-conforms-as-far-as-shown = konform, soweit nachgewiesen
verdict-does-not-conform = nicht konform
verdict-cannot-decide = nicht zu entscheiden
verdict-sure = { $outcome }. Innerhalb der Grenzen mit einer Wahrscheinlichkeit von { $within }; anzunehmen wäre falsch mit { $outside }.
verdict-guarded = Entscheidungsregel: abgesicherte Annahme, falsch mit höchstens { $risk } nach beiden Seiten (JCGM 106).
verdict-simple = Entscheidungsregel: einfache Annahme, was wahrscheinlicher ist (JCGM 106).
verdict-accepted = Bei dieser Unsicherheit wären { $accepted } konform.
verdict-more-than = mehr als { $share }
verdict-less-than = weniger als { $share }
verdict-from = { $least } und mehr
verdict-up-to = { $greatest } und weniger
verdict-anything = beliebig
verdict-on-reference = Auf der Referenz:
verdict-rebound = Rücksprung
verdict-value = Wert
verdict-by-procedure = nach dem Verfahren der Regel
verdict-by-model = nach dem Modell, aus allen Aufprallen
verdict-height = Höhe
verdict-model = Modell
verdict-budget = Unsicherheitsbudget des Mittels
verdict-budget-reference = Dasselbe auf der Referenz
verdict-budget-why = Korrekturen sind die von g T²/8, das die ganze Zeit zwischen zwei Aufprallen für Flug im Vakuum hält; wo die Regel eine Formel angibt, gibt es keine. Standardunsicherheiten addieren sich quadratisch (JCGM 100); das 95-%-Intervall hat die effektiven Freiheitsgrade.
verdict-correction = Korrektur cm
verdict-standard-uncertainty = Standardunsicherheit cm
verdict-degrees = Freiheitsgrade
verdict-combined = zusammen
verdict-cause-gravity = Fallbeschleunigung des Orts
verdict-cause-release = Fallhöhe
verdict-cause-times = Zeiten der Aufpralle
verdict-cause-scatter = Streuung der Versuche, mit ihren Zeiten
verdict-cause-assumed-scatter = Streuung einzelner Aufpralle, angenommen
verdict-procedure = Das Verfahren
verdict-asked = die Regel
verdict-here = hier
verdict-kept = eingehalten
verdict-not-kept = nicht eingehalten
verdict-not-shown = nicht nachgewiesen
verdict-item = Teil
verdict-item-release = Fallhöhe
verdict-item-surface = Untergrund
verdict-item-reference = Referenzuntergrund
verdict-item-temperature = Temperatur
verdict-item-humidity = Luftfeuchte
verdict-item-altitude = Meereshöhe
verdict-item-conditioning = Konditionierung
verdict-item-drops = Zahl der Versuche
verdict-item-reference-drops = Versuche auf der Referenz
verdict-item-places = Zahl der Stellen
test-heading = Prüfbericht
test-title = Prüfbericht { $number }
test-number = Nummer
test-laboratory = Laboratorium
test-client = Auftraggeber
test-item = Prüfgegenstand
test-sample = Probe
test-received = erhalten
test-tested = geprüft
test-issued = ausgestellt
test-location = Ort
test-operator = Prüfer
test-method = Verfahren
test-deviations = Abweichungen vom Verfahren
test-conditions = Bedingungen
test-reference = Referenz
test-equipment = Geräte und Kalibrierung
test-authorised = freigegeben von
test-closing = Erklärungen
test-only-items = Die Ergebnisse beziehen sich nur auf die geprüften Gegenstände. Dieser Bericht darf ohne Genehmigung des Laboratoriums nur vollständig vervielfältigt werden.
test-end = Ende des Berichts
test-not-given = nicht angegeben
test-check = Prüfung des Verfahrens
test-checked = ein synthetischer Versuch mit einem ersten Rücksprung von { $truth }: gefunden { $found }
job-place = Stelle { $place } von { $places }, Versuch { $drop } von { $drops }
job-reference = Referenz, Versuch { $drop } von { $drops }
job-place-name = Stelle { $place }
job-repeated = wiederholt: { $reason }
job-so-far = Bisher { $value }. { $outcome }
job-microphone = Mikrofon
job-no-drop-added = Dem Auftrag wurde kein Versuch hinzugefügt.
job-damaged = { $count ->
    [one] Eine Zeile von { $file } ist beschädigt und zählt nicht; `bouncelab job show` nennt jede Aufnahme ohne Zeile.
   *[other] { $count } Zeilen von { $file } sind beschädigt und zählen nicht; `bouncelab job show` nennt jede Aufnahme ohne Zeile.
}
job-uncounted = { $file } bleibt aufbewahrt, zählt aber nicht: Sie wurde nicht eingetragen, wie nach einer Unterbrechung. Ist ihr Versuch vollständig, zählt { $command } sie mit.
verdict-reference = auf der Referenz
verdict-share = Anteil an der Referenz
verdict-unevenness = Ungleichmäßigkeit der Stellen
verdict-plain = g T²/8 des ersten Flugs
verdict-reason = wegen
verdict-file = Datei
verdict-first-flight = erster Flug s
verdict-cause-contact = Kontaktzeit, die kein Flug ist
verdict-cause-buoyancy = Auftrieb und mitbewegte Luft
verdict-cause-drag = Luftwiderstand im Flug
verdict-rule-line = Fall aus { $drop }{ $surface ->
    [none] {""}
   *[other] {" "}(Untergrund: { $surface })
  }; verlangter Rücksprung: { $wanted }; gemessen { $point } des Balls
verdict-the-rule = Die Regel
verdict-ways = Der Rücksprung auf jedem Weg, ihn zu bestimmen
verdict-the-rebound = Der Rücksprung
verdict-drops = Die Versuche
verdict-every-drop = Jeder Versuch
verdict-every-reference-drop = Jeder Versuch auf der Referenz
verdict-all-drops = alle Versuche
verdict-method = Wie entschieden wurde
verdict-method-predicted = Beurteilt wird das Ergebnis des Verfahrens, das die Regel angibt: die Höhe des ersten Rücksprungs, nach der Formel der Regel oder, wo die Regel die Höhe selbst misst, aus der Zeit zwischen den ersten beiden Aufprallen ohne den Kontakt, mit Auftrieb, mitbewegter Luft und Luftwiderstand. Das Modell sagt denselben Rücksprung aus allen Aufprallen vorher und steht daneben.
verdict-method-decided = Abgesicherte Annahme (JCGM 106:2012, The role of measurement uncertainty in conformity assessment; ILAC-G8:09/2019): Konform ist nur, was mit höchstens dem angegebenen Risiko außerhalb der Grenzen liegt, und nicht konform nur, was mit höchstens diesem innerhalb liegt. Dazwischen lassen die Versuche keine Entscheidung zu. Konform, soweit nachgewiesen, heißt: Weder die Aufnahmen noch die Angaben zeigen, dass das ganze Verfahren eingehalten wurde.

balls-numbers = { $ball }, Kontakt { $contact }
balls-words = auch: { $words }

rule-name = Name
rule-title = Regel
rule-sport = von
rule-source = Quelle
rule-status = Stand
rule-read-primary = geprüft: der Text wurde gelesen
rule-read-secondary = Sekundärquelle
rule-read-memory = aus dem Gedächtnis
rule-address = Adresse
rule-checked = gelesen am
rule-conditioning = Konditionierung
rule-humidity = Luftfeuchte
rule-rounded = gerundet auf
rule-places-least = mindestens { $count }
rule-ball = Ball
rule-surface = Untergrund
rule-drop = Fall
rule-wants = verlangt
rule-measured-at = gemessen
rule-point = { $point } des Balls
rule-point-bottom = am tiefsten Punkt
rule-point-centre = in der Mitte
rule-point-top = am höchsten Punkt
rule-point-not-noted = nicht vermerkt; es gilt der tiefste Punkt des Balls
rule-drops = Versuche
rule-drops-mean = mindestens { $count }; ihr Mittel zählt
rule-drops-each = mindestens { $count }; jeder muss genügen
rule-places = Stellen
rule-temperature = Temperatur
rule-altitude = Meereshöhe
rule-formula = Formel
rule-formula-text = H = { $factor } (T - { $offset })² in m und s, T vom ersten Aufprall zum zweiten ({ $read })
rule-note = Anmerkung
rule-any-height = beliebige Höhe
rule-or-more = { $height } oder mehr
rule-about = etwa { $height }
rule-share-of = Anteil an dem auf der Referenz ({ $surface })
rule-limits-of = { $limits } dessen auf der Referenz ({ $surface })
rule-share-of-reference = Anteil an einer Referenz
rule-limits-of-reference = { $limits } einer Referenz
rule-within-of-mean = jede Stelle innerhalb von { $share } % des Mittels
rule-places-apart = Stellen höchstens { $share } Prozentpunkte auseinander
rule-at-least = mindestens { $least }
rule-at-most = höchstens { $greatest }

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
