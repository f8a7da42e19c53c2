//! about: a string of 10^X letters, put together one by one
//! extremity: 10^X
//! steps: 2 3 4 5
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare S = "";
#declare I = 0;
#while (I < pow(10, X)) #declare S = concat(S, "a"); #declare I = I + 1; #end
