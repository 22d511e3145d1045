test-heading = Rapport d’essai
test-title = Rapport d’essai { $number }
test-name = nom
test-number = numéro
test-laboratory = laboratoire
test-client = client
test-item = objet soumis à l’essai
test-sample = échantillon
test-from-client = déclaré par le client, non vérifié
test-received = reçu
test-tested = essayé
test-issued = émis
test-location = lieu
test-operator = opérateur
test-method = méthode
test-deviations = écarts à la méthode
test-external = résultats d’autres laboratoires
test-conditions = conditions
test-reference = référence
test-equipment = équipement et étalonnage
test-authorised = autorisé par
test-closing = Déclarations
test-only-items = Les résultats ne concernent que les objets soumis à l’essai, tels que reçus. Ce rapport ne doit pas être reproduit, sinon en entier, sans l’approbation du laboratoire.
test-end = Fin du rapport
test-not-given = non indiqué
test-check = vérification de la méthode
test-checked = { $made }, bouncelab { $version } : d'un essai synthétisé avec un premier rebond de { $truth }, { $found } a été trouvé ; { $agrees ->
    [yes] ils concordent dans l'incertitude
   *[no] ils DIFFÈRENT de plus que l'incertitude
}
job-place = emplacement { $place } sur { $places }, essai { $drop } sur { $drops }
job-reference = référence, essai { $drop } sur { $drops }
job-place-name = emplacement { $place }
job-repeated = répété : { $reason }
job-so-far = Jusqu'ici { $value }. { $outcome }
job-microphone = microphone
