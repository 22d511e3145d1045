page-app-title = bouncelab: Ball fallen lassen, Physik hören
page-app-skip = Zum Inhalt springen
page-app-nav = Seiten
page-app-lab = Zuhören
page-app-simulate = Simulieren
page-app-paper = Artikel
page-app-drops = Versuche
page-app-series = Tests
page-app-language = Sprache
page-app-to-dark = Dunkel
page-app-to-light = Hell
page-app-privacy = Nichts verlässt dieses Gerät: kein Konto, kein Server, läuft auch ohne Netz.
page-app-version = bouncelab { $version }
page-app-book = Anleitung und Dokumente
page-app-engine-failed = Das Labor konnte nicht starten.
page-app-engine-failed-hint = Der Browser hat den WebAssembly-Teil nicht geladen oder nicht ausgeführt. Lade die Seite neu; hilft das nicht, nimm einen aktuellen Firefox, Chrome, Edge oder Safari.
page-app-newer = Eine neuere Fassung dieser Seite liegt bereit.
page-app-reload = Neu laden
page-app-undo = Rückgängig
page-app-redo = Wiederholen
page-app-cancel = Abbrechen
page-app-number-wanted = Hier wird eine Zahl{ $most ->
    [none] { $least ->
        [none] {""}
       *[other] {" "}ab { $least }
      }
   *[other] {" "}von { $least } bis { $most }
  } erwartet.
page-app-drop-here = Loslassen, um die Datei zu öffnen
page-app-unreadable-link = Einiges an den Einstellungen in der Adresse war nicht zu verstehen und bleibt weg: { $parts }.

page-lab-invite = Lass einen Ball neben dem Mikrofon fallen.
page-lab-invite-touch = Lass einen Ball neben dem Handy fallen.
page-lab-lead = Die Zeiten zwischen den Aufprallen verraten, wie viel Tempo und Energie der Ball behält und aus welcher Höhe er fiel.
page-lab-listen = Zuhören
page-lab-stop = Stopp
page-lab-again = Noch einmal zuhören
page-lab-open = Datei öffnen
page-lab-rate = Abtastrate
page-lab-rate-open = Als Ton lesen
page-lab-paste = Zeiten einfügen
page-lab-demo = Beispiel ansehen
page-lab-open-label = Aufnahme oder Liste von Aufprallzeiten
page-lab-paste-label = Aufprallzeiten in Sekunden, eine je Zeile
page-lab-paste-hint = Aus einer Tabelle oder vom Oszilloskop. Zwischen den Aufprallen liegen die Flüge.
page-lab-paste-do = Auswerten
page-lab-pasted-name = eingefügte Zeiten
page-lab-demo-name = Beispiel
page-lab-recording-name = Versuch { $date }
page-lab-starting = Frage nach dem Mikrofon …
page-lab-listening = Ich höre zu. Lass den Ball fallen.
page-lab-hint-quiet = Noch war nichts Lautes zu hören: Lege das Mikrofon näher an die Stelle, wo der Ball aufkommt.
page-lab-hint-no-bounces = Es ist etwas zu hören, aber kein springender Ball: Lege das Handy näher an die Stelle, wo der Ball aufkommt, auf harten Boden, und lass ihn springen, bis er ruht.
page-lab-so-far = { $count ->
    [one] 1 Aufprall bisher
   *[other] { $count } Aufpralle bisher
  }
page-lab-so-far-keeps = er behält etwa { $share } seines Tempos
page-lab-ends-itself = Es endet von selbst, wenn der Ball ruht.
page-lab-saved = { $seconds } s sind gespeichert.
page-lab-result = Ergebnis
page-lab-opening = Lese { $name } …
page-lab-cannot-tell = Das sind zu wenige Aufpralle, um die Stoßzahl zu bestimmen.
page-lab-impacts = { $count ->
    [one] 1 Aufprall
   *[other] { $count } Aufpralle
  }
page-lab-uncertain = { $count } unsicher
page-lab-edited = von Hand geändert
page-lab-drop-of = Versuch { $index } von { $count }
page-lab-drops-heard = Versuche in dieser Aufnahme
page-lab-why = Mit und ohne Luft
page-lab-why-air-1 = Eine Ausgleichsgerade durch die Logarithmen der Flugzeiten ist der klassische Weg zur Stoßzahl. Doch auch die Luft bremst den Ball, und die Gerade schreibt das den Aufprallen zu.
page-lab-why-air-2 = Die grauen Punkte vernachlässigen die Luft; aus den blauen ist sie herausgerechnet. Sie zeigen Ball und Untergrund allein.
page-lab-refining = Rechne die Schätzung mit Luft …
page-lab-more = Alle Zahlen
page-lab-other-quantities = Weitere Größen
page-lab-tells = Was diese Aufnahme bestimmt, und was nicht
page-lab-narrowed-lead = Wie weit die Aufnahme die Unsicherheit verringert hat:
page-lab-narrowed = { $unknown }: es bleiben { $share } der Breite
page-lab-assumed = angenommen
page-lab-no-drop-title = Kein springender Ball gefunden.
page-lab-possible-drop = Vielleicht ein Versuch ab { $start } s: { $impacts } Aufpralle, Wahrscheinlichkeit { $probability }.
page-lab-accept = Es ist einer
page-lab-no-drop-hint = Stell das Mikrofon nah an die Stelle, wo der Ball aufkommt, nimm einen harten Untergrund und lass den Ball ausspringen. Siehst du die Aufpralle im Bild, dann markiere sie von Hand: Doppelklick, oder Eingabetaste am Zeiger.
page-lab-no-drop-hint-touch = Lege das Handy nah an die Stelle, wo der Ball aufkommt, auf harten Boden, und lass ihn springen, bis er ruht. Wenn du die Aufpralle in der Wellenform siehst, markiere sie mit zweimal Tippen.
page-lab-interrupted-title = Eine Aufnahme vom { $date } wurde unterbrochen.
page-lab-progress = Fortschritt
page-lab-processed = Das Gerät verändert den Ton, obwohl es das nicht soll: { $what }. Leise Aufpralle können fehlen. Ein anderer Browser oder ein äußeres Mikrofon hilft.
page-lab-processed-echoCancellation = Echounterdrückung
page-lab-processed-noiseSuppression = Rauschunterdrückung
page-lab-processed-autoGainControl = automatische Aussteuerung
page-lab-unkept-title = Die Aufnahme vom { $date } steht nicht in der Tabelle der Versuche.
page-lab-interrupted-hint = Sie ist aufgehoben, höchstens die letzte Sekunde oder zwei fehlen.
page-lab-interrupted-open = Öffnen
page-lab-interrupted-drop = Löschen

