# Was man von einem Versuch zuerst liest: die Antwort, oder warum es keine gibt.

answer-kept-first = Bei { $speed }, dem Tempo des ersten erkannten Aufpralls, behält der Ball { $share } seines Tempos, das sind { $energy } seiner Energie.
answer-kept-asked = Bei { $speed } behält der Ball { $share } seines Tempos; beim ersten erkannten Aufprall behielt er { $energy } seiner Energie.
answer-kept-always = Der Ball behält bei jedem Aufprall { $share } seines Tempos, von { $fastest } bis hinab zu { $slowest }, das sind { $energy } seiner Energie.
answer-round = Bei { $speed } behält er { $share }.
answer-fell = Er fiel aus { $height } Höhe.
answer-fell-first = Er fiel vor dem ersten erkannten Aufprall aus { $height } Höhe.
answer-height-stated = Die Fallhöhe ist { $height }, nach den Zeiten und der angegebenen Höhe.
answer-median = Der Ball behielt { $share } seines Tempos, im Median seiner Aufpralle von { $fastest } bis hinab zu { $slowest }, den Luftwiderstand herausgerechnet.
answer-median-too-few = Es gibt keinen Median: { $count } der Aufpralle liegen zwischen zwei Flügen, und 3 braucht es.
answer-none = Stoßzahl und Fallhöhe lassen sich nicht angeben. { $reason }
answer-ball = Die Zahlen gelten für diesen Ball: { $ball }.
answer-ball-assumed = Die Zahlen gelten für diesen Ball, der angenommen ist, weil keiner angegeben war: { $ball }.
answer-line = Die Ausgleichsgerade durch die Logarithmen der Flugzeiten, ohne Luft, ergibt { $share } und eine Fallhöhe von { $height }.
answer-line-agrees = Die Ausgleichsgerade durch die Logarithmen der Flugzeiten, ohne Luft, ergibt innerhalb der Unsicherheit dasselbe: { $share } und eine Fallhöhe von { $height }.
answer-line-differs = Die Ausgleichsgerade durch die Logarithmen der Flugzeiten, ohne Luft, ergibt { $share }, wo die Aufpralle ohne den Luftwiderstand { $corrected } ergeben, und eine Fallhöhe von { $height }.
