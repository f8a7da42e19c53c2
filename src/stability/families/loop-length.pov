//! about: a loop of 10^X turns
//! extremity: 10^X
//! steps: 3 4 5 6 7
//! truth: what it finds
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#declare I = 0;
#while (I < pow(10, X)) #declare I = I + 1; #end
#debug concat("found ", str(abs(I - pow(10, X)), 0, 20), "\n")
