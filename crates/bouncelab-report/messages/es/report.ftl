report-made-by = Informe de bouncelab { $version }
report-made-on = Informe de bouncelab { $version }, { $date }
report-note = Nota
report-page = Página { $page } de { $pages }
report-figure = Figura
report-details = Detalles

report-drop = El ensayo
report-drop-of = Ensayo { $number } de { $count }
report-drops = Los ensayos
report-no-drop = No se halló ningún ensayo: { $reason }
report-no-reason = nada rebota en él.
report-drops-found = Se hallaron { $drops } ensayos con { $impacts } impactos.
report-first-drops = Los primeros { $count } ensayos tienen sus propias secciones abajo; los resultados para programas los tienen todos.

report-impacts = { $count ->
    [one] Se detectó un impacto, en { $first } s
   *[other] Se detectaron { $count } impactos de { $first } s a { $last } s
  }, { $uncertain ->
    [0] ninguno de ellos dudoso.
    [one] uno de ellos dudoso.
   *[other] { $uncertain } de ellos dudosos.
  }

report-answers = Inferencia con aire, y ajuste log-lineal sin aire
report-quantities = Otras magnitudes
report-quantities-table = Otras magnitudes, con el método de cada una
report-impacts-heading = Los impactos
report-impacts-table = Impactos con el vuelo siguiente, y restitución sin y con corrección del arrastre (? señala los impactos dudosos)
report-line-heading = El ajuste log-lineal
report-line-flights = Usa { $count ->
    [one] un vuelo.
   *[other] { $count } vuelos.
  }
report-line-fits = Usa { $count } vuelos; su coeficiente de determinación es { $determination }.
report-no-line = No hay ajuste: { $reason }

report-uncertainty = Balance de incertidumbre
report-budget-restitution = Balance del coeficiente de restitución
report-budget-drop-height = Balance de la altura de caída
report-laws = Comparación de las leyes
report-laws-table = Leyes, con igual probabilidad a priori
report-contraction = Lo que determina esta grabación
report-correlations = Correlaciones de las estimaciones
report-uninformative = { $unknown }: los datos casi no añaden información a la distribución a priori.
report-little-informative = { $unknown }: los datos añaden algo de información; queda el { $left } % de la incertidumbre a priori.
report-informative = { $unknown }: queda determinado por los datos; queda el { $left } % de la incertidumbre a priori.
report-fit = Bondad del ajuste
report-fit-table = Impactos en la inferencia: pérdidas de energía, residuo y peso en el ajuste
report-sampling = El muestreo tiene { $draws } extracciones efectivas; su índice de Pareto es { $shape } (bueno por debajo de 0,7).

report-air = El aire a estas velocidades
report-conditions = Condiciones y supuestos
report-assumed = No indicado, y por tanto supuesto:
report-priors = Distribuciones a priori de la inferencia
report-source = Fuente
report-source-times = { $origin ->
    [none] una lista de tiempos de impacto
   *[other] una lista de tiempos de impacto: { $origin }
  }
report-source-sound = { $format }, { $rate } kHz, { $duration } s
report-samples = muestras
report-microphone = micrófono
report-channel = Canal
report-channel-of = { $channel } de { $count }
report-onsets = Sonidos sobre el ruido
report-ball = Pelota
report-mass = Masa
report-diameter = Diámetro
report-contact-time = Tiempo de contacto
report-gravity = Gravedad
report-air-density = Densidad del aire
report-drag-law = Ley de arrastre
report-displaced-air = Empuje y masa añadida
report-displaced-air-both = ambos tenidos en cuenta
report-displaced-air-buoyancy = solo el empuje
report-displaced-air-added-mass = solo la masa añadida
report-displaced-air-none = no se cuentan
report-measured-height = Altura de caída medida
report-release = Suelta, en la grabación
report-sampler = Muestreo
report-sampler-draws = { $draws } extracciones, semilla { $seed }

report-repeat = Para repetir esto
report-repeat-version = La versión { $version } de bouncelab da los mismos números con el mismo archivo y los mismos ajustes; los números aleatorios de la inferencia tienen una semilla.
report-repeat-files = Los archivos leídos, con su SHA-256 (sha256sum lo muestra):

report-method = Método
report-method-short = Los impactos se detectan en el sonido; el tiempo entre dos de ellos es el de un vuelo. La inferencia calcula la distribución a posteriori de la restitución, la altura de caída y el arrastre a partir de todos los tiempos de vuelo, con la caída en el aire, una restitución que varía de impacto a impacto y errores de los tiempos. Cada magnitud se da como mediana ± desviación típica de su distribución a posteriori; un intervalo de credibilidad del 95 % contiene el valor verdadero con esa probabilidad si se cumplen los supuestos. El ajuste log-lineal es una recta por los logaritmos de los tiempos de vuelo y no cuenta el aire. La restitución se da a la velocidad del primer impacto detectado y a una velocidad redonda, porque la de la mayoría de las pelotas cambia con la velocidad. Sin una altura de caída indicada, la altura de caída es la de la caída antes del primer impacto detectado; los tiempos no muestran si antes se perdieron impactos. Un solo ensayo apenas mide el arrastre: su coeficiente es sobre todo el que se conoce de las esferas, y los intervalos incluyen su incertidumbre y la de una restitución que cambia con la velocidad de manera desconocida. Las fórmulas y las referencias están en «Detalles».

report-formulas = El método y sus fórmulas
report-method-flight = Solo los impactos suenan. El tiempo T entre dos impactos es el de un vuelo, y da su altura h casi independientemente del aire:
report-method-line = Si cada impacto conservara la misma fracción e de la velocidad y no hubiera aire, los logaritmos de los tiempos de vuelo estarían sobre una recta frente al número n del impacto. Su pendiente da el coeficiente de restitución e, y su ordenada en el origen b la altura de caída (Nagurka, ec. 4 y 6):
report-method-motion = El arrastre también reduce la velocidad, el empuje se opone al peso y la pelota acelera parte del aire (masa añadida). Con la masa m, el volumen V y la sección A de la pelota, la densidad ρ del aire y un coeficiente de arrastre que depende del número de Reynolds, la velocidad v cambia así:
report-method-restitution = De cada tiempo de vuelo se obtienen la velocidad v con que la pelota dejó la superficie y la velocidad v′ con que volvió, y de dos vuelos vecinos la restitución del impacto entre ellos:
report-method-noise = Se modelan dos clases de ruido: la restitución varía de impacto a impacto con una desviación típica relativa σₑ, y los tiempos tienen errores σₜ, que los impactos vecinos comparten por las derivadas J. Los impactos atípicos pesan menos (t de Student).
report-method-posterior = La inferencia calcula la distribución a posteriori de todas las incógnitas θ, dados los tiempos t y las distribuciones a priori, con cada ley de restitución y de arrastre M. Cada magnitud se da como mediana ± desviación típica de su distribución a posteriori; un intervalo de credibilidad del 95 % contiene el valor verdadero con esa probabilidad si se cumplen los supuestos.
report-references = Referencias:
report-reference-drag = { $work }: la curva de arrastre habitual.
report-reference-scatter = { $work }: la dispersión de los impactos.
