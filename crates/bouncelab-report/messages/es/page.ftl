page-app-title = bouncelab: soltar una pelota, oír la física
page-app-skip = Ir al contenido
page-app-nav = Páginas
page-app-lab = Escuchar
page-app-simulate = Simular
page-app-paper = Artículo
page-app-drops = Ensayos
page-app-series = Tests
page-app-language = Idioma
page-app-to-dark = Oscuro
page-app-to-light = Claro
page-app-privacy = Nada sale de este dispositivo: sin cuenta, sin servidor, funciona sin conexión.
page-app-version = bouncelab { $version }
page-app-book = Tutorial y documentos
page-app-engine-failed = El laboratorio no pudo arrancar.
page-app-engine-failed-hint = El navegador no cargó o no ejecutó la parte en WebAssembly. Recarga la página; si no sirve, usa un Firefox, Chrome, Edge o Safari actual.
page-app-newer = Hay una versión más nueva de esta página.
page-app-reload = Recargar
page-app-undo = Deshacer
page-app-redo = Rehacer
page-app-cancel = Cancelar
page-app-number-wanted = Aquí se espera un número{ $most ->
    [none] { $least ->
        [none] {""}
       *[other] {" "}de al menos { $least }
      }
   *[other] {" "}de { $least } a { $most }
  }.
page-app-drop-here = Suelta para abrir el archivo
page-app-unreadable-link = Algunos ajustes de la dirección no son válidos y no se tuvieron en cuenta: { $parts }.

page-lab-invite = Deja caer una pelota cerca de tu micrófono.
page-lab-invite-touch = Deja caer una pelota cerca de tu teléfono.
page-lab-lead = Los tiempos entre los rebotes dicen cuánta velocidad y energía conserva la pelota, y desde qué altura cayó.
page-lab-listen = Escuchar
page-lab-stop = Parar
page-lab-again = Escuchar otra vez
page-lab-open = abrir un archivo
page-lab-rate = Frecuencia de muestreo
page-lab-rate-open = Leer como sonido
page-lab-paste = pegar tiempos
page-lab-demo = ver un ejemplo
page-lab-open-label = Grabación o lista de tiempos de impacto
page-lab-paste-label = Tiempos de impacto en segundos, uno por línea
page-lab-paste-hint = De una hoja de cálculo o un osciloscopio. Los vuelos están entre los impactos.
page-lab-paste-do = Analizar
page-lab-pasted-name = tiempos pegados
page-lab-demo-name = ejemplo
page-lab-recording-name = ensayo { $date }
page-lab-starting = Solicitando el micrófono…
page-lab-listening = Escuchando. Deja caer la pelota.
page-lab-hint-quiet = Aún no se ha oído nada fuerte: acerca el micrófono al lugar donde cae la pelota.
page-lab-hint-no-bounces = Se oyen sonidos, pero ningún rebote: acerca el teléfono al lugar donde cae la pelota, sobre un suelo duro, y deja que rebote hasta que repose.
page-lab-so-far = { $count ->
    [one] 1 impacto hasta ahora
   *[other] { $count } impactos hasta ahora
  }
page-lab-so-far-keeps = conserva alrededor del { $share } de su velocidad
page-lab-ends-itself = La escucha termina cuando la pelota está en reposo.
page-lab-saved = { $seconds } s están guardados.
page-lab-result = Resultado
page-lab-opening = Leyendo { $name }…
page-lab-cannot-tell = Hay muy pocos impactos para determinar el coeficiente de restitución.
page-lab-impacts = { $count ->
    [one] 1 impacto
   *[other] { $count } impactos
  }
page-lab-uncertain = { $count ->
    [one] 1 dudoso
   *[other] { $count } dudosos
  }
page-lab-edited = editado a mano
page-lab-drop-of = Ensayo { $index } de { $count }
page-lab-drops-heard = Ensayos de esta grabación
page-lab-why = Con aire y sin aire
page-lab-why-air-1 = Una recta por los logaritmos de los tiempos de vuelo (ajuste log-lineal) es la forma clásica de medir el coeficiente de restitución. Pero el aire también frena la pelota, y el ajuste lo atribuye a los impactos.
page-lab-why-air-2 = Los puntos grises no cuentan el aire; los azules están corregidos por arrastre. Muestran solo la pelota y la superficie.
page-lab-refining = Calculando la inferencia con aire…
page-lab-more = Todos los números
page-lab-other-quantities = Otras magnitudes
page-lab-tells = Lo que esta grabación determina y lo que no
page-lab-narrowed-lead = Cuánto redujo la grabación la incertidumbre a priori:
page-lab-narrowed = { $unknown }: queda el { $share } de la anchura
page-lab-assumed = supuesto
page-lab-no-drop-title = No se detectó ningún rebote.
page-lab-possible-drop = Quizá un ensayo desde { $start } s: { $impacts } impactos, probabilidad { $probability }.
page-lab-accept = Lo es
page-lab-no-drop-hint = Pon el micrófono cerca de donde cae la pelota, sobre una superficie dura, y déjala rebotar hasta el reposo. Si ves los impactos en la forma de onda, márcalos a mano: doble clic, o Intro en el cursor.
page-lab-no-drop-hint-touch = Pon el teléfono cerca de donde cae la pelota, sobre una superficie dura, y deja que rebote hasta que repose. Si ves los impactos en la forma de onda, márcalos con un doble toca.
page-lab-interrupted-title = Se interrumpió una grabación del { $date }.
page-lab-progress = Progreso
page-lab-processed = El dispositivo cambia el sonido aunque se le pidió que no: { $what }. Pueden faltar impactos débiles. Ayuda otro navegador o un micrófono externo.
page-lab-processed-echoCancellation = cancelación de eco
page-lab-processed-noiseSuppression = supresión de ruido
page-lab-processed-autoGainControl = ganancia automática
page-lab-unkept-title = La grabación del { $date } no está en la tabla de ensayos.
page-lab-interrupted-hint = Está guardada, salvo quizá el último segundo o los dos últimos.
page-lab-interrupted-open = Abrir
page-lab-interrupted-drop = Eliminar

