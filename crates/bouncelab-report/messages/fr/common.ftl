# The singular ([one]) is that of 0 too: where 0 may occur, it shows its number.

decimal-point = ,
unit-cannot-tell = indéterminé
interval-ends = { $low } à { $high }
list-and = { $first } et { $last }
list-semicolon = { $first } ; { $last }
list-more = { $first } et { $count } de plus
with-colon = { $text } :
