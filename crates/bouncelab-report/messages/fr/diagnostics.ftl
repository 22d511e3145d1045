diagnostic-recording-silent = L’enregistrement est silencieux : tous les échantillons ont la même valeur.
diagnostic-no-sound = Aucun son ne se détache du bruit de fond.
diagnostic-too-few-sounds = { $count ->
    [one] Seul { $count } son se détache
   *[other] Seuls { $count } sons se détachent
  } du bruit de fond ; la détection d’un essai demande au moins { $needed } impacts.
diagnostic-periodic-sounds = { $count } sons sont périodiques, toutes les { $interval_s } environ, comme ceux d’une horloge, de pas ou d’un tambour ; les vols d’une balle, eux, raccourcissent.
diagnostic-no-pattern = { $count } sons se détachent du bruit de fond, mais { $needed } d’entre eux n’ont nulle part les intervalles décroissants d’une balle qui rebondit.
diagnostic-too-few-times = Un vol demande deux temps d’impact, et il y en a moins.
diagnostic-too-many-times = La liste a { $count } temps ; aucun essai n’a plus de { $most } impacts. Donne ceux d’un seul essai. Une forme d’onde échantillonnée demande une seconde colonne, l’amplitude.
diagnostic-times-in-milliseconds = Des impacts sont distants de plus de 30 s ; aucune balle ne vole si longtemps. Les temps sont en secondes, sous le titre time_ms en millisecondes.
diagnostic-flights-do-not-fall = Les { $count } intervalles entre les temps ne raccourcissent pas comme les vols d’une balle qui rebondit : ils durent { $first_s } s au début et { $last_s } s à la fin. Ce sont des échantillons, une autre horloge ou plusieurs essais ; donne les temps d’impact d’un seul essai.
diagnostic-times-by-threshold = Les temps sont ceux où le son a dépassé un seuil, qui date un impact faible plus tard qu’un impact fort. Un enregistrement du son donne de meilleurs temps.
diagnostic-times-of-intervals = Les temps d’impact sont les sommes des intervalles donnés ; le premier impact est à 0 s.
diagnostic-nothing-left = Tant d’impacts ont été exclus qu’il ne reste aucun vol.
diagnostic-distant-ball = Une balle bien plus faible a été détectée de { $start_s } s à { $end_s } s ({ $impacts } impacts) et exclue.
diagnostic-drops-at-once = Deux balles rebondissent en même temps de { $start_s } s à { $end_s } s : si elles font le même bruit, un impact de l’une peut être pris pour un impact de l’autre.
diagnostic-clipped = { $samples ->
    [one] { $samples } échantillon est écrêté
   *[other] { $samples } échantillons sont écrêtés
  } : le niveau d’enregistrement était trop élevé ; les temps d’impact n’en souffrent guère, les niveaux si.
diagnostic-earlier-impact = Un son à { $time_s } s, avant l’essai à partir de { $start_s } s, peut être un impact antérieur, bien qu’il s’accorde mal avec les autres : si c’en est un, la balle est tombée de plus haut qu’indiqué.
diagnostic-sounds-unused = { $count } sons proches de l’essai à partir de { $start_s } s sont aussi forts que ses impacts et n’ont pas servi : d’autres sons, ou une seconde balle.
diagnostic-possible-drop = Essai possible { $number } : à partir de { $start_s } s, { $impacts } impacts, probabilité { $probability }. Il ne compte que si tu l’acceptes (--accept { $number }).
diagnostic-no-candidate = Il n’y a pas d’essai possible de numéro { $number }, mais { $count ->
    [0] aucun
   *[other] { $count }
  }.
diagnostic-nothing-to-exclude = Aucun impact n’est proche de { $time_s } s : rien n’y a été exclu.
diagnostic-too-far-to-include = { $time_s } s est à plus de { $reach_s } de tout essai, et n’a pas été ajouté.
diagnostic-sound-lost = Du son a été perdu à { $at_s } s : des { $impacts } impacts, les { $kept } de la plus longue partie sans lacune sont utilisés.
diagnostic-release-without-drop = Aucun essai ne commence après le lâcher indiqué à { $time_s } s.
diagnostic-height-of-another-unit = La hauteur indiquée est { $stated_m }, mais la chute détectée est d’environ { $detected_m } ; peut-être voulais-tu dire { $meant_m }.

