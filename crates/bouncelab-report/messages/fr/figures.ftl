axis-amplitude = amplitude, relative à la pleine échelle
axis-bounce = rebond
axis-drag = traînée / poids
axis-drag-coefficient = coefficient de traînée
axis-drop = essai
axis-drop-height = hauteur de chute
axis-energy-lost = énergie perdue
axis-flight = numéro du vol
axis-flight-time = temps de vol
axis-height = hauteur
axis-impact = impact
axis-impact-speed = vitesse d’impact
axis-off-line = résidu de l’ajustement
axis-rebound = hauteur de rebond
axis-restitution = restitution : vitesse après / avant
axis-restitution-at = restitution à { $speed }
axis-restitution-short = restitution
axis-share-of-reference = part de la référence
axis-speed = vitesse
axis-time = temps

figure-bounce-energies-title = Où va l’énergie ?
figure-bounce-energies-tab = Énergie
figure-bounce-energies-caption = L’énergie perdue à chaque impact et, au-dessus, celle que l’air prend pendant le vol suivant : plus la balle est rapide, plus la part de l’air est grande.
figure-bounce-energies-empty = Il n’y a pas d’énergie à montrer.
figure-bounce-energies-air = l’air, pendant le vol suivant
figure-bounce-energies-surface = le rebond

figure-bounce-heights-title = Quelle hauteur à chaque rebond ?
figure-bounce-heights-tab = Hauteurs
figure-bounce-heights-caption = Chaque rebond atteint à peu près la même fraction de la hauteur précédente : les points sont proches d’une droite.
figure-bounce-heights-empty = Il n’y a pas de hauteur à montrer.

figure-budget-title = D’où vient l’incertitude
figure-budget-tab = Bilan
figure-budget-caption = Chaque barre est la part d’une source dans la variance : pour mieux connaître la balle, réduis la source du haut.
figure-budget-empty = Il n’y a pas d’incertitude à montrer.
figure-budget-axis = part de la variance
figure-budget-drop-height = hauteur de chute : { $value }
figure-budget-others = toutes les autres
figure-budget-restitution = restitution : { $value }

figure-calibration-title = Où se trouve la valeur vraie parmi les tirages
figure-calibration-caption = Barres plates : les intervalles sont bien calibrés. Une bosse indiquerait des intervalles trop larges, un creux des intervalles trop étroits, une pente un biais.
figure-calibration-empty = Il n’y a pas de rang à montrer.
figure-calibration-drops = essais simulés
figure-calibration-expected = 99 % des barres finissent ici si tout est calibré
figure-calibration-rank = rang de la valeur vraie

figure-comparison-title = L’essai et sa simulation
figure-comparison-tab = Comparer
figure-comparison-caption = Là où les courbes se séparent, le modèle est incomplet, ou un impact est un autre son.
figure-comparison-empty = Il n’y a pas de hauteur à montrer.
figure-comparison-best-fit = simulée, avec 95 %
figure-comparison-measured = mesuré
figure-comparison-simulation = ta simulation

figure-detection-found-title = Impacts trouvés dans le bruit
figure-detection-found-caption = F1 vaut 1 là où chaque impact aussi fort que le bruit est trouvé, et rien d’autre.
figure-detection-found-empty = Il n’y a rien à comparer : aucune courbe n’a de point.
figure-detection-found-axis = F1
figure-detection-found-loudness = impact le plus fort au-dessus du bruit

figure-detection-late-title = Les impacts faibles ne sont pas datés plus tard que les forts
figure-detection-late-caption = Le premier échantillon au-dessus d’un seuil fixe vient d’autant plus tard que l’impact est faible ; le meilleur ajustement de toute la forme d’onde ne dépend pas du niveau.
figure-detection-late-empty = Il n’y a rien à comparer : aucune courbe n’a de point.
figure-detection-late-axis = retard sur le plus fort
figure-detection-late-loudness = impact au-dessus du bruit

figure-detection-stated-title = Erreurs des temps de vol et erreurs-types annoncées
figure-detection-stated-caption = 68 % des erreurs normales sont inférieures à une erreur-type.
figure-detection-stated-empty = Il n’y a rien à comparer : aucune courbe n’a de point.
figure-detection-stated-axis = à moins d’une erreur-type
figure-detection-stated-loudness = impact le plus fort au-dessus du bruit

figure-detection-timing-title = Erreurs des temps de vol et borne de Cramér-Rao
figure-detection-timing-caption = La borne de Cramér-Rao est la plus petite erreur avec laquelle on peut dater un son connu dans un bruit blanc.
figure-detection-timing-empty = Il n’y a rien à comparer : aucune courbe n’a de point.
figure-detection-timing-axis = erreur médiane rapportée à la borne
figure-detection-timing-loudness = impact le plus fort au-dessus du bruit

figure-drag-title = Traînée de l’air rapportée au poids
figure-drag-tab = Traînée
figure-drag-caption = La traînée croît presque comme le carré de la vitesse et équilibre le poids à la vitesse limite, où la courbe atteint 1.
figure-drag-reached = La traînée croît presque comme le carré de la vitesse et équilibre le poids à la vitesse limite, où la courbe atteint 1 ; cet essai a atteint { $speed }.
figure-drag-empty = Il n’y a pas de courbe de traînée à montrer.
figure-drag-fastest = cet essai : jusqu’à { $speed }

figure-drag-log-title = Traînée de l’air rapportée au poids
figure-drag-log-tab = Traînée (log)
figure-drag-log-caption = Un coefficient de traînée constant est ici une droite ; les lois diffèrent à faible vitesse, où la traînée est trop petite pour compter.
figure-drag-log-reached = Un coefficient de traînée constant est ici une droite ; les lois diffèrent à faible vitesse, où la traînée est trop petite pour compter ; cet essai a atteint { $speed }.
figure-drag-log-empty = Il n’y a pas de courbe de traînée à montrer.

figure-flight-times-title = Temps de vol et ajustement log-linéaire
figure-flight-times-tab = Avec et sans air
figure-flight-times-caption = Sans air, chaque vol durerait la même fraction du précédent, { $ratio } d’après l’ajustement ; une courbure dans le panneau du bas révèle la traînée, ou une restitution qui change avec la vitesse.
figure-flight-times-no-line = { $count ->
    [one] { $count } vol
   *[other] { $count } vols
}, sans ajustement.
figure-flight-times-empty = Il n’y a pas de vol à montrer.
figure-flight-times-line = ajustement log-linéaire : × { $ratio } à chaque fois
figure-flight-times-all = vols mesurés
figure-flight-times-unused = non utilisés
figure-flight-times-used = vols utilisés

figure-groups-title = Restitution de chaque groupe selon la vitesse
figure-groups-caption = Chaque point est un impact ; chaque ligne est la courbe d’un groupe, avec son intervalle à 95 %.
figure-groups-more = Les { $shown } premiers groupes sur { $all } sont montrés.
figure-groups-empty = Aucun impact n’a une restitution connue.

figure-height-title = Hauteur de la balle
figure-height-tab = Hauteur
figure-height-caption = Chaque rebond est plus bas et plus court que le précédent : une infinité de rebonds tient en un temps fini.
figure-height-caption-apexes = Chaque rebond est plus bas et plus court que le précédent ; les points sont les sommets mesurés.
figure-height-caption-models = Les modèles partent ensemble et s’écartent avec le temps, car un vol plus bas est aussi plus court.
figure-height-empty = Il n’y a pas de hauteur à montrer.
figure-height-apexes = sommets mesurés
figure-height-model = modèle de vol, traînée : { $drag }

figure-intervals-title = Restitution de chaque groupe
figure-intervals-caption = Si les barres foncées de deux groupes sont éloignées, les groupes diffèrent ; si l’une est dans la barre claire de l’autre, des essais isolés ne les distinguent pas.
figure-intervals-empty = Il n’y a pas de groupe à comparer.
figure-intervals-count = { $count ->
    [one] { $count } essai
   *[other] { $count } essais
}
figure-intervals-drops = essais
figure-intervals-mean = restitution, 95 %
figure-intervals-next = essai suivant, 95 %
figure-intervals-outliers = valeur aberrante

figure-limits-title = La hauteur de rebond et les limites
figure-limits-caption = Une valeur dont la barre est entre les limites les respecte avec une probabilité d’au moins 95 %.
figure-limits-empty = Il n’y a pas de valeur à comparer aux limites.
figure-limits-accepted = accepté avec cette incertitude
figure-limits-interval = 95 %
figure-limits-within = dans les limites

figure-models-title = Quelle loi est la plus probable ?
figure-models-tab = Lois
figure-models-caption = Plus la barre est longue, plus la loi est probable ; si aucune ne domine, le résultat est une moyenne sur toutes.
figure-models-empty = Il n’y a pas de modèle à comparer.
figure-models-interval = hauteur de chute, 68 %
figure-models-probability = probabilité

figure-posterior-title = Loi a posteriori conjointe
figure-posterior-tab = Loi a posteriori
figure-posterior-caption = Un nuage rond : les données séparent les deux grandeurs. Un nuage incliné : elles sont corrélées. Un histogramme aussi large que la courbe grise : les données n’ajoutent rien à l’a priori.
figure-posterior-empty = Il n’y a pas de grandeur à montrer.
figure-posterior-posterior = après les données : 68 % foncé, 95 % clair
figure-posterior-prior = avant les données

figure-residuals-title = Résidu de chaque impact
figure-residuals-tab = Résidus
figure-residuals-caption = Deux impacts sur trois devraient être dans la bande foncée, 19 sur 20 dans la claire ; un impact bien en dehors a touché un bord, ou est un autre son.
figure-residuals-empty = Il n’y a pas de résidu à montrer.
figure-residuals-axis = résidu (écarts-types)
figure-residuals-impact = impact
figure-residuals-odd = aberrant, pèse moins

