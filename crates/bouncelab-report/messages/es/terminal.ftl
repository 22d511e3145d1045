terminal-note = Nota: { $text }
terminal-assumed = Supuesto: { $list }
analyze-balls-heading = Lo que los tiempos dicen de cada pelota, frente a la indicada o supuesta:
terminal-cannot-tell = { $what }: indeterminado: { $reason }

analyze-times = { $origin ->
    [none] { $name }: tiempos de impacto
   *[other] { $name }: tiempos de impacto, { $origin }
  }
analyze-sound = { $name }: { $format }, { $rate } kHz{ $channels ->
    [1] {""}
   *[other] , canal { $channel } de { $channels }
  }, { $duration } s
analyze-listening = { $onsets } sonidos destacan sobre el ruido de fondo y se detectaron { $impacts } impactos, con el mayor contraste de { $low } a { $high } Hz, { $above } dB sobre el sonido anterior (--channel, --band).
analyze-drop = { $drops ->
    [1] Ensayo
   *[other] Ensayo { $number } de { $drops }
  }: { $count } impactos de { $first } s a { $last } s{ $uncertain ->
    [0] {""}
    [1] , 1 dudoso (?)
   *[other] , { $uncertain } dudosos (?)
  }{ $probability ->
    [none] {""}
   *[other] {" "}(un ensayo con probabilidad { $probability })
  }
analyze-line = Ajuste log-lineal
analyze-line-heading = Ajuste log-lineal de los tiempos de vuelo, sin contar el aire:
analyze-corrected = Corregido por arrastre
analyze-corrected-heading = Corregido por arrastre ({ $law }):
analyze-inference-heading = Inferencia, con aire:

analyze-details-models = Modelos, con igual probabilidad a priori:
analyze-details-budget-restitution = Balance de incertidumbre de e:
analyze-details-budget-height = Balance de incertidumbre de h0:
analyze-details-contraction = Reducción de lo a priori por los datos:
analyze-details-correlations = Correlaciones de las estimaciones:
analyze-details-impacts = Impactos en el ajuste:
analyze-details-priors = Distribuciones a priori:
analyze-details-sampling = Muestreo: { $draws } extracciones independientes, índice de Pareto { $shape } (bueno por debajo de 0,7).
analyze-no-drop = { $name }: no se halló ningún ensayo: { $reason }
analyze-detecting = detectando { $bar } { $done } s, quedan { $left }
analyze-inferring = inferencia a partir de { $impacts } impactos (--no-inference la omite)
analyze-one-report = un informe es de una grabación, y se dieron varias; bouncelab session informa sobre varias
analyze-cues-of-file = --cues copia una grabación, así que necesita un archivo en lugar de la entrada estándar
analyze-input-too-long = la entrada estándar supera 1 GiB, que se guarda en memoria; guárdala en un archivo
analyze-one-labelled = etiquetas, marcas y movimiento son de una grabación, y se dieron varias; da una cada vez
analyze-cues-need-sound = { $name } es una lista de tiempos, sin sonido que marcar; --format audacity o textgrid escribe etiquetas

terminal-wrote = escrito: { $file }
terminal-not-printed = { $browser } no imprimió el informe: { $reason }
terminal-no-browser = Un PDF lo imprime Chromium, Chrome o Edge, y no se encontró ninguno. Instala uno, o escribe el informe como .html e imprímelo.
terminal-wrote-figure = escrito: { $file }, .png, .pdf y .csv
terminal-first-figures = Los primeros { $count } ensayos tienen figuras propias; los resultados para programas los tienen todos.
terminal-all-shown = ... y { $count } más; --format csv los tiene todos.

demo-heading = Un ensayo desde 30,5 cm, sintetizado, detectado y analizado ({ $file })
demo-truth = verdadero
demo-detected = medido
demo-flight-time-error = mayor error de un tiempo de vuelo
demo-restitution-line = e, ajuste log-lineal, 10 vuelos
demo-restitution-inference = e, inferencia
demo-height-line = altura de caída, ajuste log-lineal
demo-height-inference = altura de caída, inferencia
demo-second-speed = velocidad del segundo impacto
demo-conclusion =
    El ajuste log-lineal no cuenta el arrastre: su restitución y su altura son demasiado bajas.
    La inferencia tiene en cuenta el aire y recupera ambas.

