//! about: a loop of 10^X turns
//! extremity: 10^X
//! steps: 3 4 5 6 7
//! truth: time n^1 memory n^0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare I = 0;
#while (I < pow(10, X)) #declare I = I + 1; #end
