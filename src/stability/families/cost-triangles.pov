//! about: a mesh of 10^X triangles
//! extremity: 10^X
//! steps: 2 3 4 5 6
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare R = seed(1);
#declare I = 0;
#declare D = 4 / pow(10, X / 2);
mesh { #while (I < pow(10, X)) #declare P = (<rand(R), rand(R), rand(R)> - .5) * 8; triangle { P, P + D * <1, rand(R), 0>, P + D * <0, 1, rand(R)> } #declare I = I + 1; #end pigment { rgb 1 } }
