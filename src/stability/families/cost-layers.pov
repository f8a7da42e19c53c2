//! about: a texture of 10^X layers
//! extremity: 10^X
//! steps: 1 2 3 4
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare T = texture { pigment { rgb 1 } }
#declare I = 0;
sphere { 0, 3 texture { pigment { rgb 1 } } #while (I < pow(10, X)) texture { pigment { checker rgbt .99 rgbt .95 } } #declare I = I + 1; #end }