page-rest-title = Sprache und Vibration, wenn der Ball ruht
page-rest-speech = Ergebnis vorlesen
page-rest-vibration = Vibrieren
page-rest-plus-minus = plus oder minus

page-words-restitution = Die Stoßzahl ist die Geschwindigkeit gleich nach einem Aufprall geteilt durch die gleich davor: 90 % heißt, dass der Ball ein Zehntel seiner Geschwindigkeit verliert.
page-words-bounce-energies = Die Energie wächst mit dem Quadrat der Geschwindigkeit: Ein Ball, der 90 % seiner Geschwindigkeit behält, behält 81 % seiner Energie.
page-words-height = Die Fallhöhe wird aus den Zeiten zwischen den Aufprallen berechnet. Die Kurve zeigt, wie hoch der Ball nach jedem gestiegen ist.
page-words-uncertainty = ± ist die Standardunsicherheit: Mit etwa zwei Dritteln Wahrscheinlichkeit liegt der wahre Wert darin, mit 95 % im Doppelten davon.
page-words-flight-times = Ein Flug ist die Zeit von einem Aufprall zum nächsten. Ohne Luft und mit gleicher Stoßzahl bei jedem Tempo dauerte jeder denselben Bruchteil des vorigen.
page-words-bounce-heights = Wie hoch der Ball nach jedem Aufprall gestiegen ist, berechnet aus der Zeit bis zum nächsten.
page-words-comparison = Die Höhe des Balls, wie das Modell sie berechnet, und wie du sie simuliert hast: Wo sie abweichen, ist eines von beiden falsch.
page-words-posterior = Die A-posteriori-Verteilung ist, was man nach der Messung weiß: wie wahrscheinlich jeder Wert ist, nach den Zeiten der Aufpralle und dem, was vorher bekannt war.
page-words-residuals = Ein Residuum ist die gemessene Zeit eines Aufpralls minus die des Modells. Sie sollten ohne Muster streuen.
page-words-budget = Das Messunsicherheitsbudget nennt die Quellen der Unsicherheit und den Anteil einer jeden. Wer es genauer wissen will, beginnt bei der größten.
page-words-models = Ein Gesetz sagt, wie die Stoßzahl vom Tempo abhängt. Jedes wird danach gewichtet, wie gut es die Zeiten der Aufpralle vorhersagt.
page-words-truncation = Die Antwort aus den ersten zwei Flügen, aus drei, und so weiter. Sie sollte nicht von der Zahl der Flüge abhängen.
page-words-drag = Der Luftwiderstand ist die Kraft der Luft gegen die Bewegung. Er wächst etwa mit dem Quadrat des Tempos.
page-words-drag-log = Dasselbe auf Achsen, auf denen jeder Schritt ein Faktor ist: Eine Potenz des Tempos ist dort eine Gerade.

page-faults-refused-what = Der Browser darf das Mikrofon nicht benutzen.
page-faults-refused-do = Erlaube es in der Adressleiste (Schloss oder Mikrofon) und tippe noch einmal auf „Zuhören“. Auf dem Handy sieh auch in den Einstellungen der Browser-App nach. Du kannst stattdessen eine Aufnahme öffnen.

page-faults-missing-what = Kein Mikrofon gefunden.
page-faults-missing-do = Stecke eines an und tippe noch einmal auf „Zuhören“, oder nimm mit einem anderen Gerät auf und öffne die Datei hier.

page-faults-busy-what = Ein anderes Programm benutzt das Mikrofon.
page-faults-busy-do = Beende Anrufe und Aufnahmen und tippe noch einmal auf „Zuhören“.

page-faults-insecure-what = Browser geben das Mikrofon nur Seiten mit https oder von diesem Rechner selbst.
page-faults-insecure-do = Öffne die Seite über https oder localhost. Aufnahmen lassen sich auch so öffnen.

page-faults-unsupported-what = Dieser Browser gibt keinen unbearbeiteten Ton heraus.
page-faults-unsupported-do = Nimm einen aktuellen Firefox, Chrome, Edge oder Safari, oder öffne eine Aufnahme.

page-faults-ended-what = Das Mikrofon ist weg: ausgesteckt, oder ein Anruf braucht es.
page-faults-ended-do = Der bis dahin aufgenommene Ton ist aufgehoben und ausgewertet.

page-faults-unknown-what = Das Mikrofon ließ sich nicht öffnen.
page-faults-unknown-do = Stecke es neu an oder starte den Browser neu. Du kannst stattdessen eine Aufnahme öffnen.

page-faults-silent-what = Vom Mikrofon kommt nur Stille.
page-faults-silent-do = Vielleicht ist es am Schalter oder in den Systemeinstellungen stumm.

page-faults-full-what = Der Speicher des Browsers ist voll.
page-faults-full-do = Der Ton ist vollständig im Arbeitsspeicher: Speichere ihn jetzt als WAV. Lösche danach Versuche, die du nicht brauchst.

page-faults-unavailable-what = Der Browser hebt hier nichts auf (ein privates Fenster?).
page-faults-unavailable-do = Der Ton ist vollständig im Arbeitsspeicher, bis diese Seite geschlossen wird: Speichere ihn als WAV.

