# Numbers, units and lists: what all texts are made of.

decimal-point = .
unit-cannot-tell = cannot tell
interval-ends = { $low } to { $high }
list-and = { $first } and { $last }
list-semicolon = { $first }; { $last }
list-more = { $first } and { $count } more
with-colon = { $text }:
