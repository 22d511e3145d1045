sheet-fields = Nom : _________________________ Classe : ______________ Date : ______________
sheet-page = La page sur ton téléphone : { $address }
sheet-set-up = Une balle au-dessus du sol, sa hauteur h, et un téléphone à côté
sheet-qr-code = Code QR de la page
sheet-need = Il te faut
sheet-do = Que faire
sheet-write = Note
sheet-work = Calcule
sheet-expected = À quoi s’attendre
sheet-expected-made = Calculé par bouncelab, avec l’air d’une pièce (20 °C, niveau de la mer) et la pesanteur normale. La restitution des tableaux est supposée la même à toute vitesse.
sheet-talk = À discuter
sheet-teacher = Pour l’enseignant
sheet-teacher-collect = Rassembler : chaque groupe partage son essai par un lien, et le tableau des essais de la page prend tous les liens à la fois. Il les groupe par balle et surface, donne la moyenne de chaque groupe avec son intervalle à 95 %, et nomme les essais qui ne conviennent pas.
sheet-teacher-quiet = Un sol dur ou une dalle de pierre sur une table stable, et dix secondes de silence, suffisent. Le téléphone est à moins d’un mètre, pas sur la dalle.
sheet-no-air = sans air
sheet-column-ball = balle
sheet-column-drop = essai
sheet-column-restitution = e
sheet-column-first = T₁ (s)
sheet-column-second = T₂ (s)
sheet-column-third = T₃ (s)
sheet-column-ratio = T₂ / T₁
sheet-column-height = hauteur du rebond 1 (cm)
sheet-column-terminal = vitesse limite (m/s)
sheet-column-speed = vitesse à l’impact 1 (m/s)
sheet-column-share = traînée alors, en % du poids
sheet-column-gravity = 8 h T₂² / T₁⁴ (m/s²)
sheet-column-off = écart (%)
sheet-column-mean = moyenne

sheet-bounciness-title = Comment une balle rebondit-elle ?
sheet-bounciness-aim = Une balle garde une fraction e de sa vitesse à chaque rebond : son coefficient de restitution. Tu trouves e avec l’oreille d’un téléphone, car chaque vol dure environ e fois le précédent.
sheet-bounciness-need-1 = trois balles différentes, un sol dur, une règle ou un mètre ruban
sheet-bounciness-need-2 = un téléphone ou un ordinateur avec la page de bouncelab
sheet-bounciness-do-1 = Choisis ta balle sur la page, pose le téléphone près du point de chute, et touche « Écouter ».
sheet-bounciness-do-2 = Tiens le point le plus bas de la balle à { $height } cm du sol. Lâche sans pousser. Attends que la balle soit au repos.
sheet-bounciness-do-3 = Lis les premiers temps de vol dans la liste des impacts : T₁ est le temps de l’impact 1 à l’impact 2, T₂ de 2 à 3.
sheet-bounciness-do-4 = Lâche chaque balle trois fois.
sheet-bounciness-work-1 = Divise T₂ par T₁ pour chaque essai, et prends la moyenne de chaque balle.
sheet-bounciness-work-2 = Quelle balle garde le plus de sa vitesse ? Quelle fraction de son énergie garde-t-elle (e²) ?
sheet-bounciness-work-3 = Compare ton T₂ / T₁ à la valeur e de la page. Lequel est le plus grand, et pourquoi ?
sheet-bounciness-see = Une balle ({ $ball }) lâchée de { $height } cm, pour plusieurs valeurs de e. T₂ / T₁ est inférieur à e : l’air aussi ralentit la balle.
sheet-bounciness-talk-1 = Pourquoi la durée d’un vol donne-t-elle la vitesse à laquelle il a commencé ?
sheet-bounciness-talk-2 = La hauteur d’un rebond est e² fois la précédente. Quelle est la hauteur du rebond 5 de ta meilleure balle ?
sheet-bounciness-talk-3 = Trois essais de la même balle diffèrent. Est-ce la balle, le sol ou ta façon de lâcher ?
sheet-bounciness-teacher-1 = Sans air, T₂ / T₁ = e. L’écart du tableau est presque tout l’effet de l’air : { $off } % pour e = 0,90. La page retire l’air de son e.

sheet-air-title = Quel est l’effet de l’air ?
sheet-air-aim = L’air ralentit toute balle, surtout une légère et grande. Tu mesures de combien, avec des temps de vol qui diminueraient tous dans le même rapport s’il n’y avait pas d’air.
sheet-air-need-1 = une balle de tennis de table, une balle de tennis et une balle de golf (ou une bille d’acier), un sol dur, un mètre ruban
sheet-air-need-2 = un téléphone ou un ordinateur avec la page de bouncelab
sheet-air-do-1 = Choisis la balle sur la page, touche « Écouter », et lâche la balle de { $height } cm.
sheet-air-do-2 = Note les temps des trois premiers vols de chaque balle.
sheet-air-do-3 = Regarde la figure « Restitution » de chaque essai : une fois comme s’il n’y avait pas d’air, une fois corrigée de l’air.
sheet-air-work-1 = Calcule T₂ / T₁ et T₃ / T₂. Sans air ils seraient égaux, si la balle garde la même fraction à chaque rebond.
sheet-air-work-2 = Quelle balle a la plus grande différence entre T₂ / T₁ et T₃ / T₂ ? Pourquoi celle-là ?
sheet-air-work-3 = Estime la traînée au premier impact par la vitesse limite : traînée / poids = (vitesse / vitesse limite)².
sheet-air-see = Des balles lâchées de { $height } cm qui ont toutes e = { $restitution }. L’air fait varier T₂ / T₁, et un peu aussi la durée pendant laquelle une balle touche le sol.
sheet-air-talk-1 = Pourquoi la bille d’acier ne sent-elle presque pas l’air, bien qu’elle soit si petite ?
sheet-air-talk-2 = Aux vols suivants, plus lents, T₃ / T₂ se rapproche de e. Pourquoi ?
sheet-air-talk-3 = Une classe a mesuré une balle de tennis de table sans penser à l’air. Son e est-il trop grand ou trop petit ?
sheet-air-teacher-1 = La traînée d’une balle de tennis de table à son premier impact est { $share } % de son poids. Elle rend T₂ / T₁ plus petit que e de { $off } %.
sheet-air-teacher-2 = Le vrai e d’une balle change avec la vitesse : T₃ / T₂ − T₂ / T₁ n’est donc pas l’effet de l’air seul. La page sépare les deux, et dit où l’essai ne le peut pas.

sheet-gravity-title = Mesurer g avec une balle
sheet-gravity-aim = D’une hauteur connue et de deux temps de vol suit l’accélération de la pesanteur g, sans chronomètre : la balle dit elle-même ce qu’elle perd à chaque rebond.
sheet-gravity-need-1 = une balle lourde et petite (golf ou acier), une dalle de pierre, une règle au millimètre
sheet-gravity-need-2 = un téléphone ou un ordinateur avec la page de bouncelab
sheet-gravity-do-1 = Mesure la hauteur h de la dalle au point le plus bas de la balle : { $height } cm, au millimètre si possible.
sheet-gravity-do-2 = Touche « Écouter » et lâche sans pousser. Lâche la balle cinq fois.
sheet-gravity-do-3 = Note T₁ et T₂ avec quatre décimales.
sheet-gravity-work-1 = La balle arrive avec v = √(2 g h) et repart avec e v. Donc T₁ = 2 e v / g, et e = T₂ / T₁. Montre que g = 8 h T₂² / T₁⁴.
sheet-gravity-work-2 = Calcule g pour chaque essai, puis la moyenne et son erreur-type.
sheet-gravity-work-3 = Sur la page, donne la hauteur sous « modifier », coche « mesurer g », et compare.
sheet-gravity-see = Ce que donne la formule pour des balles lâchées de { $height } cm avec e = { $restitution }, si g vaut { $gravity } m/s².
sheet-gravity-talk-1 = La balle de tennis donne un g trop petit, bien qu’elle sente moins l’air que la balle de tennis de table. Qu’est-ce qui prend encore du temps lors d’un rebond ?
sheet-gravity-talk-2 = Un millimètre sur { $height } cm fait { $share } %. Quelle erreur de g en résulte ?
sheet-gravity-talk-3 = g vaut 9,78 m/s² à l’équateur et 9,83 m/s² aux pôles. Pourrais-tu les distinguer ?
sheet-gravity-teacher-1 = La formule contient e au carré : si e varie de 0,5 % d’un rebond à l’autre, g varie de { $scatter } % d’un essai à l’autre. Avec cinq essais, la moyenne est connue à { $mean } % près.
sheet-gravity-teacher-2 = Le lâcher compte le plus : une balle poussée ou tournée a une autre hauteur. Un aimant qui lâche une bille d’acier aide.
sheet-gravity-teacher-3 = Une balle de tennis touche le sol pendant { $contact } ms, comptées comme vol : g est trop petit de { $soft } %. L’air raccourcit T₁ et diminue T₂ / T₁ ; dans cette formule, les deux se compensent presque. La page retire l’un et l’autre.

sheet-ball-table-tennis-40 = tennis de table
sheet-ball-tennis = tennis
sheet-ball-golf = golf
sheet-ball-steel = acier, 2 cm
