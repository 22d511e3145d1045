diagnostic-recording-silent = La grabación está en silencio: todas las muestras tienen el mismo valor.
diagnostic-no-sound = Ningún sonido destaca sobre el ruido de fondo.
diagnostic-too-few-sounds = { $count ->
    [one] Solo 1 sonido destaca
   *[other] Solo { $count } sonidos destacan
  } sobre el ruido de fondo; la detección de un ensayo necesita al menos { $needed } impactos.
diagnostic-periodic-sounds = { $count } sonidos son periódicos, cada { $interval_s } aproximadamente, como los de un reloj, unos pasos o un tambor; los vuelos de una pelota se acortan.
diagnostic-no-pattern = { $count } sonidos destacan sobre el ruido de fondo, pero no hay { $needed } de ellos con los intervalos decrecientes de una pelota que rebota.
diagnostic-too-few-times = Un vuelo necesita dos tiempos de impacto, y hay menos.
diagnostic-too-many-times = La lista tiene { $count } tiempos; ningún ensayo tiene más de { $most } impactos. Indica los de un solo ensayo. Una forma de onda muestreada necesita una segunda columna, la amplitud.
diagnostic-times-in-milliseconds = Hay impactos separados por más de 30 s, y ninguna pelota vuela tanto tiempo. Los tiempos son segundos; bajo el título time_ms, milisegundos.
diagnostic-flights-do-not-fall = Los { $count } intervalos entre los tiempos no se acortan como los vuelos de una pelota que rebota: duran { $first_s } s al principio y { $last_s } s al final. Son muestras, otro reloj o varios ensayos; indica los tiempos de impacto de un solo ensayo.
diagnostic-times-by-threshold = Los tiempos son aquellos en que el sonido superó un umbral, que marca un impacto débil más tarde que uno fuerte. Una grabación del sonido da mejores tiempos.
diagnostic-times-of-intervals = Los tiempos de impacto son sumas de los intervalos indicados; el primer impacto está en 0 s.
diagnostic-nothing-left = Se excluyeron tantos impactos que no queda ningún vuelo.
diagnostic-distant-ball = Se detectó una pelota mucho más débil de { $start_s } s a { $end_s } s ({ $impacts } impactos) y se excluyó.
diagnostic-drops-at-once = Dos pelotas botan a la vez de { $start_s } s a { $end_s } s: si suenan igual, un impacto de una puede tomarse por uno de la otra.
diagnostic-clipped = { $samples ->
    [one] 1 muestra está recortada
   *[other] { $samples } muestras están recortadas
  }: el nivel de grabación era demasiado alto; los tiempos de impacto apenas se ven afectados, los niveles sí.
diagnostic-earlier-impact = Un sonido en { $time_s } s, antes del ensayo desde { $start_s } s, puede ser un impacto anterior, aunque encaja mal con los demás: si lo es, la pelota cayó de más alto de lo que se indica.
diagnostic-sounds-unused = { $count } sonidos cerca del ensayo desde { $start_s } s son tan fuertes como sus impactos y no se usaron: otros sonidos o una segunda pelota.
diagnostic-possible-drop = Posible ensayo { $number }: desde { $start_s } s, { $impacts } impactos, probabilidad { $probability }. Solo cuenta si lo aceptas (--accept { $number }).
diagnostic-no-candidate = No hay ningún posible ensayo con el número { $number }, sino { $count ->
    [0] ninguno
   *[other] { $count }
  }.
diagnostic-nothing-to-exclude = No hay ningún impacto cerca de { $time_s } s, así que no se excluyó nada allí.
diagnostic-too-far-to-include = { $time_s } s está a más de { $reach_s } de todo ensayo, así que no se añadió.
diagnostic-sound-lost = Se perdió sonido en { $at_s } s: de { $impacts } impactos se usan los { $kept } de la parte más larga sin hueco.
diagnostic-release-without-drop = Ningún ensayo empieza después de la suelta indicada en { $time_s } s.
diagnostic-height-of-another-unit = La altura indicada es { $stated_m }, pero la caída detectada es de unos { $detected_m }; quizá quisiste decir { $meant_m }.