diagnostic-file-unreadable = Le fichier ne peut pas être lu.
diagnostic-file-truncated = { $expected_s ->
    [none] Le fichier est tronqué ou endommagé, ou contient plus de son que n’en compte son en-tête : il a été lu jusqu’à { $read_s } s. Si du son a été inséré avant, les temps suivants sont trop longs.
   *[other] Le fichier est tronqué : { $read_s } s sur { $expected_s } s ont pu être lues. Si le reste ne manque pas à la fin, les temps suivants sont trop courts.
  }
diagnostic-samples-not-finite = { $samples ->
    [one] { $samples } échantillon n’était pas un nombre et a été remplacé
   *[other] { $samples } échantillons n’étaient pas des nombres et ont été remplacés
  } par zéro, le premier à { $first_s } s.
diagnostic-bits-flipped = { $samples } échantillons sautent d’une puissance de deux et reviennent, le premier à { $first_s } s : des bits du fichier sont altérés, des impacts peuvent manquer ou être faux.
diagnostic-sound-missing = { $places ->
    [one] Il manque { $missing_s } s de son à { $first_s } s
   *[other] Il manque { $missing_s } s de son en { $places } endroits, le premier à { $first_s } s
  } : un silence les remplace, et aucun vol qui le traverse n’est utilisé.
diagnostic-clock-lost = { $places ->
    [one] Le fichier est endommagé à { $first_s } s
   *[other] Le fichier est endommagé en { $places } endroits, le premier à { $first_s } s
  }, et n’indique pas combien de son manque : les temps d’avant et d’après ne se rapportent pas l’un à l’autre, et aucun vol entre eux n’est utilisé.
diagnostic-sound-blank = { $places ->
    [one] Le son est exactement nul pendant { $blank_s } s à { $first_s } s
   *[other] Le son est exactement nul pendant { $blank_s } s en { $places } endroits, le premier à { $first_s } s
  }, et pas ailleurs : il y a peut-être été perdu ou écrasé.
diagnostic-checksum-wrong = Les résultats peuvent être faux : le son n’est pas celui dont le fichier donne la somme de contrôle ou la longueur. Il a été modifié quelque part de { $start_s } s à { $end_s } s ; n’importe où dans cet intervalle, des impacts peuvent manquer, être décalés ou être en trop.
diagnostic-format-changes = Le son change de fréquence d’échantillonnage ou de nombre de voies à { $at_s } s ; il a été lu jusque-là.
diagnostic-rate-in-doubt = { $implied_hz ->
    [none] L’en-tête indique { $stated_hz } échantillons par seconde, ce qui est inhabituel dans ce format et n’est indiqué qu’une fois
   *[other] L’en-tête indique { $stated_hz } échantillons par seconde, mais son débit en octets correspond à { $implied_hz }
  } : si la fréquence est fausse, tous les temps le sont.
diagnostic-edit-list-ignored = La liste de montage du fichier réordonne ou déforme le son ; il a été lu tel qu’enregistré.

diagnostic-impacts-missed = { $count ->
    [1] Un impact intermédiaire n’a pas été détecté ; il est compté.
   *[other] { $count } impacts intermédiaires n’ont pas été détectés ; ils sont comptés.
  }
diagnostic-impact-gains-energy = { $count ->
    [one] L’impact { $impacts } a un coefficient de restitution
   *[other] Les impacts { $impacts } ont un coefficient de restitution
  } supérieur à 1 : double détection, surface mobile ou autre son.
diagnostic-restitution-rises = La restitution corrigée de la traînée croît avec la vitesse d’impact, de { $slow } à { $fast }, contrairement à celle des balles réelles ; la balle est probablement une autre, plus lourde pour sa taille.
diagnostic-impacts-doubtful = { $count ->
    [one] { $count } impact est
   *[other] { $count } impacts sont
  } plutôt autre chose (probabilité inférieure à 1/2).
diagnostic-flight-grows = Le vol { $flight } est plus long que le précédent, ce qui est impossible sur une surface au repos.

