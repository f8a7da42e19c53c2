// Bodies of shapes.inc made of functions and nets. Circle_Text, Bevelled_Text and the smooth nets of HF_Sphere and
// HF_Torus are alike but not equal to the last pixel, so they are not here.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
#declare Columns = 4;
#declare Rows = 3;
camera { orthographic location <Columns * 1.5, -Rows * 1.5, -50> direction z right 3 * Columns * x up 3 * Rows * y }
light_source { <-40, 50, -60> rgb 0.9 }
background { rgb <0.3, 0.4, 0.5> }
#declare N = 0;
#macro Next() translate <3 * mod(N, Columns) + 1.5, -3 * int(N / Columns) - 1.5, 0> #declare N = N + 1; #end
#declare Paint = pigment { rgb <0.8, 0.6, 0.4> }
object { Supertorus(0.9, 0.35, 0.4, 0.3, 0.001, 1.5) pigment { Paint } rotate -50 * x Next() }
object { Supertorus(0.9, 0.35, 1, 1, 0.001, 1.5) pigment { Paint } rotate -50 * x Next() }
#declare F = function { 0.5 + 0.5 * sin(x * 12) * cos(y * 9) }
object { HF_Square(F, 1, 0, <16, 16>, 0, "", <-1, -0.2, -1>, <1, 0.2, 1>) pigment { Paint } rotate -40 * x Next() }
object { HF_Cylinder(F, 1, 1, <24, 8>, 0, "", -0.9 * y, 0.9 * y, 0.7, 0.2) pigment { gradient x scale 0.21 } rotate <-20, 30, 10> Next() }
