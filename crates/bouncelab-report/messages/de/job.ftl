test-heading = Prüfbericht
test-title = Prüfbericht { $number }
test-name = Bezeichnung
test-number = Nummer
test-laboratory = Laboratorium
test-client = Auftraggeber
test-item = Prüfgegenstand
test-sample = Probe
test-from-client = vom Auftraggeber angegeben, nicht geprüft
test-received = erhalten
test-tested = geprüft
test-issued = ausgestellt
test-location = Ort
test-operator = Prüfer
test-method = Verfahren
test-deviations = Abweichungen vom Verfahren
test-external = Ergebnisse anderer Laboratorien
test-conditions = Bedingungen
test-reference = Referenz
test-equipment = Geräte und Kalibrierung
test-authorised = freigegeben von
test-closing = Erklärungen
test-only-items = Die Ergebnisse beziehen sich nur auf die geprüften Gegenstände, wie sie erhalten wurden. Dieser Bericht darf ohne Genehmigung des Laboratoriums nur vollständig vervielfältigt werden.
test-end = Ende des Berichts
test-not-given = nicht angegeben
test-check = Prüfung des Verfahrens
test-checked = { $made }, bouncelab { $version }: in einem synthetisierten Versuch mit einem ersten Rücksprung von { $truth } wurde { $found } gefunden; { $agrees ->
    [yes] beides stimmt innerhalb der Unsicherheit überein
   *[no] beides UNTERSCHEIDET SICH um mehr als die Unsicherheit
}
job-place = Stelle { $place } von { $places }, Versuch { $drop } von { $drops }
job-reference = Referenz, Versuch { $drop } von { $drops }
job-place-name = Stelle { $place }
job-repeated = wiederholt: { $reason }
job-so-far = Bisher { $value }. { $outcome }
job-microphone = Mikrofon
