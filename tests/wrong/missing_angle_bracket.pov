// A vector that is not closed.
sphere { <0, 1, 0, 1 pigment { rgb 1 } }
