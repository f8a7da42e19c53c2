// Colour map entries without square brackets.
sphere { 0, 1 pigment { gradient y color_map { 0 rgb 0, 1 rgb 1 } } }
