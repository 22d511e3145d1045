sheet-fields = Nombre: _________________________ Clase: ______________ Fecha: ______________
sheet-page = La página en tu teléfono: { $address }
sheet-set-up = Una pelota sobre el suelo, su altura h, y un teléfono al lado
sheet-qr-code = Código QR de la página
sheet-need = Se necesita
sheet-do = Qué hacer
sheet-write = Anota
sheet-work = Calcula
sheet-expected = Qué esperar
sheet-expected-made = Calculado por bouncelab, con el aire de una sala (20 °C, nivel del mar) y la gravedad normal. La restitución de las tablas se supone igual a toda velocidad.
sheet-talk = Para discutir
sheet-teacher = Para el profesor
sheet-teacher-collect = Reunir: cada grupo comparte su ensayo como enlace, y la tabla de ensayos de la página toma todos los enlaces a la vez. Los agrupa por pelota y superficie, da la media de cada grupo con su intervalo del 95 %, y nombra los ensayos que no encajan.
sheet-teacher-quiet = Bastan un suelo duro o una losa de piedra sobre una mesa firme, y diez segundos de silencio. El teléfono está a menos de un metro, no sobre la losa.
sheet-no-air = sin aire
sheet-column-ball = pelota
sheet-column-drop = ensayo
sheet-column-restitution = e
sheet-column-first = T₁ (s)
sheet-column-second = T₂ (s)
sheet-column-third = T₃ (s)
sheet-column-ratio = T₂ / T₁
sheet-column-height = altura del rebote 1 (cm)
sheet-column-terminal = velocidad terminal (m/s)
sheet-column-speed = velocidad en el impacto 1 (m/s)
sheet-column-share = arrastre allí, en % del peso
sheet-column-gravity = 8 h T₂² / T₁⁴ (m/s²)
sheet-column-off = desviación (%)
sheet-column-mean = media

sheet-bounciness-title = ¿Cuánto rebota una pelota?
sheet-bounciness-aim = Una pelota conserva una fracción e de su velocidad en cada rebote: su coeficiente de restitución. Hallas e con el oído de un teléfono, porque cada vuelo dura unas e veces el anterior.
sheet-bounciness-need-1 = tres pelotas distintas, un suelo duro, una regla o una cinta métrica
sheet-bounciness-need-2 = un teléfono u ordenador con la página de bouncelab
sheet-bounciness-do-1 = Elige tu pelota en la página, pon el teléfono junto al lugar donde va a rebotar, y toca «Escuchar».
sheet-bounciness-do-2 = Sostén el punto más bajo de la pelota a { $height } cm del suelo. Suelta sin empujar. Espera hasta que la pelota esté en reposo.
sheet-bounciness-do-3 = Lee los primeros tiempos de vuelo en la lista de impactos: T₁ es el tiempo del impacto 1 al impacto 2, T₂ del 2 al 3.
sheet-bounciness-do-4 = Suelta cada pelota tres veces.
sheet-bounciness-work-1 = Divide T₂ entre T₁ en cada ensayo, y toma la media de cada pelota.
sheet-bounciness-work-2 = ¿Qué pelota conserva más velocidad? ¿Qué fracción de su energía conserva (e²)?
sheet-bounciness-work-3 = Compara tu T₂ / T₁ con el e de la página. ¿Cuál es mayor, y por qué?
sheet-bounciness-see = Una pelota ({ $ball }) desde { $height } cm, para varios valores de e. T₂ / T₁ es menor que e: el aire también frena la pelota.
sheet-bounciness-talk-1 = ¿Por qué el tiempo de un vuelo dice la velocidad con que empezó?
sheet-bounciness-talk-2 = La altura de un rebote es e² veces la anterior. ¿Qué altura tiene el rebote 5 de tu mejor pelota?
sheet-bounciness-talk-3 = Tres ensayos de la misma pelota difieren. ¿Es la pelota, el suelo o la forma de soltar?
sheet-bounciness-teacher-1 = Sin aire, T₂ / T₁ = e. La diferencia de la tabla es casi toda del aire: { $off } % para e = 0,90. La página descuenta el aire de su e.

