paper-chapter-numbers = Les nombres de l’article
paper-chapter-series = Restitution, temps et distance sans traînée
paper-chapter-equations = Les équations telles qu’imprimées, et telles qu’elles doivent être
paper-chapter-beyond = Résultats au-delà de l’article
paper-chapter-flights = Un essai dont l’ajustement log-linéaire est celui de l’article : e = 0,9529 avec traînée
paper-weight = poids
paper-buoyancy = poussée d’Archimède
paper-buoyancy-note = elle fixe la masse volumique de l’air, 1,2276 kg/m³
paper-buoyancy-over-weight = poussée d’Archimède sur poids
paper-first-impact = premier impact, sans traînée
paper-reynolds-number = nombre de Reynolds à cet instant
paper-reynolds-number-note = pas turbulent comme imprimé : sous la crise de traînée, couche limite laminaire
paper-terminal-speed = vitesse limite, C_D = 0,4
paper-terminal-speed-note = 9,385 est à la limite de l’arrondi
paper-first-impact-with-drag = premier impact, C_D = 0,4 (éq. 15)
paper-drag-over-weight = traînée sur poids à 2,4 m/s, C_D(Re)
paper-drag-over-weight-note = l’article a lu sa courbe sur une figure
paper-terminal-speed-of-sphere = vitesse limite, C_D(Re)
paper-terminal-speed-of-sphere-note = de même
paper-rule-steel-least = e d’après le règlement, acier, minimum
paper-rule-steel-most = e d’après le règlement, acier, maximum
paper-rule-table-least = e d’après le règlement, table, minimum
paper-rule-table-most = e d’après le règlement, table, maximum
paper-height-error = erreur de h0 = 26,7 cm
paper-height-error-note = d’après les 26,7 cm arrondis ; les temps de vol ne sont pas imprimés
paper-restitution-of-time = e de 7,50 s après le premier impact
paper-restitution-of-time-note = si les 7,50 s partent du premier impact
paper-restitution-of-total-time = e de 7,50 s après le lâcher (éq. 7)
paper-restitution-of-total-time-note = l’éq. 7 part du lâcher
paper-total-path = trajet jusqu’au repos pour e = 0,94 (éq. 8)
paper-equation-6-printed = h0 par l’éq. 6 telle qu’imprimée : g 10^b/8
paper-equation-6-printed-note = 10^b = 2 v0/g est à mettre au carré
paper-equation-6 = h0 par l’éq. 6 corrigée : g (10^b)²/8
paper-equation-13 = éq. 13 au premier impact
paper-equation-13-note = la hauteur de chute : son membre de gauche est la distance y, et non v
paper-equation-14 = éq. 14 au premier impact
paper-equation-14-note = de même
paper-drag-twice = e de l’ajustement pour e = 0,935 avec traînée (fig. 8)
paper-drag-twice-note = la fig. 8 compte la traînée deux fois
paper-drag-twice-height = hauteur de chute de cet ajustement
paper-behind-line = e dont l’ajustement est 0,9375 avec traînée
paper-behind-line-note = sur dix vols
paper-behind-line-height = hauteur de chute de son ajustement
paper-explained = part de l’écart à 30,5 cm due à la traînée
paper-explained-note = le reste : une restitution qui décroît avec la vitesse, ou plus de vols dans l’ajustement
paper-twenty-flights-height = hauteur de chute, même e, vingt vols
paper-twenty-flights-height-note = l’ajustement dépend du nombre de vols
paper-lost-gravity = pesanteur perdue par poussée d’Archimède et masse ajoutée
paper-lost-gravity-note = poussée d’Archimède seule 1,4 % ; chaque hauteur diminue d’autant
paper-flight-time = T{ $of }
paper-time-until-rest = temps jusqu’au repos avec traînée, e = { $of }
paper-path-until-rest = trajet jusqu’au repos avec traînée, e = { $of }

paper-verdict-agrees = concorde
paper-verdict-agrees-when-corrected = concorde une fois corrigé
paper-verdict-agrees-within-reading = concorde à la lecture près
paper-verdict-misprint = coquille
paper-verdict-differs = diffère

paper-air-none = aucun
paper-air-constant = C_D = 0,4
paper-air-sphere = C_D(Re)
paper-air-all-of-air = C_D(Re), Archimède, masse ajoutée
