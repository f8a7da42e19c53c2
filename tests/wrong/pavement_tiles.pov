// A pavement that there is not, in a texture declared far from the object.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Floor = texture { pigment { pavement number_of_sides 4 number_of_tiles 9 } }
plane { y, 0 texture { Floor scale 2 } }
