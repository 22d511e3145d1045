terminal-note = Note : { $text }
terminal-assumed = Supposé : { $list }
analyze-balls-heading = Ce que les temps disent de chaque balle, par rapport à celle indiquée ou supposée :
terminal-cannot-tell = { $what } : indéterminé : { $reason }

analyze-times = { $origin ->
    [none] { $name } : temps d’impact
   *[other] { $name } : temps d’impact, { $origin }
  }
analyze-sound = { $name } : { $format }, { $rate } kHz{ $channels ->
    [1] {""}
   *[other] , voie { $channel } sur { $channels }
  }, { $duration } s
analyze-listening = { $onsets } sons se détachent du bruit de fond et { $impacts } impacts ont été détectés, avec le plus fort contraste de { $low } à { $high } Hz, { $above } dB au-dessus du son précédent (--channel, --band).
analyze-drop = { $drops ->
    [1] Essai
   *[other] Essai { $number } sur { $drops }
  } : { $count } impacts de { $first } s à { $last } s{ $uncertain ->
    [0] {""}
    [1] , 1 incertain (?)
   *[other] , { $uncertain } incertains (?)
  }{ $probability ->
    [none] {""}
   *[other] {" "}(un essai avec une probabilité de { $probability })
  }
analyze-line = Ajustement log-linéaire
analyze-line-heading = Ajustement log-linéaire des temps de vol, air négligé :
analyze-corrected = Corrigé de la traînée
analyze-corrected-heading = Corrigé de la traînée ({ $law }) :
analyze-inference-heading = Inférence, avec air :

analyze-details-models = Modèles, de même probabilité a priori :
analyze-details-budget-restitution = Bilan d’incertitude de e :
analyze-details-budget-height = Bilan d’incertitude de h0 :
analyze-details-contraction = Réduction de l’a priori par les données :
analyze-details-correlations = Corrélations des estimations :
analyze-details-impacts = Impacts dans l’ajustement :
analyze-details-priors = Lois a priori :
analyze-details-sampling = Échantillonnage : { $draws } tirages indépendants, indice de Pareto { $shape } (bon au-dessous de 0,7).
analyze-no-drop = { $name } : aucun essai trouvé : { $reason }
analyze-detecting = détection { $bar } { $done } s, reste { $left }
analyze-inferring = inférence à partir de { $impacts } impacts (--no-inference l’omet)
analyze-one-report = un rapport porte sur un enregistrement, et plusieurs ont été donnés ; bouncelab session fait un rapport sur plusieurs
analyze-cues-of-file = --cues copie un enregistrement : il faut un fichier au lieu de l’entrée standard
analyze-input-too-long = l’entrée standard dépasse 1 Gio, gardé en mémoire ; enregistre-la dans un fichier
analyze-one-labelled = étiquettes, marqueurs et mouvement sont d’un seul enregistrement, et plusieurs ont été donnés ; donnes-en un à la fois
analyze-cues-need-sound = { $name } est une liste de temps, sans son à marquer ; --format audacity ou textgrid écrit des étiquettes

terminal-wrote = écrit : { $file }
terminal-not-printed = { $browser } n'a pas imprimé le rapport : { $reason }
terminal-no-browser = Un PDF est imprimé par Chromium, Chrome ou Edge, et aucun n'a été trouvé. En installer un, ou écrire le rapport en .html et l'imprimer.
terminal-wrote-figure = écrit : { $file }, .png, .pdf et .csv
terminal-first-figures = Les { $count } premiers essais ont leurs propres figures ; les résultats pour programmes les ont tous.
terminal-all-shown = ... et { $count } de plus ; --format csv les a tous.

demo-heading = Un essai depuis 30,5 cm, synthétisé, détecté et analysé ({ $file })
demo-truth = vrai
demo-detected = mesuré
demo-flight-time-error = plus grande erreur d’un temps de vol
demo-restitution-line = e, ajustement log-linéaire, 10 vols
demo-restitution-inference = e, inférence
demo-height-line = hauteur de chute, ajustement log-linéaire
demo-height-inference = hauteur de chute, inférence
demo-second-speed = vitesse du deuxième impact
demo-conclusion =
    L’ajustement log-linéaire néglige la traînée : sa restitution et sa hauteur sont trop basses.
    L’inférence tient compte de l’air et retrouve les deux.

