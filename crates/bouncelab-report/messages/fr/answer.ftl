# Ce qu’une personne lit d’abord d’un essai : la réponse, ou pourquoi il n’y en a pas.

answer-kept-first = À { $speed }, la vitesse du premier impact détecté, la balle garde { $share } de sa vitesse, soit { $energy } de son énergie.
answer-kept-asked = À { $speed }, la balle garde { $share } de sa vitesse ; au premier impact détecté, elle a gardé { $energy } de son énergie.
answer-kept-always = La balle garde { $share } de sa vitesse à chaque rebond, de { $fastest } jusqu’à { $slowest }, soit { $energy } de son énergie.
answer-round = À { $speed }, elle garde { $share }.
answer-fell = Elle est tombée de { $height }.
answer-fell-first = Elle est tombée de { $height } avant le premier impact détecté.
answer-height-stated = La hauteur de chute est de { $height }, d’après les temps et la hauteur indiquée.
answer-median = La balle a gardé { $share } de sa vitesse, la médiane de ses impacts de { $fastest } jusqu’à { $slowest }, corrigée de la traînée.
answer-median-too-few = Il n’y a pas de médiane : { $count } des impacts sont entre deux vols, et il en faut 3.
answer-none = La restitution et la hauteur de chute ne peuvent pas être données. { $reason }
answer-ball = Ces nombres valent pour cette balle : { $ball }.
answer-ball-assumed = Ces nombres valent pour cette balle, supposée parce qu’aucune n’a été indiquée : { $ball }.
answer-line = L’ajustement log-linéaire des temps de vol, qui néglige l’air, donne { $share } et une hauteur de chute de { $height }.
answer-line-agrees = L’ajustement log-linéaire des temps de vol, qui néglige l’air, donne la même chose dans la limite de l’incertitude : { $share } et une hauteur de chute de { $height }.
answer-line-differs = L’ajustement log-linéaire des temps de vol, qui néglige l’air, donne { $share } là où les impacts corrigés de la traînée donnent { $corrected }, et une hauteur de chute de { $height }.
