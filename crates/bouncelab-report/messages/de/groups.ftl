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
session-unlike = Ausreißer in ihrer Gruppe, überall mitgezählt: { $names }.
session-incomparable = Nichts lässt sich vergleichen: { $reason }
session-groups-table = Stoßzahl nach Gruppen mit ihrer Standardunsicherheit, was davon alle Versuche teilen, Streuung zwischen Versuchen und zwischen Aufprallen, und wie viele Versuche den Bereich halbieren würden
session-intervals-table = 95-%-Bereiche der Stoßzahl, des nächsten Versuchs und der Streuung zwischen Versuchen; Wiederhol- und Vergleichsstandardabweichung (ISO 5725)
session-without-table = Mit den Ausreißern jeder Gruppe und ohne sie
session-differences-table = Unterschiede von Gruppen: beim Tempo des Vergleichs, mit der Wahrscheinlichkeit, dass sie über null liegen, und als Mittel über alle Tempi, die beide haben
session-groups = Gruppen
session-against-speed = Stoßzahl über dem Tempo
session-differences-heading = Unterschiede
session-in-order = Der Reihe nach
session-troubles = Was nicht gelang
session-conditions = Bedingungen
session-assumed = Das hat niemand vermerkt, darum ist es angenommen:
session-method = Verfahren
session-method-drop = Jeder Versuch wird für sich geschätzt: Fall, Luftwiderstand, Aufpralle, die streuen, Zeiten mit Fehlern. Seine Likelihood, ohne das vorher Angenommene, geht beim Tempo seiner eigenen Aufpralle in ein Modell aller Versuche ein. Was alle Versuche eines Balls teilen (Luftwiderstand, Luft, Masse, Durchmesser, Kontaktzeit), behält die Unsicherheit, die es in einem einzelnen Versuch hat.
session-method-group = Eine Gruppe hat eine Kurve von ln e über ln v, einen kubischen Spline, dessen Steigung zufällig wandert, um die ihre Versuche im Niveau streuen. Bei gegebener Streuung ist das linear und normalverteilt; über die Streuung wird integriert, mit einer exponentiellen A-priori-Verteilung mit Mittel 1 % (Simpson et al. 2017).
session-hashes = Die SHA-256-Summe jeder Aufnahme steht in der Tabelle der Versuche (content_sha256).

session-column-difference = Unterschied
session-column-interval = 95-%-Bereich
session-column-group = Gruppe
session-column-drops = Versuche
session-column-shared = gemeinsam
session-column-between-drops = zwischen Versuchen
session-column-between-impacts = zwischen Aufprallen
session-column-needed = nötig
session-column-with = mit
session-column-without = ohne
session-column-mean = Stoßzahl
session-column-next = nächster Versuch
session-column-count = wie viele
session-column-varies = streut um
session-too-many = zu viele

session-all-drops = alle Versuche
session-no-inference = kein Versuch hat eine Auswertung, die sich vergleichen ließe
session-no-speed = kein Versuch hat Aufpralle um { $speed } m/s
session-one-drop = Ein Versuch allein sagt wenig über die Streuung zwischen Versuchen, darum ist der Bereich weit: Lass den Ball mehrmals fallen.
session-one-group = Alle Versuche sind in einer Gruppe, es gibt also nichts zu vergleichen. Ein Unterschied braucht zwei Gruppen: mit einem anderen Ball, auf einem anderen Untergrund oder von einer anderen Person.
session-no-curve = er sagt nichts über die Kurve der Stoßzahl: zu wenige Aufpralle, oder Ziehungen, die ihre Kovarianz nicht beschreibt
groups-assumed-of-some = { $assumption } (in { $count } von { $all } Aufnahmen).
session-scatter-table = Streuung der Stoßzahl neben der der Versuche, relativ
session-curve-table = Stoßzahl bei mehreren Aufpralltempi
session-heights = Fallhöhen
session-heights-table = Fallhöhen nach der Kurve der Gruppe
session-ruler = Angegebene Höhen liegen um { $value } über den gehörten (95 %: { $interval }): der Nullpunkt des Maßstabs.
session-in-words = { $group }: Stoßzahl { $value } bei { $speed } (95 %: { $interval }), aus { $drops ->
    [one] 1 Versuch
   *[other] { $drops } Versuchen
  }, Streuung { $scatter }.
session-difference-in-words = { $of } minus { $less }: { $value } (95 %: { $interval }); mit einer Wahrscheinlichkeit von { $probability } über null.
session-method-scatter = Personen, und was sonst keine Gruppen bildet, streuen mit einer A-priori-Verteilung mit Mittel 0,2 %. Unterschiede werden einzeln betrachtet. Ausreißer sind Versuche, deren Niveau einen modifizierten z-Wert über 3,5 hat (Iglewicz und Hoaglin 1993); sie bleiben dabei.
session-column-drop = Versuch
session-column-repeatability = Wiederholbarkeit
session-column-reproducibility = Vergleichbarkeit
session-column-above = über null
session-column-over = über alle Tempi
factor-ball = Ball
factor-surface = Untergrund
factor-operator = Person
factor-student = Schüler
factor-place = Ort