page-rest-title = Voz y vibración, cuando la pelota está en reposo
page-rest-speech = Decir el resultado
page-rest-vibration = Vibrar
page-rest-plus-minus = más o menos

page-words-restitution = La restitución es la velocidad justo después de un impacto dividida por la de justo antes: el 90 % significa que la pelota pierde una décima parte de su velocidad.
page-words-bounce-energies = La energía crece con el cuadrado de la velocidad: una pelota que conserva el 90 % de su velocidad conserva el 81 % de su energía.
page-words-height = La altura de caída se calcula a partir de los tiempos entre los impactos. La curva muestra hasta dónde subió la pelota después de cada uno.
page-words-uncertainty = ± es la incertidumbre típica: el valor verdadero está dentro con una probabilidad de unos dos tercios, y dentro del doble con el 95 %.
page-words-flight-times = Un vuelo es el tiempo de un impacto al siguiente. Sin aire y con la misma restitución a toda velocidad, cada uno duraría la misma fracción del anterior.
page-words-bounce-heights = Hasta dónde subió la pelota después de cada impacto, calculado con el tiempo hasta el siguiente.
page-words-comparison = La altura de la pelota según el modelo y según tu simulación: donde difieren, una de las dos es falsa.
page-words-posterior = La distribución a posteriori es lo que se sabe después de medir: la probabilidad de cada valor, dados los tiempos de impacto y lo que se sabía antes.
page-words-residuals = Un residuo es el tiempo medido de un impacto menos el del modelo. Deberían dispersarse sin ningún patrón.
page-words-budget = El balance de incertidumbre muestra sus fuentes y la parte de cada una. Para saber más, empieza por la mayor.
page-words-models = Una ley dice cómo depende la restitución de la velocidad. Cada una pesa según lo bien que predice los tiempos de impacto.
page-words-truncation = La respuesta con los dos primeros vuelos, con tres, etc. No debería cambiar con su número.
page-words-drag = El arrastre es la fuerza del aire contra el movimiento. Crece aproximadamente con el cuadrado de la velocidad.
page-words-drag-log = Lo mismo en ejes en los que cada paso es un factor: una potencia de la velocidad es una recta.

page-faults-refused-what = El navegador no puede usar el micrófono.
page-faults-refused-do = Permítelo en la barra de direcciones (candado o micrófono) y toca «Escuchar» otra vez. En un teléfono, mira también los ajustes de la aplicación del navegador. En su lugar puedes abrir una grabación.

page-faults-missing-what = No se encontró ningún micrófono.
page-faults-missing-do = Conecta uno y toca «Escuchar» otra vez, o graba con otro dispositivo y abre el archivo aquí.

page-faults-busy-what = Otro programa está usando el micrófono.
page-faults-busy-do = Cierra llamadas y grabadoras, y toca «Escuchar» otra vez.

page-faults-insecure-what = Los navegadores dan el micrófono solo a páginas con https, o de este mismo ordenador.
page-faults-insecure-do = Abre esta página con https o por localhost. Las grabaciones se pueden abrir así.

page-faults-unsupported-what = Este navegador no da sonido sin procesar.
page-faults-unsupported-do = Usa un Firefox, Chrome, Edge o Safari actual, o abre una grabación.

page-faults-ended-what = El micrófono se desconectó: desenchufado, o usado por una llamada.
page-faults-ended-do = El sonido grabado hasta entonces se guardó y se analizó.

page-faults-unknown-what = No se pudo abrir el micrófono.
page-faults-unknown-do = Desenchúfalo y vuelve a enchufarlo, o reinicia el navegador. En su lugar puedes abrir una grabación.

page-faults-silent-what = El micrófono solo da silencio.
page-faults-silent-do = Quizá está silenciado con un interruptor o en los ajustes del sistema.

page-faults-full-what = El almacenamiento del navegador está lleno.
page-faults-full-do = El sonido está completo en memoria: guárdalo ahora como WAV. Después elimina los ensayos que no necesites.

page-faults-unavailable-what = El navegador no guarda nada aquí (¿una ventana privada?).
page-faults-unavailable-do = El sonido está completo en memoria hasta que se cierre esta página: guárdalo como WAV.

