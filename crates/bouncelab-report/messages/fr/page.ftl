page-app-title = bouncelab : lâcher une balle, entendre la physique
page-app-skip = Aller au contenu
page-app-nav = Pages
page-app-lab = Écouter
page-app-simulate = Simuler
page-app-paper = Article
page-app-drops = Essais
page-app-series = Tests
page-app-language = Langue
page-app-to-dark = Sombre
page-app-to-light = Clair
page-app-privacy = Rien ne quitte cet appareil : ni compte, ni serveur ; fonctionne hors ligne.
page-app-version = bouncelab { $version }
page-app-book = Tutoriel et documents
page-app-engine-failed = Le laboratoire n’a pas pu démarrer.
page-app-engine-failed-hint = Le navigateur n’a pas chargé ou exécuté la partie WebAssembly. Recharge la page ; si cela n’aide pas, utilise un Firefox, Chrome, Edge ou Safari récent.
page-app-newer = Une version plus récente de cette page est prête.
page-app-reload = Recharger
page-app-undo = Annuler
page-app-redo = Rétablir
page-app-cancel = Interrompre
page-app-number-wanted = Un nombre{ $most ->
    [none] { $least ->
        [none] {""}
       *[other] {" "}d’au moins { $least }
      }
   *[other] {" "}de { $least } à { $most }
  } est attendu ici.
page-app-drop-here = Relâche pour ouvrir le fichier
page-app-unreadable-link = Certains réglages de l’adresse ne sont pas valables et ont été ignorés : { $parts }.

page-lab-invite = Fais tomber une balle près de ton microphone.
page-lab-invite-touch = Fais tomber une balle près de ton téléphone.
page-lab-lead = Les durées entre les rebonds disent combien de vitesse et d’énergie la balle garde, et de quelle hauteur elle est tombée.
page-lab-listen = Écouter
page-lab-stop = Arrêter
page-lab-again = Écouter encore
page-lab-open = ouvrir un fichier
page-lab-rate = Fréquence d’échantillonnage
page-lab-rate-open = Lire comme son
page-lab-paste = coller des instants
page-lab-demo = voir un exemple
page-lab-open-label = Enregistrement ou liste de temps d’impact
page-lab-paste-label = Temps d’impact en secondes, un par ligne
page-lab-paste-hint = D’un tableur ou d’un oscilloscope. Un vol va d’un impact au suivant.
page-lab-paste-do = Analyser
page-lab-pasted-name = temps collés
page-lab-demo-name = exemple
page-lab-recording-name = essai { $date }
page-lab-starting = Demande d’accès au microphone…
page-lab-listening = À l’écoute. Fais tomber la balle.
page-lab-hint-quiet = Rien de fort n’a encore été entendu : rapproche le microphone de l’endroit où la balle tombe.
page-lab-hint-no-bounces = On entend des sons, mais pas de rebonds : rapproche le téléphone de l’endroit où la balle tombe, sur un sol dur, et laisse-la rebondir jusqu’à ce qu’elle repose.
page-lab-so-far = { $count ->
    [one] { $count } impact jusqu’ici
   *[other] { $count } impacts jusqu’ici
  }
page-lab-so-far-keeps = elle garde environ { $share } de sa vitesse
page-lab-ends-itself = L’écoute se termine quand la balle est au repos.
page-lab-saved = { $seconds } s sont enregistrées.
page-lab-result = Résultat
page-lab-opening = Lecture de { $name }…
page-lab-cannot-tell = Il y a trop peu d’impacts pour déterminer le coefficient de restitution.
page-lab-impacts = { $count ->
    [one] { $count } impact
   *[other] { $count } impacts
  }
page-lab-uncertain = { $count ->
    [one] { $count } incertain
   *[other] { $count } incertains
  }
page-lab-edited = modifié à la main
page-lab-drop-of = Essai { $index } sur { $count }
page-lab-drops-heard = Essais de cet enregistrement
page-lab-why = Avec et sans air
page-lab-why-air-1 = Une droite à travers les logarithmes des temps de vol (ajustement log-linéaire) est la manière classique de mesurer le coefficient de restitution. Mais l’air aussi ralentit la balle, et l’ajustement attribue cela aux impacts.
page-lab-why-air-2 = Les points gris négligent l’air ; les bleus sont corrigés de la traînée. Ils montrent la balle et la surface seules.
page-lab-refining = Calcul de l’inférence avec air…
page-lab-more = Tous les nombres
page-lab-other-quantities = Autres grandeurs
page-lab-tells = Ce que cet enregistrement détermine, ou non
page-lab-narrowed-lead = À quel point l’enregistrement a réduit l’incertitude a priori :
page-lab-narrowed = { $unknown } : il reste { $share } de la largeur
page-lab-assumed = supposé
page-lab-no-drop-title = Aucun rebond détecté.
page-lab-possible-drop = Peut-être un essai à partir de { $start } s : { $impacts } impacts, probabilité { $probability }.
page-lab-accept = C’en est un
page-lab-no-drop-hint = Place le microphone près du point de chute, sur une surface dure, et laisse la balle rebondir jusqu’au repos. Si tu vois les impacts dans la forme d’onde, marque-les à la main : double clic, ou Entrée au curseur.
page-lab-no-drop-hint-touch = Pose le téléphone près de l’endroit où la balle tombe, sur une surface dure, et laisse-la rebondir jusqu’à ce qu’elle repose. Si tu vois les impacts dans la forme d’onde, marque-les d’un double toucher.
page-lab-interrupted-title = Un enregistrement du { $date } a été interrompu.
page-lab-progress = Progression
page-lab-processed = L’appareil modifie le son alors qu’on lui a demandé de ne pas le faire : { $what }. Des impacts faibles peuvent manquer. Un autre navigateur ou un microphone externe aide.
page-lab-processed-echoCancellation = annulation d’écho
page-lab-processed-noiseSuppression = suppression du bruit
page-lab-processed-autoGainControl = gain automatique
page-lab-unkept-title = L’enregistrement du { $date } n’est pas dans le tableau des essais.
page-lab-interrupted-hint = Il est conservé, sauf peut-être la dernière seconde ou les deux dernières.
page-lab-interrupted-open = Ouvrir
page-lab-interrupted-drop = Supprimer