simulate-heading = Une chute ({ $ball }), simulée
simulate-bounces = rebonds
simulate-first-speed = vitesse du premier impact
simulate-no-terminal-speed = aucune
simulate-total-time = temps jusqu’à la fin
simulate-total-path = trajet jusqu’à la fin
simulate-initial-energy = énergie au départ
simulate-lost-to-surface = cédée à la surface
simulate-lost-to-air = cédée à l’air
simulate-each-bounce = Chaque rebond, traînée { $law } :
simulate-bounce = rebond
simulate-to-surface = au sol µJ
simulate-to-air = à l’air µJ
simulate-drag = traînée { $law }

synth-made = { $file } : { $count ->
    [one] { $count } impact
   *[other] { $count } impacts
  } en { $seconds } s, { $rate } Hz, graine { $seed }

puzzle-question = Le désaccord : pourquoi l’ajustement log-linéaire donne-t-il e = 0,9375 et h0 = 26,7 cm pour une chute de 30,5 cm ?
puzzle-flights = vols
puzzle-first = e à 2,4 m/s
puzzle-slow = e à 0,5 m/s
puzzle-height = h0 ajustée cm
puzzle-solved = 26,7 de l’article ?
puzzle-yes = oui
puzzle-no = non
puzzle-answer =
    Chaque loi a été choisie pour que l’ajustement donne e = 0,9375 ; les coudes sont à 1,5 m/s. La traînée avec une
    restitution constante ne donne 26,7 cm qu’avec environ 21 vols dans l’ajustement ; avec
    dix vols, la restitution doit aussi décroître avec la vitesse. L’ajustement log-linéaire
    ne peut pas distinguer les deux, car son résultat dépend du nombre de vols.
puzzle-quantity = grandeur
puzzle-printed = imprimé
puzzle-computed = calculé
puzzle-verdict = verdict

job-check-failed = Le contrôle de la méthode a échoué : le programme ne trouve pas ce qui est connu. Aucune commande n'a été créée.
job-no-drop-added = Aucun essai n'a été ajouté à la commande.
job-damaged = { $count ->
    [one] Une ligne de { $file } est endommagée et ne compte pas ; `bouncelab job show` nomme chaque son sans ligne.
   *[other] { $count } lignes de { $file } sont endommagées et ne comptent pas ; `bouncelab job show` nomme chaque son sans ligne.
}
job-uncounted = { $file } est conservé mais ne compte pas : il n’a pas été inscrit, comme après une interruption. Si son essai est complet, { $command } le compte.

balls-numbers = { $ball }, contact { $contact }
balls-words = aussi : { $words }

listen-begins = écoute de { $source }, { $rate } kHz, { $channels ->
    [one] { $channels } voie
   *[other] { $channels } voies
  } ; { $file ->
    [none] rien n’est enregistré
   *[other] enregistré au fur et à mesure dans { $file }
  }
listen-saved-in = enregistré dans { $file }
listen-not-saved = NON ENREGISTRÉ
listen-silence = le microphone ne donne que du silence : est-il coupé, ou n’est-ce pas le bon (--devices) ?
listen-fault = l’analyse a échoué par une erreur du programme ; merci de la signaler
listen-goes-on = L’enregistrement continue jusqu’à ce que tu l’arrêtes.
listen-lost = du son a été perdu : l’ordinateur était trop lent, ou le microphone a eu un défaut ; les vols qui traversent la lacune sont exclus
listen-lost-in-all = { $frames } échantillons de chaque voie ({ $seconds } s) ont été perdus en { $count ->
    [one] { $count } endroit
   *[other] { $count } endroits
  }
listen-lacks-sound = tout le son n’a pas été enregistré : là où il a été perdu, le fichier contient du silence et le signale
listen-not-analysed = un essai ne peut pas être analysé : { $reason }
listen-once-more = essai { $number } à nouveau, d’après l’enregistrement entier
listen-heading = essai { $number }
listen-all-drops = Tous les essais :
listen-saved = le son est dans { $file } ; pour l’analyser à nouveau : { $command }
listen-left-out = l’essai à { $start } s { $reason ->
    [distant] est d’une balle bien plus faible que les autres
   *[unlikely] n’est pas confirmé par l’enregistrement entier
  } et est exclu
