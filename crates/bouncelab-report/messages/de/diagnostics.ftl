diagnostic-recording-silent = Die Aufnahme ist stumm: Jeder Abtastwert ist gleich.
diagnostic-no-sound = Kein Laut hebt sich vom Hintergrund ab.
diagnostic-too-few-sounds = { $count ->
    [one] Nur ein Laut hebt sich vom Hintergrund ab
   *[other] Nur { $count } Laute heben sich vom Hintergrund ab
  }; einen springenden Ball erkennt man an mindestens { $needed } Aufprallen.
diagnostic-periodic-sounds = { $count } Laute kommen im Takt, etwa alle { $interval_s }, wie von einer Uhr, von Schritten oder einer Trommel; die Flüge eines Balls werden kürzer.
diagnostic-no-pattern = { $count } Laute heben sich ab, aber keine { $needed } davon kommen in schrumpfenden Abständen wie die Aufpralle eines Balls.
diagnostic-too-few-times = Ein Flug braucht zwei Aufprallzeiten, und es sind weniger.
diagnostic-too-many-times = Die Liste hat { $count } Zeiten; kein Versuch hat mehr als { $most } Aufpralle. Nenne die eines Versuchs. Eine abgetastete Wellenform braucht eine zweite Spalte, die Amplitude.
diagnostic-times-in-milliseconds = Zwischen Aufprallen liegen mehr als 30 s; so lange fliegt kein Ball. Zeiten sind in Sekunden, unter der Überschrift time_ms in Millisekunden.
diagnostic-flights-do-not-fall = Die { $count } Abstände zwischen den Zeiten werden nicht kürzer wie die Flüge eines springenden Balls: Am Anfang dauern sie { $first_s } s, am Ende { $last_s } s. Das sind Abtastwerte, eine andere Uhr oder mehrere Versuche; nenne die Aufprallzeiten eines Versuchs.
diagnostic-times-by-threshold = Die Zeiten sind die, zu denen der Schall eine Schwelle überschritt; sie setzt einen leisen Aufprall später an als einen lauten. Eine Tonaufnahme ergibt bessere Zeiten.
diagnostic-times-of-intervals = Die Aufprallzeiten sind Summen der genannten Abstände; der erste Aufprall liegt bei 0 s.
diagnostic-nothing-left = Es wurden so viele Aufpralle weggelassen, dass kein Flug bleibt.
diagnostic-distant-ball = Ein viel leiserer Ball wurde von { $start_s } s bis { $end_s } s erkannt ({ $impacts } Aufpralle) und weggelassen.
diagnostic-drops-at-once = Von { $start_s } s bis { $end_s } s springen zwei Bälle zugleich: Klingen sie gleich, kann ein Aufprall des einen für einen des anderen gehalten werden.
diagnostic-clipped = { $samples ->
    [one] 1 Abtastwert ist übersteuert
   *[other] { $samples } Abtastwerte sind übersteuert
  }: Die Aufnahme war zu laut; Zeiten leiden kaum, Pegel schon.
diagnostic-earlier-impact = Ein Geräusch bei { $time_s } s, vor dem Versuch ab { $start_s } s, kann ein früherer Aufprall sein, auch wenn es schlecht zu den anderen passt: Dann fiel der Ball von höher als angegeben.
diagnostic-sounds-unused = { $count } Geräusche bei dem Versuch ab { $start_s } s sind so laut wie seine Aufpralle und blieben ungenutzt: andere Geräusche oder ein zweiter Ball.
diagnostic-possible-drop = Möglicher Versuch { $number }: ab { $start_s } s, { $impacts } Aufpralle, Wahrscheinlichkeit { $probability }. Er zählt nur, wenn man ihn annimmt (--accept { $number }).
diagnostic-no-candidate = Einen möglichen Versuch mit der Nummer { $number } gibt es nicht, sondern { $count ->
    [0] keinen
   *[other] { $count }
  }.
