//! about: an intersection of 10^X half-spaces around a ball
//! extremity: 10^X
//! steps: 1 2 3 4
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare R = seed(1);
#declare I = 0;
intersection { sphere { 0, 3 } #while (I < pow(10, X)) plane { vnormalize(<rand(R), rand(R), rand(R)> - .5), 2 } #declare I = I + 1; #end pigment { rgb 1 } }
