//! about: 10^X calls of a macro with a local and an expression
//! extremity: 10^X
//! steps: 3 4 5 6
//! truth: time n^1 memory n^0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#macro Next(N) #local M = N * 2 + vlength(<N, 1, 2>); (M - vlength(<N, 1, 2>)) / 2 + 1 #end
#declare I = 0;
#while (I < pow(10, X)) #declare I = Next(I); #end