diagnostic-nothing-to-exclude = Bei { $time_s } s liegt kein Aufprall, darum wurde dort keiner weggelassen.
diagnostic-too-far-to-include = { $time_s } s liegt mehr als { $reach_s } von jedem Versuch entfernt und wurde darum nicht hinzugefügt.
diagnostic-sound-lost = Bei { $at_s } s ging Ton verloren: Kein Flug über eine Lücke zählt, und von { $impacts } Aufprallen nur die { $kept } des längsten Stücks ohne Lücke.
diagnostic-release-without-drop = Nach dem angegebenen Loslassen bei { $time_s } s beginnt kein Versuch.
diagnostic-height-of-another-unit = Als Höhe sind { $stated_m } angegeben, aber der Ball fiel nach seinen Flügen aus etwa { $detected_m }, als wären { $meant_m } gemeint.

diagnostic-file-unreadable = Die Datei lässt sich nicht lesen.
diagnostic-file-truncated = { $expected_s ->
    [none] Die Datei ist abgeschnitten oder beschädigt, oder sie enthält mehr Ton, als ihr Kopf zählt: Sie wurde bis { $read_s } s gelesen. Wurde davor Ton eingefügt, sind spätere Zeiten zu spät.
   *[other] Die Datei ist abgeschnitten: { $read_s } s von { $expected_s } s waren lesbar. Fehlt der Rest nicht am Ende, sind spätere Zeiten zu früh.
  }
diagnostic-samples-not-finite = { $samples ->
    [one] 1 Abtastwert war keine Zahl und wurde zu null, bei { $first_s } s.
   *[other] { $samples } Abtastwerte waren keine Zahlen und wurden zu null, der erste bei { $first_s } s.
  }
diagnostic-bits-flipped = { $samples } Abtastwerte springen um eine Zweierpotenz und zurück, der erste bei { $first_s } s: In der Datei sind Bits vertauscht, Aufpralle können fehlen oder falsch sein.
diagnostic-sound-missing = { $places ->
    [one] { $missing_s } s Ton fehlen bei { $first_s } s
   *[other] { $missing_s } s Ton fehlen an { $places } Stellen, der ersten bei { $first_s } s
  }: Dort steht Stille, und kein Flug darüber zählt.
diagnostic-clock-lost = { $places ->
    [one] Die Datei ist bei { $first_s } s beschädigt
   *[other] Die Datei ist an { $places } Stellen beschädigt, der ersten bei { $first_s } s
  } und sagt nicht, wie viel Ton fehlt: Zeiten davor und danach gehören nicht zusammen, und kein Flug darüber zählt.
diagnostic-sound-blank = { $places ->
    [one] Der Ton ist bei { $first_s } s für { $blank_s } s genau null
   *[other] Der Ton ist an { $places } Stellen, der ersten bei { $first_s } s, für zusammen { $blank_s } s genau null
  } und sonst nicht: Dort ging er vielleicht verloren oder wurde überschrieben.
diagnostic-checksum-wrong = Die Ergebnisse können falsch sein: Der Ton ist nicht der, von dem die Datei die Prüfsumme oder die Länge hat. Er wurde irgendwo von { $start_s } s bis { $end_s } s verändert, sodass dort überall Aufpralle fehlen, verschoben oder hinzugekommen sein können.
diagnostic-format-changes = Der Ton wechselt bei { $at_s } s Rate oder Kanäle; er wurde bis dort gelesen.
diagnostic-rate-in-doubt = { $implied_hz ->
    [none] Der Kopf der Datei gibt { $stated_hz } Abtastwerte pro Sekunde an, was in diesem Format unüblich ist und nur einmal angegeben wird
   *[other] Der Kopf der Datei gibt { $stated_hz } Abtastwerte pro Sekunde an, seine Bytes pro Sekunde aber gehören zu { $implied_hz }
  }: Ist die Rate falsch, sind es alle Zeiten.
diagnostic-edit-list-ignored = Die Schnittliste der Datei ordnet den Ton um; er wurde gelesen, wie er aufgenommen ist.

