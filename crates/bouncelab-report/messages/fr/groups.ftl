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
session-compared = Les essais sont comparés par leur restitution à une vitesse d’impact de { $speed } m/s, que la plupart couvrent, corrigée de la traînée.
session-unlike = Valeurs aberrantes de leur groupe, comprises dans tous les résultats : { $names }.
session-incomparable = Rien ne peut être comparé : { $reason }
session-groups-table = Restitution par groupe : moyenne et son erreur-type, incertitude commune, dispersion entre essais et entre impacts, et nombre d’essais qui réduirait de moitié l’intervalle
session-intervals-table = Intervalles à 95 % de la moyenne, de l’essai suivant, et de la dispersion entre essais
session-without-table = Avec et sans les valeurs aberrantes de chaque groupe
session-varies-table = Composantes de la variance : écart-type de la restitution par facteur
session-differences-table = Différences selon { $factor }, toutes choses égales par ailleurs
session-trends-table = Variation de la restitution avec les métadonnées numériques, toutes choses égales par ailleurs
session-groups = Groupes
session-against-speed = Restitution en fonction de la vitesse
session-what-varies = Composantes de la variance
session-differences-heading = Différences
session-in-order = Dans l’ordre du temps
session-troubles = Ce qui n’a pas marché
session-conditions = Conditions
session-assumed = Non indiqué, et donc supposé :
session-method = Méthode
session-method-drop = Chaque essai est inféré séparément : chute, traînée, dispersion des impacts, erreurs des temps. Sa restitution à la vitesse commune a une incertitude propre (datation, dispersion des impacts) et une autre qu’il partage avec tous les essais de la balle (loi de traînée, air, masse, diamètre, durée de contact). Seule la première se moyenne sur les essais.
session-method-group = Un groupe est décrit par un modèle à effets aléatoires, une dispersion entre essais à côté de l’erreur de chacun : maximum de vraisemblance restreint (Viechtbauer 2005), erreur-type de Hartung et Knapp (2001) sous la forme de Röver, Knapp et Friede (2015), loi t de Student, intervalle du profil Q pour la dispersion (Viechtbauer 2007), intervalle de l’essai suivant (Higgins, Thompson et Spiegelhalter 2009).
session-method-factors = Les composantes de la variance, et les différences toutes choses égales par ailleurs, viennent d’un modèle mixte à facteurs aléatoires croisés (Patterson et Thompson 1971), degrés de liberté d’après Satterthwaite (Giesbrecht et Burns 1985) ; avec un seul facteur, d’après Welch (1947). Les probabilités sont ajustées au nombre de différences (Holm 1979). Les valeurs aberrantes sont repérées par des cotes z modifiées supérieures à 3,5 (Iglewicz et Hoaglin 1993) et ne sont pas retirées.
session-hashes = Le tableau des essais a le SHA-256 de chaque enregistrement (content_sha256).

session-column-difference = différence
session-column-interval = intervalle à 95 %
session-column-p-holm = p (Holm)
session-column-p = p
session-column-group = groupe
session-column-drops = essais
session-column-shared = commune
session-column-between-drops = entre essais
session-column-between-impacts = entre impacts
session-column-needed = requis
session-column-with = avec
session-column-without = sans
session-column-factor = avec
session-column-levels = niveaux
session-column-slope = pente
session-column-mean = moyenne
session-column-next = essai suivant
session-column-count = combien
session-column-varies = varie selon
session-per-metre = par m
session-per-kelvin = par K
session-all = tous
session-too-many = trop
session-drop = essai
session-together = { $names } (toujours ensemble)
session-too-few = trop peu pour le dire

session-all-drops = tous les essais
session-no-inference = aucun essai n’a d’inférence comparable
session-no-speed = aucun essai ne connaît sa restitution à { $speed } m/s : ses impacts sont plus lents ou plus rapides
session-unknown-there = il ne connaît pas sa restitution à { $speed } m/s
session-one-drop = Un seul essai ne dit rien de la dispersion entre essais, ni donc de l’intervalle d’une moyenne : lâchez la balle plusieurs fois.
session-one-group = Tous les essais sont dans un seul groupe : il n’y a rien à comparer. Des différences demandent deux groupes : une autre balle, une autre surface ou une autre personne.
session-no-curve = il ne connaît sa restitution à aucune vitesse : trop peu d’impacts, ou une trop petite plage de vitesses
groups-assumed-of-some = { $assumption } (dans { $count } des { $all } enregistrements).
