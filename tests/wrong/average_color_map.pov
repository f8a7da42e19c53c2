// An average of colours needs a pigment_map.
plane { y, 0 pigment { average color_map { [0 rgb 0] [1 rgb 1] } } }