diagnostic-impacts-missed = { $count ->
    [one] Ein Aufprall dazwischen wurde nicht erkannt; er ist mitgezählt.
   *[other] { $count } Aufpralle dazwischen wurden nicht erkannt; sie sind mitgezählt.
  }
diagnostic-impact-gains-energy = { $count ->
    [one] Aufprall { $impacts } gäbe dem Ball Energie (Stoßzahl über 1): doppelt ausgelöst, ein bewegter Untergrund oder kein Aufprall.
   *[other] Die Aufpralle { $impacts } gäben dem Ball Energie (Stoßzahl über 1): doppelt ausgelöst, ein bewegter Untergrund oder keine Aufpralle.
  }
diagnostic-restitution-rises = Die um den Luftwiderstand bereinigte Stoßzahl steigt mit dem Aufpralltempo, von { $slow } auf { $fast }: Das tun wirkliche Bälle nicht; wahrscheinlich ist der Ball ein anderer, schwerer für seine Größe.
diagnostic-impacts-doubtful = { $count ->
    [one] Ein Aufprall ist
   *[other] { $count } Aufpralle sind
  } eher etwas anderes (Wahrscheinlichkeit unter 1/2).
diagnostic-flight-grows = Flug { $flight } ist länger als der vor ihm, was auf ruhendem Untergrund nicht geht.

diagnostic-impacts-too-close = { $count ->
    [one] Der Aufprall bei { $start_s } s folgt
   *[other] { $count } Aufpralle ab { $start_s } s folgen
  } innerhalb der doppelten Zeit, die der Ball den Untergrund berührt ({ $contact_time_s }), und { $count ->
    [one] ist
   *[other] sind
  } weggelassen. Sind lange Flüge darunter, ist es wohl ein anderer Ball, oder sein Kontakt ist kürzer.
diagnostic-few-impacts = { $count ->
    [2] 2 Aufpralle zeigen nur einen Flug und keine Stoßzahl
    [3] 3 Aufpralle zeigen eine einzige Stoßzahl und nicht, wie sie sich mit dem Tempo ändert
   *[other] { $count } Aufpralle zeigen nur wenige Stoßzahlen
  }; der Rest der Antwort ist, was man von Bällen überhaupt weiß.
diagnostic-flights-may-be-two = Nur { $count } Aufschläge: Blieb zwischen je zweien einer unerkannt, so behält der Ball { $restitution } seiner Geschwindigkeit, und er fiel aus { $height_m }. Die Zeiten passen zu beidem.
diagnostic-law-needs-impacts = Das Gesetz der Stoßzahl „{ $law }“ braucht { $needed } Aufpralle zwischen zwei Flügen, um von einer gleichbleibenden Stoßzahl zu unterscheiden zu sein, und hier gibt es { $seen ->
    [one] einen
   *[other] { $seen }
  }: Wie sich die Stoßzahl ändert, ist angenommen.
diagnostic-impacts-odd = { $count ->
    [one] Aufprall { $impacts } ist ein Ausreißer und zählt weniger: Der Ball ist vielleicht weggesprungen, traf eine Kante, oder der Laut ist etwas anderes.
   *[other] Die Aufpralle { $impacts } sind Ausreißer und zählen weniger: Der Ball ist vielleicht weggesprungen, traf eine Kante, oder die Laute sind etwas anderes.
  }
