test-heading = Informe de ensayo
test-title = Informe de ensayo { $number }
test-name = nombre
test-number = número
test-laboratory = laboratorio
test-client = cliente
test-item = objeto de ensayo
test-sample = muestra
test-from-client = declarado por el cliente, no comprobado
test-received = recibido
test-tested = ensayado
test-issued = emitido
test-location = lugar
test-operator = operador
test-method = método
test-deviations = desviaciones del método
test-external = resultados de otros laboratorios
test-conditions = condiciones
test-reference = referencia
test-equipment = equipos y calibración
test-authorised = autorizado por
test-closing = Declaraciones
test-only-items = Los resultados se refieren solo a los objetos ensayados, tal como se recibieron. Este informe no debe reproducirse, salvo en su totalidad, sin la aprobación del laboratorio.
test-end = Fin del informe
test-not-given = no indicado
test-check = comprobación del método
test-checked = { $made }, bouncelab { $version }: en un ensayo sintetizado con un primer rebote de { $truth } se halló { $found }; { $agrees ->
    [yes] concuerdan dentro de la incertidumbre
   *[no] DIFIEREN en más que la incertidumbre
}
job-place = lugar { $place } de { $places }, ensayo { $drop } de { $drops }
job-reference = referencia, ensayo { $drop } de { $drops }
job-place-name = lugar { $place }
job-repeated = repetido: { $reason }
job-so-far = Hasta ahora { $value }. { $outcome }
job-microphone = micrófono
