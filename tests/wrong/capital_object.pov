// An object word with a capital letter.
#version 3.7;
Sphere { <0, 0, 0>, 1 pigment { rgb 1 } }
