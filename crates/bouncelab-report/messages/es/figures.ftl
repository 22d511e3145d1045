axis-amplitude = amplitud, relativa al fondo de escala
axis-bounce = rebote
axis-drag = arrastre / peso
axis-drag-coefficient = coeficiente de arrastre
axis-drop = ensayo
axis-drop-height = altura de caída
axis-energy-lost = energía perdida
axis-flight = número del vuelo
axis-flight-time = tiempo de vuelo
axis-height = altura
axis-impact = impacto
axis-impact-speed = velocidad de impacto
axis-off-line = residuo del ajuste
axis-rebound = altura de rebote
axis-restitution = restitución: velocidad después / antes
axis-restitution-at = restitución a { $speed }
axis-restitution-short = restitución
axis-share-of-reference = parte de la referencia
axis-speed = velocidad
axis-time = tiempo

figure-bounce-energies-title = ¿Adónde va la energía?
figure-bounce-energies-tab = Energía
figure-bounce-energies-caption = La energía perdida en cada impacto y, encima, la que se lleva el aire en el vuelo siguiente: cuanto más rápida es la pelota, mayor es la parte del aire.
figure-bounce-energies-empty = No hay energías que mostrar.
figure-bounce-energies-air = el aire, en el vuelo siguiente
figure-bounce-energies-surface = el impacto

figure-bounce-heights-title = ¿Qué altura alcanza cada rebote?
figure-bounce-heights-tab = Alturas
figure-bounce-heights-caption = Cada rebote alcanza más o menos la misma fracción de la altura anterior, de modo que los puntos quedan cerca de una recta.
figure-bounce-heights-empty = No hay alturas que mostrar.

figure-budget-title = De dónde viene la incertidumbre
figure-budget-tab = Balance
figure-budget-caption = Cada barra es la parte de una fuente en la varianza: para conocer mejor la pelota, reduce la fuente de arriba.
figure-budget-empty = No hay incertidumbre que mostrar.
figure-budget-axis = parte de la varianza
figure-budget-drop-height = altura de caída: { $value }
figure-budget-others = todas las demás
figure-budget-restitution = restitución: { $value }

figure-calibration-title = Dónde está el valor verdadero entre las extracciones
figure-calibration-caption = Barras planas: los intervalos están bien calibrados. Una loma indicaría intervalos demasiado anchos, un valle demasiado estrechos, una pendiente un sesgo.
figure-calibration-empty = No hay rangos que mostrar.
figure-calibration-drops = ensayos simulados
figure-calibration-expected = el 99 % de las barras acaba aquí si hay calibración
figure-calibration-rank = rango del valor verdadero

figure-comparison-title = El ensayo y su simulación
figure-comparison-tab = Comparar
figure-comparison-caption = Donde las curvas se separan, el modelo es incompleto o un impacto es otro sonido.
figure-comparison-empty = No hay alturas que mostrar.
figure-comparison-best-fit = simulada, con 95 %
figure-comparison-measured = medido
figure-comparison-simulation = tu simulación

figure-detection-found-title = Impactos hallados en el ruido
figure-detection-found-caption = F1 vale 1 donde se halla cada impacto tan fuerte como el ruido y nada más.
figure-detection-found-empty = No hay nada que comparar: ninguna curva tiene puntos.
figure-detection-found-axis = F1
figure-detection-found-loudness = impacto más fuerte sobre el ruido

figure-detection-late-title = Los impactos débiles no se sitúan más tarde que los fuertes
figure-detection-late-caption = La primera muestra por encima de un umbral fijo llega más tarde cuanto más débil es el impacto; el mejor ajuste de toda la forma de onda no depende del nivel.
figure-detection-late-empty = No hay nada que comparar: ninguna curva tiene puntos.
figure-detection-late-axis = retraso respecto al más fuerte
figure-detection-late-loudness = impacto sobre el ruido

figure-detection-stated-title = Errores de los tiempos de vuelo y errores típicos declarados
figure-detection-stated-caption = El 68 % de los errores normales es menor que un error típico.
figure-detection-stated-empty = No hay nada que comparar: ninguna curva tiene puntos.
figure-detection-stated-axis = dentro de un error típico
figure-detection-stated-loudness = impacto más fuerte sobre el ruido

figure-detection-timing-title = Errores de los tiempos de vuelo y cota de Cramér-Rao
figure-detection-timing-caption = La cota de Cramér-Rao es el menor error con el que se puede situar en el tiempo un sonido conocido en ruido blanco.
figure-detection-timing-empty = No hay nada que comparar: ninguna curva tiene puntos.
figure-detection-timing-axis = error mediano relativo a la cota
figure-detection-timing-loudness = impacto más fuerte sobre el ruido