page-faults-empty-what = Die Datei ist leer.
page-faults-empty-do = Es wurde nichts hineingeschrieben. Endete die Aufnahme, bevor sie begann? Nimm neu auf oder wähle eine andere Datei.

page-faults-unsupported-file-what = Das ist weder eine Aufnahme noch eine Liste von Zeiten.
page-faults-unsupported-file-do = Ton: { $formats }. Listen: eine Zeit in Sekunden je Zeile.

page-faults-damaged-what = Die Datei ist beschädigt.
page-faults-damaged-do = Kopiere oder lade sie neu. Eine Datei, an der das Handy noch schreibt, ist noch nicht lesbar.

page-faults-times-what = Das können keine Aufprallzeiten sein.
page-faults-times-do = Eine Zeit in Sekunden je Zeile, aufsteigend; Komma oder Punkt für Nachkommastellen.
page-faults-rate-what = In der Tabelle steht nicht, wann die Werte aufgenommen wurden.
page-faults-rate-do = Gib die Abtastrate an: wie viele Werte das Gerät in der Sekunde aufnahm, oft 44100 oder 48000.

page-faults-huge-what = Die Datei ist zu groß für einen Browser.
page-faults-huge-do = Bis zwei Stunden Ton in zwei Kanälen oder vier in einem. Schneide sie auf die Minuten mit dem Ball, oder nimm die Kommandozeile: bouncelab analyze.

page-faults-setting-what = Eine Einstellung widerspricht den anderen.
page-faults-setting-do = Siehe unten bei den Einstellungen.

page-faults-fault-what = Die Auswertung ist fehlgeschlagen.
page-faults-fault-do = Was aufgenommen wurde, ist aufgehoben. Lade die Seite neu und öffne es wieder; eine Meldung an das Projekt hilft.

page-faults-link-what = Dieser Link eines Versuchs ist nicht zu gebrauchen.
page-faults-link-do = Kopiere den ganzen Link, oder lies den Code noch einmal ein.

page-faults-no-drop-what = Darin ist kein springender Ball zu finden.
page-faults-no-drop-do = Öffne sie im Labor: Dort kannst du sie anhören und Aufpralle markieren.

page-faults-series-full-what = Der Speicher des Browsers ist voll: Dieser Versuch zählt noch nicht.
page-faults-series-full-do = Was vorher gespeichert wurde, ist unverändert da. Speichere diesen Ton als Datei, lösche Versuche oder Reihen, die du nicht brauchst, und versuche es noch einmal.

page-faults-series-known-what = Diese Aufnahme zählt schon.
page-faults-series-known-do = Jede Aufnahme zählt einmal. Wähle die eines anderen Versuchs.

page-faults-series-storage-what = Der Browser konnte es nicht speichern.
page-faults-series-storage-do = Was vorher gespeichert wurde, ist unverändert da. Ein privates Fenster speichert nichts: Nimm ein gewöhnliches.

page-faults-archive-what = Das ist keine vollständige Datei aufgehobener Versuche.
page-faults-archive-do = Kopiere oder lade sie noch einmal und füge diese hinzu. Was hier aufgehoben ist, ist unverändert.

page-faults-bad-drop-what = Diesen Versuch kann diese Seite nicht aufgehoben haben.
page-faults-bad-drop-do = Bitte um seine Aufnahme oder seinen Link. Die anderen Versuche der Datei sind hinzugefügt.

page-faults-archive-newer-what = Eine neuere Fassung dieser Seite hat diese Datei gespeichert.
page-faults-archive-newer-do = Lade die Seite neu und füge die Datei noch einmal hinzu. Was hier aufgehoben ist, ist unverändert.

page-faults-archive-storage-what = Nicht alles aus der Datei ließ sich aufheben.
page-faults-archive-storage-do = Der Speicher des Browsers ist voll oder nicht verfügbar. Lösche Versuche, die du nicht brauchst, und füge die Datei noch einmal hinzu; was schon aufgehoben war, ist unverändert.

page-faults-keep-what = Der Versuch ließ sich nicht aufheben.
page-faults-keep-do = Der Speicher des Browsers ist voll oder gesperrt. Speichere stattdessen Ton und Zahlen als Dateien.

page-wave-title = Wellenform
page-wave-label = Wellenform, Ort des Zeigers
page-wave-seconds = { $value } Sekunden
page-wave-impact-at = Aufprall { $number }, { $seconds }{ $certain ->
    [yes] {""}
   *[no] , unsicher
  }
page-wave-add = Aufprall setzen
page-wave-remove = Entfernen
page-wave-snap = Am Ton einrasten
page-wave-zoom-in = Näher
page-wave-zoom-out = Weiter
page-wave-all = Alles
page-wave-amplitude = Höhe der Wellenform
page-wave-amplitude-whole = Höhe: Aufnahme
page-wave-amplitude-view = Höhe: Ausschnitt
page-wave-amplitude-decibels = Höhe: Dezibel
page-wave-play = Abspielen
page-wave-stop = Stopp
page-wave-speed = Tempo
page-wave-slower = { $speed } ×
page-wave-spectrogram = Spektrogramm
page-wave-spectrogram-label = Spektrogramm: Zeit nach rechts, Tonhöhe nach oben, lauter ist dunkler
page-wave-overview = Die ganze Aufnahme; ziehen verschiebt
page-wave-restore = Wie erkannt
page-wave-list = Liste der Aufpralle
page-wave-number = Nr.
page-wave-time = Zeit
page-wave-flight = Flug danach
page-wave-probability = Wahrscheinlichkeit
page-wave-level = Pegel
page-wave-restitution = Stoßzahl
page-wave-actions = Ändern
page-wave-remove-one = Aufprall { $number } entfernen
page-wave-select = Aufprall { $number } zeigen
page-wave-added = Aufprall bei { $seconds } s gesetzt.
page-wave-removed = Aufprall { $number } entfernt.
page-wave-moved = Aufprall { $number } auf { $seconds } s verschoben.
page-wave-undone = Rückgängig gemacht.
page-wave-redone = Wiederholt.
page-wave-keys = Pfeiltasten bewegen den Zeiger, mit Umschalttaste fein; Bild auf und Bild ab gehen von Aufprall zu Aufprall; Plus und Minus vergrößern und verkleinern, 0 zeigt alles; Eingabe setzt einen Aufprall, Entf entfernt den gewählten, Komma und Punkt schieben ihn, S rastet ihn am Ton ein; Leertaste spielt ab; Strg+Z macht rückgängig.
page-wave-pointer = Ziehen verschiebt, Spreizen oder Mausrad vergrößert (vorher anklicken), Tippen wählt einen Aufprall, Ziehen bewegt ihn, Doppeltippen setzt einen neuen.
page-wave-times = Das sind nur Zeiten: Es gibt keinen Ton zu zeigen.