diagnostic-file-unreadable = El archivo no se puede leer.
diagnostic-file-truncated = { $expected_s ->
    [none] El archivo está truncado o dañado, o contiene más sonido del que cuenta su cabecera: se leyó hasta { $read_s } s. Si antes se insertó sonido, los tiempos posteriores son demasiado largos.
   *[other] El archivo está truncado: se pudieron leer { $read_s } s de { $expected_s } s. Si el resto no falta al final, los tiempos posteriores son demasiado cortos.
  }
diagnostic-samples-not-finite = { $samples ->
    [one] 1 muestra no era un número y se sustituyó
   *[other] { $samples } muestras no eran números y se sustituyeron
  } por cero, la primera en { $first_s } s.
diagnostic-bits-flipped = { $samples } muestras saltan una potencia de dos y vuelven, la primera en { $first_s } s: hay bits alterados en el archivo, y pueden faltar impactos o ser falsos.
diagnostic-sound-missing = { $places ->
    [one] Faltan { $missing_s } s de sonido en { $first_s } s
   *[other] Faltan { $missing_s } s de sonido en { $places } lugares, el primero en { $first_s } s
  }: allí hay silencio, y no se usa ningún vuelo que lo cruce.
diagnostic-clock-lost = { $places ->
    [one] El archivo está dañado en { $first_s } s
   *[other] El archivo está dañado en { $places } lugares, el primero en { $first_s } s
  }, y no indica cuánto sonido falta: los tiempos de antes y de después no guardan relación, y no se usa ningún vuelo entre ellos.
diagnostic-sound-blank = { $places ->
    [one] El sonido es exactamente cero durante { $blank_s } s en { $first_s } s
   *[other] El sonido es exactamente cero durante { $blank_s } s en { $places } lugares, el primero en { $first_s } s
  }, y no en otra parte: quizá se perdió o se sobrescribió allí.
diagnostic-checksum-wrong = Los resultados pueden ser falsos: el sonido no es aquel cuya suma de comprobación o duración tiene el archivo. Se cambió en alguna parte de { $start_s } s a { $end_s } s, de modo que en cualquier punto de ese intervalo pueden faltar impactos, estar desplazados o sobrar.
diagnostic-format-changes = El sonido cambia de frecuencia de muestreo o de canales en { $at_s } s; se leyó hasta allí.
diagnostic-rate-in-doubt = { $implied_hz ->
    [none] La cabecera indica { $stated_hz } muestras por segundo, lo que es inusual en este formato y solo consta una vez
   *[other] La cabecera indica { $stated_hz } muestras por segundo, pero sus bytes por segundo corresponden a { $implied_hz }
  }: si la frecuencia es falsa, lo son todos los tiempos.
diagnostic-edit-list-ignored = La lista de edición del archivo reordena o deforma el sonido; se leyó tal como se grabó.

diagnostic-impacts-missed = { $count ->
    [one] Un impacto intermedio no se detectó; está contado.
   *[other] { $count } impactos intermedios no se detectaron; están contados.
  }
diagnostic-impact-gains-energy = { $count ->
    [one] El impacto { $impacts } tiene un coeficiente de restitución
   *[other] Los impactos { $impacts } tienen un coeficiente de restitución
  } mayor que 1: una detección doble, una superficie en movimiento u otro sonido.
diagnostic-restitution-rises = La restitución corregida por arrastre crece con la velocidad de impacto, de { $slow } a { $fast }, al contrario que la de las pelotas reales; la pelota es probablemente otra, más pesada para su tamaño.
diagnostic-impacts-doubtful = { $count ->
    [one] 1 impacto es
   *[other] { $count } impactos son
  } más probablemente otra cosa (probabilidad menor que 1/2).
diagnostic-flight-grows = El vuelo { $flight } es más largo que el anterior, lo cual es imposible sobre una superficie en reposo.

diagnostic-impacts-too-close = { $count ->
    [one] El impacto en { $start_s } s sigue
   *[other] { $count } impactos desde { $start_s } s siguen
  } a menos del doble del tiempo que la pelota toca la superficie ({ $contact_time_s }), y { $count ->
    [one] se deja
   *[other] se dejan
  } fuera. Si hay vuelos largos entre ellos, la pelota es probablemente otra, o su contacto es más corto.
