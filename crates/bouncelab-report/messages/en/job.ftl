# What a job and its report say.
test-heading = Test report
test-title = Test report { $number }
test-name = name
test-number = number
test-laboratory = laboratory
test-client = client
test-item = item tested
test-sample = sample
test-from-client = stated by the client, not checked
test-received = received
test-tested = tested
test-issued = issued
test-location = location
test-operator = operator
test-method = method
test-deviations = deviations from the method
test-external = results of other laboratories
test-conditions = conditions
test-reference = reference
test-equipment = equipment and calibration
test-authorised = authorised by
test-closing = Statements
test-only-items = The results relate only to the items tested, as received. This report shall not be reproduced except in full without approval of the laboratory.
test-end = End of the report
test-not-given = not given
test-check = check of the method
test-checked = { $made }, bouncelab { $version }: of a synthesised drop with a first rebound of { $truth } it found { $found }; { $agrees ->
    [yes] they agree within the uncertainty
   *[no] THEY DIFFER by more than the uncertainty
}
job-place = place { $place } of { $places }, drop { $drop } of { $drops }
job-reference = reference, drop { $drop } of { $drops }
job-place-name = place { $place }
job-repeated = repeated: { $reason }
job-so-far = So far { $value }. { $outcome }
job-microphone = microphone