diagnostic-impacts-too-close = { $count ->
    [one] L’impact à { $start_s } s suit
   *[other] { $count } impacts à partir de { $start_s } s se suivent
  } à moins de deux fois la durée du contact de la balle ({ $contact_time_s }), et { $count ->
    [one] est laissé
   *[other] sont laissés
  } de côté. S’il y a de longs vols parmi eux, la balle est probablement une autre, ou son contact est plus court.
diagnostic-few-impacts = { $count ->
    [2] 2 impacts montrent un seul vol et aucune restitution de la balle
    [3] 3 impacts montrent une seule restitution de la balle, et non comment elle change avec la vitesse
   *[other] { $count } impacts montrent peu de restitutions de la balle
  } ; le reste du résultat vient des lois a priori.
diagnostic-flights-may-be-two = { $count } impacts seulement : si un impact entre deux autres n’a chaque fois pas été détecté, la balle garde { $restitution } de sa vitesse, et elle est tombée de { $height_m }. Les temps correspondent aux deux.
diagnostic-law-needs-impacts = Pour se distinguer d’une constante, la loi de restitution « { $law } » demande { $needed } impacts entre deux vols, et il y en a { $seen } : la variation de la restitution avec la vitesse vient de la loi a priori.
diagnostic-impacts-odd = { $count ->
    [one] L’impact { $impacts } est aberrant et pèse moins : la balle a pu dévier ou toucher un bord, ou le son est autre chose.
   *[other] Les impacts { $impacts } sont aberrants et pèsent moins : la balle a pu dévier ou toucher un bord, ou les sons sont autre chose.
  }
diagnostic-scatter-exceeds-prior = La restitution varie d’environ { $relative_sd } % d’un impact à l’autre, plus que les { $assumed_relative_sd } % supposés : les intervalles peuvent être trop étroits.
diagnostic-height-contradicts-times = La hauteur indiquée de { $measured_m } contredit les impacts, qui indiquent une chute de { $detected_m } ; elle n’est pas utilisée. Les deux s’accorderaient avec une pesanteur de { $gravity_m_s2 }. La hauteur, la balle ou la fréquence d’échantillonnage est peut-être fausse.
diagnostic-first-impact-doubtful = Le premier impact, à { $time_s } s, s’accorde mal avec les autres : avec une probabilité de { $probability }, c’est un autre bruit, ou il vient d’une chute précédente, et la balle est tombée de { $height_m }.
diagnostic-release-contradicts-times = Le lâcher indiqué, { $stated_s } s avant le premier impact, contredit les impacts, qui indiquent une chute de { $detected_s } s ; il n’est pas utilisé.
diagnostic-first-impacts-missed = Des impacts avant le premier détecté ont été manqués, avec une probabilité de { $probability }.
diagnostic-other-ball-fits-better = Les temps correspondent mieux à une autre sorte de balle que celle indiquée, au moins { $odds } contre 1 : { $balls }. Vérifie quelle balle c’était.
diagnostic-never-rests = Selon certaines lois de restitution possibles, la balle perd si peu aux impacts lents qu’elle n’atteindrait pas le repos en un temps raisonnable.
diagnostic-inference-off = Aucune inférence n’a été demandée.
diagnostic-inference-needs-impacts = Une inférence demande au moins un vol, soit deux impacts.
diagnostic-restitution-undetermined = Il y a trop peu d’impacts : avec { $count }, la restitution peut aller de { $least } à { $greatest }. Enregistre au moins trois impacts, ou mesure et indique la hauteur de chute.
diagnostic-contact-overlaps = Les impacts { $first } et { $second }, à { $time_s } s, sont séparés de { $interval_s }, et la balle touche la surface pendant { $contact_time_s }. L’un d’eux est probablement un écho ou un autre son : exclus-le. Sinon, corrige la balle ou sa durée de contact.
diagnostic-no-model-fits = Aucun modèle physique ne convient à ces temps. Vérifie qu’ils sont en secondes et d’un seul essai, exclus les autres sons, et vérifie la balle.
diagnostic-sampling-not-converged = Les temps ne déterminent pas l’essai : le calcul des incertitudes n’a pas convergé. Exclus les impacts qui ne sont pas de cet essai, vérifie la balle, ou enregistre plus d’impacts.
diagnostic-sampling-failed = Ces temps ne s’expliquent pas comme ceux d’un seul essai. Exclus les autres sons, ou analyse chaque essai à part.
diagnostic-missed-in-a-row = { $missed } impacts de suite ont été manqués après l’impact { $after }. Ajoute-les, ou exclus les impacts après la lacune.
diagnostic-flight-too-long = Le vol après l’impact { $after } dure { $duration_s }, ce que la traînée de l’air rend impossible pour cette balle. Ajoute un impact manqué à cet endroit, ou vérifie la masse, le diamètre et l’unité des temps.
diagnostic-gains-speed = La balle gagnerait de la vitesse à la plupart des impacts, ce qui est impossible sur une surface au repos ; les temps sont-ils dans l’ordre, en secondes, et d’un seul essai ?
diagnostic-variances-confounded = Les variances de ces groupes ne peuvent pas être séparées.

