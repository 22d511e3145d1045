session-untitled = Eine Sitzung
session-counts = { $drops ->
    [one] 1 Versuch
   *[other] { $drops } Versuche
  } in { $recordings ->
    [one] 1 Aufnahme
   *[other] { $recordings } Aufnahmen
  }{ $without ->
    [0] {""}
   *[other] , { $without } ohne springenden Ball
  }{ $failed ->
    [0] {""}
   *[other] , { $failed } nicht lesbar
  }{ $duplicates ->
    [0] {""}
   *[other] , { $duplicates } doppelt
  }
session-without-drop = Ohne springenden Ball
session-failed = Nicht lesbar
session-duplicates = Derselbe Ton wie ein anderer, der zählt
session-left-out = Nicht verglichen
session-odd = Genauer anzusehen
session-compared = Verglichen wird die Stoßzahl der Versuche bei einem Aufpralltempo von { $speed } m/s, das die meisten kennen, die Luft herausgerechnet.
session-unlike = Ausreißer in ihrer Gruppe, überall mitgezählt: { $names }.
session-incomparable = Nichts lässt sich vergleichen: { $reason }
session-groups-table = Stoßzahl nach Gruppen: Mittel und sein Standardfehler, was alle Versuche teilen, Streuung zwischen Versuchen und zwischen Aufprallen, und wie viele Versuche den Bereich halbieren würden
session-intervals-table = 95-%-Bereiche des Mittels, des nächsten Versuchs und der Streuung zwischen Versuchen
session-without-table = Mit den Ausreißern jeder Gruppe und ohne sie
session-varies-table = Varianzkomponenten: Standardabweichung der Stoßzahl nach Faktor
session-differences-table = Unterschiede nach { $factor }, alles andere gleich
session-trends-table = Änderung der Stoßzahl mit dem, was in Zahlen vermerkt ist, alles andere gleich
session-groups = Gruppen
session-against-speed = Stoßzahl über dem Tempo
session-what-varies = Varianzkomponenten
session-differences-heading = Unterschiede
session-in-order = Der Reihe nach
session-troubles = Was nicht gelang
session-conditions = Bedingungen
session-assumed = Das hat niemand vermerkt, darum ist es angenommen:
session-method = Verfahren
session-method-drop = Jeder Versuch wird für sich geschätzt: Fall, Luftwiderstand, Aufpralle, die streuen, Zeiten mit Fehlern. Seine Stoßzahl beim gemeinsamen Tempo hat eine eigene Unsicherheit (Zeiten, Streuung der Aufpralle) und eine, die sie mit allen Versuchen des Balls teilt (Widerstandsgesetz, Luft, Masse, Durchmesser, Kontakt). Nur die erste mittelt sich über Versuche heraus.
session-method-group = Eine Gruppe beschreibt ein Modell mit zufälligen Effekten, einer Streuung zwischen Versuchen neben dem Fehler eines jeden: eingeschränkte Maximum-Likelihood (Viechtbauer 2005), Standardfehler nach Hartung und Knapp (2001) in der Form von Röver, Knapp und Friede (2015), Student-t, Q-Profil-Bereich der Streuung (Viechtbauer 2007), Bereich des nächsten Versuchs (Higgins, Thompson und Spiegelhalter 2009).
session-method-factors = Was streut, und Unterschiede bei sonst Gleichem, folgen aus einem gemischten Modell mit gekreuzten zufälligen Faktoren (Patterson und Thompson 1971), Freiheitsgrade nach Satterthwaite (Giesbrecht und Burns 1985); bei einem einzigen Faktor nach Welch (1947). Wahrscheinlichkeiten sind für die Zahl der Unterschiede berichtigt (Holm 1979). Ausreißer heißen modifizierte z-Werte über 3,5 (Iglewicz und Hoaglin 1993); sie bleiben dabei.
session-hashes = Die SHA-256-Summe jeder Aufnahme steht in der Tabelle der Versuche (content_sha256).

session-column-difference = Unterschied
session-column-interval = 95-%-Bereich
session-column-p-holm = p (Holm)
session-column-p = p
session-column-group = Gruppe
session-column-drops = Versuche
session-column-shared = gemeinsam
session-column-between-drops = zwischen Versuchen
session-column-between-impacts = zwischen Aufprallen
session-column-needed = nötig
session-column-with = mit
session-column-without = ohne
session-column-factor = mit
session-column-levels = Stufen
session-column-slope = Steigung
session-column-mean = Mittel
session-column-next = nächster Versuch
session-column-count = wie viele
session-column-varies = streut um
session-per-metre = je m
session-per-kelvin = je K
session-all = alle
session-too-many = zu viele
session-drop = Versuch
session-together = { $names } (immer zusammen)
session-too-few = zu wenige

session-all-drops = alle Versuche
session-no-inference = kein Versuch hat eine Auswertung, die sich vergleichen ließe
session-no-speed = kein Versuch kennt seine Stoßzahl bei { $speed } m/s: seine Aufpralle sind langsamer oder schneller
session-unknown-there = er kennt seine Stoßzahl bei { $speed } m/s nicht
session-one-drop = Ein Versuch allein sagt nichts über die Streuung zwischen Versuchen und darum nichts über den Bereich eines Mittels: Lass den Ball mehrmals fallen.
session-one-group = Alle Versuche sind in einer Gruppe, es gibt also nichts zu vergleichen. Ein Unterschied braucht zwei Gruppen: mit einem anderen Ball, auf einem anderen Untergrund oder von einer anderen Person.
session-no-curve = seine Stoßzahl ist bei keinem Tempo bekannt: zu wenige Aufpralle, oder ihr Tempo unterscheidet sich zu wenig
groups-assumed-of-some = { $assumption } (in { $count } von { $all } Aufnahmen).
