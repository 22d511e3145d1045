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
session-compared = Los ensayos se comparan por su restitución a una velocidad de impacto de { $speed } m/s, que la mayoría cubre, corregida por arrastre.
session-unlike = Valores atípicos de su grupo, incluidos en todos los resultados: { $names }.
session-incomparable = No se puede comparar nada: { $reason }
session-groups-table = Restitución por grupo: media y su error típico, incertidumbre común, dispersión entre ensayos y entre impactos, y número de ensayos que reduciría el intervalo a la mitad
session-intervals-table = Intervalos del 95 % de la media, del ensayo siguiente y de la dispersión entre ensayos
session-without-table = Con y sin los valores atípicos de cada grupo
session-varies-table = Componentes de la varianza: desviación típica de la restitución por factor
session-differences-table = Diferencias según { $factor }, con todo lo demás igual
session-trends-table = Cambio de la restitución con los metadatos numéricos, con todo lo demás igual
session-groups = Grupos
session-against-speed = Restitución frente a la velocidad
session-what-varies = Componentes de la varianza
session-differences-heading = Diferencias
session-in-order = En orden temporal
session-troubles = Lo que no funcionó
session-conditions = Condiciones
session-assumed = No indicado, y por tanto supuesto:
session-method = Método
session-method-drop = Cada ensayo se infiere por separado: caída, arrastre, dispersión de los impactos, errores de los tiempos. Su restitución a la velocidad común tiene una incertidumbre propia (tiempos, dispersión de los impactos) y otra que comparte con todos los ensayos de la pelota (ley de arrastre, aire, masa, diámetro, tiempo de contacto). Solo la primera se promedia entre ensayos.
session-method-group = Un grupo se describe con un modelo de efectos aleatorios, una dispersión entre ensayos además del error de cada uno: máxima verosimilitud restringida (Viechtbauer 2005), error típico de Hartung y Knapp (2001) en la forma de Röver, Knapp y Friede (2015), t de Student, intervalo del perfil Q para la dispersión (Viechtbauer 2007), intervalo del ensayo siguiente (Higgins, Thompson y Spiegelhalter 2009).
session-method-factors = Las componentes de la varianza, y las diferencias con todo lo demás igual, vienen de un modelo mixto con factores aleatorios cruzados (Patterson y Thompson 1971), grados de libertad según Satterthwaite (Giesbrecht y Burns 1985); con un solo factor, según Welch (1947). Las probabilidades se ajustan al número de diferencias (Holm 1979). Los valores atípicos se identifican con puntuaciones z modificadas mayores que 3,5 (Iglewicz y Hoaglin 1993) y no se eliminan.
session-hashes = La tabla de ensayos tiene el SHA-256 de cada grabación (content_sha256).

session-column-difference = diferencia
session-column-interval = intervalo del 95 %
session-column-p-holm = p (Holm)
session-column-p = p
session-column-group = grupo
session-column-drops = ensayos
session-column-shared = común
session-column-between-drops = entre ensayos
session-column-between-impacts = entre impactos
session-column-needed = hacen falta
session-column-with = con
session-column-without = sin
session-column-factor = con
session-column-levels = niveles
session-column-slope = pendiente
session-column-mean = media
session-column-next = ensayo siguiente
session-column-count = cuántos
session-column-varies = varía según
session-per-metre = por m
session-per-kelvin = por K
session-all = todos
session-too-many = demasiados
session-drop = ensayo
session-together = { $names } (siempre juntos)
session-too-few = demasiado pocos para decirlo

session-all-drops = todos los ensayos
session-no-inference = ningún ensayo tiene una inferencia que se pueda comparar
session-no-speed = ningún ensayo conoce su restitución a { $speed } m/s: sus impactos son más lentos o más rápidos
session-unknown-there = no conoce su restitución a { $speed } m/s
session-one-drop = Un solo ensayo no dice nada de la dispersión entre ensayos, ni por tanto del intervalo de una media: suelte la pelota varias veces.
session-one-group = Todos los ensayos están en un grupo, así que no hay nada que comparar. Las diferencias necesitan dos grupos: otra pelota, otra superficie u otra persona.
session-no-curve = no conoce su restitución a ninguna velocidad: demasiado pocos impactos, o un intervalo de velocidades demasiado pequeño
groups-assumed-of-some = { $assumption } (en { $count } de { $all } grabaciones).
