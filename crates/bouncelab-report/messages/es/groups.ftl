session-untitled = Una serie
session-counts = { $drops ->
    [one] 1 ensayo
   *[other] { $drops } ensayos
  } en { $recordings ->
    [one] 1 grabación
   *[other] { $recordings } grabaciones
  }{ $without ->
    [0] {""}
   *[other] , { $without } sin ensayo
  }{ $failed ->
    [0] {""}
    [one] , 1 ilegible
   *[other] , { $failed } ilegibles
  }{ $duplicates ->
    [0] {""}
    [one] , 1 igual a otra
   *[other] , { $duplicates } iguales a otra
  }
session-without-drop = Sin ensayo
session-failed = Ilegibles
session-duplicates = Mismo contenido que otra grabación, que es la que se usa
session-left-out = No comparados
session-odd = Observaciones sobre los ensayos
session-unlike = Valores atípicos de su grupo, incluidos en todos los resultados: { $names }.
session-incomparable = No se puede comparar nada: { $reason }
session-groups-table = Restitución por grupo con su incertidumbre típica, la parte común a todos los ensayos, dispersión entre ensayos y entre impactos, y número de ensayos que reduciría el intervalo a la mitad
session-intervals-table = Intervalos del 95 % de la restitución, del ensayo siguiente y de la dispersión entre ensayos; desviaciones típicas de repetibilidad y reproducibilidad (ISO 5725)
session-without-table = Con y sin los valores atípicos de cada grupo
session-differences-table = Diferencias entre grupos: a la velocidad de la comparación, con la probabilidad de que sean mayores que cero, y como media sobre las velocidades que ambos tienen
session-groups = Grupos
session-against-speed = Restitución frente a la velocidad
session-differences-heading = Diferencias
session-in-order = En orden temporal
session-troubles = Lo que no funcionó
session-conditions = Condiciones
session-assumed = No indicado, y por tanto supuesto:
session-method = Método
session-method-drop = Cada ensayo se infiere por separado: caída, arrastre, dispersión de los impactos, errores de los tiempos. Su verosimilitud, sin lo supuesto de antemano, entra en un modelo de todos los ensayos a las velocidades de sus propios impactos. Lo que comparten todos los ensayos de una pelota (arrastre, aire, masa, diámetro, tiempo de contacto) conserva la incertidumbre que tiene en un solo ensayo.
session-method-group = Un grupo tiene una curva de ln e sobre ln v, un spline cúbico cuya pendiente varía al azar, en torno a la cual sus ensayos se dispersan en nivel. Dada la dispersión, esto es lineal y gaussiano; la dispersión se integra con una distribución previa exponencial de media 1 % (Simpson et al. 2017).
session-hashes = La tabla de ensayos tiene el SHA-256 de cada grabación (content_sha256).

session-column-difference = diferencia
session-column-interval = intervalo del 95 %
session-column-group = grupo
session-column-drops = ensayos
session-column-shared = común
session-column-between-drops = entre ensayos
session-column-between-impacts = entre impactos
session-column-needed = hacen falta
session-column-with = con
session-column-without = sin
session-column-mean = restitución
session-column-next = ensayo siguiente
session-column-count = cuántos
session-column-varies = varía según
session-too-many = demasiados

session-all-drops = todos los ensayos
session-no-inference = ningún ensayo tiene una inferencia que se pueda comparar
session-no-speed = ningún ensayo tiene impactos en torno a { $speed } m/s
session-one-drop = Un solo ensayo dice poco de la dispersión entre ensayos, así que el intervalo es ancho: suelta la pelota varias veces.
session-one-group = Todos los ensayos están en un grupo, así que no hay nada que comparar. Las diferencias necesitan dos grupos: otra pelota, otra superficie u otra persona.
session-no-curve = no dice nada de la curva de restitución: demasiado pocos impactos, o muestras que su covarianza no describe
groups-assumed-of-some = { $assumption } (en { $count } de { $all } grabaciones).
session-scatter-table = Dispersión de la restitución además de la de los ensayos, relativa
session-curve-table = Restitución a varias velocidades de impacto
session-heights = Alturas de caída
session-heights-table = Alturas de caída según la curva del grupo
session-ruler = Las alturas indicadas superan a las oídas en { $value } (95 %: { $interval }): el cero de la regla.
session-in-words = { $group }: restitución { $value } a { $speed } (95 %: { $interval }), de { $drops ->
    [one] 1 ensayo
   *[other] { $drops } ensayos
  }, con una dispersión de { $scatter }.
session-difference-in-words = { $of } menos { $less }: { $value } (95 %: { $interval }); es mayor que cero con una probabilidad de { $probability }.
session-method-scatter = Los operadores, y lo demás que no forma grupos, se dispersan con una distribución previa de media 0,2 %. Las diferencias se miran una a una. Son atípicos los ensayos cuyo nivel tiene una puntuación z modificada mayor que 3,5 (Iglewicz y Hoaglin 1993); no se eliminan.
session-column-drop = ensayo
session-column-repeatability = repetibilidad
session-column-reproducibility = reproducibilidad
session-column-above = mayor que cero
session-column-over = a toda velocidad
factor-ball = pelota
factor-surface = superficie
factor-operator = operador
factor-student = alumno
factor-place = lugar
