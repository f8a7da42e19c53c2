//! about: a height field of 10^X squares
//! extremity: 10^X
//! steps: 2 3 4 5 6
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare N = ceil(pow(10, X / 2));
height_field { function N, N { .5 + .3 * sin(9 * x) * cos(7 * y) } translate <-.5, 0, -.5> scale <8, 2, 8> pigment { rgb 1 } }
