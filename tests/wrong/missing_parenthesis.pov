// A parenthesis that is not closed.
#version 3.7;
sphere { 0, sin(pi/2 pigment { rgb 1 } }