figure-restitution-title = Restitution de chaque impact
figure-restitution-tab = Restitution
figure-restitution-caption = La restitution est le rapport de la vitesse après un impact à la vitesse avant. L’écart entre le gris et le bleu est dû à l’air ; l’ajustement log-linéaire l’attribue à l’impact.
figure-restitution-empty = Aucun impact n’a une restitution connue.
figure-restitution-corrected = corrigé de la traînée
figure-restitution-law = loi ajustée, 68 et 95 %
figure-restitution-line = ajustement log-linéaire : { $value }
figure-restitution-odd = aberrant, pèse moins
figure-restitution-raw = air négligé

figure-run-title = Y a-t-il une dérive ?
figure-run-caption = Niveau de chaque essai moins la médiane de son groupe, dans l’ordre : une pente ou une marche signifie que la balle, la surface ou l’air ont changé.
figure-run-empty = Il n’y a pas d’essai à montrer.
figure-run-off = ln e moins la médiane du groupe
figure-run-order = essai, dans l’ordre
figure-run-outlier = valeur aberrante
figure-run-unchanged = si rien ne change

figure-truncation-title = Le résultat dépend-il du nombre de vols utilisés ?
figure-truncation-tab = Nombre de vols
figure-truncation-caption = Un modèle correct donne le même résultat pour tout nombre de vols ; celui de l’ajustement log-linéaire change, parce qu’il néglige l’air.
figure-truncation-empty = Il n’y a pas de résultat à comparer.
figure-truncation-flights = vols utilisés
figure-truncation-inference = inférence, avec air
figure-truncation-line = ajustement log-linéaire
figure-truncation-stated = indiquée

figure-waveform-title = Le son et ses impacts
figure-waveform-caption = { $impacts ->
    [one] { $impacts } impact
   *[other] { $impacts } impacts
} { $drops ->
    [1] d’un essai
   *[other] de { $drops } essais
}{ $uncertain ->
    [0] {""}
    [1] {" "}(1 incertain, ouvert et orange)
   *[other] {" "}({ $uncertain } incertains, ouverts et orange)
}{ $pattern ->
    [yes] {" : "}leur intervalle se réduit chaque fois dans presque le même rapport
   *[no] {""}
}.
figure-waveform-no-impacts = Le son, dans lequel aucun impact n’a été trouvé.
figure-waveform-empty = Il n’y a pas de son à montrer.
figure-waveform-drop = essai { $number }
figure-waveform-impact = impact
figure-waveform-uncertain = impact incertain

figure-drop-impacts-title = Restitution de chaque impact, essai par essai
figure-drop-impacts-caption = Corrigée de la traînée. Les essais d’une même balle sur une même surface devraient suivre une même ligne.
figure-drop-impacts-more = Les { $shown } derniers essais sur { $all } sont montrés.
figure-drop-impacts-empty = Aucun impact n’a une restitution connue.

figure-drops-title = Restitution de chaque essai
figure-drops-caption = Ce qu’une balle garde de sa vitesse, essai par essai ; les barres sont d’un écart-type.
figure-drops-empty = Il n’y a pas d’essai à montrer.

figure-lesson-title = La hauteur de chute d’après l’ajustement log-linéaire
figure-lesson-caption = Sans air, l’ajustement donne la vraie hauteur quel que soit le nombre de vols ; avec air, sa hauteur diminue à chaque vol de plus.
figure-lesson-empty = Il n’y a pas de vol à montrer.
figure-lesson-air = avec air
figure-lesson-flights = vols dans l’ajustement
figure-lesson-height-of-line = hauteur de chute ajustée
figure-lesson-no-air = sans air
figure-lesson-paper = comme dans l’article
figure-lesson-truth = vraie hauteur

figure-lesson-height-title = La hauteur avec et sans air
figure-lesson-height-caption = Deux essais de même restitution ; l’air abrège l’essai.
figure-lesson-height-empty = Il n’y a pas de hauteur à montrer.

figure-lesson-line-title = Temps de vol sans air
figure-lesson-line-caption = Sur cet axe, des vols dont chacun dure la même fraction du précédent sont sur une droite.
figure-lesson-line-empty = Il n’y a pas de vol à montrer.
figure-lesson-line-line = ajustement log-linéaire

figure-run-flight-times-title = Temps de vol
figure-run-flight-times-caption = Sur cet axe, des vols à restitution constante et sans air sont sur une droite ; une courbure révèle la traînée, ou une restitution qui change avec la vitesse.
figure-run-flight-times-empty = Il n’y a pas de vol à montrer.

figure-runs-title = Hauteur de la balle
figure-runs-caption = Chaque rebond est plus bas et plus court que le précédent.
figure-runs-empty = Il n’y a pas de hauteur à montrer.