diagnostic-few-impacts = { $count ->
    [2] 2 impactos muestran un solo vuelo y ninguna restitución de la pelota
    [3] 3 impactos muestran una sola restitución de la pelota, y no cómo cambia con la velocidad
   *[other] { $count } impactos muestran pocas restituciones de la pelota
  }; el resto del resultado viene de las distribuciones a priori.
diagnostic-flights-may-be-two = Solo { $count } impactos: si entre cada dos de ellos no se detectó uno, la pelota conserva { $restitution } de su velocidad y cayó desde { $height_m }. Los tiempos concuerdan con ambas cosas.
diagnostic-law-needs-impacts = Para distinguirse de una constante, la ley de restitución «{ $law }» necesita { $needed } impactos entre dos vuelos, y hay { $seen }: el cambio de la restitución con la velocidad viene de la distribución a priori.
diagnostic-impacts-odd = { $count ->
    [one] El impacto { $impacts } es atípico y pesa menos: la pelota pudo desviarse o dar en un borde, o el sonido es otra cosa.
   *[other] Los impactos { $impacts } son atípicos y pesan menos: la pelota pudo desviarse o dar en un borde, o los sonidos son otra cosa.
  }
diagnostic-scatter-exceeds-prior = La restitución varía alrededor de un { $relative_sd } % de un impacto a otro, más que el { $assumed_relative_sd } % supuesto: los intervalos pueden ser demasiado estrechos.
diagnostic-height-contradicts-times = La altura indicada de { $measured_m } contradice los impactos, que indican una caída desde { $detected_m }; no se utiliza. Ambas concordarían con una gravedad de { $gravity_m_s2 }. La altura, la pelota o la frecuencia de muestreo puede ser errónea.
diagnostic-first-impact-doubtful = El primer impacto, a los { $time_s } s, concuerda mal con los demás: con probabilidad { $probability } es otro sonido, o de una caída anterior, y la pelota cayó desde { $height_m }.
diagnostic-release-contradicts-times = El momento de soltar indicado, { $stated_s } s antes del primer impacto, contradice los impactos, que indican una caída de { $detected_s } s; no se utiliza.
diagnostic-first-impacts-missed = Se perdieron impactos antes del primero detectado, con probabilidad { $probability }.
diagnostic-other-ball-fits-better = Los tiempos encajan mejor con otro tipo de pelota que el indicado, al menos { $odds } a 1: { $balls }. Comprueba qué pelota era.
diagnostic-never-rests = Según algunas de las leyes de restitución posibles, la pelota pierde tan poco en los impactos lentos que no llegaría al reposo en un tiempo razonable.
diagnostic-inference-off = No se pidió ninguna inferencia.
diagnostic-inference-needs-impacts = Una inferencia necesita al menos un vuelo, es decir, dos impactos.
diagnostic-restitution-undetermined = Hay muy pocos impactos: con { $count } la restitución puede estar entre { $least } y { $greatest }. Graba al menos tres impactos, o mide e indica la altura de caída.
diagnostic-contact-overlaps = Los impactos { $first } y { $second }, en { $time_s } s, están a { $interval_s } uno de otro, y la pelota toca la superficie durante { $contact_time_s }. Uno de ellos es probablemente un eco u otro sonido: exclúyelo. Si no, corrige la pelota o su tiempo de contacto.
diagnostic-no-model-fits = Ningún modelo físico se ajusta a estos tiempos. Comprueba que están en segundos y son de un solo ensayo, excluye otros sonidos, y comprueba la pelota.
diagnostic-sampling-not-converged = Los tiempos no determinan el ensayo: el cálculo de las incertidumbres no convergió. Excluye los impactos que no son de este ensayo, comprueba la pelota, o graba más impactos.
diagnostic-sampling-failed = Ninguna extracción de la distribución a posteriori explica los tiempos como los de un solo ensayo. Excluye otros sonidos, o analiza cada ensayo por separado.
diagnostic-missed-in-a-row = Se perdieron { $missed } impactos seguidos después del impacto { $after }. Inclúyelos, o excluye los impactos después del hueco.
diagnostic-flight-too-long = El vuelo después del impacto { $after } dura { $duration_s }, lo que el arrastre del aire hace imposible con esta pelota. Incluye un impacto perdido ahí, o comprueba la masa, el diámetro y la unidad de los tiempos.
diagnostic-gains-speed = La pelota ganaría velocidad en la mayoría de los impactos, lo cual es imposible sobre una superficie en reposo; ¿están los tiempos en orden, en segundos, y son de un solo ensayo?
diagnostic-variances-confounded = Las varianzas de estos grupos no se pueden separar.

diagnostic-out-of-range = { $quantity }: { $value }{ $unit ->
    [none] {""}
   *[other] {" "}{ $unit }
  }; valor admitido: { $range ->
    [above] finito y mayor que { $low }
    [at-least] finito y al menos { $low }
    [below] finito y menor que { $high }
    [at-most] finito y como máximo { $high }
    [above-below] mayor que { $low } y menor que { $high }
    [above-at-most] mayor que { $low } y como máximo { $high }
    [at-least-below] al menos { $low } y menor que { $high }
    [at-least-at-most] de { $low } a { $high }
   *[finite] finito
  }
diagnostic-unknown-name = Nombre desconocido ({ $kind }): «{ $name }»; el más próximo es «{ $nearest }» (conocidos: { $known }).
diagnostic-reynolds-too-high = La tabla de arrastre termina en el número de Reynolds { $max_reynolds }, pero la pelota alcanza { $reynolds }; añade allí un punto o elige la curva estándar.
diagnostic-ball-floats = La pelota pesa { $mass_kg } y desplaza { $displaced_kg } de aire, así que flota; comprueba la masa y el diámetro, o no cuentes el empuje.
diagnostic-endless-drop = La pelota aún sube { $apex_m } después de { $bounces } rebotes; reduce la restitución, para a una altura mayor, o pide como mucho { $bounces } rebotes.
diagnostic-too-few-flights = Un ajuste log-lineal de los tiempos de vuelo necesita al menos 2 vuelos, y hay { $flights }; usa una grabación con al menos 3 impactos, o un intervalo más amplio de vuelos.
diagnostic-too-few-drops = Esto necesita al menos { $needed } ensayos, y hay { $drops }.
diagnostic-no-band = Ninguna banda está al menos por mitad { $range } Hz; con esta frecuencia de muestreo, las bandas son { $bands } Hz.
diagnostic-settings-contradict = { $first } y { $second } se contradicen; omite uno de los dos.
diagnostic-not-in-order = { $what } número { $number }: este número no es mayor que el anterior; numera en orden, una vez cada uno.
diagnostic-no-channel = No hay canal { $channel }: la grabación tiene { $channels ->
    [one] solo uno
   *[other] { $channels }, y el primero es el 1
  }.
diagnostic-too-many-drops = Hay { $drops } ensayos; solo se analizaron los primeros { $most }, hasta { $end_s } s. Corta la grabación allí, y analiza el resto por separado.
diagnostic-too-many-channels = { $channels } canales son más de los que se pueden analizar juntos: con esta frecuencia de muestreo, como mucho { $most }; elige uno de ellos.
diagnostic-each-of-reference = Una parte de una referencia compara medias: los ensayos aislados no tienen parte.
diagnostic-implausible-quantity = { $quantity }: ¿{ $value } { $unit }?{ $meant_unit ->
    [none] {""}
   *[other] {" "}¿Quisiste decir { $meant } { $meant_unit }?
  }
diagnostic-implausible-ball = ¿Una pelota de { $mass_kg } y { $diameter_m } de diámetro?{ $meant_g ->
    [none] { $meant_cm ->
        [none] { $meant_mm ->
            [none] {""}
           *[other] {" "}¿Quisiste decir { $meant_mm } mm?
          }
       *[other] {" "}¿Quisiste decir { $meant_cm } cm?
      }
   *[other] { $meant_mm ->
        [none] {" "}¿Quisiste decir { $meant_g } g?
       *[other] {" "}¿Quisiste decir { $meant_g } g y { $meant_mm } mm?
      }
  }

diagnostic-assumed-ball = La pelota es: { $ball }.
diagnostic-ball-not-stated = No se indicó la pelota: los intervalos valen para cada tipo de pelota que los tiempos permiten. Si se indica, se estrechan.
diagnostic-assumed-contact-time = La pelota toca la superficie durante { $contact_time_s }.
diagnostic-assumed-rule-ball = La pelota es la de la regla: { $ball }.
diagnostic-assumed-rule-height = El punto más bajo de la pelota cayó { $height_m } ± { $sd_m }, como en la regla.
diagnostic-assumed-air = Aire a { $temperature_k } °C, { $pressure_pa } hPa, { $relative_humidity } % de humedad.
diagnostic-assumed-gravity = Gravedad { $gravity_m_s2 }.

diagnostic-prior-restitution = Restitución: uniforme de 0 a 1.
diagnostic-prior-restitution-stated = Restitución según la velocidad de impacto, como se indicó: { $prior }.
diagnostic-prior-scatter = Dispersión de la restitución: alrededor del { $relative_sd } %, probablemente entre el { $low_relative_sd } y el { $high_relative_sd } %.
diagnostic-prior-slow-losses = Impactos más lentos que los detectados: como dice la ley, o con pérdidas que además crecen al bajar la velocidad (según una potencia de alrededor de { $exponent }).
diagnostic-prior-exact = { $input }: valor exacto.
diagnostic-prior-unknown = { $input }: valor desconocido (un factor e en ambos sentidos).
diagnostic-prior-input = { $input }: valor conocido al { $relative_sd } %.
diagnostic-prior-height = Altura de caída: medida, { $height_m } ± { $sd_m }.
diagnostic-prior-height-flat = Altura de caída: uniforme en su logaritmo.
diagnostic-prior-release = Suelta: medida, { $release_s } s ± { $sd_s }.
diagnostic-prior-missed = Cada impacto más perdido al principio: la mitad de probable; donde había silencio, casi imposible. En una lista de tiempos nada muestra si se perdieron impactos.

diagnostic-rule-without-limits = La regla no indica límites.
diagnostic-procedure-not-kept = No se siguió el procedimiento de la regla: { $item }.
diagnostic-drop-without-first-flight = No se detectó el primer vuelo del ensayo { $drop }: la regla pide el rebote del primer impacto.
diagnostic-rule-secondary = No se leyó el texto de esta regla, sino uno que la cita: comprueba la edición vigente antes de fiarte de un veredicto.
diagnostic-model-differs = El modelo da otro valor que el procedimiento de la regla, con una diferencia mayor que las incertidumbres de ambos; el veredicto sigue el procedimiento.
diagnostic-drops-that-decide = { $drops } ensayos con esta media y esta dispersión decidirían.
diagnostic-no-drops-decide = Más ensayos no decidirían: lo que comparten todos, como la altura de caída y el tiempo de contacto, es demasiado incierto.
diagnostic-rule-needs-height = La regla no indica altura, y la altura de caída no se indicó.
diagnostic-limit-within-uncertainty = Un límite está dentro de la incertidumbre; ayudarían más ensayos, o mejores.
diagnostic-rule-unverified = Esta regla se escribió de memoria; no te fíes de ella.
diagnostic-formula-unverified = No se leyó el texto de la fórmula de esta regla ({ $read }).
diagnostic-rule-other-ball = La regla es para una pelota del tipo { $ball }, y la pelota indicada tiene otra masa u otro diámetro: ¿es la regla correcta?
diagnostic-rule-without-point = La regla no indica en qué punto de la pelota mide; se toma el más bajo.
diagnostic-verdict-of-few-drops = { $drops ->
    [one] El veredicto es de este único ensayo: no muestra la dispersión entre ensayos; tres o más lo harían.
   *[other] Dos ensayos apenas muestran la dispersión entre ensayos, así que su media es incierta; un tercero ayudaría mucho.
  }
