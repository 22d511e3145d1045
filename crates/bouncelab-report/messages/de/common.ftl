decimal-point = ,
unit-cannot-tell = nicht zu sagen
interval-ends = { $low } bis { $high }
list-and = { $first } und { $last }
list-semicolon = { $first }; { $last }
list-more = { $first } und { $count } weitere
with-colon = { $text }:
