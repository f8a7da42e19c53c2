//! about: a macro that calls itself 10^X times
//! extremity: 10^X
//! steps: 1 2 3 4 5 6
//! truth: what it finds
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#macro Sum(N) #if (N = 0) 0 #else (1 + Sum(N - 1)) #end #end
#debug concat("found ", str(abs(Sum(ceil(pow(10, X))) - ceil(pow(10, X))), 0, 20), "\n")