page-rest-title = Voix et vibration, quand la balle est au repos
page-rest-speech = Dire le résultat
page-rest-vibration = Vibrer
page-rest-plus-minus = plus ou moins

page-words-restitution = La restitution est la vitesse juste après un impact divisée par celle juste avant : 90 % veut dire que la balle perd un dixième de sa vitesse.
page-words-bounce-energies = L’énergie croît avec le carré de la vitesse : une balle qui garde 90 % de sa vitesse garde 81 % de son énergie.
page-words-height = La hauteur de chute est calculée à partir des durées entre les impacts. La courbe montre jusqu’où la balle est montée après chacun.
page-words-uncertainty = ± est l’incertitude-type : la vraie valeur s’y trouve avec une probabilité d’environ deux tiers, et dans le double avec 95 %.
page-words-flight-times = Un vol est le temps d’un impact au suivant. Sans air et avec la même restitution à toute vitesse, chacun durerait la même fraction du précédent.
page-words-bounce-heights = Jusqu’où la balle est montée après chaque impact, calculé d’après le temps jusqu’au suivant.
page-words-comparison = La hauteur de la balle d’après le modèle et d’après ta simulation : là où elles diffèrent, l’une des deux est fausse.
page-words-posterior = La loi a posteriori est ce qu’on sait après la mesure : la probabilité de chaque valeur, d’après les temps d’impact et ce qu’on savait avant.
page-words-residuals = Un résidu est le temps mesuré d’un impact moins celui du modèle. Ils devraient se disperser sans motif.
page-words-budget = Le bilan d’incertitude montre ses sources et la part de chacune. Pour en savoir plus, commence par la plus grande.
page-words-models = Une loi dit comment la restitution dépend de la vitesse. Chacune pèse selon la qualité de sa prédiction des temps d’impact.
page-words-truncation = La réponse avec les deux premiers vols, avec trois, etc. Elle ne devrait pas changer avec leur nombre.
page-words-drag = La traînée est la force de l’air contre le mouvement. Elle croît à peu près avec le carré de la vitesse.
page-words-drag-log = La même chose sur des axes où chaque pas est un facteur : une puissance de la vitesse est une droite.

page-faults-refused-what = Le navigateur n’a pas le droit d’utiliser le microphone.
page-faults-refused-do = Autorise-le dans la barre d’adresse (cadenas ou microphone) et touche « Écouter » à nouveau. Sur un téléphone, vois aussi les réglages de l’application du navigateur. Tu peux ouvrir un enregistrement à la place.

page-faults-missing-what = Aucun microphone n’a été trouvé.
page-faults-missing-do = Branche-en un et touche « Écouter » à nouveau, ou enregistre avec un autre appareil et ouvre le fichier ici.

page-faults-busy-what = Le microphone est utilisé par un autre programme.
page-faults-busy-do = Ferme appels et enregistreurs, puis touche « Écouter » à nouveau.

page-faults-insecure-what = Les navigateurs ne donnent le microphone qu’aux pages en https, ou de cet ordinateur même.
page-faults-insecure-do = Ouvre cette page en https ou par localhost. Les enregistrements peuvent être ouverts ainsi.

page-faults-unsupported-what = Ce navigateur ne fournit pas de son non traité.
page-faults-unsupported-do = Utilise un Firefox, Chrome, Edge ou Safari récent, ou ouvre un enregistrement.

page-faults-ended-what = Le microphone a été déconnecté : débranché, ou pris par un appel.
page-faults-ended-do = Le son enregistré jusque-là est conservé et analysé.

page-faults-unknown-what = Le microphone n’a pas pu être ouvert.
page-faults-unknown-do = Débranche-le et rebranche-le, ou redémarre le navigateur. Tu peux ouvrir un enregistrement à la place.

page-faults-silent-what = Le microphone ne donne que du silence.
page-faults-silent-do = Il est peut-être coupé par un interrupteur ou dans les réglages du système.

page-faults-full-what = Le stockage du navigateur est plein.
page-faults-full-do = Le son est complet en mémoire : enregistre-le en WAV maintenant. Supprime ensuite les essais inutiles.

page-faults-unavailable-what = Le navigateur ne conserve rien ici (une fenêtre privée ?).
page-faults-unavailable-do = Le son est complet en mémoire jusqu’à la fermeture de cette page : enregistre-le en WAV.

