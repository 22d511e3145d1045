sheet-fields = Name: _________________________ Klasse: ______________ Datum: ______________
sheet-page = Die Seite auf deinem Handy: { $address }
sheet-set-up = Ein Ball über dem Boden, seine Höhe h, und ein Handy daneben
sheet-qr-code = QR-Code der Seite
sheet-need = Das brauchst du
sheet-do = Das tust du
sheet-write = Schreib auf
sheet-work = Rechne
sheet-expected = Was zu erwarten ist
sheet-expected-made = Berechnet von bouncelab, mit der Luft eines Zimmers (20 °C, auf Meereshöhe) und der Normfallbeschleunigung. Die Stoßzahl ist in den Tabellen bei jedem Tempo gleich angenommen.
sheet-talk = Besprecht
sheet-teacher = Für die Lehrkraft
sheet-teacher-collect = Einsammeln: Jede Gruppe teilt ihren Versuch als Link, und die Tabelle der Versuche auf der Seite nimmt alle Links auf einmal. Sie ordnet sie nach Ball und Untergrund, gibt das Mittel jeder Gruppe mit seinem 95-%-Bereich und nennt die Versuche, die nicht dazu passen.
sheet-teacher-quiet = Ein harter Boden oder eine Steinplatte auf einem festen Tisch und zehn Sekunden Stille genügen. Das Telefon liegt höchstens einen Meter entfernt, nicht auf der Platte.
sheet-no-air = ohne Luft
sheet-column-ball = Ball
sheet-column-drop = Versuch
sheet-column-restitution = e
sheet-column-first = T₁ (s)
sheet-column-second = T₂ (s)
sheet-column-third = T₃ (s)
sheet-column-ratio = T₂ / T₁
sheet-column-height = Höhe nach Aufprall 1 (cm)
sheet-column-terminal = Endtempo (m/s)
sheet-column-speed = Tempo bei Aufprall 1 (m/s)
sheet-column-share = Luftwiderstand dort, in % des Gewichts
sheet-column-gravity = 8 h T₂² / T₁⁴ (m/s²)
sheet-column-off = daneben um (%)
sheet-column-mean = Mittel

sheet-bounciness-title = Wie gut springt ein Ball?
sheet-bounciness-aim = Ein Ball behält bei jedem Aufprall den Anteil e seines Tempos: seine Stoßzahl. Du findest e mit dem Ohr eines Telefons, denn jeder Flug dauert etwa e-mal so lang wie der vorige.
sheet-bounciness-need-1 = drei verschiedene Bälle, einen harten Boden, ein Lineal oder Maßband
sheet-bounciness-need-2 = ein Telefon oder einen Computer mit der Seite von bouncelab
sheet-bounciness-do-1 = Wähle deinen Ball auf der Seite, leg das Telefon neben die Stelle, an der der Ball aufprallt, und tippe auf „Zuhören“.
sheet-bounciness-do-2 = Halte den tiefsten Punkt des Balls { $height } cm über den Boden. Lass ohne Stoß los. Warte, bis der Ball ruht.
sheet-bounciness-do-3 = Lies die ersten Flugzeiten aus der Liste der Aufpralle: T₁ ist die Zeit von Aufprall 1 bis Aufprall 2, T₂ von 2 bis 3.
sheet-bounciness-do-4 = Lass jeden Ball dreimal fallen.
sheet-bounciness-work-1 = Teile für jeden Versuch T₂ durch T₁ und bilde für jeden Ball das Mittel.
sheet-bounciness-work-2 = Welcher Ball behält am meisten Tempo? Welchen Anteil seiner Energie behält er (e²)?
sheet-bounciness-work-3 = Vergleiche dein T₂ / T₁ mit dem e der Seite. Welches ist größer, und warum?
sheet-bounciness-see = Ein Ball ({ $ball }) aus { $height } cm für mehrere Werte von e. T₂ / T₁ ist kleiner als e: Auch die Luft bremst den Ball.
sheet-bounciness-talk-1 = Warum verrät die Dauer eines Flugs das Tempo, mit dem er begann?
sheet-bounciness-talk-2 = Die Höhe eines Sprungs ist das e²-fache der vorigen. Wie hoch ist Sprung 5 deines besten Balls?
sheet-bounciness-talk-3 = Drei Versuche mit demselben Ball unterscheiden sich. Liegt es am Ball, am Boden oder am Loslassen?
sheet-bounciness-teacher-1 = Ohne Luft wäre T₂ / T₁ = e. Der Unterschied in der Tabelle ist fast nur die Luft: { $off } % bei e = 0,90. Die Seite rechnet die Luft aus ihrem e heraus.