page-faults-empty-what = El archivo está vacío.
page-faults-empty-do = No se escribió nada en él. ¿Se paró la grabación antes de empezar? Graba otra vez o elige otro archivo.

page-faults-unsupported-file-what = Esto no es ni una grabación ni una lista de tiempos.
page-faults-unsupported-file-do = Sonidos: { $formats }. Listas: un tiempo en segundos por línea.

page-faults-damaged-what = El archivo está dañado.
page-faults-damaged-do = Cópialo o descárgalo otra vez. Un archivo que un teléfono aún está escribiendo no se puede leer todavía.

page-faults-times-what = Estos tiempos no pueden ser tiempos de impacto.
page-faults-times-do = Da un tiempo en segundos por línea, en orden creciente, con coma o punto decimal.
page-faults-rate-what = La tabla no dice cuándo se tomaron las muestras.
page-faults-rate-do = Indica la frecuencia de muestreo: cuántas muestras por segundo tomó el dispositivo, a menudo 44100 o 48000.

page-faults-huge-what = El archivo es demasiado grande para un navegador.
page-faults-huge-do = Hasta dos horas de sonido en dos canales, o cuatro en uno. Córtalo a los minutos del ensayo, o usa la línea de comandos: bouncelab analyze.

page-faults-setting-what = Un ajuste contradice a los demás.
page-faults-setting-do = Mira abajo, en los ajustes.

page-faults-fault-what = El análisis falló.
page-faults-fault-do = Lo grabado está guardado. Recarga la página y ábrelo otra vez; ayuda comunicarlo al proyecto.

page-faults-link-what = Este enlace de un ensayo no se puede usar.
page-faults-link-do = Copia el enlace entero, o lee el código otra vez.

page-faults-no-drop-what = No se halló en él ninguna pelota que rebote.
page-faults-no-drop-do = Ábrelo en el laboratorio: allí puedes escucharlo y marcar impactos.

page-faults-series-full-what = El almacenamiento del navegador está lleno: este ensayo aún no cuenta.
page-faults-series-full-do = Lo guardado antes sigue ahí, sin cambios. Guarda este sonido como archivo, elimina ensayos o series que no necesites e inténtalo de nuevo.

page-faults-series-known-what = Esta grabación ya cuenta.
page-faults-series-known-do = Cada grabación cuenta una vez. Elige la de otro ensayo.

page-faults-series-storage-what = El navegador no pudo guardarlo.
page-faults-series-storage-do = Lo guardado antes sigue ahí, sin cambios. Una ventana privada no guarda nada: usa una normal.

page-faults-archive-what = Esto no es un archivo completo de ensayos guardados.
page-faults-archive-do = Cópialo o descárgalo otra vez, y añade ese. Lo guardado aquí no ha cambiado.

page-faults-bad-drop-what = Esta página no pudo guardar este ensayo.
page-faults-bad-drop-do = Pide su grabación o su enlace. Los otros ensayos del archivo se han añadido.

page-faults-archive-newer-what = Una versión más nueva de esta página guardó este archivo.
page-faults-archive-newer-do = Recarga la página y añade el archivo otra vez. Lo guardado aquí no ha cambiado.

page-faults-archive-storage-what = No se pudo guardar todo el archivo.
page-faults-archive-storage-do = El almacenamiento del navegador está lleno o no está disponible. Elimina los ensayos que no necesites y añade el archivo otra vez; lo guardado antes no ha cambiado.

page-faults-keep-what = No se pudo guardar el ensayo.
page-faults-keep-do = El almacenamiento del navegador está lleno o no está disponible. Guarda el sonido y los números como archivos.

page-wave-title = Forma de onda
page-wave-label = Forma de onda, posición del cursor
page-wave-seconds = { $value } segundos
page-wave-impact-at = impacto { $number }, { $seconds }{ $certain ->
    [yes] {""}
   *[no] , dudoso
  }
page-wave-add = Añadir impacto
page-wave-remove = Eliminar
page-wave-snap = Ajustar al sonido
page-wave-zoom-in = Ampliar
page-wave-zoom-out = Reducir
page-wave-all = Todo
page-wave-amplitude = Altura de la forma de onda
page-wave-amplitude-whole = altura: grabación
page-wave-amplitude-view = altura: vista
page-wave-amplitude-decibels = altura: decibelios
page-wave-play = Reproducir
page-wave-stop = Parar
page-wave-speed = Velocidad
page-wave-slower = { $speed } ×
page-wave-spectrogram = Espectrograma
page-wave-spectrogram-label = Espectrograma: tiempo hacia la derecha, frecuencia hacia arriba, más fuerte es más oscuro
page-wave-overview = Toda la grabación; arrastra para moverte
page-wave-restore = Como se detectó
page-wave-list = Lista de impactos
page-wave-number = N.º
page-wave-time = Tiempo
page-wave-flight = Vuelo siguiente
page-wave-probability = Probabilidad
page-wave-level = Nivel
page-wave-restitution = Restitución
page-wave-actions = Cambiar
page-wave-remove-one = Eliminar el impacto { $number }
page-wave-select = Mostrar el impacto { $number }
page-wave-added = Impacto añadido en { $seconds } s.
page-wave-removed = Impacto { $number } eliminado.
page-wave-moved = Impacto { $number } movido a { $seconds } s.
page-wave-undone = Deshecho.
page-wave-redone = Rehecho.
page-wave-keys = Las flechas mueven el cursor, con Mayús en pasos pequeños; Re Pág y Av Pág van de impacto en impacto; más y menos amplían y reducen, 0 muestra todo; Intro añade un impacto, Supr elimina el elegido, la coma y el punto lo mueven, S lo ajusta al sonido; la barra espaciadora reproduce; Ctrl+Z deshace.
page-wave-pointer = Arrastra para moverte, pellizca o gira la rueda para ampliar (haz clic antes), toca un impacto para elegirlo, arrástralo para moverlo, toca dos veces para añadir uno.
page-wave-times = Solo hay tiempos: no hay sonido que mostrar.