page-faults-empty-what = Le fichier est vide.
page-faults-empty-do = Rien n’y a été écrit. L’enregistrement a-t-il été arrêté avant de commencer ? Enregistre à nouveau ou choisis un autre fichier.

page-faults-unsupported-file-what = Ce n’est ni un enregistrement ni une liste de temps.
page-faults-unsupported-file-do = Sons : { $formats }. Listes : un temps en secondes par ligne.

page-faults-damaged-what = Le fichier est endommagé.
page-faults-damaged-do = Copie-le ou télécharge-le à nouveau. Un fichier qu’un téléphone écrit encore ne peut pas être lu.

page-faults-times-what = Ces temps ne peuvent pas être des temps d’impact.
page-faults-times-do = Donne un temps en secondes par ligne, dans l’ordre croissant, avec une virgule ou un point décimal.
page-faults-rate-what = Le tableau ne dit pas quand ses échantillons ont été pris.
page-faults-rate-do = Indique la fréquence d’échantillonnage : combien d’échantillons par seconde l’appareil a pris, souvent 44100 ou 48000.

page-faults-huge-what = Le fichier est trop grand pour un navigateur.
page-faults-huge-do = Jusqu’à deux heures de son en deux canaux, ou quatre en un seul. Coupe-le aux minutes de l’essai, ou utilise la ligne de commande : bouncelab analyze.

page-faults-setting-what = Un réglage contredit les autres.
page-faults-setting-do = Vois ci-dessous, aux réglages.

page-faults-fault-what = L’analyse a échoué.
page-faults-fault-do = Ce qui a été enregistré est conservé. Recharge la page et ouvre-le à nouveau ; un rapport au projet est utile.

page-faults-link-what = Ce lien d’un essai ne peut pas être utilisé.
page-faults-link-do = Copie le lien entier, ou lis le code à nouveau.

page-faults-no-drop-what = Aucune balle qui rebondit n’y a été trouvée.
page-faults-no-drop-do = Ouvre-le dans le laboratoire : tu peux l’y écouter et marquer des impacts.

page-faults-series-full-what = Le stockage du navigateur est plein : cet essai ne compte pas encore.
page-faults-series-full-do = Ce qui a été conservé avant est là, inchangé. Enregistre ce son dans un fichier, supprime des essais ou des séries inutiles et réessaie.

page-faults-series-known-what = Cet enregistrement compte déjà.
page-faults-series-known-do = Chaque enregistrement compte une fois. Choisis celui d’un autre essai.

page-faults-series-storage-what = Le navigateur n’a pas pu l’enregistrer.
page-faults-series-storage-do = Ce qui a été conservé avant est là, inchangé. Une fenêtre privée ne conserve rien : prends une fenêtre ordinaire.

page-faults-archive-what = Ce n’est pas un fichier complet d’essais conservés.
page-faults-archive-do = Copie-le ou télécharge-le à nouveau, et ajoute celui-là. Ce qui est conservé ici n’a pas changé.

page-faults-bad-drop-what = Cette page n’a pas pu conserver cet essai.
page-faults-bad-drop-do = Demande son enregistrement ou son lien. Les autres essais du fichier ont été ajoutés.

page-faults-archive-newer-what = Une version plus récente de cette page a enregistré ce fichier.
page-faults-archive-newer-do = Recharge la page, et ajoute le fichier à nouveau. Ce qui est conservé ici n’a pas changé.

page-faults-archive-storage-what = Le fichier n’a pas pu être conservé en entier.
page-faults-archive-storage-do = Le stockage du navigateur est plein ou indisponible. Supprime les essais inutiles, et ajoute le fichier à nouveau ; ce qui était conservé n’a pas changé.

page-faults-keep-what = L’essai n’a pas pu être conservé.
page-faults-keep-do = Le stockage du navigateur est plein ou indisponible. Enregistre plutôt le son et les nombres dans des fichiers.

page-wave-title = Forme d’onde
page-wave-label = Forme d’onde, position du curseur
page-wave-seconds = { $value } secondes
page-wave-impact-at = impact { $number }, { $seconds }{ $certain ->
    [yes] {""}
   *[no] , incertain
  }
page-wave-add = Ajouter un impact
page-wave-remove = Supprimer
page-wave-snap = Caler sur le son
page-wave-zoom-in = Agrandir
page-wave-zoom-out = Réduire
page-wave-all = Tout
page-wave-amplitude = Hauteur de la forme d’onde
page-wave-amplitude-whole = hauteur : enregistrement
page-wave-amplitude-view = hauteur : vue
page-wave-amplitude-decibels = hauteur : décibels
page-wave-play = Lire
page-wave-stop = Arrêter
page-wave-speed = Vitesse
page-wave-slower = { $speed } ×
page-wave-spectrogram = Spectrogramme
page-wave-spectrogram-label = Spectrogramme : temps vers la droite, fréquence vers le haut, plus fort est plus sombre
page-wave-overview = Tout l’enregistrement ; glisse pour déplacer
page-wave-restore = Comme détecté
page-wave-list = Liste des impacts
page-wave-number = N°
page-wave-time = Temps
page-wave-flight = Vol suivant
page-wave-probability = Probabilité
page-wave-level = Niveau
page-wave-restitution = Restitution
page-wave-actions = Modifier
page-wave-remove-one = Supprimer l’impact { $number }
page-wave-select = Montrer l’impact { $number }
page-wave-added = Impact ajouté à { $seconds } s.
page-wave-removed = Impact { $number } supprimé.
page-wave-moved = Impact { $number } déplacé à { $seconds } s.
page-wave-undone = Annulé.
page-wave-redone = Rétabli.
page-wave-keys = Les flèches déplacent le curseur, avec Maj par petits pas ; Page précédente et Page suivante vont d’impact en impact ; plus et moins changent l’échelle, 0 montre tout ; Entrée ajoute un impact, Suppr supprime celui qui est choisi, virgule et point le déplacent, S le cale sur le son ; Espace lit ; Ctrl+Z annule.
page-wave-pointer = Glisse pour déplacer, pince ou tourne la molette pour agrandir (clique d’abord), touche un impact pour le choisir, glisse-le pour le déplacer, touche deux fois pour en ajouter un.
page-wave-times = Il n’y a que des temps : aucun son à montrer.

