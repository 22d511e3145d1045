### What the rules that are built in say in words of their own.

rule-title-basketball = Basketball
rule-title-racquetball = Racquetball
rule-title-pickleball = Pickleball
rule-title-tennis-court-ball-rebound = Tennis court, ball rebound
rule-title-indoor-sports-floor-basketball-rebound = Indoor sports floor, basketball rebound
rule-title-rebound-of-a-ball-on-a-surface-by-sound = Rebound of a ball on a surface, by sound
rule-title-football-turf-fifa-quality-pro = Football turf, FIFA Quality Pro
rule-title-football-turf-fifa-quality = Football turf, FIFA Quality
rule-title-reference-football-for-turf-tests = Reference football for turf tests
rule-title-futsal-ball = Futsal ball
rule-title-table-tennis-ball-40-mm = Table-tennis ball, 40 mm
rule-title-table-tennis-ball-38-mm = Table-tennis ball, 38 mm
rule-title-table-tennis-ball-38-mm-on-an-approved-table = Table-tennis ball, 38 mm, on an approved table
rule-title-table-tennis-table = Table-tennis table
rule-title-tennis-ball-types-1-to-3 = Tennis ball, types 1 to 3
rule-title-tennis-ball-for-high-altitude = Tennis ball for high altitude
rule-title-padel-ball = Padel ball
rule-title-padel-ball-for-high-altitude = Padel ball for high altitude
rule-title-tennis-ball-type-1-by-another-source = Tennis ball, type 1, by another source
rule-title-basketball-floor-fiba-level-1 = Basketball floor, FIBA level 1
rule-title-basketball-floor-fiba-level-2 = Basketball floor, FIBA level 2

rule-surface-granite-plate = granite plate
rule-surface-the-court = the court
rule-surface-a-smooth-rigid-surface-such-as-polished-granite = a smooth, rigid surface such as polished granite
rule-surface-the-floor = the floor
rule-surface-concrete = concrete
rule-surface-the-reference-surface = the reference surface
rule-surface-the-turf = the turf
rule-surface-steel-block = steel block
rule-surface-approved-table = approved table
rule-surface-the-table = the table
rule-surface-smooth-granite = smooth granite
rule-surface-a-hard-surface = a hard surface

rule-note-another-copy-of-the-rules-measures-the-rebound-at-the-top-of-the-ball-too = another copy of the rules measures the rebound at the top of the ball too
rule-note-the-itf-recommends-these-values-it-does-not-demand-them = the ITF recommends these values, it does not demand them
rule-note-a-method-for-any-ball-from-any-height-it-states-the-percentage-and-sets-no-limit = a method for any ball from any height; it states the percentage and sets no limit
rule-note-the-law-says-about-23-cm-and-not-how-near = the law says about 23 cm, and not how near
rule-note-texts-that-cite-the-booklet-of-the-itf-give-138-to-151-cm-for-type-1-see-itf-tennis-type-1 = texts that cite the booklet of the ITF give 138 to 151 cm for type 1: see itf-tennis-type-1
rule-note-copies-of-the-rules-of-tennis-give-135-to-147-cm-for-types-1-to-3-see-itf-tennis = copies of the Rules of Tennis give 135 to 147 cm for types 1 to 3: see itf-tennis
rule-note-en-12235-states-the-procedure-and-was-not-read = EN 12235 states the procedure, and was not read
rule-note-another-text-that-cites-the-rules-says-above-800-m-where-this-one-says-above-500-m = another text that cites the rules says above 800 m, where this one says above 500 m
rule-conditioning-24-hours-in-a-controlled-environment-pre-compressed-on-three-axes-tested-within-two-hours = 24 hours in a controlled environment, pre-compressed on three axes, tested within two hours
rule-conditioning-balls-pressurised-at-21-to-25-c-pre-compressed-three-times-on-three-diameters = balls pressurised at 21 to 25 °C, pre-compressed three times on three diameters