diagnostic-out-of-range = { $quantity } : { $value }{ $unit ->
    [none] {""}
   *[other] {" "}{ $unit }
  } ; valeur admise : { $range ->
    [above] finie et supérieure à { $low }
    [at-least] finie et au moins { $low }
    [below] finie et inférieure à { $high }
    [at-most] finie et au plus { $high }
    [above-below] supérieure à { $low } et inférieure à { $high }
    [above-at-most] supérieure à { $low } et au plus { $high }
    [at-least-below] au moins { $low } et inférieure à { $high }
    [at-least-at-most] de { $low } à { $high }
   *[finite] finie
  }
diagnostic-unknown-name = Nom inconnu ({ $kind }) : « { $name } » ; le plus proche est « { $nearest } » (connus : { $known }).
diagnostic-reynolds-too-high = La table de traînée s’arrête au nombre de Reynolds { $max_reynolds }, mais la balle atteint { $reynolds } ; ajoutes-y un point ou choisis la courbe standard.
diagnostic-ball-floats = La balle pèse { $mass_kg } et déplace { $displaced_kg } d’air : elle flotte ; vérifie la masse et le diamètre, ou néglige la poussée d’Archimède.
diagnostic-endless-drop = La balle monte encore à { $apex_m } après { $bounces } rebonds ; diminue la restitution, arrête à une hauteur plus grande, ou demande au plus { $bounces } rebonds.
diagnostic-too-few-flights = Un ajustement log-linéaire des temps de vol demande au moins 2 vols, et il y en a { $flights } ; utilise un enregistrement d’au moins 3 impacts, ou une plus large plage de vols.
diagnostic-too-few-drops = Il faut au moins { $needed } essais, et il y en a { $drops }.
diagnostic-no-band = Aucune bande n’est au moins pour moitié { $range } Hz ; à cette fréquence d’échantillonnage, les bandes sont { $bands } Hz.
diagnostic-settings-contradict = { $first } et { $second } se contredisent ; supprime l’un des deux.
diagnostic-not-in-order = { $what } numéro { $number } : ce numéro ne dépasse pas le précédent ; numérote dans l’ordre, une fois chacun.
diagnostic-no-channel = Il n’y a pas de voie { $channel } : l’enregistrement { $channels ->
    [1] n’en a qu’une
   *[other] en a { $channels }, la première étant la 1
  }.
diagnostic-too-many-drops = Il y a { $drops } essais ; seuls les { $most } premiers, jusqu’à { $end_s } s, ont été analysés. Coupe l’enregistrement à cet endroit, et analyse le reste à part.
diagnostic-too-many-channels = { $channels } voies sont plus qu’on ne peut en analyser ensemble : à cette fréquence d’échantillonnage, { $most } au plus ; choisis l’une d’elles.
diagnostic-each-of-reference = Une part d’une référence compare des moyennes : un essai isolé n’a pas de part.
diagnostic-implausible-quantity = { $quantity } : { $value } { $unit } ?{ $meant_unit ->
    [none] {""}
   *[other] {" "}Voulais-tu dire { $meant } { $meant_unit } ?
  }
diagnostic-implausible-ball = Une balle de { $mass_kg } et de { $diameter_m } de diamètre ?{ $meant_g ->
    [none] { $meant_cm ->
        [none] { $meant_mm ->
            [none] {""}
           *[other] {" "}Voulais-tu dire { $meant_mm } mm ?
          }
       *[other] {" "}Voulais-tu dire { $meant_cm } cm ?
      }
   *[other] { $meant_mm ->
        [none] {" "}Voulais-tu dire { $meant_g } g ?
       *[other] {" "}Voulais-tu dire { $meant_g } g et { $meant_mm } mm ?
      }
  }

