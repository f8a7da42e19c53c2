// Without a comma the sign becomes an operator, and the box has one corner.
box { <-1, -1, -1> -1 pigment { rgb 1 } }
