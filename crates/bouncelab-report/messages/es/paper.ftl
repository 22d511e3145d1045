paper-chapter-numbers = Los números del artículo
paper-chapter-series = Restitución, tiempo y distancia sin arrastre
paper-chapter-equations = Las ecuaciones como están impresas y como deben ser
paper-chapter-beyond = Resultados más allá del artículo
paper-chapter-flights = Un ensayo cuyo ajuste log-lineal es el del artículo: e = 0,9529 con arrastre
paper-weight = peso
paper-buoyancy = empuje
paper-buoyancy-note = fija la densidad del aire, 1,2276 kg/m³
paper-buoyancy-over-weight = empuje entre peso
paper-first-impact = primer impacto, sin arrastre
paper-reynolds-number = número de Reynolds allí
paper-reynolds-number-note = no es turbulento como está impreso: por debajo de la crisis de arrastre, con capa límite laminar
paper-terminal-speed = velocidad terminal, C_D = 0,4
paper-terminal-speed-note = 9,385 está en el límite del redondeo
paper-first-impact-with-drag = primer impacto, C_D = 0,4 (ec. 15)
paper-drag-over-weight = arrastre entre peso a 2,4 m/s, C_D(Re)
paper-drag-over-weight-note = el artículo leyó su curva en una figura
paper-terminal-speed-of-sphere = velocidad terminal, C_D(Re)
paper-terminal-speed-of-sphere-note = lo mismo
paper-rule-steel-least = e según el reglamento, acero, mínimo
paper-rule-steel-most = e según el reglamento, acero, máximo
paper-rule-table-least = e según el reglamento, mesa, mínimo
paper-rule-table-most = e según el reglamento, mesa, máximo
paper-height-error = error de h0 = 26,7 cm
paper-height-error-note = de los 26,7 cm redondeados; los tiempos de vuelo no están impresos
paper-restitution-of-time = e de 7,50 s tras el primer impacto
paper-restitution-of-time-note = si los 7,50 s cuentan desde el primer impacto
paper-restitution-of-total-time = e de 7,50 s tras la suelta (ec. 7)
paper-restitution-of-total-time-note = la ec. 7 cuenta desde la suelta
paper-total-path = recorrido hasta el reposo con e = 0,94 (ec. 8)
paper-equation-6-printed = h0 por la ec. 6 como está impresa: g 10^b/8
paper-equation-6-printed-note = 10^b = 2 v0/g debe elevarse al cuadrado
paper-equation-6 = h0 por la ec. 6 corregida: g (10^b)²/8
paper-equation-13 = ec. 13 en el primer impacto
paper-equation-13-note = la altura de caída: su lado izquierdo es la distancia y, no v
paper-equation-14 = ec. 14 en el primer impacto
paper-equation-14-note = lo mismo
paper-drag-twice = e del ajuste para e = 0,935 con arrastre (fig. 8)
paper-drag-twice-note = la fig. 8 cuenta el arrastre dos veces
paper-drag-twice-height = altura de caída de ese ajuste
paper-behind-line = e cuyo ajuste es 0,9375 con arrastre
paper-behind-line-note = con diez vuelos
paper-behind-line-height = altura de caída de su ajuste
paper-explained = parte de la diferencia con 30,5 cm debida al arrastre
paper-explained-note = el resto: una restitución que decrece con la velocidad, o más vuelos en el ajuste
paper-twenty-flights-height = altura de caída, mismo e, veinte vuelos
paper-twenty-flights-height-note = el ajuste depende del número de vuelos
paper-lost-gravity = gravedad perdida por empuje y masa añadida
paper-lost-gravity-note = el empuje solo, 1,4 %; cada altura se reduce igual
paper-flight-time = T{ $of }
paper-time-until-rest = tiempo hasta el reposo con arrastre, e = { $of }
paper-path-until-rest = recorrido hasta el reposo con arrastre, e = { $of }

paper-verdict-agrees = coincide
paper-verdict-agrees-when-corrected = coincide corregido
paper-verdict-agrees-within-reading = coincide según lectura
paper-verdict-misprint = errata
paper-verdict-differs = difiere

paper-air-none = ninguno
paper-air-constant = C_D = 0,4
paper-air-sphere = C_D(Re)
paper-air-all-of-air = C_D(Re), empuje, masa añadida