page-figures-title = Figuras
page-figures-more = Más figuras
page-figures-fewer = Menos figuras
page-curve-label = Altura de la pelota en función del tiempo; el primer salto detectado sube hasta { $height }
page-figures-against = { $y } frente a { $x }
page-figures-reset = Arrastra de lado para ampliar, doble clic para ver todo.
page-figures-numbers = Lo mismo en números
page-figures-save-svg = SVG
page-figures-save-png = PNG
page-figures-save-csv = CSV
page-figures-save = Guardar esta figura

page-settings-ball = Pelota
page-settings-air = Aire
page-settings-gravity = g
page-settings-change = cambiar
page-settings-title = Magnitudes conocidas
page-settings-assumed-hint = El aire y la gravedad no indicados se suponen. Si no se indica la pelota, cuenta cada tipo de pelota que admiten los tiempos, y los intervalos son más anchos.
page-settings-own = otra pelota
page-settings-mass = Masa
page-settings-diameter = Diámetro
page-settings-contact = Tiempo de contacto
page-settings-temperature = Temperatura
page-settings-pressure = Presión
page-settings-humidity = Humedad
page-settings-vacuum = vacío
page-settings-no-drag = sin aire
page-settings-gravity-field = Gravedad
page-settings-measure-g = medir g: indica también la altura de caída
page-settings-latitude = Latitud
page-settings-altitude = Altitud
page-settings-drag-law = Arrastre del aire
page-settings-drag-none = ninguno, sin contar el aire
page-settings-drag-standard = curva estándar de una esfera
page-settings-drag-table = tabla propia de C_D
page-settings-restitution-law = Restitución
page-settings-restitution-any = todas las leyes
page-settings-measured = El ensayo, si se midió
page-settings-height = Altura de caída
page-settings-height-sd = ± de la altura
page-settings-flights = Vuelos del ajuste log-lineal
page-settings-flights-from = de
page-settings-flights-to = a
page-settings-reset = Restablecer los ajustes
page-settings-refused = Estos ajustes se contradicen:

page-ball-row = ¿Qué pelota?
page-ball-other = otra: tamaño y peso

page-setup-named = { $name }: { $value }
page-setup-offered = Este enlace indica: { $what }. Tus propias caídas no lo usan si no lo quieres.
page-setup-laws = otros modelos del análisis
page-setup-take = usarlo para mis caídas
page-setup-leave = no usarlo
page-setup-unusual = Analizado con: { $what }.
page-setup-reset = Restablecer

page-keep-title = Guardar
page-keep-keep = Guardar este ensayo
page-keep-long-sound = El sonido dura más de media hora: solo se guarda el ensayo, no el archivo.
page-keep-kept = Guardado como «{ $name }».
page-keep-name = Nombre
page-keep-name-hint = por ejemplo: Anna, primer ensayo
page-keep-see-all = Tabla de ensayos
page-keep-lasting = El navegador guarda lo que hay aquí hasta que lo elimines.
page-keep-not-lasting = Si falta espacio, el navegador puede eliminar lo guardado aquí: guarda una copia como archivo.
page-keep-for-a-week = Este navegador borra lo que guarda una página tras siete días sin visitas, salvo que la página esté en la pantalla de inicio (Compartir, «Añadir a pantalla de inicio»): guarda una copia como archivo.
page-keep-commas = tablas con punto y coma y coma decimal
page-keep-wav = Sonido (WAV)
page-keep-csv = Tabla (CSV)
page-keep-json = Todos los datos (JSON)
page-keep-share = Compartir estos ajustes
page-keep-shared = Se copió la dirección con estos ajustes.
page-keep-share-by-hand = Copia esta dirección:
page-keep-report = Informe (HTML)
page-keep-link = Compartir este ensayo
page-keep-link-qr = Código QR de la dirección de este ensayo

page-simulate-title = Simular un ensayo
page-simulate-lead = Mueve un control y mira qué cambia; guarda una simulación para compararla con la siguiente.
page-simulate-height = Altura de caída
page-simulate-restitution = Restitución (a 1 m/s)
page-simulate-slope = Decrece con la velocidad en
page-simulate-slope-hint = 0: la misma a toda velocidad
page-simulate-law = Ley de restitución
page-simulate-law-of-sliders = constante o decreciente, según los controles
page-simulate-law-numbers = Ley con sus números
page-simulate-ball = Pelota
page-simulate-drag = Arrastre del aire
page-simulate-pressure = Presión del aire
page-simulate-body = Dónde