page-figures-title = Figures
page-figures-more = Plus de figures
page-figures-fewer = Moins de figures
page-curve-label = Hauteur de la balle en fonction du temps ; le premier saut détecté monte à { $height }
page-figures-against = { $y } en fonction de { $x }
page-figures-reset = Glisse latéralement pour agrandir, double clic pour tout voir.
page-figures-numbers = Les valeurs en nombres
page-figures-save-svg = SVG
page-figures-save-png = PNG
page-figures-save-csv = CSV
page-figures-save = Enregistrer cette figure

page-settings-ball = Balle
page-settings-air = Air
page-settings-gravity = g
page-settings-change = modifier
page-settings-title = Grandeurs connues
page-settings-assumed-hint = L’air et la gravité non indiqués sont supposés. Si la balle n’est pas indiquée, chaque type de balle que permettent les temps compte, et les intervalles sont plus larges.
page-settings-own = autre balle
page-settings-mass = Masse
page-settings-diameter = Diamètre
page-settings-contact = Durée de contact
page-settings-temperature = Température
page-settings-pressure = Pression
page-settings-humidity = Humidité
page-settings-vacuum = vide
page-settings-no-drag = sans air
page-settings-gravity-field = Pesanteur
page-settings-measure-g = mesurer g : indique aussi la hauteur de chute
page-settings-latitude = Latitude
page-settings-altitude = Altitude
page-settings-drag-law = Traînée de l’air
page-settings-drag-none = aucune, air négligé
page-settings-drag-standard = courbe standard d’une sphère
page-settings-drag-table = table de C_D fournie
page-settings-restitution-law = Restitution
page-settings-restitution-any = toutes les lois
page-settings-measured = L’essai, s’il est mesuré
page-settings-height = Hauteur de chute
page-settings-height-sd = ± de la hauteur
page-settings-flights = Vols de l’ajustement log-linéaire
page-settings-flights-from = de
page-settings-flights-to = à
page-settings-reset = Réinitialiser les réglages
page-settings-refused = Ces réglages se contredisent :

page-ball-row = Quelle balle ?
page-ball-other = autre : taille et masse

page-setup-named = { $name } : { $value }
page-setup-offered = Ce lien indique : { $what }. Tes propres essais ne l’utilisent que si tu le veux.
page-setup-laws = d’autres modèles de l’analyse
page-setup-take = l’utiliser pour mes essais
page-setup-leave = ne pas l’utiliser
page-setup-unusual = Analysé avec : { $what }.
page-setup-reset = Réinitialiser

page-keep-title = Conserver
page-keep-keep = Conserver cet essai
page-keep-long-sound = Le son dure plus d’une demi-heure : seul l’essai est gardé, pas le fichier.
page-keep-kept = Conservé sous « { $name } ».
page-keep-name = Nom
page-keep-name-hint = par exemple : Anna, premier essai
page-keep-see-all = Tableau des essais
page-keep-lasting = Le navigateur garde ce qui est ici jusqu’à ce que tu le supprimes.
page-keep-not-lasting = Si la place manque, le navigateur peut supprimer ce qui est ici : enregistre une copie dans un fichier.
page-keep-for-a-week = Ce navigateur efface ce qu’une page garde après sept jours sans visite, sauf si la page est sur l’écran d’accueil (Partager, « Sur l’écran d’accueil ») : enregistre une copie dans un fichier.
page-keep-commas = tableaux avec points-virgules et virgules décimales
page-keep-wav = Son (WAV)
page-keep-csv = Tableau (CSV)
page-keep-json = Toutes les données (JSON)
page-keep-share = Partager ces réglages
page-keep-shared = L’adresse avec ces réglages a été copiée.
page-keep-share-by-hand = Copie cette adresse :
page-keep-report = Rapport (HTML)
page-keep-link = Partager cet essai
page-keep-link-qr = Code QR de l’adresse de cet essai

page-simulate-title = Simuler un essai
page-simulate-lead = Déplace un curseur et vois ce qui change ; conserve une simulation pour la comparer à la suivante.
page-simulate-height = Hauteur de chute
page-simulate-restitution = Restitution (à 1 m/s)
page-simulate-slope = Décroît avec la vitesse de
page-simulate-slope-hint = 0 : la même à toute vitesse
page-simulate-law = Loi de restitution
page-simulate-law-of-sliders = constante ou décroissante, selon les curseurs
page-simulate-law-numbers = Loi avec ses nombres
page-simulate-ball = Balle
page-simulate-drag = Traînée de l’air
page-simulate-pressure = Pression de l’air
page-simulate-body = Où

