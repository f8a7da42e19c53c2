//! about: a box from which 10^X spheres are taken
//! extremity: 10^X
//! steps: 2 3 4 5
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare R = seed(1);
#declare I = 0;
difference { box { -4, 4 } #while (I < pow(10, X)) sphere { (<rand(R), rand(R), rand(R)> - .5) * 8, 2 / pow(10, X / 3) } #declare I = I + 1; #end pigment { rgb 1 } }
