//! about: an array of 10^X vectors, filled and summed
//! extremity: 10^X
//! steps: 3 4 5 6
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare A = array[pow(10, X)];
#declare Sum = <0, 0, 0>;
#declare I = 0;
#while (I < pow(10, X)) #declare A[I] = <I, 1, 2>; #declare I = I + 1; #end
#declare I = 0;
#while (I < pow(10, X)) #declare Sum = Sum + A[I]; #declare I = I + 1; #end