page-figures-title = Abbildungen
page-figures-more = Mehr Abbildungen
page-figures-fewer = Weniger Abbildungen
page-curve-label = Höhe des Balls über der Zeit; der erste erkannte Sprung erreicht { $height }
page-figures-against = { $y } über { $x }
page-figures-reset = Seitwärts ziehen vergrößert, ein Doppelklick zeigt wieder alles.
page-figures-numbers = Dasselbe als Zahlen
page-figures-save-svg = SVG
page-figures-save-png = PNG
page-figures-save-csv = CSV
page-figures-save = Diese Abbildung speichern

page-settings-ball = Ball
page-settings-air = Luft
page-settings-gravity = g
page-settings-change = ändern
page-settings-title = Bekannte Größen
page-settings-assumed-hint = Luft und Schwerkraft sind ohne Angabe angenommen. Ohne Angabe des Balls zählt jede Art von Ball, die die Zeiten zulassen, und die Intervalle sind weiter.
page-settings-own = eigener Ball
page-settings-mass = Masse
page-settings-diameter = Durchmesser
page-settings-contact = Kontaktzeit
page-settings-temperature = Temperatur
page-settings-pressure = Druck
page-settings-humidity = Feuchte
page-settings-vacuum = Vakuum
page-settings-no-drag = ohne Luft
page-settings-gravity-field = Fallbeschleunigung
page-settings-measure-g = g messen: dazu die Fallhöhe angeben
page-settings-latitude = Geografische Breite
page-settings-altitude = Höhe über dem Meer
page-settings-drag-law = Luftwiderstand
page-settings-drag-none = keiner, als gäbe es keine Luft
page-settings-drag-standard = Standardkurve einer Kugel
page-settings-drag-table = eigene Tabelle von C_D
page-settings-restitution-law = Stoßzahl
page-settings-restitution-any = jedes Gesetz, das passt
page-settings-measured = Der Versuch, falls gemessen
page-settings-height = Fallhöhe
page-settings-height-sd = ± der Höhe
page-settings-flights = Flüge der Ausgleichsgeraden
page-settings-flights-from = von
page-settings-flights-to = bis
page-settings-reset = Alle Einstellungen vergessen
page-settings-refused = Diese Einstellungen widersprechen sich:

page-ball-row = Welcher Ball?
page-ball-other = anderer: Größe und Gewicht

page-setup-named = { $name }: { $value }
page-setup-offered = Dieser Link gibt an: { $what }. Für deine eigenen Versuche gilt das nur, wenn du es willst.
page-setup-laws = andere Modelle der Auswertung
page-setup-take = für meine Versuche verwenden
page-setup-leave = nicht verwenden
page-setup-unusual = Ausgewertet mit: { $what }.
page-setup-reset = Zurücksetzen

page-keep-title = Aufheben
page-keep-keep = Diesen Versuch aufheben
page-keep-long-sound = Der Ton dauert länger als eine halbe Stunde: Nur der Versuch wird behalten, die Datei nicht.
page-keep-kept = Aufgehoben als „{ $name }“.
page-keep-name = Name
page-keep-name-hint = zum Beispiel: Anna, erster Versuch
page-keep-see-all = Tabelle der Versuche
page-keep-lasting = Der Browser hebt auf, was hier ist, bis du es löschst.
page-keep-not-lasting = Wird der Platz knapp, darf der Browser löschen, was hier aufgehoben ist: Speichere eine Kopie als Datei.
page-keep-for-a-week = Dieser Browser löscht, was eine Seite aufhebt, nach sieben Tagen ohne Besuch, wenn die Seite nicht auf dem Startbildschirm liegt (Teilen, „Zum Home-Bildschirm“): Sichere eine Kopie als Datei.
page-keep-commas = Tabellen mit Semikolon und Dezimalkomma
page-keep-wav = Ton (WAV)
page-keep-csv = Tabelle (CSV)
page-keep-json = Alle Daten (JSON)
page-keep-share = Einstellungen teilen
page-keep-shared = Die Adresse mit diesen Einstellungen ist kopiert.
page-keep-share-by-hand = Diese Adresse kopieren:
page-keep-report = Bericht (HTML)
page-keep-link = Diesen Versuch teilen
page-keep-link-qr = QR-Code der Adresse dieses Versuchs

page-simulate-title = Einen Versuch simulieren
page-simulate-lead = Schieb einen Regler und sieh, was sich ändert; behalte einen Lauf, um ihn mit dem nächsten zu vergleichen.
page-simulate-height = Fallhöhe
page-simulate-restitution = Stoßzahl (bei 1 m/s)
page-simulate-slope = Abnahme der Stoßzahl mit dem Tempo
page-simulate-slope-hint = 0: bei jedem Tempo gleich
page-simulate-law = Stoßzahlgesetz
page-simulate-law-of-sliders = konstant oder fallend, nach den Reglern
page-simulate-law-numbers = Gesetz mit seinen Zahlen
page-simulate-ball = Ball
page-simulate-drag = Luftwiderstand
page-simulate-pressure = Luftdruck
page-simulate-body = Wo

page-simulate-bodies-earth = Erde
page-simulate-bodies-moon = Mond
page-simulate-bodies-mars = Mars
page-simulate-bodies-venus = Venus
page-simulate-bodies-titan = Titan
page-simulate-bodies-jupiter = Jupiter
page-simulate-keep-run = Diesen Lauf behalten
page-simulate-hear = Ton abspielen
page-simulate-stop = Stopp
page-simulate-lay = Über die Messung legen
page-simulate-take-off = Nicht mehr über die Messung legen
page-simulate-laid = Er liegt jetzt über der Messung, in der Abbildung „Vergleich“.
page-simulate-analyse = Seinen Ton auswerten
page-simulate-runs = Läufe
page-simulate-this-run = dieser Lauf
page-simulate-run = Lauf { $index }
page-simulate-remove = { $name } entfernen
page-simulate-says = Er springt { $bounces } Mal in { $time } und legt { $path } zurück.
page-simulate-terminal = Seine Endgeschwindigkeit ist hier { $speed }.
page-simulate-no-terminal = Ohne Luft gibt es keine Endgeschwindigkeit.
page-simulate-losses = Von seiner Energie gehen { $surface } in die Aufpralle, { $air } in die Luft.
page-simulate-impossible = Das lässt sich nicht simulieren:
page-simulate-address = Die Regler stehen in der Adresse: Teile sie, und andere sehen denselben Lauf.

page-paper-title = Der Artikel
page-paper-source = M. Nagurka, „Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment“
page-paper-lead = Lass einen Tischtennisball fallen und hör zu. Die Zeiten zwischen den Aufprallen ergeben Stoßzahl und Fallhöhe, doch die Höhe gerät um 12 % zu klein. Diese Seite erklärt, warum, und berechnet jede Zahl und jede Abbildung beim Lesen.

page-paper-one-title = 1. Von Zeiten zu Höhen
page-paper-one-text-1 = Zwischen zwei Aufprallen steigt und fällt der Ball eine Zeit T lang. Ohne Luft flog er mit dem Tempo gT/2 los und stieg auf gT²/8. Mehr als eine Uhr braucht man nicht.
page-paper-one-text-2 = Behält jeder Aufprall den Anteil e des Tempos, so dauert jeder Flug e-mal so lang wie der vorige. Auf logarithmischer Skala liegen die Flugzeiten auf einer Geraden: Ihre Steigung ist log e, und ihr Achsenabschnitt ergibt die Fallhöhe.
page-paper-one-equation = log Tₙ = n log e + log (2v₀/g),   h₀ = v₀²/2g
page-paper-one-see = Die Flugzeiten eines Balls aus 30,5 cm, ohne Luft. Jeder Punkt auf der Geraden; sie findet e und 30,5 cm genau.

page-paper-two-title = 2. Der Versuch und eine Abweichung
page-paper-two-text-1 = Im Artikel fiel ein Ball von 2,5 g und 38 mm aus 30,5 cm. Die Ausgleichsgerade durch die ersten zehn Flüge ergab e = 0,9375 und eine Fallhöhe von 26,7 cm.
page-paper-two-text-2 = Das sind 3,8 cm zu wenig, 12,3 %: weit mehr, als ein Maßband irrt. Der Artikel nennt den Luftwiderstand als wahrscheinlichen Grund.

page-paper-three-title = 3. Wie stark die Luft bremst
page-paper-three-text = Bei den 2,4 m/s des ersten Aufpralls ist der Luftwiderstand nur 6 % des Gewichts, und er schwindet mit dem Quadrat des Tempos. Der Artikel erprobt zwei Gesetze: einen gleichbleibenden Beiwert von 0,4 und einen, der vom Tempo abhängt. Wo es darauf ankommt, stimmen sie überein.
page-paper-three-equation = F/W = ½ ρ A C_D v² / mg
page-paper-three-see = Luftwiderstand durch Gewicht über dem Tempo, nach beiden Gesetzen. Auf der log. Skala gibt ein gleichbleibender Beiwert eine Gerade der Steigung 2.
page-paper-three-see-height = Der ganze Fall mit e = 0,935, mit Luft und ohne: sechs Prozent des Gewichts, und der Ball ruht Sekunden früher.

page-paper-four-title = 4. Erklärt der Luftwiderstand die Abweichung?
page-paper-four-text = Simuliere Bälle in Luft, lege dieselbe Ausgleichsgerade hindurch und vergleiche mit dem Artikel. Wähle die Stoßzahl des Balls und die Zahl der Flüge.
page-paper-four-e = Wahre Stoßzahl des Balls, bei 1 m/s
page-paper-four-slope = Abnahme der Stoßzahl mit dem Tempo
page-paper-four-flights = Flüge in der Geraden
page-paper-four-line-says = Die Gerade ergibt e = { $e } und h₀ = { $h }.
page-paper-four-paper-says = Die Gerade des Artikels ergibt e = 0,9375 und h₀ = 26,7 cm.
page-paper-four-truth = Wahre Fallhöhe: 30,5 cm.
page-paper-four-hit = Das ist das Ergebnis des Artikels, auf die letzte Stelle.
page-paper-four-solve-drag = e gleich, zehn Flüge
page-paper-four-solve-many = e gleich, 21 Flüge
page-paper-four-solve-slope = e fällt mit dem Tempo, zehn Flüge
page-paper-four-see = Fallhöhe nach der Ausgleichsgeraden über der Zahl ihrer Flüge. Grau: Ohne Luft bleibt sie gleich, solange die Stoßzahl konstant ist. Orangerot: Mit Luft sinkt sie mit jedem Flug. Blau: das Ergebnis des Artikels.