listen-impact = essai { $drop } : impact { $impact } à { $time } s après { $flight } ms{ $rests ->
    [yes] {" ; "}la balle est au repos
   *[no] {""}
  }
listen-line = e = { $restitution }, h0 = { $height } air négligé
listen-corrected = e = { $restitution } corrigé de la traînée
listen-too-loud = TROP FORT : écrêté
listen-level = niveau
listen-seconds = { $seconds } s
listen-drops = { $count ->
    [one] { $count } essai
   *[other] { $count } essais
  }
listen-sounds = { $count ->
    [one] { $count } son
   *[other] { $count } sons
  }
listen-lost-so-far = { $count } échantillons PERDUS
listen-ends = Ctrl-C arrête
listen-at = à s
listen-e-line = e, sans air
listen-h0-line = h0, sans air
listen-mean = moyenne
listen-scatter = dispersion
listen-save-failed = l’enregistrement du son a échoué : { $fault } ; { $seconds } s sont dans le fichier. L’écoute continue
listen-end-not-saved = la fin du son manque peut-être dans le fichier : { $fault }
listen-device = nom
listen-device-kind = ce que c’est
listen-device-default = par défaut

session-ball-assumed = La traînée dépend de la balle, qui n’a pas été indiquée : indique-la avec --ball, dans les noms des enregistrements ou dans session.toml.
session-title = Série
session-speed = Restitution à une vitesse d’impact de { $speed } m/s :
session-legend =
    ± : incertitude-type ; commune : la part que tous les essais partagent (traînée, air, balle, opérateurs)
    et que plus d’essais ne réduisent pas ; entre essais : dispersion au-delà de leurs propres erreurs ; { $wanted ->
        [none] requis : essais en tout qui réduiraient de moitié l’intervalle
       *[other] requis : essais en tout pour une restitution connue à ± { $wanted } (95 %)
      }
session-intervals = Intervalles à 95 %, et les écarts-types de l’ISO 5725 :
session-scatters = Dispersion à côté de celle des essais, relative :
session-curves = Restitution en fonction de la vitesse d’impact :
session-drop-heights = Hauteurs de chute :
session-outliers = Valeurs aberrantes de leur groupe ; leurs métadonnées sont-elles justes ?
session-outlier = { $name } : { $off } { $side ->
    [above] au-dessus
   *[below] au-dessous
  } des autres de { $group }, { $score } écarts-types
session-outliers-count = Elles sont comprises dans tous les résultats ci-dessus. Avec et sans elles :
session-exclude = --exclude NAME en exclut une de tout.
session-differences = Différences entre groupes :
session-more = et { $count } de plus (--details)
session-tables = Tableaux : { $list }
session-no-drop = aucun enregistrement ne contient d’essai
session-damaged-journal = { $count } lignes du journal sont tronquées ou endommagées, et sont ignorées
session-died = son analyse a terminé son processus deux fois, la seconde fois seule ({ $how }) ; s’il est long, donne-lui plus de --memory, sinon merci de le signaler
session-unmatched-names = { $count ->
    [one] { $count } nom ne correspond
   *[other] { $count } noms ne correspondent
  } pas au modèle « { $pattern } » : { $names }
session-noted-otherwise = { $first } et { $other } sont le même son, mais { $field } est { $of-first } pour l’un et { $of-other } pour l’autre ; c’est ce qui est noté du premier qui compte
session-not-noted = non noté
session-by-hand = exclu à la main
session-inference-left-out = les essais sont comparés par l’inférence, qui a été omise (--no-inference)
session-progress = analyse { $bar } { $done } enregistrements, { $rate }, reste { $left }
session-known = { $kept } enregistrements sur { $all } ont été analysés lors d’un passage précédent
session-out-of-time = son analyse a pris plus de { $seconds } s de temps processeur ; donne-lui plus de --time-limit, ou demande moins : moins de --draws, un enregistrement plus court
session-restitution = Restitution

serve-address = Le laboratoire est à l’adresse { $address } (Ctrl-C l’arrête)
serve-no-browser = aucun navigateur n’a pu être ouvert ({ $reason }) ; ouvre { $address } toi-même
page-written = { $files } fichiers sont dans { $folder }. Si un serveur les envoie en https, les téléphones peuvent utiliser le microphone.
