// A light source without a colour.
#version 3.7;
light_source { <1, 2, -3> }
sphere { 0, 1 pigment { rgb 1 } }