sheet-air-title = Wie viel nimmt die Luft?
sheet-air-aim = Luft bremst jeden Ball, am meisten einen leichten und großen. Du misst, wie sehr, mit Flugzeiten, die ohne Luft alle im selben Verhältnis kürzer würden.
sheet-air-need-1 = einen Tischtennisball, einen Tennisball und einen Golfball (oder eine Stahlkugel), einen harten Boden, ein Maßband
sheet-air-need-2 = ein Telefon oder einen Computer mit der Seite von bouncelab
sheet-air-do-1 = Wähle den Ball auf der Seite, tippe auf „Zuhören“ und lass den Ball aus { $height } cm fallen.
sheet-air-do-2 = Schreib für jeden Ball die Dauer der ersten drei Flüge auf.
sheet-air-do-3 = Sieh dir zu jedem Versuch die Abbildung „Stoßzahl“ an: einmal, als gäbe es keine Luft, einmal mit herausgerechneter Luft.
sheet-air-work-1 = Berechne T₂ / T₁ und T₃ / T₂. Ohne Luft wären sie gleich, wenn der Ball bei jedem Aufprall denselben Anteil behält.
sheet-air-work-2 = Bei welchem Ball unterscheiden sich T₂ / T₁ und T₃ / T₂ am meisten? Warum bei diesem?
sheet-air-work-3 = Schätze den Luftwiderstand beim ersten Aufprall aus dem Endtempo: Widerstand / Gewicht = (Tempo / Endtempo)².
sheet-air-see = Bälle aus { $height } cm, die alle e = { $restitution } haben. Die Luft macht T₂ / T₁ verschieden, und ein wenig die Zeit, die ein Ball den Boden berührt.
sheet-air-talk-1 = Warum spürt die Stahlkugel die Luft kaum, obwohl sie so klein ist?
sheet-air-talk-2 = Bei späteren, langsameren Flügen kommt T₃ / T₂ näher an e. Warum?
sheet-air-talk-3 = Eine Klasse hat einen Tischtennisball gemessen, ohne an die Luft zu denken. Ist ihr e zu groß oder zu klein?
sheet-air-teacher-1 = Der Luftwiderstand eines Tischtennisballs ist beim ersten Aufprall { $share } % seines Gewichts. Er macht T₂ / T₁ um { $off } % kleiner als e.
sheet-air-teacher-2 = Das wahre e eines Balls ändert sich mit dem Tempo, darum ist T₃ / T₂ − T₂ / T₁ nicht die Luft allein. Die Seite trennt beides und sagt, wo der Versuch es nicht kann.

sheet-gravity-title = Miss g mit einem Ball
sheet-gravity-aim = Aus einer bekannten Höhe und zwei Flugzeiten folgt die Fallbeschleunigung g, ohne Stoppuhr: Der Ball sagt selbst, wie viel er bei jedem Aufprall verliert.
sheet-gravity-need-1 = einen schweren, kleinen Ball (Golfball oder Stahlkugel), eine Steinplatte, ein Lineal auf den Millimeter
sheet-gravity-need-2 = ein Telefon oder einen Computer mit der Seite von bouncelab
sheet-gravity-do-1 = Miss die Höhe h von der Platte bis zum tiefsten Punkt des Balls: { $height } cm, wenn du kannst, auf den Millimeter.
sheet-gravity-do-2 = Tippe auf „Zuhören“ und lass ohne Stoß los. Lass den Ball fünfmal fallen.
sheet-gravity-do-3 = Schreib T₁ und T₂ mit vier Nachkommastellen auf.
sheet-gravity-work-1 = Der Ball kommt mit v = √(2 g h) an und geht mit e v. Also ist T₁ = 2 e v / g und e = T₂ / T₁. Zeige, dass g = 8 h T₂² / T₁⁴.
sheet-gravity-work-2 = Berechne g für jeden Versuch, dann das Mittel und seinen Standardfehler.
sheet-gravity-work-3 = Gib auf der Seite unter „ändern“ die Höhe an, kreuze „g messen“ an und vergleiche.
sheet-gravity-see = Was die Formel für Bälle aus { $height } cm mit e = { $restitution } ergibt, wenn g { $gravity } m/s² ist.
sheet-gravity-talk-1 = Der Tennisball ergibt ein zu kleines g, obwohl er weniger von der Luft spürt als der Tischtennisball. Was dauert bei einem Aufprall noch?
sheet-gravity-talk-2 = Ein Millimeter von { $height } cm sind { $share } %. Wie groß ist der Fehler von g, der daraus folgt?
sheet-gravity-talk-3 = g ist am Äquator 9,78 m/s² und an den Polen 9,83 m/s². Könntest du das unterscheiden?
sheet-gravity-teacher-1 = In der Formel steht e im Quadrat: Streut e von Aufprall zu Aufprall um 0,5 %, so streut g von Versuch zu Versuch um { $scatter } %. Mit fünf Versuchen ist das Mittel auf { $mean } % bekannt.
sheet-gravity-teacher-2 = Auf das Loslassen kommt es am meisten an: Ein Ball, der gestoßen oder gedreht wird, hat eine andere Höhe. Ein Magnet, der eine Stahlkugel loslässt, hilft.
sheet-gravity-teacher-3 = Ein Tennisball berührt den Boden { $contact } ms lang, die als Flug zählen: g wird { $soft } % zu klein. Die Luft verkürzt T₁ und macht T₂ / T₁ kleiner; in dieser Formel hebt sich beides fast auf. Die Seite rechnet beides heraus.

sheet-ball-table-tennis-40 = Tischtennis
sheet-ball-tennis = Tennis
sheet-ball-golf = Golf
sheet-ball-steel = Stahl, 2 cm