page-simulate-bodies-earth = Tierra
page-simulate-bodies-moon = Luna
page-simulate-bodies-mars = Marte
page-simulate-bodies-venus = Venus
page-simulate-bodies-titan = Titán
page-simulate-bodies-jupiter = Júpiter
page-simulate-keep-run = Guardar
page-simulate-hear = Oír el sonido
page-simulate-stop = Parar
page-simulate-lay = Comparar con la medida
page-simulate-take-off = Quitar de la comparación
page-simulate-laid = Ahora se compara con la medida, en la figura «Comparar».
page-simulate-analyse = Analizar su sonido
page-simulate-runs = Simulaciones
page-simulate-this-run = esta
page-simulate-run = simulación { $index }
page-simulate-remove = Eliminar { $name }
page-simulate-says = Rebota { $bounces } veces en { $time } y recorre { $path }.
page-simulate-terminal = Su velocidad terminal es aquí { $speed }.
page-simulate-no-terminal = No hay aire, así que no hay velocidad terminal.
page-simulate-losses = De su energía, { $surface } se pierde en los impactos, { $air } en el aire.
page-simulate-impossible = Esto no se puede simular:
page-simulate-address = La dirección contiene los ajustes: compártela, y otros verán la misma simulación.

page-paper-title = El artículo
page-paper-source = M. Nagurka, «Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment»
page-paper-lead = Deja caer una pelota de tenis de mesa y escucha. Los tiempos entre los impactos dan su restitución y su altura de caída, pero la altura sale un 12 % demasiado baja. Esta página explica por qué, y calcula cada número y cada figura mientras lees.

page-paper-one-title = 1. De los tiempos a las alturas
page-paper-one-text-1 = Entre dos impactos, la pelota sube y baja durante un tiempo T. Sin aire, deja la superficie con la velocidad gT/2 y sube hasta gT²/8. Basta un reloj.
page-paper-one-text-2 = Si cada impacto conserva la fracción e de la velocidad, cada vuelo dura e veces el anterior. En escala logarítmica, los tiempos de vuelo están sobre una recta: su pendiente es log e, y su ordenada en el origen da la altura de caída. Este es el ajuste log-lineal.
page-paper-one-equation = log Tₙ = n log e + log (2v₀/g),   h₀ = v₀²/2g
page-paper-one-see = Los tiempos de vuelo de una caída desde 30,5 cm, sin aire. Cada punto está sobre la recta; el ajuste da exactamente e y 30,5 cm.

page-paper-two-title = 2. El experimento, y una discrepancia
page-paper-two-text-1 = El artículo dejó caer una pelota de 2,5 g y 38 mm desde 30,5 cm. El ajuste log-lineal de sus diez primeros vuelos dio e = 0,9375 y una altura de caída de 26,7 cm.
page-paper-two-text-2 = Son 3,8 cm o un 12,3 % de menos, mucho más que el error de una cinta métrica. El artículo señala el arrastre del aire como causa probable.

page-paper-three-title = 3. La intensidad del arrastre del aire
page-paper-three-text = A los 2,4 m/s del primer impacto, el arrastre es solo un 6 % del peso, y decrece con el cuadrado de la velocidad. El artículo prueba dos leyes: un coeficiente constante de 0,4, y uno que depende de la velocidad. Coinciden donde el arrastre importa.
page-paper-three-equation = F/P = ½ ρ A C_D v² / mg
page-paper-three-see = Arrastre entre peso frente a la velocidad, según las dos leyes. En escala logarítmica, un coeficiente constante es una recta de pendiente 2.
page-paper-three-see-height = El ensayo entero con e = 0,935, con aire y sin él: con un arrastre del seis por ciento del peso, la pelota llega al reposo segundos antes.

page-paper-four-title = 4. ¿Explica el arrastre la discrepancia?
page-paper-four-text = Simula ensayos con aire, aplica el mismo ajuste log-lineal, y compara con el artículo. Elige la restitución de la pelota y el número de vuelos del ajuste.
page-paper-four-e = Restitución verdadera de la pelota, a 1 m/s
page-paper-four-slope = Decrece con la velocidad en
page-paper-four-flights = Vuelos en el ajuste
page-paper-four-line-says = El ajuste da e = { $e } y h₀ = { $h }.
page-paper-four-paper-says = El ajuste del artículo da e = 0,9375 y h₀ = 26,7 cm.
page-paper-four-truth = Altura de caída verdadera: 30,5 cm.
page-paper-four-hit = Es el resultado del artículo, hasta la última cifra.
page-paper-four-solve-drag = e constante, diez vuelos
page-paper-four-solve-many = e constante, 21 vuelos
page-paper-four-solve-slope = e decrece con la velocidad, diez vuelos
page-paper-four-see = Altura de caída según el ajuste log-lineal, frente a su número de vuelos. Gris: sin aire es igual para todos los números, si la restitución es constante. Bermellón: con aire decrece con cada vuelo. Azul: el resultado del artículo.

