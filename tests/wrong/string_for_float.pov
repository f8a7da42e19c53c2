// A string where a number is needed.
sphere { 0, "1" pigment { rgb 1 } }
