//! about: a torus whose tube is 10^X of its ring, traced along, across and aslant
//! extremity: 10^X
//! steps: -1 to -12 by -1
//! truth: what it finds
//! tolerance: 1e-4
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#declare R = pow(10, X);
#declare T = torus { 1, R }
// Points of the tube, seen along their normal: how far off, in radii of the tube.
#declare I = 0;
#while (I < 200)
  #local A = radians(I * 1.8);
  #local B = radians(I * 77.7);
  #local Out = <cos(A), 0, sin(A)>;
  #local Normal = Out * cos(B) + y * sin(B);
  #local N = <0, 0, 0>;
  #local P = trace(T, Out + Normal * .5, -Normal, N);
  #local Off = (vlength(N) = 0 ? 1 : vlength(P - Out - Normal * R) / R);
  #debug concat("found ", str(Off, 0, 20), "\n")
  #declare I = I + 1;
#end