page-simulate-bodies-earth = Terre
page-simulate-bodies-moon = Lune
page-simulate-bodies-mars = Mars
page-simulate-bodies-venus = Vénus
page-simulate-bodies-titan = Titan
page-simulate-bodies-jupiter = Jupiter
page-simulate-keep-run = Conserver
page-simulate-hear = Écouter le son
page-simulate-stop = Arrêter
page-simulate-lay = Comparer à la mesure
page-simulate-take-off = Retirer de la comparaison
page-simulate-laid = Elle est maintenant comparée à la mesure, dans la figure « Comparer ».
page-simulate-analyse = Analyser son son
page-simulate-runs = Simulations
page-simulate-this-run = celle-ci
page-simulate-run = simulation { $index }
page-simulate-remove = Supprimer { $name }
page-simulate-says = Elle rebondit { $bounces } fois en { $time } et parcourt { $path }.
page-simulate-terminal = Sa vitesse limite est ici de { $speed }.
page-simulate-no-terminal = Il n’y a pas d’air, donc pas de vitesse limite.
page-simulate-losses = De son énergie, { $surface } sont perdus dans les impacts, { $air } dans l’air.
page-simulate-impossible = Ceci ne peut pas être simulé :
page-simulate-address = L’adresse contient les réglages : partage-la, et d’autres verront la même simulation.

page-paper-title = L’article
page-paper-source = M. Nagurka, « Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment »
page-paper-lead = Fais tomber une balle de tennis de table et écoute. Les temps entre les impacts donnent sa restitution et sa hauteur de chute, mais la hauteur est trop basse de 12 %. Cette page explique pourquoi, et calcule chaque nombre et chaque figure pendant que tu lis.

page-paper-one-title = 1. Des temps aux hauteurs
page-paper-one-text-1 = Entre deux impacts, la balle monte et retombe pendant un temps T. Sans air, elle quitte la surface avec la vitesse gT/2 et monte à gT²/8. Il suffit d’une horloge.
page-paper-one-text-2 = Si chaque impact garde la fraction e de la vitesse, chaque vol dure e fois le précédent. En échelle logarithmique, les temps de vol sont sur une droite : sa pente est log e, et son ordonnée à l’origine donne la hauteur de chute. C’est l’ajustement log-linéaire.
page-paper-one-equation = log Tₙ = n log e + log (2v₀/g),   h₀ = v₀²/2g
page-paper-one-see = Les temps de vol d’une chute de 30,5 cm, sans air. Chaque point est sur la droite ; l’ajustement donne exactement e et 30,5 cm.

page-paper-two-title = 2. L’expérience, et un désaccord
page-paper-two-text-1 = L’article a fait tomber une balle de 2,5 g et 38 mm de 30,5 cm. L’ajustement log-linéaire de ses dix premiers vols a donné e = 0,9375 et une hauteur de chute de 26,7 cm.
page-paper-two-text-2 = C’est 3,8 cm de moins, soit 12,3 %, bien plus que l’erreur d’un mètre ruban. L’article y voit l’effet probable de la traînée de l’air.

page-paper-three-title = 3. L’intensité de la traînée de l’air
page-paper-three-text = Aux 2,4 m/s du premier impact, la traînée n’est que 6 % du poids, et elle décroît comme le carré de la vitesse. L’article essaie deux lois : un coefficient constant de 0,4, et un qui dépend de la vitesse. Elles s’accordent là où la traînée compte.
page-paper-three-equation = F/P = ½ ρ A C_D v² / mg
page-paper-three-see = Traînée sur poids en fonction de la vitesse, d’après les deux lois. En échelle logarithmique, un coefficient constant est une droite de pente 2.
page-paper-three-see-height = L’essai entier avec e = 0,935, avec air et sans : avec une traînée de six pour cent du poids, la balle est au repos des secondes plus tôt.

page-paper-four-title = 4. La traînée explique-t-elle le désaccord ?
page-paper-four-text = Simule des essais avec air, applique le même ajustement log-linéaire, et compare à l’article. Choisis la restitution de la balle et le nombre de vols de l’ajustement.
page-paper-four-e = Vraie restitution de la balle, à 1 m/s
page-paper-four-slope = Décroît avec la vitesse de
page-paper-four-flights = Vols dans l’ajustement
page-paper-four-line-says = L’ajustement donne e = { $e } et h₀ = { $h }.
page-paper-four-paper-says = L’ajustement de l’article donne e = 0,9375 et h₀ = 26,7 cm.
page-paper-four-truth = Vraie hauteur de chute : 30,5 cm.
page-paper-four-hit = C’est le résultat de l’article, jusqu’au dernier chiffre.
page-paper-four-solve-drag = e constant, dix vols
page-paper-four-solve-many = e constant, 21 vols
page-paper-four-solve-slope = e décroît avec la vitesse, dix vols
page-paper-four-see = Hauteur de chute d’après l’ajustement log-linéaire, en fonction de son nombre de vols. En gris : sans air, elle est la même pour tout nombre, si la restitution est constante. En vermillon : avec air, elle diminue à chaque vol. En bleu : le résultat de l’article.

page-paper-five-title = 5. L’explication
page-paper-five-text-1 = La traînée, avec une restitution constante, explique environ la moitié de l’écart : une balle de e = 0,953 donne le 0,9375 de l’article, mais 28,8 cm.
page-paper-five-text-2 = Il y a deux explications du reste : la restitution décroît un peu avec la vitesse, comme celle des balles réelles, ou plus de dix vols ont servi à l’ajustement. L’ajustement log-linéaire ne peut pas les distinguer, car son résultat dépend du nombre de vols.
page-paper-five-text-3 = Le laboratoire de cette page infère donc ensemble la hauteur de chute, la traînée et la restitution à partir des temps d’impact, avec leurs incertitudes.
page-paper-five-law = Restitution
page-paper-five-drag = Air
page-paper-five-flights = Vols
page-paper-five-first = e à 2,4 m/s
page-paper-five-slow = e à 0,5 m/s
page-paper-five-height = h₀ ajustée
page-paper-five-same = Les 26,7 cm de l’article ?
page-paper-five-yes = oui
page-paper-five-no = non
page-paper-five-caption = Modèles dont l’ajustement log-linéaire donne e = 0,9375 ; les coudes sont à 1,5 m/s

page-paper-six-title = 6. Chaque nombre de l’article
page-paper-six-lead = Tel qu’imprimé, et tel que calculé ici. Les coquilles des équations sont corrigées.
page-paper-six-quantity = Grandeur
page-paper-six-printed = Imprimé
page-paper-six-computed = Calculé
page-paper-six-verdict = Verdict

page-paper-verdicts-agrees = concorde
page-paper-verdicts-agrees-when-corrected = concorde une fois corrigé
page-paper-verdicts-agrees-within-reading = concorde à la lecture près
page-paper-verdicts-misprint = coquille
page-paper-verdicts-differs = diffère
page-paper-verdicts- = {""}

page-paper-air-names-none = sans air
page-paper-air-names-constant = C_D = 0,4
page-paper-air-names-sphere = C_D(Re)
page-paper-air-names-all-of-air = C_D(Re), poussée d’Archimède, masse ajoutée

page-paper-try-it = À toi de faire tomber une balle

page-drops-title = Tableau des essais
page-drops-empty = Aucun essai n’est encore conservé. Après un essai, « Conserver cet essai » le place ici, dans ce navigateur seulement.
page-drops-to-lab = Au laboratoire
page-drops-name = Nom
page-drops-when = Date
page-drops-ball = Balle
page-drops-e = Restitution e
page-drops-h = Hauteur de chute
page-drops-impacts = Impacts
page-drops-actions = Modifier
page-drops-open = Ouvrir
page-drops-open-one = Ouvrir { $name }
page-drops-delete = Supprimer
page-drops-delete-one = Supprimer { $name }
page-drops-deleted = « { $name } » a été supprimé.
page-drops-choose = Comparer { $name }
page-drops-compare = Comparer
page-drops-rename = Nom de { $name }
page-drops-mean = Moyenne
page-drops-scatter = Dispersion (écart-type)
page-drops-of-drops = { $count ->
    [one] de { $count } essai
   *[other] de { $count } essais
  }
page-drops-scatter-sentence = En moyenne, la balle a gardé { $mean } de sa vitesse. L’écart-type entre essais est de { $scatter } ; chaque essai isolé annonce ± { $inside }.
page-drops-csv = Enregistrer le tableau (CSV)
page-drops-json = Enregistrer tout (JSON)
page-drops-archive = Enregistrer tout avec le son (ZIP)
page-drops-archiving = Collecte des sons…
page-drops-adding = Lecture de { $name }…
page-drops-added = { $count ->
    [0] Il ne contient rien de nouveau.
    [one] { $count } essai a été ajouté.
   *[other] { $count } essais ont été ajoutés.
  }
page-drops-delete-all = Tout supprimer
page-drops-deleted-all = { $count ->
    [one] { $count } essai a été supprimé.
   *[other] { $count } essais ont été supprimés.
  }
page-drops-links = Liens d’essais d’autres personnes, autant que tu veux
page-drops-links-do = Ajouter à ce tableau
page-drops-unavailable = Le navigateur ne conserve rien ici (une fenêtre privée ?).

page-class-ball = Balle
page-class-surface = Surface
page-class-student = Élève
page-class-ball-of = Balle de { $name }
page-class-surface-of = Surface de { $name }
page-class-student-of = Élève : { $name }
page-class-add = Ajouter des essais
page-class-add-hint = Des fichiers de tout type que cette page enregistre ou ouvre, autant que tu veux, aussi en ZIP ; et des liens. Ce qui est endommagé est nommé, le reste est ajouté.
page-class-files = Choisir des fichiers
page-class-files-label = Fichiers d’essais
page-class-known = { $count ->
    [one] { $count } est déjà dans le tableau.
   *[other] { $count } sont déjà dans le tableau.
  }
page-class-groups = Groupes
page-class-details = Détails
page-class-by = Grouper par
page-class-report = Enregistrer le rapport (HTML)
page-class-sheets = Fiches de travail
page-class-sheet-bounciness = Comment une balle rebondit-elle ?
page-class-sheet-air = Quel est l’effet de l’air ?
page-class-sheet-gravity = Mesurer g avec une balle
page-class-sheet-html = à imprimer
page-class-sheet-markdown = en texte à modifier
page-class-sheets-hint = Les fiches portent l’adresse de la leçon ci-dessus, ou celle de cette page tant qu’aucune balle n’est choisie.