page-paper-five-title = 5. La explicación
page-paper-five-text-1 = El arrastre con restitución constante explica alrededor de la mitad de la diferencia: una pelota de e = 0,953 da el 0,9375 del artículo, pero 28,8 cm.
page-paper-five-text-2 = Hay dos explicaciones del resto: la restitución decrece un poco con la velocidad, como la de las pelotas reales, o se usaron más de diez vuelos en el ajuste. El ajuste log-lineal no puede distinguirlas, porque su resultado depende del número de vuelos.
page-paper-five-text-3 = Por eso el laboratorio de esta página infiere juntos la altura de caída, el arrastre y la restitución a partir de los tiempos de impacto, con sus incertidumbres.
page-paper-five-law = Restitución
page-paper-five-drag = Aire
page-paper-five-flights = Vuelos
page-paper-five-first = e a 2,4 m/s
page-paper-five-slow = e a 0,5 m/s
page-paper-five-height = h₀ del ajuste
page-paper-five-same = ¿Los 26,7 cm del artículo?
page-paper-five-yes = sí
page-paper-five-no = no
page-paper-five-caption = Modelos cuyo ajuste log-lineal da e = 0,9375; los codos están a 1,5 m/s

page-paper-six-title = 6. Cada número del artículo
page-paper-six-lead = Como está impreso, y como se calcula aquí. Las erratas de las ecuaciones están corregidas.
page-paper-six-quantity = Magnitud
page-paper-six-printed = Impreso
page-paper-six-computed = Calculado
page-paper-six-verdict = Veredicto

page-paper-verdicts-agrees = coincide
page-paper-verdicts-agrees-when-corrected = coincide corregido
page-paper-verdicts-agrees-within-reading = coincide según lectura
page-paper-verdicts-misprint = errata
page-paper-verdicts-differs = difiere
page-paper-verdicts- = {""}

page-paper-air-names-none = sin aire
page-paper-air-names-constant = C_D = 0,4
page-paper-air-names-sphere = C_D(Re)
page-paper-air-names-all-of-air = C_D(Re), empuje, masa añadida

page-paper-try-it = Ahora deja caer tú una pelota

page-drops-title = Tabla de ensayos
page-drops-empty = Aún no hay ensayos guardados. Después de un ensayo, «Guardar este ensayo» lo pone aquí, solo en este navegador.
page-drops-to-lab = Al laboratorio
page-drops-name = Nombre
page-drops-when = Fecha
page-drops-ball = Pelota
page-drops-e = Restitución e
page-drops-h = Altura de caída
page-drops-impacts = Impactos
page-drops-actions = Cambiar
page-drops-open = Abrir
page-drops-open-one = Abrir { $name }
page-drops-delete = Eliminar
page-drops-delete-one = Eliminar { $name }
page-drops-deleted = «{ $name }» se eliminó.
page-drops-choose = Comparar { $name }
page-drops-compare = Comparar
page-drops-rename = Nombre de { $name }
page-drops-mean = Media
page-drops-scatter = Dispersión (desviación típica)
page-drops-of-drops = { $count ->
    [one] de 1 ensayo
   *[other] de { $count } ensayos
  }
page-drops-scatter-sentence = En promedio, la pelota conservó el { $mean } de su velocidad. La desviación típica entre ensayos fue { $scatter }; cada ensayo por separado indica ± { $inside }.
page-drops-csv = Guardar la tabla (CSV)
page-drops-json = Guardar todo (JSON)
page-drops-archive = Guardar todo con sonido (ZIP)
page-drops-archiving = Reuniendo los sonidos…
page-drops-adding = Leyendo { $name }…
page-drops-added = { $count ->
    [0] No contiene nada nuevo.
    [one] Se añadió 1 ensayo.
   *[other] Se añadieron { $count } ensayos.
  }
page-drops-delete-all = Eliminar todo
page-drops-deleted-all = { $count ->
    [one] Se eliminó 1 ensayo.
   *[other] Se eliminaron { $count } ensayos.
  }
page-drops-links = Enlaces de ensayos de otras personas, tantos como quieras
page-drops-links-do = Añadir a esta tabla
page-drops-unavailable = El navegador no guarda nada aquí (¿una ventana privada?).

page-class-ball = Pelota
page-class-surface = Superficie
page-class-student = Alumno
page-class-ball-of = Pelota de { $name }
page-class-surface-of = Superficie de { $name }
page-class-student-of = Alumno: { $name }
page-class-add = Añadir ensayos
page-class-add-hint = Archivos de cualquier tipo que esta página guarda o abre, tantos como quieras, también como ZIP; y enlaces. Lo dañado se nombra, el resto se añade.
page-class-files = Elegir archivos
page-class-files-label = Archivos con ensayos
page-class-known = { $count ->
    [one] 1 ya está en la tabla.
   *[other] { $count } ya están en la tabla.
  }
page-class-groups = Grupos
page-class-details = Detalles
page-class-by = Agrupar por
page-class-report = Guardar el informe (HTML)
page-class-sheets = Hojas de trabajo
page-class-sheet-bounciness = ¿Cuánto rebota una pelota?
page-class-sheet-air = ¿Cuánto se lleva el aire?
page-class-sheet-gravity = Medir g con una pelota
page-class-sheet-html = para imprimir
page-class-sheet-markdown = como texto editable
page-class-sheets-hint = En las hojas figura la dirección de la clase de arriba, o la de esta página mientras no se elija ninguna pelota.