simulate-heading = Una caída ({ $ball }), simulada
simulate-bounces = rebotes
simulate-first-speed = velocidad del primer impacto
simulate-no-terminal-speed = ninguna
simulate-total-time = tiempo hasta el final
simulate-total-path = recorrido hasta el final
simulate-initial-energy = energía al principio
simulate-lost-to-surface = cedida a la superficie
simulate-lost-to-air = cedida al aire
simulate-each-bounce = Cada rebote, arrastre { $law }:
simulate-bounce = rebote
simulate-to-surface = al suelo µJ
simulate-to-air = al aire µJ
simulate-drag = arrastre { $law }

synth-made = { $file }: { $count ->
    [one] 1 impacto
   *[other] { $count } impactos
  } en { $seconds } s, { $rate } Hz, semilla { $seed }

puzzle-question = La discrepancia: ¿qué hace que el ajuste log-lineal dé e = 0,9375 y h0 = 26,7 cm en una caída desde 30,5 cm?
puzzle-flights = vuelos
puzzle-first = e a 2,4 m/s
puzzle-slow = e a 0,5 m/s
puzzle-height = h0 ajustada cm
puzzle-solved = ¿26,7 del artículo?
puzzle-yes = sí
puzzle-no = no
puzzle-answer =
    Cada ley se eligió de modo que el ajuste dé e = 0,9375; los codos están a 1,5 m/s. El arrastre con restitución constante
    da 26,7 cm solo con unos 21 vuelos en el ajuste; con diez vuelos la restitución debe además
    decrecer con la velocidad. El ajuste log-lineal no puede distinguir los dos casos, porque su
    resultado depende del número de vuelos.
puzzle-quantity = magnitud
puzzle-printed = impreso
puzzle-computed = calculado
puzzle-verdict = veredicto

job-check-failed = La comprobación del método falló: el programa no halla lo que se conoce. No se creó ningún encargo.
job-no-drop-added = No se añadió ningún ensayo al encargo.
job-damaged = { $count ->
    [one] Una línea de { $file } está dañada y no cuenta; `bouncelab job show` nombra cada sonido sin línea.
   *[other] { $count } líneas de { $file } están dañadas y no cuentan; `bouncelab job show` nombra cada sonido sin línea.
}
job-uncounted = { $file } se conserva pero no cuenta: no quedó anotado, como tras una interrupción. Si su ensayo está completo, { $command } lo cuenta.

balls-numbers = { $ball }, contacto { $contact }
balls-words = también: { $words }

listen-begins = escuchando { $source }, { $rate } kHz, { $channels ->
    [one] 1 canal
   *[other] { $channels } canales
  }; { $file ->
    [none] no se guarda nada
   *[other] se guarda en { $file } según llega
  }
listen-saved-in = guardado en { $file }
listen-not-saved = NO GUARDADO
listen-silence = el micrófono solo da silencio: ¿está silenciado, o no es el correcto (--devices)?
listen-fault = el análisis falló por un error del programa; comunícalo, por favor
listen-goes-on = La grabación sigue hasta que la termines tú.
listen-lost = se perdió sonido: el ordenador fue demasiado lento, o el micrófono tuvo un fallo; los vuelos que cruzan el hueco se excluyen
listen-lost-in-all = se perdieron { $frames } muestras de cada canal ({ $seconds } s) en { $count ->
    [one] 1 lugar
   *[other] { $count } lugares
  }
listen-lacks-sound = no se guardó todo el sonido: donde se perdió, el archivo tiene silencio y lo indica
listen-not-analysed = no se puede analizar un ensayo: { $reason }
listen-once-more = ensayo { $number } otra vez, con toda la grabación
listen-heading = ensayo { $number }
listen-all-drops = Todos los ensayos:
listen-saved = el sonido está en { $file }; para analizarlo otra vez: { $command }
listen-left-out = el ensayo en { $start } s { $reason ->
    [distant] es de una pelota mucho más débil que las otras
   *[unlikely] no lo confirma toda la grabación
  } y se excluye
