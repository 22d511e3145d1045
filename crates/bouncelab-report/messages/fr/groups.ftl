session-untitled = Une série
session-counts = { $drops ->
    [one] { $drops } essai
   *[other] { $drops } essais
  } dans { $recordings ->
    [one] { $recordings } enregistrement
   *[other] { $recordings } enregistrements
  }{ $without ->
    [0] {""}
   *[other] , { $without } sans essai
  }{ $failed ->
    [0] {""}
    [1] , 1 illisible
   *[other] , { $failed } illisibles
  }{ $duplicates ->
    [0] {""}
    [1] , 1 identique à un autre
   *[other] , { $duplicates } identiques à un autre
  }
session-without-drop = Sans essai
session-failed = Illisibles
session-duplicates = Même contenu qu’un autre enregistrement, qui est utilisé
session-left-out = Non comparés
session-odd = Remarques sur les essais
session-unlike = Valeurs aberrantes de leur groupe, comprises dans tous les résultats : { $names }.
session-incomparable = Rien ne peut être comparé : { $reason }
session-groups-table = Restitution par groupe avec son incertitude-type, la part commune à tous les essais, dispersion entre essais et entre impacts, et nombre d’essais qui réduirait de moitié l’intervalle
session-intervals-table = Intervalles à 95 % de la restitution, de l’essai suivant, et de la dispersion entre essais ; écarts-types de répétabilité et de reproductibilité (ISO 5725)
session-without-table = Avec et sans les valeurs aberrantes de chaque groupe
session-differences-table = Différences entre groupes : à la vitesse de la comparaison, avec la probabilité qu’elles soient positives, et en moyenne sur toutes les vitesses communes aux deux
session-groups = Groupes
session-against-speed = Restitution en fonction de la vitesse
session-differences-heading = Différences
session-in-order = Dans l’ordre du temps
session-troubles = Ce qui n’a pas marché
session-conditions = Conditions
session-assumed = Non indiqué, et donc supposé :
session-method = Méthode
session-method-drop = Chaque essai est inféré séparément : chute, traînée, dispersion des impacts, erreurs des temps. Sa vraisemblance, sans ce qui était supposé d’avance, entre dans un modèle de tous les essais aux vitesses de ses propres impacts. Ce que partagent tous les essais d’une balle (traînée, air, masse, diamètre, durée de contact) garde l’incertitude qu’il a dans un seul essai.
session-method-group = Un groupe a une courbe de ln e selon ln v, une spline cubique dont la pente suit une marche aléatoire, autour de laquelle ses essais se dispersent en niveau. La dispersion étant donnée, c’est linéaire et gaussien ; la dispersion est intégrée avec une loi a priori exponentielle de moyenne 1 % (Simpson et al. 2017).
session-hashes = Le tableau des essais a le SHA-256 de chaque enregistrement (content_sha256).

session-column-difference = différence
session-column-interval = intervalle à 95 %
session-column-group = groupe
session-column-drops = essais
session-column-shared = commune
session-column-between-drops = entre essais
session-column-between-impacts = entre impacts
session-column-needed = requis
session-column-with = avec
session-column-without = sans
session-column-mean = restitution
session-column-next = essai suivant
session-column-count = combien
session-column-varies = varie selon
session-too-many = trop

session-all-drops = tous les essais
session-no-inference = aucun essai n’a d’inférence comparable
session-no-speed = aucun essai n’a d’impacts autour de { $speed } m/s
session-one-drop = Un seul essai dit peu de la dispersion entre essais, l’intervalle est donc large : lâche la balle plusieurs fois.
session-one-group = Tous les essais sont dans un seul groupe : il n’y a rien à comparer. Des différences demandent deux groupes : une autre balle, une autre surface ou une autre personne.
session-no-curve = il ne dit rien de la courbe de restitution : trop peu d’impacts, ou des tirages que leur covariance ne décrit pas
groups-assumed-of-some = { $assumption } (dans { $count } des { $all } enregistrements).
session-scatter-table = Dispersion de la restitution à côté de celle des essais, relative
session-curve-table = Restitution à plusieurs vitesses d’impact
session-heights = Hauteurs de chute
session-heights-table = Hauteurs de chute d’après la courbe du groupe
session-ruler = Les hauteurs indiquées dépassent celles entendues de { $value } (95 % : { $interval }) : le zéro de la règle.
session-in-words = { $group } : restitution { $value } à { $speed } (95 % : { $interval }), de { $drops ->
    [one] 1 essai
   *[other] { $drops } essais
  }, avec une dispersion de { $scatter }.
session-difference-in-words = { $of } moins { $less } : { $value } (95 % : { $interval }) ; elle est positive avec une probabilité de { $probability }.
session-method-scatter = Les opérateurs, et ce qui d’autre ne forme pas de groupes, se dispersent avec une loi a priori de moyenne 0,2 %. Les différences sont regardées une à une. Sont aberrants les essais dont le niveau a une cote z modifiée supérieure à 3,5 (Iglewicz et Hoaglin 1993) ; ils ne sont pas retirés.
session-column-drop = essai
session-column-repeatability = répétabilité
session-column-reproducibility = reproductibilité
session-column-above = positive
session-column-over = à toute vitesse
factor-ball = balle
factor-surface = surface
factor-operator = opérateur
factor-student = élève
factor-place = lieu
