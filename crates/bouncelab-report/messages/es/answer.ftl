# Lo que una persona lee primero de un ensayo: la respuesta, o por qué no la hay.

answer-kept-first = A { $speed }, la velocidad del primer impacto detectado, la pelota conserva el { $share } de su velocidad, es decir, el { $energy } de su energía.
answer-kept-asked = A { $speed } la pelota conserva el { $share } de su velocidad; en el primer impacto detectado conservó el { $energy } de su energía.
answer-kept-always = La pelota conserva el { $share } de su velocidad en cada rebote, desde { $fastest } hasta { $slowest }, es decir, el { $energy } de su energía.
answer-round = A { $speed } conserva el { $share }.
answer-fell = Cayó desde { $height }.
answer-fell-first = Cayó desde { $height } antes del primer impacto detectado.
answer-height-stated = La altura de caída es { $height }, según los tiempos y la altura indicada.
answer-median = La pelota conservó el { $share } de su velocidad, la mediana de sus impactos desde { $fastest } hasta { $slowest }, corregida por arrastre.
answer-median-too-few = No hay mediana: { $count } de los impactos están entre dos vuelos, y hacen falta 3.
answer-none = La restitución y la altura de caída no se pueden dar. { $reason }
answer-ball = Los números valen para esta pelota: { $ball }.
answer-ball-assumed = Los números valen para esta pelota, que se supone porque no se indicó ninguna: { $ball }.
answer-line = El ajuste log-lineal de los tiempos de vuelo, que no cuenta el aire, da el { $share } y una altura de caída de { $height }.
answer-line-agrees = El ajuste log-lineal de los tiempos de vuelo, que no cuenta el aire, da lo mismo dentro de la incertidumbre: { $share } y una altura de caída de { $height }.
answer-line-differs = El ajuste log-lineal de los tiempos de vuelo, que no cuenta el aire, da el { $share } donde los impactos corregidos por arrastre dan el { $corrected }, y una altura de caída de { $height }.