diagnostic-assumed-ball = La balle est : { $ball }.
diagnostic-ball-not-stated = La balle n’est pas indiquée : les intervalles valent pour chaque sorte de balle que les temps permettent. Si on l’indique, ils se resserrent.
diagnostic-assumed-contact-time = La balle touche la surface pendant { $contact_time_s }.
diagnostic-assumed-rule-ball = La balle est celle de la règle : { $ball }.
diagnostic-assumed-rule-height = Le point le plus bas de la balle est tombé de { $height_m } ± { $sd_m }, comme dans la règle.
diagnostic-assumed-air = Air à { $temperature_k } °C, { $pressure_pa } hPa, { $relative_humidity } % d’humidité.
diagnostic-assumed-gravity = Pesanteur { $gravity_m_s2 }.

diagnostic-prior-restitution = Restitution : uniforme de 0 à 1.
diagnostic-prior-restitution-stated = Restitution selon la vitesse d’impact, comme indiqué : { $prior }.
diagnostic-prior-scatter = Dispersion de la restitution : environ { $relative_sd } %, probablement de { $low_relative_sd } à { $high_relative_sd } %.
diagnostic-prior-slow-losses = Impacts plus lents que ceux détectés : comme le dit la loi, ou avec des pertes qui croissent en plus quand la vitesse diminue (selon une puissance d’environ { $exponent }).
diagnostic-prior-exact = { $input } : exact.
diagnostic-prior-unknown = { $input } : inconnu (un facteur e dans les deux sens).
diagnostic-prior-input = { $input } : connu à { $relative_sd } % près.
diagnostic-prior-height = Hauteur de chute : mesurée, { $height_m } ± { $sd_m }.
diagnostic-prior-height-flat = Hauteur de chute : uniforme en logarithme.
diagnostic-prior-release = Lâcher : mesuré, { $release_s } s ± { $sd_s }.
diagnostic-prior-missed = Chaque impact de plus manqué au début : deux fois moins probable ; là où c’était silencieux, presque impossible. Dans une liste de temps, rien ne montre si des impacts ont été manqués.

diagnostic-rule-without-limits = La règle n’indique pas de limites.
diagnostic-procedure-not-kept = La procédure de la règle n’a pas été suivie : { $item }.
diagnostic-drop-without-first-flight = Le premier vol de l’essai { $drop } n’a pas été détecté : la règle demande le rebond du premier impact.
diagnostic-rule-secondary = Le texte de cette règle n’a pas été lu, mais un texte qui la cite : vérifie l’édition en vigueur avant de te fier à un verdict.
diagnostic-model-differs = Le modèle donne une autre valeur que la procédure de la règle, l’écart dépassant les incertitudes des deux ; le verdict suit la procédure.
diagnostic-drops-that-decide = { $drops } essais avec cette moyenne et cette dispersion décideraient.
diagnostic-no-drops-decide = Plus d’essais ne décideraient pas : ce qu’ils ont en commun, comme la hauteur de chute et la durée de contact, est trop incertain.
diagnostic-rule-needs-height = La règle n’indique pas de hauteur, et la hauteur de chute n’a pas été indiquée.
diagnostic-limit-within-uncertainty = Une limite est à l’intérieur de l’incertitude ; des essais plus nombreux ou meilleurs aideraient.
diagnostic-rule-unverified = Cette règle a été écrite de mémoire ; ne t’y fie pas.
diagnostic-formula-unverified = Le texte de la formule de cette règle n’a pas été lu ({ $read }).
diagnostic-rule-other-ball = La règle vaut pour une balle du type { $ball }, et la balle indiquée a une autre masse ou un autre diamètre : est-ce la bonne règle ?
diagnostic-rule-without-point = La règle n’indique pas en quel point de la balle elle mesure ; c’est le plus bas qui est pris.
diagnostic-verdict-of-few-drops = { $drops ->
    [one] Le verdict porte sur ce seul essai : il ne montre pas la dispersion entre essais ; trois ou plus le feraient.
   *[other] Deux essais ne montrent guère la dispersion entre essais : leur moyenne est incertaine ; un troisième aiderait beaucoup.
  }
