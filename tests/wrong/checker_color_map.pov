// A checker has two colours, not a color_map.
plane { y, 0 pigment { checker color_map { [0 rgb 0] [1 rgb 1] } } }
