// A vector where one number is needed.
sphere { 0, <1, 2, 3> pigment { rgb 1 } }
