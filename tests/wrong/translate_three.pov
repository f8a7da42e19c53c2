// Three numbers where a vector belongs.
#version 3.7;
sphere { 0, 1 pigment { rgb 1 } translate 1, 2, 3 }
