// A modifier with a typing mistake.
sphere { 0, 1 pigmnet { rgb <1, 0, 0> } }
