column-impact = impacto
column-impacts = impactos
column-drop = ensayo
column-start = desde s
column-time = tiempo s
column-flight = vuelo s
column-apex = altura cm
column-speed = velocidad m/s
column-e = e
column-e-error = ± e
column-h0 = h0
column-ratio = e sin aire
column-time-error = ± tiempo µs
column-level = nivel dB
column-probability = probabilidad
column-line = residuo %
column-law = ley de restitución
column-drag = arrastre
column-evidence = ln evidencia
column-ball = pelota
column-bayes-factor = ln factor de Bayes
column-source = fuente
column-alone = sola
column-variance = % de la varianza
column-unknown = incógnita
column-width-left = % restante del a priori
column-to-surface = al suelo mJ
column-to-air = al aire mJ
column-residual = residuo
column-weight = peso
column-inference = inferencia, con aire
column-plain = g T²/8
column-95 = 95 %
column-straight-line = ajuste log-lineal, sin aire
column-corrected = corregido por arrastre

quantity-restitution = coeficiente de restitución
quantity-drop-height = altura de caída
quantity-energy-kept = energía conservada
quantity-drag = coeficiente de arrastre
quantity-terminal-speed = velocidad terminal
quantity-gravity = gravedad
quantity-total-time = tiempo hasta el reposo
quantity-total-path = recorrido hasta el reposo
quantity-slope = pendiente de la restitución
quantity-scatter = dispersión de la restitución
quantity-timing = errores de los tiempos
quantity-contact-time = tiempo de contacto
quantity-height-to-reach = el rebote { $bounce } alcanza { $apex } desde

quantity-interval = 95 %: { $interval }
quantity-at-speed = { $quantity } a { $speed }
quantity-of-impacts = mediana de { $count } impactos de { $slowest } a { $fastest } m/s
quantity-of-flights = antes del primer impacto detectado; { $count ->
    [one] 1 vuelo
   *[other] { $count } vuelos
  }
quantity-first-fall = antes del primer impacto detectado
quantity-stated = indicada
quantity-missed = impactos perdidos antes: { $list }
quantity-before-data = { $value } antes de los datos
quantity-known = se toma como conocido

source-impact-timing = tiempos de los impactos
source-restitution-scatter = dispersión de la restitución
source-release-time = instante de la suelta
source-restitution-slope = pendiente de la restitución
source-measured-height = altura medida
source-drag-law = ley de arrastre
source-contact-time = tiempo de contacto
source-gravity = gravedad
source-air-density = densidad del aire
source-ball-mass = masa de la pelota
source-ball-diameter = diámetro de la pelota
source-added-mass = masa añadida
source-choice-of-ball = qué pelota es
source-choice-of-law = elección de la ley
source-number-of-impacts = número de impactos

drag-none = ninguno
drag-constant = C_D = { $coefficient }
drag-standard = curva estándar de una esfera
drag-table = tabla propia
