column-impact = impact
column-impacts = impacts
column-drop = essai
column-start = dès s
column-time = temps s
column-flight = vol s
column-apex = sommet cm
column-speed = vitesse m/s
column-e = e
column-e-error = ± e
column-h0 = h0
column-ratio = e sans air
column-time-error = ± temps µs
column-level = niveau dB
column-probability = probabilité
column-line = résidu %
column-law = loi de restitution
column-drag = traînée
column-evidence = ln évidence
column-ball = balle
column-bayes-factor = ln facteur de Bayes
column-source = source
column-alone = seule
column-variance = % de la variance
column-unknown = inconnue
column-width-left = % restant de l’a priori
column-to-surface = au sol mJ
column-to-air = à l’air mJ
column-residual = résidu
column-weight = poids
column-inference = inférence, avec air
column-plain = g T²/8
column-95 = 95 %
column-straight-line = ajustement log-linéaire, sans air
column-corrected = corrigé de la traînée

quantity-restitution = coefficient de restitution
quantity-drop-height = hauteur de chute
quantity-energy-kept = énergie conservée
quantity-drag = coefficient de traînée
quantity-terminal-speed = vitesse limite de chute
quantity-gravity = pesanteur
quantity-total-time = durée jusqu’au repos
quantity-total-path = trajet jusqu’au repos
quantity-slope = pente de la restitution
quantity-scatter = dispersion de la restitution
quantity-timing = erreurs des temps
quantity-contact-time = durée de contact
quantity-height-to-reach = le rebond { $bounce } atteint { $apex } depuis

quantity-interval = 95 % : { $interval }
quantity-at-speed = { $quantity } à { $speed }
quantity-of-impacts = médiane de { $count } impacts de { $slowest } à { $fastest } m/s
quantity-of-flights = avant le premier impact détecté ; { $count ->
    [one] { $count } vol
   *[other] { $count } vols
  }
quantity-first-fall = avant le premier impact détecté
quantity-stated = indiquée
quantity-missed = impacts manqués avant : { $list }
quantity-before-data = { $value } avant les données
quantity-known = pris comme connu

source-impact-timing = datation des impacts
source-restitution-scatter = dispersion de la restitution
source-release-time = instant du lâcher
source-restitution-slope = pente de la restitution
source-measured-height = hauteur mesurée
source-drag-law = loi de traînée
source-contact-time = durée de contact
source-gravity = pesanteur
source-air-density = masse volumique de l’air
source-ball-mass = masse de la balle
source-ball-diameter = diamètre de la balle
source-added-mass = masse ajoutée
source-choice-of-ball = quelle balle c’est
source-choice-of-law = choix de la loi
source-number-of-impacts = nombre d’impacts

drag-none = aucune
drag-constant = C_D = { $coefficient }
drag-standard = courbe standard d’une sphère
drag-table = table fournie
