report-made-by = Rapport de bouncelab { $version }
report-made-on = Rapport de bouncelab { $version }, { $date }
report-note = Note
report-page = Page { $page } sur { $pages }
report-figure = Figure
report-details = Détails

report-drop = L’essai
report-drop-of = Essai { $number } sur { $count }
report-drops = Les essais
report-no-drop = Aucun essai trouvé : { $reason }
report-no-reason = rien n’y rebondit.
report-drops-found = { $drops } essais avec { $impacts } impacts ont été trouvés.
report-first-drops = Les { $count } premiers essais ont leurs propres sections ci-dessous ; les résultats pour programmes les ont tous.

report-impacts = { $count ->
    [1] Un impact a été détecté, à { $first } s
   *[other] { $count } impacts ont été détectés de { $first } s à { $last } s
  }, { $uncertain ->
    [0] aucun n’est incertain.
    [1] dont un incertain.
   *[other] dont { $uncertain } incertains.
  }

report-answers = Inférence avec air, et ajustement log-linéaire sans air
report-quantities = Autres grandeurs
report-quantities-table = Autres grandeurs, avec la méthode de chacune
report-impacts-heading = Les impacts
report-impacts-table = Impacts avec le vol qui suit, et restitution sans et avec correction de la traînée (« ? » signale les impacts incertains)
report-line-heading = L’ajustement log-linéaire
report-line-flights = Il utilise { $count ->
    [1] un vol.
   *[other] { $count } vols.
  }
report-line-fits = Il utilise { $count } vols ; son coefficient de détermination est de { $determination }.
report-no-line = Il n’y a pas d’ajustement : { $reason }

report-uncertainty = Bilan d’incertitude
report-budget-restitution = Bilan du coefficient de restitution
report-budget-drop-height = Bilan de la hauteur de chute
report-laws = Comparaison des lois
report-laws-table = Lois, de même probabilité a priori
report-contraction = Ce que cet enregistrement détermine
report-correlations = Corrélations des estimations
report-uninformative = { $unknown } : les données n’ajoutent presque rien à l’a priori.
report-little-informative = { $unknown } : les données ajoutent un peu d’information ; il reste { $left } % de l’incertitude a priori.
report-informative = { $unknown } : grandeur déterminée par les données ; il reste { $left } % de l’incertitude a priori.
report-fit = Qualité de l’ajustement
report-fit-table = Impacts dans l’inférence : pertes d’énergie, résidu et poids dans l’ajustement
report-sampling = L’échantillonnage a { $draws } tirages effectifs ; son indice de Pareto est de { $shape } (bon au-dessous de 0,7).

report-air = L’air à ces vitesses
report-conditions = Conditions et hypothèses
report-assumed = Non indiqué, et donc supposé :
report-priors = Lois a priori de l’inférence
report-source = Source
report-source-times = { $origin ->
    [none] une liste de temps d’impact
   *[other] une liste de temps d’impact : { $origin }
  }
report-source-sound = { $format }, { $rate } kHz, { $duration } s
report-samples = échantillons
report-microphone = microphone
report-channel = Voie
report-channel-of = { $channel } sur { $count }
report-onsets = Sons au-dessus du bruit
report-ball = Balle
report-mass = Masse
report-diameter = Diamètre
report-contact-time = Durée de contact
report-gravity = Pesanteur
report-air-density = Masse volumique de l’air
report-drag-law = Loi de traînée
report-displaced-air = Poussée d’Archimède et masse ajoutée
report-displaced-air-both = toutes deux prises en compte
report-displaced-air-buoyancy = poussée d’Archimède seulement
report-displaced-air-added-mass = masse ajoutée seulement
report-displaced-air-none = négligées
report-measured-height = Hauteur de chute mesurée
report-release = Lâcher, dans l’enregistrement
report-sampler = Échantillonnage
report-sampler-draws = { $draws } tirages, graine { $seed }

report-repeat = Pour répéter l’analyse
report-repeat-version = La version { $version } de bouncelab donne les mêmes nombres à partir du même fichier et des mêmes réglages ; les nombres aléatoires de l’inférence ont une graine.
report-repeat-files = Les fichiers lus, avec leur SHA-256 (sha256sum l’affiche) :

report-method = Méthode
report-method-short = Les impacts sont détectés dans le son ; le temps entre deux impacts est celui d’un vol. L’inférence calcule la loi a posteriori de la restitution, de la hauteur de chute et de la traînée à partir de tous les temps de vol, avec la chute dans l’air, une restitution qui varie d’un impact à l’autre et des erreurs sur les temps. Chaque grandeur est donnée comme médiane ± écart-type de sa loi a posteriori ; un intervalle de crédibilité à 95 % contient la valeur vraie avec cette probabilité si les hypothèses sont vraies. L’ajustement log-linéaire est une droite à travers les logarithmes des temps de vol et néglige l’air. Le coefficient de restitution est donné à la vitesse du premier impact détecté et à une vitesse ronde, car celui de la plupart des balles change avec la vitesse. Sans hauteur de chute indiquée, la hauteur de chute est celle de la chute avant le premier impact détecté ; les temps ne montrent pas si des impacts ont été manqués avant lui. Un seul essai mesure à peine la traînée : son coefficient est surtout celui que l’on connaît des sphères, et les intervalles comprennent son incertitude et celle d’une restitution qui change avec la vitesse d’une manière inconnue. Les formules et les références sont sous « Détails ».

report-formulas = La méthode et ses formules
report-method-flight = Seuls les impacts font du bruit. Le temps T entre deux impacts est celui d’un vol, et donne sa hauteur h presque indépendamment de l’air :
report-method-line = Si chaque impact gardait la même fraction e de la vitesse et s’il n’y avait pas d’air, les logarithmes des temps de vol seraient sur une droite en fonction du numéro n de l’impact. Sa pente donne le coefficient de restitution e, et son ordonnée à l’origine b la hauteur de chute (Nagurka, éq. 4 et 6) :
report-method-motion = La traînée réduit aussi la vitesse, la poussée d’Archimède s’oppose au poids, et la balle accélère une partie de l’air (masse ajoutée). Avec la masse m, le volume V et la section A de la balle, la masse volumique ρ de l’air et un coefficient de traînée qui dépend du nombre de Reynolds, la vitesse v varie ainsi :
report-method-restitution = De chaque temps de vol se déduisent la vitesse v à laquelle la balle a quitté la surface et la vitesse v′ à laquelle elle est revenue, et de deux vols voisins la restitution de l’impact qui les sépare :
report-method-noise = Deux sortes de bruit sont modélisées : la restitution varie d’un impact à l’autre avec un écart-type relatif σₑ, et les temps ont des erreurs σₜ, que des impacts voisins partagent par les dérivées J. Les impacts aberrants pèsent moins (loi t de Student).
report-method-posterior = L’inférence calcule la loi a posteriori de toutes les inconnues θ, connaissant les temps t et les lois a priori, sous chaque loi de restitution et de traînée M. Chaque grandeur est donnée comme médiane ± écart-type de sa loi a posteriori ; un intervalle de crédibilité à 95 % contient la valeur vraie avec cette probabilité si les hypothèses sont vraies.
report-references = Références :
report-reference-drag = { $work } : la courbe de traînée usuelle.
report-reference-scatter = { $work } : la dispersion des impacts.
