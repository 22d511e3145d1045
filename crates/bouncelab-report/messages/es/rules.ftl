### Lo que dicen las reglas incluidas con sus propias palabras.

rule-title-basketball = Balón de baloncesto
rule-title-racquetball = Pelota de ráquetbol
rule-title-pickleball = Pelota de pickleball
rule-title-tennis-court-ball-rebound = Pista de tenis, rebote de la pelota
rule-title-indoor-sports-floor-basketball-rebound = Suelo deportivo interior, rebote del balón de baloncesto
rule-title-rebound-of-a-ball-on-a-surface-by-sound = Rebote de una pelota en una superficie, por el sonido
rule-title-football-turf-fifa-quality-pro = Césped de fútbol, FIFA Quality Pro
rule-title-football-turf-fifa-quality = Césped de fútbol, FIFA Quality
rule-title-reference-football-for-turf-tests = Balón de referencia para ensayos de césped
rule-title-futsal-ball = Balón de fútbol sala
rule-title-table-tennis-ball-40-mm = Pelota de tenis de mesa, 40 mm
rule-title-table-tennis-ball-38-mm = Pelota de tenis de mesa, 38 mm
rule-title-table-tennis-ball-38-mm-on-an-approved-table = Pelota de tenis de mesa, 38 mm, en una mesa homologada
rule-title-table-tennis-table = Mesa de tenis de mesa
rule-title-tennis-ball-types-1-to-3 = Pelota de tenis, tipos 1 a 3
rule-title-tennis-ball-for-high-altitude = Pelota de tenis para gran altitud
rule-title-padel-ball = Pelota de pádel
rule-title-padel-ball-for-high-altitude = Pelota de pádel para gran altitud
rule-title-tennis-ball-type-1-by-another-source = Pelota de tenis, tipo 1, según otra fuente
rule-title-basketball-floor-fiba-level-1 = Suelo de baloncesto, nivel FIBA 1
rule-title-basketball-floor-fiba-level-2 = Suelo de baloncesto, nivel FIBA 2

rule-surface-granite-plate = placa de granito
rule-surface-the-court = la pista
rule-surface-a-smooth-rigid-surface-such-as-polished-granite = una superficie lisa y rígida como el granito pulido
rule-surface-the-floor = el suelo
rule-surface-concrete = hormigón
rule-surface-the-reference-surface = la superficie de referencia
rule-surface-the-turf = el césped
rule-surface-steel-block = bloque de acero
rule-surface-approved-table = mesa homologada
rule-surface-the-table = la mesa
rule-surface-smooth-granite = granito liso
rule-surface-a-hard-surface = una superficie dura

rule-note-another-copy-of-the-rules-measures-the-rebound-at-the-top-of-the-ball-too = otra copia de las reglas mide también el rebote en la parte superior de la pelota
rule-note-the-itf-recommends-these-values-it-does-not-demand-them = la ITF recomienda estos valores, no los exige
rule-note-a-method-for-any-ball-from-any-height-it-states-the-percentage-and-sets-no-limit = un método para cualquier pelota y altura; da el porcentaje y no fija ningún límite
rule-note-the-law-says-about-23-cm-and-not-how-near = la regla dice unos 23 cm, y no con qué aproximación
rule-note-texts-that-cite-the-booklet-of-the-itf-give-138-to-151-cm-for-type-1-see-itf-tennis-type-1 = textos que citan el folleto de la ITF dan de 138 a 151 cm para el tipo 1: véase itf-tennis-type-1
rule-note-copies-of-the-rules-of-tennis-give-135-to-147-cm-for-types-1-to-3-see-itf-tennis = copias de las reglas de tenis dan de 135 a 147 cm para los tipos 1 a 3: véase itf-tennis
rule-note-en-12235-states-the-procedure-and-was-not-read = EN 12235 establece el procedimiento y no se leyó
rule-note-another-text-that-cites-the-rules-says-above-800-m-where-this-one-says-above-500-m = otro texto que cita las reglas dice por encima de 800 m, y este por encima de 500 m
rule-conditioning-24-hours-in-a-controlled-environment-pre-compressed-on-three-axes-tested-within-two-hours = 24 horas en ambiente controlado, precompresión en tres ejes, ensayo en dos horas
rule-conditioning-balls-pressurised-at-21-to-25-c-pre-compressed-three-times-on-three-diameters = pelotas presurizadas a 21 a 25 °C, tres precompresiones en tres diámetros