diagnostic-scatter-exceeds-prior = Die Stoßzahl streut von Aufprall zu Aufprall um etwa { $relative_sd } %, mehr als die angenommenen { $assumed_relative_sd } %: Die Intervalle können zu schmal sein.
diagnostic-height-contradicts-times = Die angegebene Höhe von { $measured_m } widerspricht den Aufprallen, aus denen ein Fall aus { $detected_m } folgt; sie wird nicht verwendet. Beides stimmte bei einer Fallbeschleunigung von { $gravity_m_s2 }. Falsche Höhe, falscher Ball oder falsche Abtastrate?
diagnostic-first-impact-doubtful = Der erste Aufprall, bei { $time_s } s, passt schlecht zu den anderen: Mit der Wahrscheinlichkeit { $probability } ist er ein anderes Geräusch oder gehört zu einem früheren Fall, und der Ball fiel aus { $height_m } Höhe.
diagnostic-release-contradicts-times = Das angegebene Loslassen, { $stated_s } s vor dem ersten Aufprall, widerspricht den Aufprallen, aus denen ein Fall von { $detected_s } s folgt; es wird nicht verwendet.
diagnostic-first-impacts-missed = Mit der Wahrscheinlichkeit { $probability } fehlen Aufpralle vor dem ersten erkannten.
diagnostic-other-ball-fits-better = Die Zeiten passen besser zu einer anderen Art von Ball als der angegebenen, mindestens { $odds } zu 1: { $balls }. Prüfen, welcher Ball es war.
diagnostic-never-rests = Nach einigen der möglichen Gesetze der Stoßzahl geht bei langsamen Aufprallen so wenig verloren, dass der Ball in keiner vernünftigen Zeit zur Ruhe käme.
diagnostic-inference-off = Eine Schätzung war nicht verlangt.
diagnostic-inference-needs-impacts = Eine Schätzung braucht einen Flug, und ein Flug braucht zwei Aufpralle.
diagnostic-restitution-undetermined = Das sind zu wenige Aufpralle: Mit { $count } davon kann die Stoßzahl zwischen { $least } und { $greatest } liegen. Nimm mindestens drei Aufpralle auf, oder miss die Fallhöhe und gib sie an.
diagnostic-contact-overlaps = Die Aufpralle { $first } und { $second }, bei { $time_s } s, liegen { $interval_s } auseinander, und der Ball berührt den Untergrund { $contact_time_s } lang. Einer davon ist wohl ein Echo oder ein anderer Laut: Lass ihn weg. Sonst berichtige den Ball oder seine Kontaktzeit.
diagnostic-no-model-fits = Kein physikalisches Modell erklärt diese Zeiten. Prüfe, ob sie in Sekunden und von einem Versuch sind, lass andere Laute weg, und prüfe den Ball.
diagnostic-sampling-not-converged = Die Zeiten bestimmen diesen Versuch nicht: Die Berechnung der Unsicherheiten ist nicht konvergiert. Lass Aufpralle weg, die nicht zu diesem Versuch gehören, prüfe den Ball, oder nimm mehr Aufpralle auf.
diagnostic-sampling-failed = Diese Zeiten lassen sich nicht als die eines Versuchs erklären. Lass andere Laute weg, oder werte jeden Versuch für sich aus.
diagnostic-missed-in-a-row = { $missed } Aufpralle in Folge fehlen nach Aufprall { $after }. Ergänze sie, oder lass die Aufpralle nach der Lücke weg.
diagnostic-flight-too-long = Der Flug nach Aufprall { $after } dauert { $duration_s }, was der Luftwiderstand bei diesem Ball unmöglich macht. Ergänze einen dort verpassten Aufprall, oder prüfe Masse, Durchmesser und die Einheit der Zeiten.
diagnostic-gains-speed = Der Ball gewänne bei jedem Aufprall an Tempo, was ruhender Untergrund nicht gibt; stehen die Zeiten der Reihe nach, in Sekunden, und sind sie von einem Versuch?
diagnostic-variances-confounded = Die Varianzen dieser Gruppen lassen sich nicht trennen.

diagnostic-out-of-range = { $quantity }: { $value }{ $unit ->
    [none] {""}
   *[other] {" "}{ $unit }
  }; erlaubt ist: { $range ->
    [above] endlich und über { $low }
    [at-least] endlich und mindestens { $low }
    [below] endlich und unter { $high }
    [at-most] endlich und höchstens { $high }
    [above-below] über { $low } und unter { $high }
    [above-at-most] über { $low } und höchstens { $high }
    [at-least-below] mindestens { $low } und unter { $high }
    [at-least-at-most] von { $low } bis { $high }
   *[finite] endlich
  }
