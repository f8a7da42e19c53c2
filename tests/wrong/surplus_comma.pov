// A comma after the last parameter.
sphere { 0, 1, pigment { rgb 1 } }