page-verdict-title = Evaluar según una regla
page-verdict-rule = Regla
page-verdict-reference = Superficie de referencia
page-verdict-kept = Cumplido, según lo que indicas:
page-verdict-ball = La regla no indica ninguna pelota: elígela primero.
page-verdict-unlike = Estos ensayos tienen pelotas u otros ajustes distintos. Marca los de una sola pelota.
page-verdict-report = Guardar el veredicto (HTML)

page-lesson-title = Lo que dejas caer
page-lesson-name = Tu nombre
page-lesson-leave = salir de la clase
page-lesson-who = Escribe abajo tu nombre y entrega el ensayo.
page-lesson-make = Clase: un enlace para todos
page-lesson-make-hint = Elige lo que se deja caer en la clase. La página del alumnado pide entonces nombre, pelota, superficie y altura, y nada más.
page-lesson-balls = Pelotas
page-lesson-surfaces = Superficies, separadas por comas
page-lesson-heights = Alturas de caída en cm, separadas por punto y coma; ninguna si se van a medir
page-lesson-qr = Código QR de la clase
page-hand-in = Entregar
page-hand-share = Compartir…
page-hand-copy = Copiar el enlace
page-hand-copied = Copiado.
page-scan = Escanear códigos QR
page-scan-stop = Dejar de escanear
page-scan-refused = No se puede usar la cámara. Permítela en la barra de direcciones, o pide que te envíen los enlaces.
page-class-all-balls = Pelota de los { $count } elegidos
page-class-all-surfaces = Superficie de los { $count } elegidos

page-reason-counted = Es la grabación { $number } de esta serie.
page-reason-empty-content = No contiene datos.
page-reason-empty-sound = Tiene una cabecera, pero ningún sonido.
page-reason-empty-time = No contiene ningún tiempo.
page-reason-not-sound = Parece { $kind }.
page-looks-png = una imagen PNG
page-looks-jpeg = una imagen JPEG
page-looks-gif = una imagen GIF
page-looks-pdf = un documento PDF
page-looks-zip = un archivo ZIP o un documento de oficina
page-looks-gzip = un archivo gzip
page-looks-riff = un archivo RIFF sin sonido, como AVI o WebP
page-looks-zeros = una serie de ceros
page-looks-text = texto
page-looks-unknown = datos de tipo desconocido
page-reason-malformed = { $stage ->
    [header] No se puede leer su cabecera
    [codec] No se puede preparar su decodificador
   *[sound] No se puede decodificar nada de su sonido
  } ({ $format }: { $detail }).
page-reason-no-audio-track = Este archivo { $format } no tiene sonido, o ninguno de tipo conocido. ¿Estaba apagado el micrófono?
page-reason-unsupported-codec = El sonido de este archivo { $format } no se puede decodificar: { $codec }. Expórtalo como WAV o M4A.
page-reason-layout-too-slow = { $sample_rate_hz } muestras por segundo son demasiado pocas para situar un impacto en el tiempo: se necesitan al menos { $min_hz }.
page-reason-layout-too-fast = Su cabecera indica { $sample_rate_hz } muestras por segundo; se leen como mucho { $max_hz }.
page-reason-layout-too-many-channels = Tiene { $channels } canales; se leen como mucho { $max }.
page-reason-lasts-too-long = Dura más de { $max_h } horas, que es lo máximo que se lee. Córtalo en partes.
page-reason-times-line = Línea { $line }: { $problem }
page-reason-times-ending = El nombre de una lista termina en .txt, .csv, .tsv, .xls, .xlsx, .ods, .zip, .json, .TextGrid o .svl.
page-reason-times-not-text = No es texto. Guarda la lista como texto, CSV u hoja de cálculo.
page-reason-times-not-table = No es una tabla ({ $detail }).
page-reason-times-not-file = Es un dispositivo o una tubería; guarda la lista en un archivo.
page-reason-times-too-long = Son más de { $max_mb } MB de texto; guarda el sonido como WAV.
page-reason-times-not-sample = «{ $text }» no es un número; bajo sus títulos, una forma de onda muestreada solo tiene números.
page-reason-times-fewer-columns = { $found } de { $columns } números: cada línea de una forma de onda muestreada tiene uno para el tiempo y uno por canal.
page-reason-times-uneven = Está { $interval_s } s después de la línea anterior, pero en promedio las separan { $mean_s } s; los tiempos de una forma de onda muestreada son equidistantes.
page-reason-times-sampled = Es una tabla de { $rows } muestras, { $rate_hz } por segundo, y no una lista de tiempos de impacto; el sonido necesita al menos { $min_hz } por segundo. Indica los tiempos de los impactos.
page-reason-times-positions = Son posiciones en el tiempo ({ $found }) y no tiempos de impacto. Abre la grabación o indica los tiempos de los impactos.
page-reason-times-several-drops = Hay varias columnas de tiempos ({ $found }) y { $rows } filas. Una lista tiene un solo ensayo: una columna de tiempos o una fila de paradas.
page-reason-times-no-rate = { $rows } muestras sin tiempos, y no una lista de tiempos de impacto: guarda el sonido como WAV, añade una columna de tiempos, o ábrelo en el laboratorio e indica su frecuencia de muestreo.
page-reason-times-no-order = { $number } sigue a { $before }. Los números sin título son tiempos de impacto, que crecen, o intervalos, que decrecen. Escribe time_s o interval_s encima; las muestras necesitan una columna de tiempos.
page-reason-times-not-interval = { $text } no es un intervalo de un impacto al siguiente, que es mayor que 0 s.
page-reason-times-not-layer = No es una capa de Sonic Visualiser con puntos. Expórtala otra vez (File > Export Annotation Layer).
page-reason-times-no-list = Ninguna de las tablas es una lista de tiempos de impacto: { $found }. Abre una grabación sola, y las de una clase como archivos o carpeta.
page-reason-times-tables-disagree = Las tablas { $first } y { $second } tienen tiempos distintos. Quédate con una.
page-reason-times-of-recordings = Es una tabla sobre grabaciones, y no una lista de tiempos de impacto. Abre las grabaciones.
page-reason-times-not-array = Se esperaba una lista de números, como [0.1, 0.45] ({ $detail }).
page-reason-times-not-text-grid = No es un TextGrid de Praat, o no está entero. Guárdalo otra vez desde Praat.
page-reason-times-no-point-tier = Ninguna capa tiene puntos, solo intervalos: { $found }. Añade en Praat una capa con un punto en cada impacto (Tier > Add point tier…).
page-reason-times-which-point-tier = Varias capas tienen puntos: { $found }. Llama en Praat «impacts» a la de los impactos.
page-reason-times-no-time-column = Ningún título tiene una palabra para tiempo o impacto con una unidad, como time_s, Tiempo (s) o interval_s. Hay: { $found }.
page-reason-times-nameless-columns = Hay { $columns } columnas. Da nombre a la de los tiempos en una primera línea: time_s.
page-reason-times-more-columns = Tiene { $found } columnas, pero la primera línea tiene { $columns }. Si la coma es decimal, separa las columnas con punto y coma.
page-reason-times-missing = Falta el tiempo.
page-reason-times-not-number = «{ $text }» no es un tiempo en segundos, como 0.125.
page-reason-times-not-later = { $time_s } no viene después de { $before_s }. Pon los impactos en orden.
page-reason-too-long = Tiene más de { $minutes } minutos en { $channels ->
    [one] 1 canal
   *[other] { $channels } canales
  }.