page-paper-five-title = 5. Die Erklärung
page-paper-five-text-1 = Luftwiderstand mit gleichbleibender Stoßzahl erklärt etwa die Hälfte der Lücke: Ein Ball mit e = 0,953 gäbe die 0,9375 des Artikels, aber 28,8 cm.
page-paper-five-text-2 = Für den Rest gibt es zwei Erklärungen: Die Stoßzahl fällt etwas mit dem Tempo, wie bei echten Bällen, oder es gingen mehr als zehn Flüge in die Gerade ein. Die Ausgleichsgerade kann beides nicht unterscheiden, denn ihr Ergebnis hängt von der Zahl der Flüge ab.
page-paper-five-text-3 = Darum schätzt das Labor auf dieser Seite Fallhöhe, Luftwiderstand und Stoßzahl gemeinsam aus den Aufprallzeiten, mit ihren Unsicherheiten.
page-paper-five-law = Stoßzahl
page-paper-five-drag = Luft
page-paper-five-flights = Flüge
page-paper-five-first = e bei 2,4 m/s
page-paper-five-slow = e bei 0,5 m/s
page-paper-five-height = h₀ der Geraden
page-paper-five-same = Die 26,7 cm des Artikels?
page-paper-five-yes = ja
page-paper-five-no = nein
page-paper-five-caption = Modelle, für die die Ausgleichsgerade e = 0,9375 ergibt; Knicke liegen bei 1,5 m/s

page-paper-six-title = 6. Alle Zahlen des Artikels
page-paper-six-lead = Wie gedruckt und wie hier berechnet. Druckfehler der Gleichungen sind berichtigt.
page-paper-six-quantity = Größe
page-paper-six-printed = Gedruckt
page-paper-six-computed = Berechnet
page-paper-six-verdict = Urteil

page-paper-verdicts-agrees = stimmt
page-paper-verdicts-agrees-when-corrected = stimmt, berichtigt
page-paper-verdicts-agrees-within-reading = stimmt, soweit ablesbar
page-paper-verdicts-misprint = Druckfehler
page-paper-verdicts-differs = weicht ab
page-paper-verdicts- = {""}

page-paper-air-names-none = keine Luft
page-paper-air-names-constant = C_D = 0,4
page-paper-air-names-sphere = C_D(Re)
page-paper-air-names-all-of-air = C_D(Re), Auftrieb, mitbewegte Luft

page-paper-try-it = Jetzt selbst einen Ball fallen lassen

page-drops-title = Tabelle der Versuche
page-drops-empty = Noch ist kein Versuch aufgehoben. Nach einem Versuch legt „Diesen Versuch aufheben“ ihn hier ab, nur in diesem Browser.
page-drops-to-lab = Zum Labor
page-drops-name = Name
page-drops-when = Wann
page-drops-ball = Ball
page-drops-e = Stoßzahl e
page-drops-h = Fallhöhe
page-drops-impacts = Aufpralle
page-drops-actions = Ändern
page-drops-open = Öffnen
page-drops-open-one = { $name } öffnen
page-drops-delete = Löschen
page-drops-delete-one = { $name } löschen
page-drops-deleted = „{ $name }“ ist gelöscht.
page-drops-choose = { $name } vergleichen
page-drops-compare = Vergleich
page-drops-rename = Name von { $name }
page-drops-mean = Mittel
page-drops-scatter = Streuung (Standardabweichung)
page-drops-of-drops = { $count ->
    [one] von 1 Versuch
   *[other] von { $count } Versuchen
  }
page-drops-scatter-sentence = Im Mittel behielt der Ball { $mean } seines Tempos. Von Versuch zu Versuch streute das um { $scatter }; jeder einzelne Versuch gibt ± { $inside } an.
page-drops-csv = Tabelle speichern (CSV)
page-drops-json = Alles speichern (JSON)
page-drops-archive = Alles mit Ton speichern (ZIP)
page-drops-archiving = Die Töne werden gesammelt …
page-drops-adding = Lese { $name } …
page-drops-added = { $count ->
    [0] Nichts darin ist neu.
    [one] 1 Versuch ist hinzugefügt.
   *[other] { $count } Versuche sind hinzugefügt.
  }
page-drops-delete-all = Alle löschen
page-drops-deleted-all = { $count ->
    [one] 1 Versuch ist gelöscht.
   *[other] { $count } Versuche sind gelöscht.
  }
page-drops-links = Links zu Versuchen anderer, beliebig viele
page-drops-links-do = In diese Tabelle aufnehmen
page-drops-unavailable = Der Browser hebt hier nichts auf (ein privates Fenster?).

page-class-ball = Ball
page-class-surface = Untergrund
page-class-student = Schüler
page-class-ball-of = Ball von { $name }
page-class-surface-of = Untergrund von { $name }
page-class-student-of = Schülerin oder Schüler: { $name }
page-class-add = Versuche hinzufügen
page-class-add-hint = Dateien jeder Art, die diese Seite speichert oder öffnet, beliebig viele, auch als ZIP; und Links. Was beschädigt ist, wird genannt, der Rest hinzugefügt.
page-class-files = Dateien wählen
page-class-files-label = Dateien mit Versuchen
page-class-known = { $count ->
    [one] 1 steht schon in der Tabelle.
   *[other] { $count } stehen schon in der Tabelle.
  }
page-class-groups = Gruppen
page-class-details = Einzelheiten
page-class-by = Gruppen nach
page-class-report = Bericht speichern (HTML)
page-class-sheets = Arbeitsblätter
page-class-sheet-bounciness = Wie gut springt ein Ball?
page-class-sheet-air = Wie viel nimmt die Luft?
page-class-sheet-gravity = Miss g mit einem Ball
page-class-sheet-html = zum Drucken
page-class-sheet-markdown = als Text zum Ändern
page-class-sheets-hint = Auf den Blättern steht die Adresse der Stunde von oben, oder die dieser Seite, solange kein Ball gewählt ist.