page-verdict-title = Juger selon une règle
page-verdict-rule = Règle
page-verdict-reference = Surface de référence
page-verdict-kept = Respecté, d’après toi :
page-verdict-ball = La règle ne nomme pas de balle : choisis-la d’abord.
page-verdict-unlike = Ces essais ont des balles ou d’autres réglages différents. Coche ceux d’une seule balle.
page-verdict-report = Enregistrer le verdict (HTML)

page-lesson-title = Ce que tu fais tomber
page-lesson-name = Ton nom
page-lesson-leave = quitter le cours
page-lesson-who = Écris ton nom ci-dessous, puis rends l’essai.
page-lesson-make = Classe : un lien pour tous
page-lesson-make-hint = Choisis ce que le cours fait tomber. La page d’un élève demande alors nom, balle, surface et hauteur, et rien d’autre.
page-lesson-balls = Balles
page-lesson-surfaces = Surfaces, séparées par des virgules
page-lesson-heights = Hauteurs de chute en cm, séparées par des points-virgules ; aucune si elles sont à mesurer
page-lesson-qr = Code QR du cours
page-hand-in = Rendre
page-hand-share = Partager…
page-hand-copy = Copier le lien
page-hand-copied = Copié.
page-scan = Scanner des codes QR
page-scan-stop = Arrêter
page-scan-refused = La caméra ne peut pas être utilisée. Autorise-la dans la barre d’adresse, ou fais-toi envoyer les liens.
page-class-all-balls = Balle des { $count } choisis
page-class-all-surfaces = Surface des { $count } choisis

page-reason-counted = C’est l’enregistrement { $number } de cette série.
page-reason-empty-content = Il ne contient aucune donnée.
page-reason-empty-sound = Il a un en-tête, mais aucun son.
page-reason-empty-time = Il ne contient aucun temps.
page-reason-not-sound = Il ressemble à { $kind }.
page-looks-png = une image PNG
page-looks-jpeg = une image JPEG
page-looks-gif = une image GIF
page-looks-pdf = un document PDF
page-looks-zip = une archive ZIP ou un document bureautique
page-looks-gzip = une archive gzip
page-looks-riff = un fichier RIFF sans son, comme AVI ou WebP
page-looks-zeros = une suite de zéros
page-looks-text = du texte
page-looks-unknown = des données d’un type inconnu
page-reason-malformed = { $stage ->
    [header] Son en-tête ne peut pas être lu
    [codec] Son décodeur ne peut pas être préparé
   *[sound] Rien de son contenu sonore ne peut être décodé
  } ({ $format } : { $detail }).
page-reason-no-audio-track = Ce fichier { $format } n’a pas de son, ou aucun d’un type connu. Le microphone était-il coupé ?
page-reason-unsupported-codec = Le son de ce fichier { $format } ne peut pas être décodé : { $codec }. Exporte-le en WAV ou M4A.
page-reason-layout-too-slow = { $sample_rate_hz } échantillons par seconde sont trop peu pour dater un impact : il en faut au moins { $min_hz }.
page-reason-layout-too-fast = Son en-tête annonce { $sample_rate_hz } échantillons par seconde ; { $max_hz } au plus sont lus.
page-reason-layout-too-many-channels = Il a { $channels } voies ; { $max } au plus sont lues.
page-reason-lasts-too-long = Il dure plus de { $max_h } heures, le plus qui soit lu. Coupe-le en parties.
page-reason-times-line = Ligne { $line } : { $problem }
page-reason-times-ending = Le nom d’une liste se termine par .txt, .csv, .tsv, .xls, .xlsx, .ods, .zip, .json, .TextGrid ou .svl.
page-reason-times-not-text = Ce n’est pas du texte. Enregistre la liste en texte, en CSV ou dans un tableur.
page-reason-times-not-table = Ce n’est pas un tableau ({ $detail }).
page-reason-times-not-file = C’est un périphérique ou un tube ; enregistre la liste dans un fichier.
page-reason-times-too-long = Il y a plus de { $max_mb } Mo de texte ; enregistre le son en WAV.
page-reason-times-not-sample = « { $text } » n’est pas un nombre ; sous ses titres, une forme d’onde échantillonnée n’a que des nombres.
page-reason-times-fewer-columns = { $found } nombres sur { $columns } : chaque ligne d’une forme d’onde échantillonnée en a un pour le temps et un par voie.
page-reason-times-uneven = Elle vient { $interval_s } s après la précédente, mais { $mean_s } s séparent les lignes en moyenne ; les temps d’une forme d’onde échantillonnée sont équidistants.
page-reason-times-sampled = C’est un tableau de { $rows } échantillons, { $rate_hz } par seconde, et non une liste de temps d’impact ; il faut au son au moins { $min_hz } échantillons par seconde. Donne les temps des impacts.
page-reason-times-positions = Ce sont des positions au cours du temps ({ $found }) et non des temps d’impact. Ouvre l’enregistrement ou donne les temps des impacts.
page-reason-times-several-drops = Il y a plusieurs colonnes de temps ({ $found }) et { $rows } lignes. Une liste a un seul essai : une colonne de temps, ou une ligne d’arrêts.
page-reason-times-no-rate = { $rows } échantillons sans temps, et non une liste de temps d’impact : enregistre le son en WAV, ajoute une colonne de temps, ou ouvre-le dans le laboratoire et indique sa fréquence d’échantillonnage.
page-reason-times-no-order = { $number } suit { $before }. Des nombres sans titre sont des temps d’impact, qui croissent, ou des intervalles, qui décroissent. Écris time_s ou interval_s au-dessus ; des échantillons demandent une colonne de temps.
page-reason-times-not-interval = { $text } n’est pas un intervalle d’un impact au suivant, qui dépasse 0 s.
page-reason-times-not-layer = Ce n’est pas une couche de Sonic Visualiser avec des points. Exporte-la à nouveau (File > Export Annotation Layer).
page-reason-times-no-list = Aucun des tableaux n’est une liste de temps d’impact : { $found }. Ouvre un enregistrement seul, et ceux d’une classe comme fichiers ou dossier.
page-reason-times-tables-disagree = Les tableaux { $first } et { $second } ont des temps différents. Garde l’un des deux.
page-reason-times-of-recordings = C’est un tableau sur des enregistrements, et non une liste de temps d’impact. Ouvre les enregistrements.
page-reason-times-not-array = Une liste de nombres était attendue, comme [0.1, 0.45] ({ $detail }).
page-reason-times-not-text-grid = Ce n’est pas un TextGrid de Praat, ou pas en entier. Enregistre-le à nouveau depuis Praat.
page-reason-times-no-point-tier = Aucune couche n’a de points, seulement des intervalles : { $found }. Ajoute dans Praat une couche avec un point à chaque impact (Tier > Add point tier…).
page-reason-times-which-point-tier = Plusieurs couches ont des points : { $found }. Nomme dans Praat celle des impacts « impacts ».
page-reason-times-no-time-column = Aucun titre n’a un mot pour temps ou impact avec une unité, comme time_s, Temps (s) ou interval_s. Il y a : { $found }.
page-reason-times-nameless-columns = Il y a { $columns } colonnes. Nomme celle des temps dans une première ligne : time_s.
page-reason-times-more-columns = Elle a { $found } colonnes, mais la première ligne en a { $columns }. Si la virgule est décimale, sépare les colonnes par des points-virgules.
page-reason-times-missing = Le temps manque.
page-reason-times-not-number = « { $text } » n’est pas un temps en secondes, comme 0.125.
page-reason-times-not-later = { $time_s } ne vient pas après { $before_s }. Liste les impacts dans l’ordre.
page-reason-too-long = Il a plus de { $minutes } minutes en { $channels ->
    [one] { $channels } voie
   *[other] { $channels } voies
  }.