page-reason-no-memory = Este dispositivo no tiene memoria suficiente para él.
page-reason-breaks-decoder = Está dañado, y su decodificador falla con él.
page-reason-unreadable = El navegador no puede leerlo. ¿Se movió o se eliminó?
page-reason-link-changed = Fue modificado o está incompleto.
page-reason-link-other-version = Lo hizo otra versión de esta página; recarga la página.
page-reason-link-times = Un enlace contiene de 2 a 1000 impactos.
page-reason-link-too-long = El ensayo tiene demasiados impactos para un código QR.

page-series-title = Serie de pruebas
page-series-lead = Una prueba según una regla, ensayo por ensayo y lugar por lugar, con el informe de un laboratorio.
page-series-known = Guardadas en este navegador
page-series-open = Seguir con { $name }
page-series-delete = Eliminar
page-series-delete-hint = Sus grabaciones también se pierden. Guarda antes la serie como ZIP si la necesitas.
page-series-delete-really = Eliminar { $name } con sus grabaciones
page-series-new = Una serie nueva
page-series-name = Nombre, por ejemplo del suelo o de la pelota
page-series-ball = Pelota
page-series-places = Lugares
page-series-drops = Ensayos en cada lugar
page-series-as-the-rule = Lo que dejes vacío será lo que pide la regla. Antes se comprueba el método con una grabación sintetizada.
page-series-begin = Empezar la serie
page-series-all = Todas las series
page-series-complete = Cada lugar tiene sus ensayos.
page-series-damaged = { $count ->
    [one] Una línea del registro está dañada y no cuenta.
   *[other] { $count } líneas del registro están dañadas y no cuentan.
}
page-series-files = añadir grabaciones
page-series-files-label = Grabaciones de los próximos ensayos
page-series-operator = Quién suelta la pelota
page-series-places-done = Lugares completos: { $done } de { $all }
page-series-place-done = (completo)
page-series-recordings = Grabaciones
page-series-repeat = Repetir el ensayo { $number }
page-series-reason = Por qué no cuenta
page-series-repeat-do = Repetir { $number }; el sonido se conserva
page-series-notes = Lo que indica el informe
page-series-notes-keep = Guardar los datos
page-series-report = Guardar el informe (HTML)
page-series-one-page = Página para el cliente (HTML)
page-series-zip = Guardar toda la serie (ZIP)
page-series-zip-hint = Descomprimido, el ZIP es una carpeta para el programa: bouncelab job show CARPETA. Contiene cada grabación con su SHA-256, también las repetidas.
page-series-microphone = micrófono
page-series-interrupted = micrófono, interrumpido
page-series-count-interrupted = Contarla como el próximo ensayo
page-series-keep-again = Intentarlo de nuevo
page-series-save-sound = Guardar el sonido como archivo
