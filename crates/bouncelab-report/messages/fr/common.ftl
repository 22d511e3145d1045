# De 0 à moins de 2 c'est le singulier (« one ») : un message avec [one] montre son nombre.

decimal-point = ,
unit-cannot-tell = indéterminé
interval-ends = { $low } à { $high }
list-and = { $first } et { $last }
list-more = { $first } et { $count } de plus