page-reason-no-memory = Cet appareil n’a pas assez de mémoire pour lui.
page-reason-breaks-decoder = Il est endommagé, et son décodeur échoue.
page-reason-unreadable = Le navigateur ne peut pas le lire. A-t-il été déplacé ou supprimé ?
page-reason-link-changed = Il a été modifié ou est incomplet.
page-reason-link-other-version = Une autre version de cette page l’a fait ; recharge la page.
page-reason-link-times = Un lien contient de 2 à 1000 impacts.
page-reason-link-too-long = L’essai a trop d’impacts pour un code QR.

page-series-title = Série de tests
page-series-lead = Un test selon une règle, essai par essai et emplacement par emplacement, avec le rapport d’un laboratoire.
page-series-known = Conservées dans ce navigateur
page-series-open = Continuer { $name }
page-series-delete = Supprimer
page-series-delete-hint = Ses enregistrements disparaissent aussi. Enregistre d’abord la série en ZIP si tu en as besoin.
page-series-delete-really = Supprimer { $name } et ses enregistrements
page-series-new = Une nouvelle série
page-series-name = Nom, par exemple du sol ou de la balle
page-series-ball = Balle
page-series-places = Emplacements
page-series-drops = Essais par emplacement
page-series-as-the-rule = Ce qui reste vide est comme le demande la règle. La méthode est d’abord vérifiée sur un enregistrement synthétisé.
page-series-begin = Commencer la série
page-series-all = Toutes les séries
page-series-complete = Chaque emplacement a ses essais.
page-series-damaged = { $count ->
    [one] Une ligne du journal est endommagée et ne compte pas.
   *[other] { $count } lignes du journal sont endommagées et ne comptent pas.
}
page-series-files = ajouter des enregistrements
page-series-files-label = Enregistrements des prochains essais
page-series-operator = Qui lâche la balle
page-series-places-done = Emplacements terminés : { $done } sur { $all }
page-series-place-done = (terminé)
page-series-recordings = Enregistrements
page-series-repeat = Répéter l’essai { $number }
page-series-reason = Pourquoi il ne compte pas
page-series-repeat-do = Répéter { $number } ; le son reste
page-series-notes = Ce que le rapport indique
page-series-notes-keep = Enregistrer les données
page-series-report = Enregistrer le rapport (HTML)
page-series-one-page = Page pour le client (HTML)
page-series-zip = Enregistrer toute la série (ZIP)
page-series-zip-hint = Décompressé, le ZIP est un dossier pour le programme : bouncelab job show DOSSIER. Il contient chaque enregistrement avec son SHA-256, même ceux qui ont été répétés.
page-series-microphone = microphone
page-series-interrupted = microphone, interrompu
page-series-count-interrupted = Le compter comme prochain essai
page-series-keep-again = Réessayer
page-series-save-sound = Enregistrer le son dans un fichier