diagnostic-unknown-name = { $kind } „{ $name }“ gibt es nicht; am nächsten kommt „{ $nearest }“ (bekannt: { $known }).
diagnostic-reynolds-too-high = Die Tabelle des Luftwiderstands endet bei der Reynolds-Zahl { $max_reynolds }, der Ball erreicht aber { $reynolds }; ergänze dort einen Wert oder wähle die Standardkurve.
diagnostic-ball-floats = Der Ball wiegt { $mass_kg } und verdrängt { $displaced_kg } Luft, er schwebt also; prüfe Masse und Durchmesser, oder lass den Auftrieb weg.
diagnostic-endless-drop = Der Ball steigt noch { $apex_m } nach { $bounces } Sprüngen; senke die Stoßzahl, höre bei größerer Höhe auf, oder begnüge dich mit { $bounces } Sprüngen.
diagnostic-too-few-flights = Eine Ausgleichsgerade durch die Logarithmen der Flugzeiten braucht mindestens 2 Flüge, hier { $flights ->
    [0] ist es keiner
    [one] ist es einer
   *[other] sind es { $flights }
  }; nimm eine Aufnahme mit mindestens 3 Aufprallen oder mehr Flüge.
diagnostic-too-few-drops = Das braucht mindestens { $needed } Versuche, hier { $drops ->
    [0] ist es keiner
    [one] ist es einer
   *[other] sind es { $drops }
  }.
diagnostic-no-band = Kein Band liegt mindestens zur Hälfte { $range } Hz; bei dieser Abtastrate sind die Bänder { $bands } Hz.
diagnostic-settings-contradict = { $first } und { $second } widersprechen einander; lass eines davon weg.
diagnostic-not-in-order = { $what } Nummer { $number } liegt nicht über der Nummer davor; nummeriere der Reihe nach, jede einmal.
diagnostic-no-channel = Einen Kanal { $channel } gibt es nicht: Die Aufnahme hat { $channels ->
    [one] nur einen
   *[other] { $channels }, der erste ist 1
  }.
diagnostic-too-many-drops = Es gibt { $drops } Versuche; nur die ersten { $most }, bis { $end_s } s, wurden ausgewertet. Schneide die Aufnahme dort, und werte den Rest für sich aus.
diagnostic-too-many-channels = { $channels } Kanäle sind mehr, als sich zusammen auswerten lassen: bei dieser Abtastrate höchstens { $most }; wähle einen davon.
diagnostic-each-of-reference = Ein Anteil an einer Referenz ist einer von Mittelwerten: Einzelne Versuche haben keinen.
diagnostic-implausible-quantity = { $quantity }: { $value } { $unit }?{ $meant_unit ->
    [none] {""}
   *[other] {" "}Sind { $meant } { $meant_unit } gemeint?
  }
diagnostic-implausible-ball = Ein Ball von { $mass_kg } und { $diameter_m } Durchmesser?{ $meant_g ->
    [none] { $meant_cm ->
        [none] { $meant_mm ->
            [none] {""}
           *[other] {" "}Sind { $meant_mm } mm gemeint?
          }
       *[other] {" "}Sind { $meant_cm } cm gemeint?
      }
   *[other] { $meant_mm ->
        [none] {" "}Sind { $meant_g } g gemeint?
       *[other] {" "}Sind { $meant_g } g und { $meant_mm } mm gemeint?
      }
  }

diagnostic-assumed-ball = Der Ball: { $ball }.
diagnostic-ball-not-stated = Der Ball wurde nicht angegeben: die Intervalle gelten für jede Art von Ball, die die Zeiten zulassen. Mit der Angabe werden sie enger.
diagnostic-assumed-contact-time = Der Ball berührt den Untergrund { $contact_time_s } lang.
diagnostic-assumed-rule-ball = Der Ball: { $ball }, wie in der Regel.
diagnostic-assumed-rule-height = Der tiefste Punkt des Balls fiel { $height_m } ± { $sd_m }, wie in der Regel.
diagnostic-assumed-air = Luft von { $temperature_k } °C, { $pressure_pa } hPa, { $relative_humidity } % Feuchte.
diagnostic-assumed-gravity = Fallbeschleunigung { $gravity_m_s2 }.

