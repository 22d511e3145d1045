### Was die eingebauten Regeln in eigenen Worten sagen.

rule-title-basketball = Basketball
rule-title-racquetball = Racquetball
rule-title-pickleball = Pickleball
rule-title-tennis-court-ball-rebound = Tennisplatz, Rücksprung des Balls
rule-title-indoor-sports-floor-basketball-rebound = Hallenboden, Rücksprung des Basketballs
rule-title-rebound-of-a-ball-on-a-surface-by-sound = Rücksprung eines Balls auf einem Untergrund, nach Gehör
rule-title-football-turf-fifa-quality-pro = Fußballrasen, FIFA Quality Pro
rule-title-football-turf-fifa-quality = Fußballrasen, FIFA Quality
rule-title-reference-football-for-turf-tests = Referenzfußball für die Prüfung von Rasen
rule-title-futsal-ball = Futsalball
rule-title-table-tennis-ball-40-mm = Tischtennisball, 40 mm
rule-title-table-tennis-ball-38-mm = Tischtennisball, 38 mm
rule-title-table-tennis-ball-38-mm-on-an-approved-table = Tischtennisball, 38 mm, auf einem zugelassenen Tisch
rule-title-table-tennis-table = Tischtennistisch
rule-title-tennis-ball-types-1-to-3 = Tennisball, Typen 1 bis 3
rule-title-tennis-ball-for-high-altitude = Tennisball für große Höhen
rule-title-padel-ball = Padelball
rule-title-padel-ball-for-high-altitude = Padelball für große Höhen
rule-title-tennis-ball-type-1-by-another-source = Tennisball, Typ 1, nach anderer Quelle
rule-title-basketball-floor-fiba-level-1 = Basketballboden, FIBA-Stufe 1
rule-title-basketball-floor-fiba-level-2 = Basketballboden, FIBA-Stufe 2

rule-surface-granite-plate = Granitplatte
rule-surface-the-court = der Platz
rule-surface-a-smooth-rigid-surface-such-as-polished-granite = ein glatter, starrer Untergrund wie polierter Granit
rule-surface-the-floor = der Boden
rule-surface-concrete = Beton
rule-surface-the-reference-surface = der Referenzuntergrund
rule-surface-the-turf = der Rasen
rule-surface-steel-block = Stahlblock
rule-surface-approved-table = zugelassener Tisch
rule-surface-the-table = der Tisch
rule-surface-smooth-granite = glatter Granit
rule-surface-a-hard-surface = ein harter Untergrund

rule-note-another-copy-of-the-rules-measures-the-rebound-at-the-top-of-the-ball-too = ein anderer Text der Regeln misst auch den Rückprall an der Oberkante des Balls
rule-note-the-itf-recommends-these-values-it-does-not-demand-them = die ITF empfiehlt diese Werte, sie verlangt sie nicht
rule-note-a-method-for-any-ball-from-any-height-it-states-the-percentage-and-sets-no-limit = ein Verfahren für jeden Ball aus jeder Höhe; es gibt den Anteil an und setzt keine Grenze
rule-note-the-law-says-about-23-cm-and-not-how-near = die Regel sagt etwa 23 cm, und nicht, wie genau
rule-note-texts-that-cite-the-booklet-of-the-itf-give-138-to-151-cm-for-type-1-see-itf-tennis-type-1 = Texte, die das Heft der ITF anführen, geben 138 bis 151 cm für Typ 1: siehe itf-tennis-type-1
rule-note-copies-of-the-rules-of-tennis-give-135-to-147-cm-for-types-1-to-3-see-itf-tennis = Abschriften der Tennisregeln geben 135 bis 147 cm für die Typen 1 bis 3: siehe itf-tennis
rule-note-en-12235-states-the-procedure-and-was-not-read = EN 12235 legt das Verfahren fest und wurde nicht gelesen
rule-note-another-text-that-cites-the-rules-says-above-800-m-where-this-one-says-above-500-m = ein anderer Text, der die Regeln zitiert, sagt über 800 m, dieser über 500 m
rule-conditioning-24-hours-in-a-controlled-environment-pre-compressed-on-three-axes-tested-within-two-hours = 24 Stunden in geregeltem Raumklima, in drei Achsen vorgedrückt, binnen zwei Stunden geprüft
rule-conditioning-balls-pressurised-at-21-to-25-c-pre-compressed-three-times-on-three-diameters = Bälle unter Druck bei 21 bis 25 °C, dreimal in drei Durchmessern vorgedrückt
