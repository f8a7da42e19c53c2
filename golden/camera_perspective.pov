// perspective camera: from above, rolled by sky, with an angle and an image shape of its own.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { perspective location <2, 5, -4> sky <0.3, 1, 0.1> right 1.2 * x up 0.9 * y look_at <0.2, 0, 0.4> angle 55 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> } }
box { <-0.5, 0, -0.5>, <0.5, 2, 0.5> pigment { rgb <0.8, 0.3, 0.2> } }
sphere { <1.5, 0.6, 1>, 0.6 pigment { rgb <0.9, 0.8, 0.3> } }