diagnostic-prior-restitution = Stoßzahl: alles von 0 bis 1.
diagnostic-prior-restitution-stated = Stoßzahl über der Aufprallgeschwindigkeit, wie angegeben: { $prior }.
diagnostic-prior-scatter = Streuung der Stoßzahl: etwa { $relative_sd } %, wahrscheinlich { $low_relative_sd } bis { $high_relative_sd } %.
diagnostic-prior-slow-losses = Aufpralle unter dem langsamsten erkannten: wie das Gesetz sagt, oder mit Verlusten, die bei kleinerem Tempo zusätzlich wachsen (mit einer Potenz von etwa { $exponent }).
diagnostic-prior-exact = { $input }: genau bekannt.
diagnostic-prior-unknown = { $input }: unbekannt (ein Faktor e nach oben oder unten).
diagnostic-prior-input = { $input }: auf { $relative_sd } % bekannt.
diagnostic-prior-height = Fallhöhe: gemessen, { $height_m } ± { $sd_m }.
diagnostic-prior-height-flat = Fallhöhe: beliebig (im Logarithmus gleich verteilt).
diagnostic-prior-release = Loslassen: gemessen, { $release_s } s ± { $sd_s }.
diagnostic-prior-missed = Jeder weitere Aufprall, der am Anfang fehlt: halb so wahrscheinlich; wo es still war, so gut wie unmöglich. In einer Liste von Zeiten zeigt nichts, ob Aufpralle fehlen.

diagnostic-rule-without-limits = Die Regel nennt keine Grenzen.
diagnostic-procedure-not-kept = Das Verfahren der Regel wurde nicht eingehalten: { $item }.
diagnostic-drop-without-first-flight = Der erste Flug von Versuch { $drop } wurde nicht erkannt: Die Regel verlangt den Rücksprung nach dem ersten Aufprall.
diagnostic-rule-secondary = Nicht der Text dieser Regel wurde gelesen, sondern einer, der sie anführt: Prüf die gültige Ausgabe, bevor du dich auf ein Urteil verlässt.
diagnostic-model-differs = Das Modell gibt einen anderen Wert als das Verfahren der Regel, um mehr als die Unsicherheiten beider; das Urteil folgt dem Verfahren.
diagnostic-drops-that-decide = { $drops } Versuche mit diesem Mittel und dieser Streuung würden entscheiden.
diagnostic-no-drops-decide = Mehr Versuche würden nicht entscheiden: Was allen gemeinsam ist, wie Fallhöhe und Kontaktzeit, ist zu unsicher.
diagnostic-rule-needs-height = Die Regel nennt keine Höhe, und niemand hat angegeben, aus welcher der Ball fiel.
diagnostic-limit-within-uncertainty = Eine Grenze liegt innerhalb der Unsicherheit; mehr oder bessere Versuche würden helfen.
diagnostic-rule-unverified = Diese Regel wurde aus dem Gedächtnis aufgeschrieben; verlass dich nicht auf sie.
diagnostic-formula-unverified = Der Text der Formel dieser Regel wurde nicht gelesen ({ $read }).
diagnostic-rule-other-ball = Die Regel gilt für einen Ball der Art { $ball }, und der angegebene ist nach Masse oder Durchmesser ein anderer: Ist es die richtige Regel?
diagnostic-rule-without-point = Wo am Ball diese Regel misst, ist nicht vermerkt; es gilt der tiefste Punkt.
diagnostic-verdict-of-few-drops = { $drops ->
    [one] Das Urteil beruht auf diesem einen Versuch: Wie sehr sich Versuche unterscheiden, zeigt er nicht; drei oder mehr würden es.
   *[other] Zwei Versuche zeigen kaum, wie sehr sich Versuche unterscheiden, was ihr Mittel unsicher macht; ein dritter hülfe viel.
  }
