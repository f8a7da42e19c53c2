// A vector in round brackets.
sphere { (0, 1, 0), 1 pigment { rgb 1 } }