listen-impact = ensayo { $drop }: impacto { $impact } en { $time } s tras { $flight } ms{ $rests ->
    [yes] ; la pelota está en reposo
   *[no] {""}
  }
listen-line = e = { $restitution }, h0 = { $height } sin contar el aire
listen-corrected = e = { $restitution } corregido por arrastre
listen-too-loud = DEMASIADO FUERTE: recortado
listen-level = nivel
listen-seconds = { $seconds } s
listen-drops = { $count ->
    [one] 1 ensayo
   *[other] { $count } ensayos
  }
listen-sounds = { $count ->
    [one] 1 sonido
   *[other] { $count } sonidos
  }
listen-lost-so-far = { $count } muestras PERDIDAS
listen-ends = Ctrl-C para
listen-at = en s
listen-e-line = e, sin aire
listen-h0-line = h0, sin aire
listen-mean = media
listen-scatter = dispersión
listen-save-failed = no se pudo guardar el sonido: { $fault }; { $seconds } s están en el archivo. La escucha sigue
listen-end-not-saved = puede faltar en el archivo el final del sonido: { $fault }
listen-device = nombre
listen-device-kind = qué es
listen-device-default = por defecto

session-ball-assumed = El arrastre depende de la pelota, que no se indicó: indícala con --ball, en los nombres de las grabaciones o en session.toml.
session-title = Serie
session-speed = Restitución a una velocidad de impacto de { $speed } m/s:
session-legend =
    ±: incertidumbre típica; común: la parte que comparten todos los ensayos (arrastre, aire, pelota,
    operadores) y que más ensayos no reducen; entre ensayos: dispersión más allá de sus propios errores; { $wanted ->
        [none] hacen falta: ensayos en total que reducirían el intervalo a la mitad
       *[other] hacen falta: ensayos en total para una restitución conocida a ± { $wanted } (95 %)
      }
session-intervals = Intervalos del 95 %, y las desviaciones típicas de ISO 5725:
session-scatters = Dispersión además de la de los ensayos, relativa:
session-curves = Restitución frente a la velocidad de impacto:
session-drop-heights = Alturas de caída:
session-outliers = Valores atípicos de su grupo; ¿son correctos sus metadatos?
session-outlier = { $name }: { $off } { $side ->
    [above] por encima
   *[below] por debajo
  } de los demás de { $group }, { $score } desviaciones típicas
session-outliers-count = Están incluidos en todos los resultados anteriores. Con ellos y sin ellos:
session-exclude = --exclude NAME excluye uno de todo.
session-differences = Diferencias entre grupos:
session-more = y { $count } más (--details)
session-tables = Tablas: { $list }
session-no-drop = ninguna grabación contiene un ensayo
session-damaged-journal = { $count } líneas del diario están truncadas o dañadas, y no se tienen en cuenta
session-died = su análisis terminó su proceso dos veces, la segunda a solas ({ $how }); si es larga, dale más --memory, y si no, comunícalo, por favor
session-unmatched-names = { $count ->
    [one] 1 nombre no se ajusta
   *[other] { $count } nombres no se ajustan
  } al patrón «{ $pattern }»: { $names }
session-noted-otherwise = { $first } y { $other } son el mismo sonido, pero { $field } es { $of-first } en uno y { $of-other } en el otro; vale lo anotado del primero
session-not-noted = sin anotar
session-by-hand = excluido a mano
session-inference-left-out = los ensayos se comparan por la inferencia, que se omitió (--no-inference)
session-progress = analizando { $bar } { $done } grabaciones, { $rate }, quedan { $left }
session-known = { $kept } de { $all } grabaciones se analizaron en una ejecución anterior
session-out-of-time = su análisis tomó más de { $seconds } s de tiempo de procesador; dale más con --time-limit, o pide menos: menos --draws, una grabación más corta
session-restitution = Restitución

serve-address = El laboratorio está en { $address } (Ctrl-C lo termina)
serve-no-browser = no se pudo abrir ningún navegador ({ $reason }); abre { $address } tú
page-written = Hay { $files } archivos en { $folder }. Si un servidor los envía por https, los teléfonos pueden usar el micrófono.
