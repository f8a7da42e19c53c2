// A texture's name within a pigment.
#declare Paint = texture { pigment { rgb 1 } }
sphere { 0, 1 pigment { Paint } }
