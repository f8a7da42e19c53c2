//! about: a plane seen at a slope of 10^X, against the closed form
//! extremity: 10^X
//! steps: -1 to -20 by -1
//! truth: what it finds
//! tolerance: 1e-9
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#macro Found(Object)
  #local N = <0, 0, 0>;
  #local P = trace(Object, <0, 1, 0>, <1, -pow(10, X), 0>, N);
  #debug concat("found ", str((vlength(N) = 0 ? 1 : abs(P.x * pow(10, X) - 1)), 0, 20), "\n")
#end
Found(plane { y, 0 })
Found(box { <-1e30, -1, -1>, <1e30, 0, 1> })
Found(cylinder { -y, 0, 1e30 })
Found(triangle { <0, 0, -1e30>, <0, 0, 1e30>, <3e30, 0, 0> })