sheet-air-title = ¿Cuánto se lleva el aire?
sheet-air-aim = El aire frena toda pelota, sobre todo una ligera y grande. Mides cuánto, con tiempos de vuelo que se reducirían todos en la misma razón si no hubiera aire.
sheet-air-need-1 = una pelota de tenis de mesa, una de tenis y una de golf (o una bola de acero), un suelo duro, una cinta métrica
sheet-air-need-2 = un teléfono u ordenador con la página de bouncelab
sheet-air-do-1 = Elige la pelota en la página, toca «Escuchar», y suelta la pelota desde { $height } cm.
sheet-air-do-2 = Anota los tiempos de los tres primeros vuelos de cada pelota.
sheet-air-do-3 = Mira la figura «Restitución» de cada ensayo: una vez como si no hubiera aire, otra descontado el aire.
sheet-air-work-1 = Calcula T₂ / T₁ y T₃ / T₂. Sin aire serían iguales, si la pelota conserva la misma fracción en cada rebote.
sheet-air-work-2 = ¿Qué pelota tiene la mayor diferencia entre T₂ / T₁ y T₃ / T₂? ¿Por qué esa?
sheet-air-work-3 = Estima el arrastre en el primer impacto con la velocidad terminal: arrastre / peso = (velocidad / velocidad terminal)².
sheet-air-see = Pelotas desde { $height } cm, todas con e = { $restitution }. El aire hace variar T₂ / T₁, y un poco el tiempo que una pelota toca el suelo.
sheet-air-talk-1 = ¿Por qué la bola de acero apenas nota el aire aunque es tan pequeña?
sheet-air-talk-2 = En los vuelos posteriores, más lentos, T₃ / T₂ se acerca a e. ¿Por qué?
sheet-air-talk-3 = Una clase midió una pelota de tenis de mesa sin pensar en el aire. ¿Su e es demasiado grande o demasiado pequeño?
sheet-air-teacher-1 = El arrastre de una pelota de tenis de mesa en su primer impacto es el { $share } % de su peso. Hace T₂ / T₁ un { $off } % menor que e.
sheet-air-teacher-2 = El e real de una pelota cambia con la velocidad, así que T₃ / T₂ − T₂ / T₁ no se debe solo al aire. La página separa los dos efectos, y dice dónde el ensayo no puede.

sheet-gravity-title = Medir g con una pelota
sheet-gravity-aim = De una altura conocida y dos tiempos de vuelo se obtiene la aceleración de la gravedad g, sin cronómetro: la pelota misma dice cuánto pierde en cada rebote.
sheet-gravity-need-1 = una pelota pesada y pequeña (golf o acero), una losa de piedra, una regla milimetrada
sheet-gravity-need-2 = un teléfono u ordenador con la página de bouncelab
sheet-gravity-do-1 = Mide la altura h de la losa al punto más bajo de la pelota: { $height } cm, al milímetro si puedes.
sheet-gravity-do-2 = Toca «Escuchar» y suelta sin empujar. Suelta la pelota cinco veces.
sheet-gravity-do-3 = Anota T₁ y T₂ con cuatro decimales.
sheet-gravity-work-1 = La pelota llega con v = √(2 g h) y sale con e v. Así, T₁ = 2 e v / g, y e = T₂ / T₁. Muestra que g = 8 h T₂² / T₁⁴.
sheet-gravity-work-2 = Calcula g en cada ensayo, y después la media y su error típico.
sheet-gravity-work-3 = En la página, da la altura en «cambiar», marca «medir g», y compara.
sheet-gravity-see = Lo que da la fórmula para pelotas desde { $height } cm con e = { $restitution }, si g es { $gravity } m/s².
sheet-gravity-talk-1 = La pelota de tenis da un g demasiado pequeño, aunque nota menos el aire que la de tenis de mesa. ¿Qué más lleva tiempo en un rebote?
sheet-gravity-talk-2 = Un milímetro de { $height } cm es el { $share } %. ¿Qué error de g resulta de ello?
sheet-gravity-talk-3 = g es 9,78 m/s² en el ecuador y 9,83 m/s² en los polos. ¿Podrías distinguirlos?
sheet-gravity-teacher-1 = La fórmula tiene e al cuadrado: si e varía un 0,5 % de rebote a rebote, g varía un { $scatter } % de ensayo a ensayo. Con cinco ensayos, la media se conoce al { $mean } %.
sheet-gravity-teacher-2 = Lo que más importa es la suelta: una pelota empujada o girada tiene otra altura. Ayuda un imán que suelta una bola de acero.
sheet-gravity-teacher-3 = Una pelota de tenis toca el suelo durante { $contact } ms, que cuentan como vuelo: g sale un { $soft } % demasiado pequeño. El aire acorta T₁ y reduce T₂ / T₁; en esta fórmula los dos casi se compensan. La página descuenta ambos.

sheet-ball-table-tennis-40 = tenis de mesa
sheet-ball-tennis = tenis
sheet-ball-golf = golf
sheet-ball-steel = acero, 2 cm
