//! about: 10^X lights
//! extremity: 10^X
//! steps: 1 2 3 3.5
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
#declare R = seed(1);
#declare I = 0;
#while (I < pow(10, X)) light_source { (<rand(R), rand(R), rand(R)> - .5) * 80, 1 / pow(10, X) } #declare I = I + 1; #end
sphere { 0, 2 pigment { rgb 1 } }
plane { y, -2 pigment { rgb 1 } }
