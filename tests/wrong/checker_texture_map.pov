// A checker has two textures, not a texture_map.
plane { y, 0 texture { checker texture_map { [0 pigment { rgb 0 }] [1 pigment { rgb 1 }] } } }
