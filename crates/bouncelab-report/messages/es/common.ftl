decimal-point = ,
unit-cannot-tell = indeterminado
interval-ends = { $low } a { $high }
list-and = { $first } y { $last }
list-semicolon = { $first }; { $last }
list-more = { $first } y { $count } más
with-colon = { $text }:
