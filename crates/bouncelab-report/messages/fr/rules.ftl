### Ce que disent les règles intégrées avec leurs propres mots.

rule-title-basketball = Ballon de basket-ball
rule-title-racquetball = Balle de racquetball
rule-title-pickleball = Balle de pickleball
rule-title-tennis-court-ball-rebound = Court de tennis, rebond de la balle
rule-title-indoor-sports-floor-basketball-rebound = Sol sportif intérieur, rebond du ballon de basket-ball
rule-title-rebound-of-a-ball-on-a-surface-by-sound = Rebond d’une balle sur une surface, d’après le son
rule-title-football-turf-fifa-quality-pro = Gazon de football, FIFA Quality Pro
rule-title-football-turf-fifa-quality = Gazon de football, FIFA Quality
rule-title-reference-football-for-turf-tests = Ballon de référence pour les essais de gazon
rule-title-futsal-ball = Ballon de futsal
rule-title-table-tennis-ball-40-mm = Balle de tennis de table, 40 mm
rule-title-table-tennis-ball-38-mm = Balle de tennis de table, 38 mm
rule-title-table-tennis-ball-38-mm-on-an-approved-table = Balle de tennis de table, 38 mm, sur une table homologuée
rule-title-table-tennis-table = Table de tennis de table
rule-title-tennis-ball-types-1-to-3 = Balle de tennis, types 1 à 3
rule-title-tennis-ball-for-high-altitude = Balle de tennis pour haute altitude
rule-title-padel-ball = Balle de padel
rule-title-padel-ball-for-high-altitude = Balle de padel pour haute altitude
rule-title-tennis-ball-type-1-by-another-source = Balle de tennis, type 1, d’après une autre source
rule-title-basketball-floor-fiba-level-1 = Sol de basket-ball, niveau FIBA 1
rule-title-basketball-floor-fiba-level-2 = Sol de basket-ball, niveau FIBA 2

rule-surface-granite-plate = plaque de granit
rule-surface-the-court = le court
rule-surface-a-smooth-rigid-surface-such-as-polished-granite = une surface lisse et rigide comme le granit poli
rule-surface-the-floor = le sol
rule-surface-concrete = béton
rule-surface-the-reference-surface = la surface de référence
rule-surface-the-turf = le gazon
rule-surface-steel-block = bloc d’acier
rule-surface-approved-table = table homologuée
rule-surface-the-table = la table
rule-surface-smooth-granite = granit lisse
rule-surface-a-hard-surface = une surface dure

rule-note-another-copy-of-the-rules-measures-the-rebound-at-the-top-of-the-ball-too = une autre copie des règles mesure aussi le rebond en haut de la balle
rule-note-the-itf-recommends-these-values-it-does-not-demand-them = l’ITF recommande ces valeurs, elle ne les exige pas
rule-note-a-method-for-any-ball-from-any-height-it-states-the-percentage-and-sets-no-limit = une méthode pour toute balle et toute hauteur ; elle donne le pourcentage et ne fixe aucune limite
rule-note-the-law-says-about-23-cm-and-not-how-near = la règle dit environ 23 cm, sans dire à combien près
rule-note-texts-that-cite-the-booklet-of-the-itf-give-138-to-151-cm-for-type-1-see-itf-tennis-type-1 = des textes qui citent la brochure de l’ITF donnent 138 à 151 cm pour le type 1 : voir itf-tennis-type-1
rule-note-copies-of-the-rules-of-tennis-give-135-to-147-cm-for-types-1-to-3-see-itf-tennis = des copies des règles du tennis donnent 135 à 147 cm pour les types 1 à 3 : voir itf-tennis
rule-note-en-12235-states-the-procedure-and-was-not-read = EN 12235 fixe la procédure et n'a pas été lu
rule-note-another-text-that-cites-the-rules-says-above-800-m-where-this-one-says-above-500-m = un autre texte qui cite les règles dit au-dessus de 800 m, celui-ci au-dessus de 500 m
rule-conditioning-24-hours-in-a-controlled-environment-pre-compressed-on-three-axes-tested-within-two-hours = 24 heures en ambiance contrôlée, précompression sur trois axes, essai dans les deux heures
rule-conditioning-balls-pressurised-at-21-to-25-c-pre-compressed-three-times-on-three-diameters = balles sous pression à 21 à 25 °C, trois précompressions sur trois diamètres