page-verdict-title = Nach einer Regel beurteilen
page-verdict-rule = Regel
page-verdict-reference = Vergleichsuntergrund
page-verdict-kept = Eingehalten, nach deiner Angabe:
page-verdict-ball = Die Regel nennt keinen Ball: Wähle ihn zuerst.
page-verdict-unlike = Diese Versuche haben verschiedene Bälle oder andere Einstellungen. Wähle die mit einem Ball aus.
page-verdict-report = Urteil speichern (HTML)

page-lesson-title = Was du fallen lässt
page-lesson-name = Dein Name
page-lesson-leave = Stunde verlassen
page-lesson-who = Schreibe unten deinen Namen, dann gib den Versuch ab.
page-lesson-make = Klasse: ein Link für alle
page-lesson-make-hint = Wähle, was in der Stunde fällt. Die Seite fragt die Klasse dann nach Name, Ball, Untergrund und Höhe, sonst nach nichts.
page-lesson-balls = Bälle
page-lesson-surfaces = Untergründe, mit Komma getrennt
page-lesson-heights = Fallhöhen in cm, mit Semikolon getrennt; keine, wenn sie gemessen werden sollen
page-lesson-qr = QR-Code der Stunde
page-hand-in = Abgeben
page-hand-share = Teilen …
page-hand-copy = Link kopieren
page-hand-copied = Kopiert.
page-scan = QR-Codes scannen
page-scan-stop = Scannen beenden
page-scan-refused = Die Kamera kann nicht benutzt werden. Erlaube sie in der Adressleiste, oder lass dir die Links schicken.
page-class-all-balls = Ball der { $count } gewählten
page-class-all-surfaces = Untergrund der { $count } gewählten

page-reason-counted = Es ist die Aufnahme { $number } dieser Reihe.
page-reason-empty-content = Es sind keine Daten darin.
page-reason-empty-sound = Sie hat einen Kopf, aber keinen Ton.
page-reason-empty-time = Es steht keine Zeit darin.
page-reason-not-sound = Sie sieht aus wie { $kind }.
page-looks-png = ein PNG-Bild
page-looks-jpeg = ein JPEG-Bild
page-looks-gif = ein GIF-Bild
page-looks-pdf = ein PDF-Dokument
page-looks-zip = ein ZIP-Archiv oder ein Office-Dokument
page-looks-gzip = ein gzip-Archiv
page-looks-riff = eine RIFF-Datei ohne Ton, etwa AVI oder WebP
page-looks-zeros = lauter Nullen
page-looks-text = Text
page-looks-unknown = Daten unbekannter Art
page-reason-malformed = { $stage ->
    [header] Ihr Kopf ist nicht lesbar
    [codec] Ihr Decoder lässt sich nicht einrichten
   *[sound] Nichts von ihrem Ton lässt sich decodieren
  } ({ $format }: { $detail }).
page-reason-no-audio-track = Diese Datei ({ $format }) hat keinen Ton, oder keinen bekannter Art. War das Mikrofon aus?
page-reason-unsupported-codec = Der Ton dieser Datei ({ $format }) lässt sich nicht decodieren: { $codec }. Speichere sie als WAV oder M4A.
page-reason-layout-too-slow = { $sample_rate_hz } Abtastwerte je Sekunde sind zu wenige für die Zeit eines Aufpralls: Es braucht mindestens { $min_hz }.
page-reason-layout-too-fast = Ihr Kopf behauptet { $sample_rate_hz } Abtastwerte je Sekunde; gelesen werden höchstens { $max_hz }.
page-reason-layout-too-many-channels = Sie hat { $channels } Kanäle; gelesen werden höchstens { $max }.
page-reason-lasts-too-long = Sie dauert länger als { $max_h } Stunden; mehr wird nicht gelesen. Schneide sie in Teile.
page-reason-times-line = Zeile { $line }: { $problem }
page-reason-times-ending = Der Name einer Liste endet auf .txt, .csv, .tsv, .xls, .xlsx, .ods, .zip, .json, .TextGrid oder .svl.
page-reason-times-not-text = Das ist kein Text. Speichere die Liste als Text, CSV oder Tabellenblatt.
page-reason-times-not-table = Das ist keine Tabelle ({ $detail }).
page-reason-times-not-file = Das ist ein Gerät oder eine Pipe; speichere die Liste in einer Datei.
page-reason-times-too-long = Das sind über { $max_mb } MB Text; speichere den Ton als WAV.
page-reason-times-not-sample = „{ $text }“ ist keine Zahl; unter ihren Überschriften hat eine abgetastete Wellenform nur Zahlen.
page-reason-times-fewer-columns = { $found } von { $columns } Zahlen: Eine abgetastete Wellenform hat in jeder Zeile eine für die Zeit und eine für jeden Kanal.
page-reason-times-uneven = Sie kommt { $interval_s } s nach der Zeile davor, im Mittel liegen aber { $mean_s } s dazwischen; die Zeiten einer abgetasteten Wellenform haben gleiche Abstände.
page-reason-times-sampled = Das ist eine Tabelle mit { $rows } Abtastwerten, { $rate_hz } in der Sekunde, und keine Liste von Aufprallzeiten; Ton braucht mindestens { $min_hz } in der Sekunde. Nenne die Zeiten der Aufpralle.
page-reason-times-positions = Das sind Orte über der Zeit ({ $found }) und keine Aufprallzeiten. Öffne die Aufnahme oder nenne die Zeiten der Aufpralle.
page-reason-times-several-drops = Es gibt mehrere Spalten mit Zeiten ({ $found }) und { $rows } Zeilen. Eine Liste hat einen Versuch: eine Spalte mit Zeiten oder eine Zeile mit Stopps.
page-reason-times-no-rate = { $rows } Abtastwerte ohne Zeiten, keine Liste von Aufprallzeiten: Speichere den Ton als WAV, füge eine Spalte mit Zeiten hinzu, oder öffne sie im Labor und gib ihre Abtastrate an.
page-reason-times-no-order = { $number } folgt auf { $before }. Zahlen ohne Überschrift sind Aufprallzeiten, die steigen, oder Abstände, die fallen. Schreibe time_s oder interval_s darüber; Abtastwerte brauchen eine Spalte mit Zeiten.
page-reason-times-not-interval = { $text } ist kein Abstand von einem Aufprall zum nächsten; er ist größer als 0 s.
page-reason-times-not-layer = Das ist keine Ebene von Sonic Visualiser mit Punkten. Exportiere sie noch einmal (File > Export Annotation Layer).
page-reason-times-no-list = Keine der Tabellen ist eine Liste von Aufprallzeiten: { $found }. Öffne eine Aufnahme für sich, die Aufnahmen einer Klasse als Dateien oder Ordner.
page-reason-times-tables-disagree = Die Tabellen { $first } und { $second } haben verschiedene Zeiten. Behalte eine davon.
page-reason-times-of-recordings = Das ist eine Tabelle über Aufnahmen und keine Liste von Aufprallzeiten. Öffne die Aufnahmen.
page-reason-times-not-array = Erwartet war eine Liste von Zahlen wie [0.1, 0.45] ({ $detail }).
page-reason-times-not-text-grid = Das ist kein TextGrid von Praat oder nicht das ganze. Speichere es in Praat noch einmal.
page-reason-times-no-point-tier = Keine Spur hat Punkte, nur Intervalle: { $found }. Füge in Praat eine Spur mit einem Punkt bei jedem Aufprall hinzu (Tier > Add point tier…).
page-reason-times-which-point-tier = Mehrere Spuren haben Punkte: { $found }. Nenne die der Aufpralle in Praat „impacts“.
page-reason-times-no-time-column = Keine Überschrift hat ein Wort für Zeit oder Aufprall mit Einheit, wie time_s, Zeit (s) oder interval_s. Es gibt: { $found }.
page-reason-times-nameless-columns = Es sind { $columns } Spalten. Benenne die mit den Zeiten in einer ersten Zeile: time_s.
page-reason-times-more-columns = Sie hat { $found } Spalten, die erste Zeile aber { $columns }. Wo das Komma zur Zahl gehört, trennt ein Strichpunkt die Spalten.
page-reason-times-missing = Die Zeit fehlt.
page-reason-times-not-number = „{ $text }“ ist keine Zeit in Sekunden wie 0.125.
page-reason-times-not-later = { $time_s } kommt nicht nach { $before_s }. Die Aufpralle gehören der Reihe nach.
page-reason-too-long = Sie hat mehr als { $minutes } Minuten in { $channels ->
    [one] 1 Kanal
   *[other] { $channels } Kanälen
  }.
