//! about: rays that dip 10^X deep into a sphere, and into a cylinder, a torus and a cone, against the closed form
//! extremity: 10^X
//! steps: -1 to -15 by -1
//! truth: what it finds
//! tolerance: 1e-3
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
// A ray along z at height 1 - E enters the unit sphere at z = -sqrt(E (2 - E)): its relative error.
#declare E = pow(10, X);
#declare H = 1 - E;
#declare E = 1 - H;
#macro Found(Object, From, Right)
  #local N = <0, 0, 0>;
  #local P = trace(Object, From, z, N);
  #if (vlength(N) = 0) #local Off = 1; #else #local Off = abs(P.z / Right - 1); #end
  #debug concat("found ", str(Off, 0, 20), "\n")
#end
#declare Z = -sqrt(E * (2 - E));
Found(sphere { 0, 1 }, <0, H, -5>, Z)
Found(cylinder { -2*x, 2*x, 1 }, <.3, H, -5>, Z)
Found(cylinder { -2*x, 2*x, 1 open }, <.3, H, -5>, Z)
Found(torus { 5, 1 rotate 90*x translate <0, 5, 0> }, <0, H, -5>, Z)
Found(superellipsoid { <1, 1> }, <0, H, -5>, Z)
Found(quadric { <1, 1, 1>, 0, 0, -1 }, <0, H, -5>, Z)