figure-drag-title = Arrastre del aire relativo al peso
figure-drag-tab = Arrastre
figure-drag-caption = El arrastre crece casi con el cuadrado de la velocidad y equilibra el peso a la velocidad terminal, donde la curva llega a 1.
figure-drag-reached = El arrastre crece casi con el cuadrado de la velocidad y equilibra el peso a la velocidad terminal, donde la curva llega a 1; este ensayo alcanzó { $speed }.
figure-drag-empty = No hay curvas de arrastre que mostrar.
figure-drag-fastest = este ensayo: hasta { $speed }

figure-drag-log-title = Arrastre del aire relativo al peso
figure-drag-log-tab = Arrastre (log)
figure-drag-log-caption = Un coeficiente de arrastre constante es aquí una recta; las leyes difieren a baja velocidad, donde el arrastre es demasiado pequeño para importar.
figure-drag-log-reached = Un coeficiente de arrastre constante es aquí una recta; las leyes difieren a baja velocidad, donde el arrastre es demasiado pequeño para importar; este ensayo alcanzó { $speed }.
figure-drag-log-empty = No hay curvas de arrastre que mostrar.

figure-flight-times-title = Tiempos de vuelo y ajuste log-lineal
figure-flight-times-tab = Con aire y sin aire
figure-flight-times-caption = Sin aire, cada vuelo duraría la misma fracción del anterior, { $ratio } según el ajuste; una curvatura en el panel inferior revela el arrastre, o una restitución que cambia con la velocidad.
figure-flight-times-no-line = { $count ->
    [one] 1 vuelo
   *[other] { $count } vuelos
}, sin ajuste.
figure-flight-times-empty = No hay vuelos que mostrar.
figure-flight-times-line = ajuste log-lineal: × { $ratio } cada vez
figure-flight-times-all = vuelos medidos
figure-flight-times-unused = no usados
figure-flight-times-used = vuelos usados

figure-groups-title = Restitución de cada grupo según la velocidad
figure-groups-caption = Cada punto es un impacto; cada línea es la curva de un grupo, con su intervalo del 95 %.
figure-groups-more = Se muestran los primeros { $shown } de { $all } grupos.
figure-groups-empty = No hay impactos de restitución conocida.

figure-height-title = Altura de la pelota
figure-height-tab = Altura
figure-height-caption = Cada rebote es más bajo y más corto que el anterior, de modo que infinitos rebotes caben en un tiempo finito.
figure-height-caption-apexes = Cada rebote es más bajo y más corto que el anterior; los puntos son las alturas máximas medidas.
figure-height-caption-models = Los modelos empiezan igual y se separan con el tiempo, porque un vuelo más bajo es también más corto.
figure-height-empty = No hay alturas que mostrar.
figure-height-apexes = alturas máximas medidas
figure-height-model = modelo de vuelo, arrastre: { $drag }

figure-intervals-title = Restitución de cada grupo
figure-intervals-caption = Donde las barras oscuras de dos grupos están lejos, los grupos difieren; donde una está dentro de la barra clara de otro, ensayos aislados no los distinguen.
figure-intervals-empty = No hay grupos que comparar.
figure-intervals-count = { $count ->
    [one] 1 ensayo
   *[other] { $count } ensayos
}
figure-intervals-drops = ensayos
figure-intervals-mean = restitución, 95 %
figure-intervals-next = ensayo siguiente, 95 %
figure-intervals-outliers = valor atípico

figure-limits-title = La altura de rebote y los límites
figure-limits-caption = Un valor cuya barra está entre los límites los cumple con una probabilidad del 95 % o más.
figure-limits-empty = No hay valor que comparar con los límites.
figure-limits-accepted = aceptado con esta incertidumbre
figure-limits-interval = 95 %
figure-limits-within = dentro de los límites

figure-models-title = ¿Qué ley es la más probable?
figure-models-tab = Leyes
figure-models-caption = Cuanto más larga la barra, más probable la ley; donde ninguna domina, el resultado es una media de todas.
figure-models-empty = No hay modelos que comparar.
figure-models-interval = altura de caída, 68 %
figure-models-probability = probabilidad

figure-posterior-title = Distribución a posteriori conjunta
figure-posterior-tab = Distribución
figure-posterior-caption = Una nube redonda: los datos separan las dos magnitudes. Una inclinada: están correlacionadas. Un histograma tan ancho como la curva gris: los datos no añaden información a la distribución a priori.
figure-posterior-empty = No hay magnitudes que mostrar.
figure-posterior-posterior = después de los datos: 68 % oscuro, 95 % claro
figure-posterior-prior = antes de los datos

figure-residuals-title = Residuo de cada impacto
figure-residuals-tab = Residuos
figure-residuals-caption = Dos de cada tres impactos deberían estar en la banda oscura, 19 de cada 20 en la clara; un impacto muy fuera dio en un borde, o es otro sonido.
figure-residuals-empty = No hay residuos que mostrar.
figure-residuals-axis = residuo (desviaciones típicas)
figure-residuals-impact = impacto
figure-residuals-odd = atípico, pesa menos

figure-restitution-title = Restitución de cada impacto
figure-restitution-tab = Restitución
figure-restitution-caption = La restitución es la velocidad después de un impacto entre la velocidad antes. La separación entre gris y azul se debe al aire; el ajuste log-lineal la atribuye al impacto.
figure-restitution-empty = No hay impactos de restitución conocida.
figure-restitution-corrected = corregida por arrastre
figure-restitution-law = ley ajustada, 68 y 95 %
figure-restitution-line = ajuste log-lineal: { $value }
figure-restitution-odd = atípico, pesa menos
figure-restitution-raw = sin contar el aire

figure-run-title = ¿Hay una deriva?
figure-run-caption = Nivel de cada ensayo menos la mediana de su grupo, en orden: una pendiente o un escalón significa que cambió la pelota, la superficie o el aire.
figure-run-empty = No hay ensayos que mostrar.
figure-run-off = ln e menos la mediana del grupo
figure-run-order = ensayo, en orden
figure-run-outlier = valor atípico
figure-run-unchanged = si nada cambia

figure-truncation-title = ¿Depende el resultado del número de vuelos usados?
figure-truncation-tab = Truncamiento
figure-truncation-caption = Un modelo correcto da el mismo resultado con cualquier número de vuelos; el del ajuste log-lineal cambia, porque no cuenta el aire.
figure-truncation-empty = No hay resultados que comparar.
figure-truncation-flights = vuelos usados
figure-truncation-inference = inferencia, con aire
figure-truncation-line = ajuste log-lineal
figure-truncation-stated = indicada

figure-waveform-title = El sonido y sus impactos
figure-waveform-caption = { $impacts ->
    [one] 1 impacto
   *[other] { $impacts } impactos
} de { $drops ->
    [one] un ensayo
   *[other] { $drops } ensayos
}{ $uncertain ->
    [0] {""}
    [one] {" "}(1 dudoso, abierto y naranja)
   *[other] {" "}({ $uncertain } dudosos, abiertos y naranjas)
}{ $pattern ->
    [yes] : su separación se reduce cada vez casi en la misma razón
   *[no] {""}
}.
figure-waveform-no-impacts = El sonido, en el que no se hallaron impactos.
figure-waveform-empty = No hay sonido que mostrar.
figure-waveform-drop = ensayo { $number }
figure-waveform-impact = impacto
figure-waveform-uncertain = impacto dudoso

figure-drop-impacts-title = Restitución de cada impacto, ensayo por ensayo
figure-drop-impacts-caption = Corregida por arrastre. Los ensayos de una pelota sobre una superficie deberían quedar en una sola línea.
figure-drop-impacts-more = Se muestran los últimos { $shown } de { $all } ensayos.
figure-drop-impacts-empty = No hay impactos de restitución conocida.

figure-drops-title = Restitución de cada ensayo
figure-drops-caption = Cuánto conserva una pelota de su velocidad, ensayo por ensayo; las barras son una desviación típica.
figure-drops-empty = No hay ensayos que mostrar.

figure-lesson-title = La altura de caída según el ajuste log-lineal
figure-lesson-caption = Sin aire, el ajuste da la altura verdadera con cualquier número de vuelos; con aire, su altura disminuye con cada vuelo más.
figure-lesson-empty = No hay vuelos que mostrar.
figure-lesson-air = con aire
figure-lesson-flights = vuelos en el ajuste
figure-lesson-height-of-line = altura de caída ajustada
figure-lesson-no-air = sin aire
figure-lesson-paper = como en el artículo
figure-lesson-truth = altura verdadera

figure-lesson-height-title = La altura con y sin aire
figure-lesson-height-caption = Dos ensayos con la misma restitución; el aire acorta el ensayo.
figure-lesson-height-empty = No hay alturas que mostrar.

figure-lesson-line-title = Tiempos de vuelo sin aire
figure-lesson-line-caption = En este eje, los vuelos que duran cada uno la misma fracción del anterior están sobre una recta.
figure-lesson-line-empty = No hay vuelos que mostrar.
figure-lesson-line-line = ajuste log-lineal

figure-run-flight-times-title = Tiempos de vuelo
figure-run-flight-times-caption = En este eje, los vuelos con restitución constante y sin aire están sobre una recta; una curvatura revela el arrastre, o una restitución que cambia con la velocidad.
figure-run-flight-times-empty = No hay vuelos que mostrar.

figure-runs-title = Altura de la pelota
figure-runs-caption = Cada rebote es más bajo y más corto que el anterior.
figure-runs-empty = No hay alturas que mostrar.