page-reason-no-memory = Dieses Gerät hat nicht genug Speicher dafür.
page-reason-breaks-decoder = Sie ist beschädigt, und ihr Decoder scheitert daran.
page-reason-unreadable = Der Browser kann sie nicht lesen. Wurde sie verschoben oder gelöscht?
page-reason-link-changed = Er wurde verändert oder ist unvollständig.
page-reason-link-other-version = Eine andere Version dieser Seite hat ihn gemacht; lade die Seite neu.
page-reason-link-times = Ein Link fasst 2 bis 1000 Aufpralle.
page-reason-link-too-long = Der Versuch hat zu viele Aufpralle für einen QR-Code.

page-series-title = Prüfreihe
page-series-lead = Eine Prüfung nach einer Regel, Versuch für Versuch und Stelle für Stelle, mit dem Bericht eines Labors.
page-series-known = In diesem Browser gespeichert
page-series-open = Mit { $name } weitermachen
page-series-delete = Löschen
page-series-delete-hint = Ihre Aufnahmen gehen mit verloren. Speichere die Reihe vorher als ZIP, wenn du sie brauchst.
page-series-delete-really = { $name } mit den Aufnahmen löschen
page-series-new = Eine neue Reihe
page-series-name = Name, etwa des Bodens oder des Balls
page-series-ball = Ball
page-series-places = Stellen
page-series-drops = Versuche je Stelle
page-series-as-the-rule = Was leer bleibt, ist wie von der Regel verlangt. Zuerst wird das Verfahren an einer synthetischen Aufnahme geprüft.
page-series-begin = Reihe beginnen
page-series-all = Alle Prüfreihen
page-series-complete = Jede Stelle hat ihre Versuche.
page-series-damaged = { $count ->
    [one] Eine Zeile des Protokolls ist beschädigt und zählt nicht.
   *[other] { $count } Zeilen des Protokolls sind beschädigt und zählen nicht.
}
page-series-files = Aufnahmen hinzufügen
page-series-files-label = Aufnahmen der nächsten Versuche
page-series-operator = Wer den Ball fallen lässt
page-series-places-done = Fertige Stellen: { $done } von { $all }
page-series-place-done = (fertig)
page-series-recordings = Aufnahmen
page-series-repeat = Versuch { $number } wiederholen
page-series-reason = Warum er nicht zählt
page-series-repeat-do = { $number } wiederholen; der Ton bleibt
page-series-notes = Was der Bericht angibt
page-series-notes-keep = Angaben speichern
page-series-report = Bericht speichern (HTML)
page-series-one-page = Seite für den Auftraggeber (HTML)
page-series-zip = Ganze Reihe speichern (ZIP)
page-series-zip-hint = Entpackt ist das ZIP ein Ordner für das Programm: bouncelab job show ORDNER. Es enthält jede Aufnahme mit ihrer SHA-256, auch die wiederholten.
page-series-microphone = Mikrofon
page-series-interrupted = Mikrofon, unterbrochen
page-series-count-interrupted = Als nächsten Versuch zählen
page-series-keep-again = Noch einmal versuchen
page-series-save-sound = Ton als Datei speichern
